# SPDX-License-Identifier: MIT
"""From a sample to its display in a window that the processor draws: waiting apart from drawing.

A server of the small hall, a trainee who moves by a clip, and an observer's window of a virtual
display in low quality, at 15, 30 and 60 frames a second and as fast as this machine draws. Where
the rate that is asked for is not reached, the goal does not count. Display share: from the arrival
of the snapshot to the frame that shows it, in frames of that rate. Age: how old the motion is that
a frame shows when it is drawn. `./run bench latency --display=NAME` has the same of other displays.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from statistics import mean, median

from bench import Bench
from toolchain.latency import Window, observe, read_delays
from toolchain.paths import CLIPS
from toolchain.processes import free_port
from toolchain.project import prepare

PART = "pacing"
SECONDS = 40
# Shaders are compiled in the first ones.
WARM_UP_S = 20.0
# Frames a second that are asked for (0: as many as there are), and the size of the window.
CASES = ((15, "320x180"), (30, "320x180"), (60, "160x90"), (0, "640x360"))
WORLD = "hall"
# A rate is reached by so much of it.
REACHED = 0.95
# A goal of issue 18.
MAX_SHARE = 1.5


def measure(bench: Bench) -> None:
    """Adds the figures of each rate."""
    prepare(export=True)
    add = bench.stats.add
    for fps, size in CASES:
        case = f"window {size}, {fps or 'free'} fps"
        report, delays, rate = watch(fps, size)
        frame_ms = 1000.0 / (min(fps, rate) if fps else rate)
        add(case, "frames", rate, "1/s")
        share = mean(delays) / frame_ms
        if fps and rate < REACHED * fps:
            bench.leave_out(case, f"this machine draws {rate:.0f} frames a second")
            add(case, "display share", share, "frames")
        else:
            add(case, "display share", share, "frames", at_most=MAX_SHARE if fps else None)
        add(case, "display share, p50", median(delays) / frame_ms, "frames")
        add(case, "age, p50", report["frame_age"]["p50_ms"], "ms", at_most=frame_ms)
        for name, part in report.get("frame_times", {}).items():
            add(case, name, part["p50_ms"], "ms")


def watch(fps: int, size: str) -> tuple[dict, list[float], float]:
    """What an observer reports of a session; see read_delays()."""
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        file = Path(folder) / "latency.csv"
        window = Window("window", size)
        trainee = [f"--bvh={CLIPS / '01_01.bvh'}"]
        low = ["--quality=low"]
        report = observe(free_port(), SECONDS, fps, file, window, trainee, low, WORLD)["observer"]
        return report, *read_delays(file, WARM_UP_S)
