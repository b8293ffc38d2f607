# SPDX-License-Identifier: MIT
"""How much worse a body follows in a live session than in the benchmark, by exported programs.

A server and a trainee on 127.0.0.1 play a clip in real time, soft root; the server's own stats of
how the limbs follow, by those of `bench tracking` for the same clip and length. Once on the machine
as it is, once with twice as many busy loops as there are processors. Options: --bvh=FILE (again for
more; default the three clips), --seconds=20 (of each), --busy=N (loops, only this case).
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from bench import Bench, Options, main
from toolchain.console import Failure
from toolchain.paths import CLIENT_BINARY, CLIPS, SERVER_BINARY
from toolchain.processes import ask, free_port, json_lines
from toolchain.stats import GOALS_MISSED, LEFT_OUT, Stats

TRACKING = "res://tests/bench/bench_tracking.gd"
MAX_RATIO = 1.3
# The first moments, in which a body is put into its pose, and in which clocks find each other.
SETTLE_S = 3.0


def measure(arguments: list[str]) -> int:
    """Runs the sessions and prints their stats."""
    processors = len(os.sched_getaffinity(0))
    defaults = {
        "bvh": [str(clip) for clip in sorted(CLIPS.glob("*.bvh"))],
        "seconds": 20.0,
        "busy": -1,
    }
    options = Options(arguments, defaults)
    bench = Bench("live", options.json, export=True)
    busy = [options["busy"]] if options["busy"] >= 0 else [0, 2 * processors]
    for clip in map(Path, options["bvh"]):
        simulated = run_simulated(bench, clip, options["seconds"])
        for loops in busy:
            case = f"{clip.name}, {loops} busy loops"
            add(bench.stats, case, simulated, run_live(bench, clip, options["seconds"], loops))
    return bench.finish()


def run_simulated(bench: Bench, clip: Path, seconds: float) -> dict[str, float]:
    """The errors of the benchmark, by metric, deg."""
    options = [f"--bvh={clip}", f"--seconds={seconds}", "--root=soft", "--hz=60", "--json"]
    command = bench.command("--headless", "-s", TRACKING, "--", *options)
    rows = json_lines(bench.run(command, codes=(0, GOALS_MISSED, LEFT_OUT))[0])
    if not rows:
        raise Failure(f"The benchmark found nothing in {clip}.")
    return {row["metric"]: row["value"] for row in rows if "value" in row}


def run_live(bench: Bench, clip: Path, seconds: float, loops: int) -> dict[str, Any]:
    """The server's report of the trainee, with that of its ticks."""
    with bench.session() as (group, _), ExitStack() as stack:
        port = free_port()
        server = [f"--port={port}", "--root=soft", "--role=server"]
        group.start("server", [str(SERVER_BINARY), "--headless", "--", *server])
        status = group.await_status()
        trainee = ["--role=trainee", f"--port={port}", f"--bvh={clip}"]
        group.start("trainee", [str(CLIENT_BINARY), "--headless", "--", *trainee])
        for _ in range(loops):
            busy = subprocess.Popen([sys.executable, "-c", "while True: pass"])
            stack.callback(busy.kill)

        def has_body() -> bool:
            report = ask(status)
            return report["ticks"] > 0 and bool(report["people"])

        group.await_that("trainee", has_body, "the trainee's body", 60.0)
        time.sleep(SETTLE_S)
        before = ask(status)["people"][0]
        time.sleep(seconds)
        after = ask(status)
        after["people"][0]["mean_deg"] = since(before, after["people"][0])
        return after


def since(before: dict[str, float], after: dict[str, float]) -> float:
    """The mean error between two reports, deg."""
    sums = [part["mean_deg"] * part["count"] for part in (before, after)]
    return (sums[1] - sums[0]) / max(after["count"] - before["count"], 1)


def add(stats: Stats, case: str, simulated: dict[str, float], live: dict[str, Any]) -> None:
    """Adds a session's stats."""
    person = live["people"][0]
    for key, metric in (("mean_deg", "mean error"), ("p95_deg", "p95 error")):
        stats.add(case, f"{metric}, benchmark", simulated[metric], "deg")
        stats.add(case, f"{metric}, live", person[key], "deg")
        ratio = person[key] / simulated[metric]
        most = MAX_RATIO if key == "mean_deg" else None
        stats.add(case, f"{metric}, live by benchmark", ratio, "", at_most=most)
    stats.add(case, "sample to tick, p50", person["sample_to_tick_ms_p50"], "ms")
    stats.add(case, "sample to tick, p95", person["sample_to_tick_ms_p95"], "ms")
    stats.add(case, "ticks", live["ticks_per_second"], "/s")


if __name__ == "__main__":
    main(measure)
