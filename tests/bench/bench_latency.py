# SPDX-License-Identifier: MIT
"""From a sample to its display on loopback, through exported programs in real time.

A server of 60 ticks/s, a trainee who moves by a clip, and an observer, whose frames come at a fixed
rate that drifts against the ticks; stages and ages as in docs/latency.md. The own body is what the
trainee sees in local feedback. Options: --fps=60 (of the displays, again for more; default 50 to
144), --seconds=10 (at each), --rate=60 (samples per second), --smoothing=METHOD (of the observer),
--bvh=FILE, --port=7777 (a free one by default).

--display=NAME (again for more; default none: the observer has no window): the observer shows the
world in this way - window, side-by-side, anaglyph, wall, ... - in a window of a virtual display,
which the processor draws. Besides the stages: display share, from the arrival of a snapshot to the
frame that shows it, in frames of that rate, and where the time of a frame goes. Then --fps is 15 by
default, --seconds 40. Headsets: ./run bench displays --part=hmd.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from statistics import mean, median

from bench import main
from toolchain.console import Failure
from toolchain.latency import Settings, read_delays, run_session
from toolchain.processes import free_port
from toolchain.stats import Stats

FPS = ["50", "59", "60", "72", "75", "90", "120", "144"]
SECONDS = 10
# Of the motion that a frame shows, when it is drawn.
MAX_AGE_MS = 17.0
MAX_AGE_SD_MS = 4.0
# Of a sample, until the first frame that shows it, where frames keep in step with the ticks.
IN_STEP = 60
MAX_MS = 20.0
MAX_SD_MS = 6.0
# One frame of 60 Hz.
MAX_OWN_MS = 16.7
THESIS_MS = 50.7
# In a window that the processor draws: a rate that it reaches, and a goal of issue 18.
WINDOW_FPS = "15"
WINDOW_SECONDS = 40
# Shaders are compiled in the first seconds; no more of a session than this.
WARM_UP_S = 20.0
WARM_UP_SHARE = 0.5
MAX_SHARE = 1.5
# A renderer at its limit takes 1.5 frames: a sample waits for half of one, and one is drawn. The
# goal is for rates that are reached, to this share.
HELD_SHARE = 0.95


def measure(arguments: list[str]) -> int:
    """Runs a session for each rate of the displays and prints its stats."""
    stats = Stats("latency", "--json" in arguments)
    fps = [option.removeprefix("--fps=") for option in arguments if option.startswith("--fps=")]
    displays = [option for option in arguments if option.startswith("--display=")]
    options = [
        option
        for option in arguments
        if option != "--json" and not option.startswith(("--fps=", "--port=", "--display="))
    ]
    if not any(option.startswith("--seconds=") for option in options):
        options.append(f"--seconds={WINDOW_SECONDS if displays else SECONDS}")
    port = [option for option in arguments if option.startswith("--port=")]
    for display in displays:
        for rate in fps or [WINDOW_FPS]:
            session = [*options, display, f"--fps={rate}"]
            measure_display(stats, [*session, *(port or [f"--port={free_port()}"])])
    if not displays:
        for rate in fps or FPS:
            measure_at(stats, [*options, f"--fps={rate}", *(port or [f"--port={free_port()}"])])
    return stats.finish()


def measure_display(stats: Stats, options: list[str]) -> None:
    """Runs a session whose observer has a window, and adds its stats."""
    settings = Settings(options)
    if settings.window is None:
        raise Failure("--display= needs a name, such as window or side-by-side.", 2)
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        file = Path(folder) / "latency.csv"
        observer = run_session(settings, file)["observer"]
        warm_up_s = min(WARM_UP_S, WARM_UP_SHARE * settings.seconds)
        delays, rate = read_delays(file, warm_up_s)
    case = f"{settings.window.display}, {settings.fps} fps"
    frame_ms = 1000.0 / min(settings.fps, rate)
    stats.add(case, "frames", rate, "1/s")
    holds = rate >= HELD_SHARE * settings.fps
    if not holds:
        print(f"latency: {case}: only {rate:.1f} are drawn here: no goal", file=sys.stderr)
    share = mean(delays) / frame_ms
    stats.add(case, "display share", share, "frames", at_most=MAX_SHARE if holds else None)
    stats.add(case, "display share, p50", median(delays) / frame_ms, "frames")
    for name in ("mean", "sd", "p50", "p95"):
        stats.add(case, f"age, {name}", observer["frame_age"][f"{name}_ms"], "ms")
    stats.add(case, "motion to photon", observer["motion_to_photon_ms"], "ms")
    for name, part in observer["frame_times"].items():
        stats.add(case, f"a frame's {name}, p50", part["p50_ms"], "ms")
    for stage, row in observer["latency"].items():
        stats.add(case, f"{stage}, mean", row["mean_ms"], "ms")
        stats.add(case, f"{stage}, p99", row["p99_ms"], "ms")


def measure_at(stats: Stats, options: list[str]) -> None:
    """Runs a session and adds its stats."""
    settings = Settings(options)
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        reports = run_session(settings, Path(folder) / "latency.csv")
    observer = reports["observer"]
    case = f"{settings.fps} Hz"
    stats.add(case, "age, mean", observer["frame_age"]["mean_ms"], "ms", at_most=MAX_AGE_MS)
    stats.add(case, "age, sd", observer["frame_age"]["sd_ms"], "ms", at_most=MAX_AGE_SD_MS)
    stats.add(case, "age, p95", observer["frame_age"]["p95_ms"], "ms")
    stats.add(case, "frames", observer["frames_per_second"], "1/s")
    total = observer["latency"].pop("total")
    step = settings.fps == IN_STEP
    stats.add(case, "sample", total["mean_ms"], "ms", at_most=MAX_MS if step else None)
    stats.add(case, "sample, sd", total["sd_ms"], "ms", at_most=MAX_SD_MS if step else None)
    stats.add(case, "sample, p95", total["p95_ms"], "ms")
    least = 0.9 * settings.rate * settings.seconds
    stats.add(case, "samples", total["count"], "", at_least=least)
    if step:
        stats.add(case, "thesis over ours", THESIS_MS / max(total["mean_ms"], 0.001), "")
    own = reports["trainee"].get("own_latency", {"count": 0})
    if own["count"]:
        stats.add(case, "own body, mean", own["mean_ms"], "ms", at_most=MAX_OWN_MS)
        stats.add(case, "own body, p95", own["p95_ms"], "ms")
    else:
        print("The trainee did not show the own body.", file=sys.stderr)
    if step:
        for stage, row in observer["latency"].items():
            stats.add(stage, "mean", row["mean_ms"], "ms")
            stats.add(stage, "p99", row["p99_ms"], "ms")


if __name__ == "__main__":
    main(measure)
