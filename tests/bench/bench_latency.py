# SPDX-License-Identifier: MIT
"""From a sample to its display on loopback, through exported programs in real time.

A server of 60 ticks/s, a trainee who moves by a clip, and an observer, whose frames come at a fixed
rate that drifts against the ticks; stages and ages as in docs/latency.md. The own body is what the
trainee sees in local feedback. Options: --fps=60 (of the displays, again for more; default 50 to
144), --seconds=10 (at each), --rate=60 (samples per second), --smoothing=METHOD (of the observer),
--bvh=FILE, --port=7777 (a free one by default).
"""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path

from toolchain.console import Failure
from toolchain.latency import Settings, run_session
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


def measure(arguments: list[str]) -> int:
    """Runs a session for each rate of the displays and prints its stats."""
    stats = Stats("latency", "--json" in arguments)
    fps = [option.removeprefix("--fps=") for option in arguments if option.startswith("--fps=")]
    options = [
        option
        for option in arguments
        if option != "--json" and not option.startswith(("--fps=", "--port="))
    ]
    if not any(option.startswith("--seconds=") for option in options):
        options.append(f"--seconds={SECONDS}")
    port = [option for option in arguments if option.startswith("--port=")]
    for rate in fps or FPS:
        measure_at(stats, [*options, f"--fps={rate}", *(port or [f"--port={free_port()}"])])
    return stats.finish()


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
    try:
        sys.exit(measure(sys.argv[1:]))
    except Failure as failure:
        print(failure, file=sys.stderr)
        sys.exit(2)
    except (KeyError, json.JSONDecodeError) as broken:
        print(f"A report lacks what is needed: {broken}", file=sys.stderr)
        sys.exit(1)
