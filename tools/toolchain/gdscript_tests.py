# SPDX-License-Identifier: MIT
"""The GDScript tests, in headless Godot."""

from __future__ import annotations

import re
import shutil
import tempfile
from collections import defaultdict
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import takewhile

from .console import say, tail
from .durations import keep_durations, read_durations
from .godot import Godot
from .paths import BUILD, ROOT
from .suites import Result

# A test that hangs is ended by the runner itself; a busy machine takes five times as long.
LIMIT_S = 3600
LONG_FILES = 40
# A line of a test: whether it holds, its file, its name, and how long it took, ms.
VERDICT = re.compile(r"^(ok  |FAIL) (\S+)  (\S+)  \((\d+) ms\)", re.M)
# Lines before a test's verdict that are of use where it fails.
SAID_BEFORE = 60
# What a verbose engine says that is of no use there.
NOISE = re.compile(r"^(?:Loading resource|Orphan StringName): .*\n", re.M)


@dataclass
class GDScriptSuite:
    """The GDScript tests, shared by several runners."""

    godot: Godot
    text: str = ""
    runners: int = 1
    name: str = "gdscript"

    def run(self) -> Result:
        """Runs all, side by side; a hang ends after a while, and is named."""
        arguments = [f"--filter={self.text}"] if self.text else []
        # Those begin first; the others follow, whatever has been claimed.
        arguments += [f"tests/{file}" for file in _longest()] + ["tests"]
        with tempfile.TemporaryDirectory() as claims, ThreadPoolExecutor(self.runners) as pool:
            options = [f"--claims={claims}", *arguments]
            parts = list(pool.map(lambda one: self._run(options, one), range(self.runners)))
        whole = Result()
        for part in parts:
            whole.passed |= part.passed
            whole.failed.update(part.failed)
            whole.faults += part.faults
        if not (self.text or whole.passed or whole.failed or whole.faults):
            whole.faults.append("no tests were found")
        return whole

    def run_again(self, failed: Iterable[str]) -> Result:
        """Runs those, each in an engine of its own."""
        whole = Result()
        for name in failed:
            part = self._run([f"--filter={name}", f"tests/{name.split()[0]}"], 0)
            whole.passed |= part.passed & {name}
            whole.failed.update(part.failed)
            whole.faults += part.faults
        return whole

    def _run(self, options: list[str], number: int) -> Result:
        # Frames come as fast as they can: nobody watches, and a simulated minute takes seconds.
        # Verbose, the engine names what it finds left at its end.
        command = ["--verbose", "--fixed-fps", "60", "--path", str(ROOT)]
        command += ["-s", "res://tests/framework/test_runner.gd", "--", *options]
        # Each has its own user://, empty as on a fresh machine.
        home = f"test-home-{number}"
        shutil.rmtree(BUILD / home / "data" / "godot" / "app_userdata", ignore_errors=True)
        code, output = self.godot.call(command, LIMIT_S, home=home)
        output = NOISE.sub("", output)
        keep_durations(read_times(output))
        result = read_output(output)
        # Two thousand lines would hide the few that are of use.
        say(output if self.text else "\n".join(result.failed.values()))
        is_ended = re.search(r"^\d+ passed, \d+ failed", output, re.M) is not None
        # Who is left without a file says so and fails.
        if not is_ended or (code != 0 and result.passed and not result.failed):
            result.faults.append(f"a runner did not finish (exit {code}):\n{tail(output)}")
        return result


def read_output(output: str) -> Result:
    """What a runner has printed: its tests, what those that failed said, and leaks."""
    result = Result(faults=find_leaks(output))
    said: list[str] = []
    lines = output.splitlines()
    for at, line in enumerate(lines):
        match = VERDICT.match(line)
        if match is None:
            said.append(line)
            continue
        name = f"{match[2]} {match[3]}"
        if match[1] == "FAIL":
            faults = takewhile(lambda text: text.startswith("     "), lines[at + 1 :])
            result.failed[name] = "\n".join([*said[-SAID_BEFORE:], line, *faults])
        else:
            result.passed.add(name)
        said = []
    return result


def _longest() -> list[str]:
    """The files that took longest last time, longest first."""
    known = {name: s for name, s in read_durations().items() if name.endswith(".gd")}
    files = sorted(known, key=lambda name: -known[name])[:LONG_FILES]
    return [name for name in files if (ROOT / "tests" / name).exists()]


def read_times(output: str) -> dict[str, float]:
    """How long each file took, s, by what a runner has printed."""
    seconds: dict[str, float] = defaultdict(float)
    for match in VERDICT.finditer(output):
        seconds[match[2]] += int(match[4]) / 1000.0
    return seconds


def find_leaks(output: str) -> list[str]:
    """What the engine says at its end of what nobody has freed, with the name of each."""
    leaks = re.findall(
        r"^(?:WARNING|ERROR): (.*(?:leaked|in use|in use exist) at exit.*)", output, re.M
    )
    named = re.findall(r"^(?:Leaked instance|Resource still in use): .*", output, re.M)
    if any(name.endswith("(GDScript)") for name in named):
        # Scripts are the engine's own to free, and those that name each other it does not always
        # untangle (4.6.3, by the order in which they were read); what is static of them stays too.
        return [leak for leak in leaks if not re.search("instances|resources", leak)]
    return ["\n".join([leaks[0], *named]), *leaks[1:]] if leaks else []
