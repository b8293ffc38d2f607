# SPDX-License-Identifier: MIT
"""How much worse a body follows in a live session than in the benchmark, by exported programs.

A server and a trainee on 127.0.0.1 play a clip in real time, soft root; the server's own stats of
how the limbs follow, by those of `bench tracking` for the same clip and length. Once on the machine
as it is, once with twice as many busy loops as there are processors. Options: --bvh=FILE (again for
more; default the three clips), --seconds=20 (of each), --busy=N (loops, only this case).
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
import urllib.request
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from toolchain.console import Failure
from toolchain.godot import Godot
from toolchain.paths import CLIENT_BINARY, CLIPS, ROOT, SERVER_BINARY
from toolchain.processes import Group, free_port
from toolchain.project import prepare
from toolchain.stats import Stats

TRACKING = "res://tests/bench/bench_tracking.gd"
MAX_RATIO = 1.3
# The first moments, in which a body is put into its pose, and in which clocks find each other.
SETTLE_S = 3.0


def measure(arguments: list[str]) -> int:
    """Runs the sessions and prints their stats."""
    clips: list[Path] = []
    seconds, busy = 20.0, [0, 2 * len(os.sched_getaffinity(0))]
    for option in arguments:
        name, _, value = option.removeprefix("--").partition("=")
        if name == "bvh":
            clips.append(Path(value))
        elif name == "seconds":
            seconds = float(value)
        elif name == "busy":
            busy = [int(value)]
        elif option != "--json":
            raise Failure(f"'{option}' is no option: --bvh, --seconds, --busy, --json.", 2)
    godot = prepare(export=True)
    stats = Stats("live", "--json" in arguments)
    for clip in clips or sorted(CLIPS.glob("*.bvh")):
        simulated = run_simulated(godot, clip, seconds)
        for loops in busy:
            case = f"{clip.name}, {loops} busy loops"
            add(stats, case, simulated, run_live(clip, seconds, loops))
    return stats.finish()


def run_simulated(godot: Godot, clip: Path, seconds: float) -> dict[str, float]:
    """The errors of the benchmark, by metric, deg."""
    command = [str(godot.program), "--headless", "--no-header", "--path", str(ROOT), "-s", TRACKING]
    options = [f"--bvh={clip}", f"--seconds={seconds}", "--root=soft", "--hz=60", "--json"]
    done = subprocess.run(
        [*command, "--", *options],
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
        env={**os.environ, **godot.environment()},
    )
    rows = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    if not rows:
        raise Failure(f"The benchmark found nothing in {clip}:\n{done.stderr[-1000:]}")
    return {row["metric"]: row["value"] for row in rows if "value" in row}


def run_live(clip: Path, seconds: float, loops: int) -> dict[str, Any]:
    """The server's report of the trainee, with that of its ticks."""
    with (
        tempfile.TemporaryDirectory(prefix="dismount-") as folder,
        Group(Path(folder), {}) as group,
        ExitStack() as stack,
    ):
        port = free_port()
        server = [f"--port={port}", "--root=soft", "--role=server"]
        group.start("server", [str(SERVER_BINARY), "--headless", "--", *server])
        mark = "status at http://127.0.0.1:"
        group.await_text("server", mark, 60)
        status = f"http://127.0.0.1:{group.log('server').split(mark)[1].split('/')[0]}/"
        trainee = ["--role=trainee", f"--port={port}", f"--bvh={clip}"]
        group.start("trainee", [str(CLIENT_BINARY), "--headless", "--", *trainee])
        for _ in range(loops):
            busy = subprocess.Popen([sys.executable, "-c", "while True: pass"])
            stack.callback(busy.kill)
        end = time.monotonic() + 60.0
        while (report := look(status))["ticks"] == 0 or not report["people"]:
            if time.monotonic() > end:
                raise Failure(f"The trainee has no body:\n{group.log('trainee')[-2000:]}")
            time.sleep(0.2)
        time.sleep(SETTLE_S)
        before = look(status)["people"][0]
        time.sleep(seconds)
        after = look(status)
        after["people"][0]["mean_deg"] = since(before, after["people"][0])
        return after


def since(before: dict[str, float], after: dict[str, float]) -> float:
    """The mean error between two reports, deg."""
    sums = [part["mean_deg"] * part["count"] for part in (before, after)]
    return (sums[1] - sums[0]) / max(after["count"] - before["count"], 1)


def look(status: str) -> dict[str, Any]:
    """What the server reports."""
    with urllib.request.urlopen(status, timeout=60) as reply:
        report: dict[str, Any] = json.load(reply)
    return report


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
    try:
        sys.exit(measure(sys.argv[1:]))
    except Failure as failure:
        print(failure, file=sys.stderr)
        sys.exit(2)
