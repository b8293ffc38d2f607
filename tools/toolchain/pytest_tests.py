# SPDX-License-Identifier: MIT
"""What is written for pytest: the tools' own tests, bindings, whole processes.

A test that fails runs once more, alone, when all others are done: see flaky.py.
"""

from __future__ import annotations

import os
import subprocess
import time
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from pathlib import Path

from .console import say, tail
from .flaky import Flaky, Ledger, Sighting
from .godot import Godot
from .outcome import Outcome
from .paths import BUILD, ROOT, cache
from .project import EXTENSIONS

TESTS = ["tests", "gdextension/bindings/tests", "--ignore=tests/kernel"]
# What failed last time, and nothing where nothing did.
AGAIN = ["--last-failed", "--last-failed-no-failures=none"]
# More that fail at once have lost no race: something is broken.
MOST_AGAIN = 10
SLOWEST = 25


@dataclass
class Result:
    """What pytest has reported of a run."""

    passed: set[str] = field(default_factory=set)
    skipped: int = 0
    failed: dict[str, str] = field(default_factory=dict)
    """What was said of each test that failed, by its name."""
    fault: str = ""
    """Why there is no report."""


def run_pytest(godot: Godot, tools: Path, text: str, chosen: list[str] | None = None) -> Outcome:
    """Runs the tests with as many workers as there are processors, then what failed, alone."""
    environment = {
        **godot.environment(),
        "DISMOUNT_GODOT": str(godot.program),
        "DISMOUNT_BUILD": str(EXTENSIONS),
        "DISMOUNT_USER_CACHE": str(cache().parent),
        "PYTHONPATH": str(ROOT / "tools"),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    pytest = [str(tools / "pytest"), "-p", "toolchain.schedule"]
    pytest += ["-o", f"cache_dir={BUILD / 'pytest-cache'}"]
    pytest += [*(TESTS if chosen is None else chosen), *(["-k", text] if text else [])]
    is_whole = chosen is None and not text
    # They take seconds to start, which a few tests are not worth.
    workers = ["-n", str(os.cpu_count() or 2)] if is_whole else []
    first = _run([*pytest, *workers, f"--durations={SLOWEST}"], environment)
    if first.fault:
        return Outcome(0, 1, [f"system: {first.fault}"])
    load = f"{os.getloadavg()[0]:.1f}"
    again: Result | None = None
    if 0 < len(first.failed) <= MOST_AGAIN:
        say(f"=== system: {len(first.failed)} failed; they run once more, alone")
        again = _run([*pytest, *AGAIN], environment)
    # A part of the tests tells nothing of how often a test is flaky.
    return judge(first, again, load, Ledger(cache()) if is_whole else None)


def judge(first: Result, again: Result | None, load: str, ledger: Ledger | None) -> Outcome:
    """Counts what passed and failed; a test that failed and then passed alone is noted as flaky."""
    notes = [f"system: {first.skipped} skipped"] if first.skipped else []
    if again is not None and again.fault:
        notes.append(f"system: {again.fault} when it ran what had failed")
    saved = again.passed if again is not None else set()
    sightings = [Sighting(name, said) for name, said in first.failed.items() if name in saved]
    failed = len(first.failed) - len(sightings)
    for flaky in _note(ledger, sightings, load):
        notes += [flaky.describe(), f"  load {load}; it said last:", tail(flaky.said, 40)]
        failed += flaky.is_too_often()
    return Outcome(len(first.passed) + len(first.failed) - failed, failed, notes)


def _note(ledger: Ledger | None, sightings: list[Sighting], load: str) -> list[Flaky]:
    if ledger is None:
        return [Flaky(one.test, 1, one.said, BUILD / "pytest.xml") for one in sightings]
    done = subprocess.run(
        ["git", "rev-parse", "--short", "HEAD"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    return ledger.note(sightings, time.strftime("%Y-%m-%d %H:%M"), done.stdout.strip() or "?", load)


def _run(command: list[str], environment: dict[str, str]) -> Result:
    report = BUILD / "pytest.xml"
    report.unlink(missing_ok=True)
    command = [*command, f"--junitxml={report}"]
    code = subprocess.run(command, cwd=ROOT, env=environment, check=False).returncode
    if not report.exists():
        return Result(fault=f"pytest did not finish (exit {code})")
    result = read_report(report)
    if code not in (0, 1, 5) and not result.failed:
        result.fault = f"pytest ended with {code}"
    return result


def read_report(report: Path) -> Result:
    """What a report in JUnit's format says."""
    result = Result()
    for case in ElementTree.parse(report).getroot().iter("testcase"):
        name = f"{case.get('classname')}::{case.get('name')}"
        faults = [*case.findall("failure"), *case.findall("error")]
        if faults:
            said = "\n".join(fault.text or fault.get("message") or "" for fault in faults)
            # A test and its end can fail both.
            result.failed[name] = f"{result.failed.get(name, '')}{said}"
        elif case.find("skipped") is not None:
            result.skipped += 1
        else:
            result.passed.add(name)
    result.passed -= set(result.failed)
    return result
