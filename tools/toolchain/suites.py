# SPDX-License-Identifier: MIT
"""Large parts of the tests that run side by side, and what fails of them once more, alone.

One of them alone leaves processors idle: its tests wait for clocks and for one another.
"""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import Protocol

from .console import say, tail
from .flaky import Ledger, Sighting
from .outcome import Outcome
from .paths import ROOT

# More that fail at once have lost no race: something is broken.
MOST_AGAIN = 10


@dataclass
class Result:
    """What has come of a run of a suite."""

    passed: set[str] = field(default_factory=set)
    skipped: int = 0
    failed: dict[str, str] = field(default_factory=dict)
    """What was said of each test that failed, by its name."""
    faults: list[str] = field(default_factory=list)
    """What is wrong besides, such as a runner that did not finish: each counts as a failure."""


class Suite(Protocol):
    """A part of the tests whose tests have names."""

    name: str

    def run(self) -> Result:
        """Runs all."""
        ...

    def run_again(self, failed: Iterable[str]) -> Result:
        """Runs those once more, with nothing beside them."""
        ...


def run_suites(suites: list[Suite], ledger: Ledger | None) -> Outcome:
    """Runs suites at once, then what failed of them; the ledger takes those that passed then."""
    say(f"\n=== {', '.join(suite.name for suite in suites)}")
    begin = time.monotonic()
    with ThreadPoolExecutor(len(suites)) as pool:
        firsts = list(pool.map(lambda suite: suite.run(), suites))
    load = f"{os.getloadavg()[0]:.1f}"
    outcome = Outcome()
    sightings: list[Sighting] = []
    for suite, first in zip(suites, firsts, strict=True):
        again = Result()
        if 0 < len(first.failed) <= MOST_AGAIN:
            say(f"=== {suite.name}: {len(first.failed)} failed; they run once more, alone")
            again = suite.run_again(first.failed)
        part, saved = judge(suite.name, first, again)
        say(f"=== {suite.name}: {part.passed} passed, {part.failed} failed")
        outcome.add(part)
        sightings += saved
    outcome.add(note(ledger, sightings, load))
    say(f"=== together {time.monotonic() - begin:.0f} s")
    return outcome


def judge(name: str, first: Result, again: Result) -> tuple[Outcome, list[Sighting]]:
    """Counts what passed and failed; what failed and then passed alone has passed, and is told."""
    notes = [f"{name}: {first.skipped} skipped"] if first.skipped else []
    notes += [f"{name}: {fault}" for fault in first.faults]
    notes += [f"{name}: {fault} when it ran what had failed" for fault in again.faults]
    saved = [Sighting(test, said) for test, said in first.failed.items() if test in again.passed]
    failed = len(first.failed) - len(saved) + len(first.faults)
    return Outcome(len(first.passed) + len(saved), failed, notes), saved


def note(ledger: Ledger | None, sightings: list[Sighting], load: str) -> Outcome:
    """Tells of flaky tests; those that are so too often have failed after all."""
    if ledger is None:
        texts = [f"FLAKY {one.test}\n{tail(one.said, 40)}" for one in sightings]
        return Outcome(0, 0, texts)
    command = ["git", "rev-parse", "--short", "HEAD"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    outcome = Outcome()
    now = time.strftime("%Y-%m-%d %H:%M")
    for flaky in ledger.note(sightings, now, done.stdout.strip() or "?", load):
        outcome.notes += [flaky.describe(), f"  load {load}; it said last:", tail(flaky.said, 40)]
        outcome.failed += flaky.is_too_often()
        outcome.passed -= flaky.is_too_often()
    return outcome
