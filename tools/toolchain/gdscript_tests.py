# SPDX-License-Identifier: MIT
"""The GDScript tests, in headless Godot."""

from __future__ import annotations

import os
import re
import tempfile
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor

from .durations import keep_durations, read_durations
from .godot import Godot
from .outcome import Outcome
from .paths import ROOT

# A test that hangs is ended by the runner itself; a busy machine takes five times as long.
LIMIT_S = 3600
LONG_FILES = 40


def run_gdscript(godot: Godot, text: str) -> Outcome:
    """Runs the GDScript tests, side by side; a hang ends after a while, and is named."""
    # Frames come as fast as they can: nobody watches, and a simulated minute takes seconds.
    arguments = ["--fixed-fps", "60", "--path", str(ROOT)]
    arguments += ["-s", "res://tests/framework/test_runner.gd", "--"]
    arguments += [f"--filter={text}"] if text else []
    # Those begin first; the others follow, whatever has been claimed.
    arguments += [f"tests/{file}" for file in _longest()] + ["tests"]
    # Some tests wait for the clock: one more than there are processors.
    runners = (os.cpu_count() or 2) + 1
    with tempfile.TemporaryDirectory() as claims, ThreadPoolExecutor(runners) as pool:
        command = [*arguments, f"--claims={claims}"]
        outcome = Outcome()
        for one in pool.map(lambda number: _run_gdscript(godot, command, number), range(runners)):
            outcome.add(one)
    return outcome if text or outcome.passed + outcome.failed > 0 else Outcome(0, 1)


def _run_gdscript(godot: Godot, command: list[str], number: int) -> Outcome:
    # Each has its own user://.
    home = f"test-home-{number}"
    code, output = godot.call(command, LIMIT_S, home=home)
    print(output)
    match = re.search(r"^(\d+) passed, (\d+) failed", output, re.M)
    if match is None:
        return Outcome(0, 1, [f"gdscript: the runner did not finish (exit {code})"])
    passed, failed = int(match.group(1)), int(match.group(2))
    # Who is left without a file says so and fails.
    if code != 0 and failed == 0 and passed > 0:
        failed = 1
    keep_durations(read_times(output))
    leaks = find_leaks(output)
    return Outcome(passed, failed + len(leaks), [f"gdscript: {leak}" for leak in leaks])


def _longest() -> list[str]:
    """The files that took longest last time, longest first."""
    known = {name: s for name, s in read_durations().items() if name.endswith(".gd")}
    files = sorted(known, key=lambda name: -known[name])[:LONG_FILES]
    return [name for name in files if (ROOT / "tests" / name).exists()]


def read_times(output: str) -> dict[str, float]:
    """How long each file took, s, by what a runner has printed."""
    seconds: dict[str, float] = defaultdict(float)
    for file, milliseconds in re.findall(r"^(?:ok  |FAIL) (\S+)  \S+  \((\d+) ms\)", output, re.M):
        seconds[file] += int(milliseconds) / 1000.0
    return seconds


def find_leaks(output: str) -> list[str]:
    """What the engine says at its end of what nobody has freed; --verbose has it name each."""
    return re.findall(
        r"^(?:WARNING|ERROR): (.*(?:leaked|in use|in use exist) at exit.*)", output, re.M
    )
