# SPDX-License-Identifier: MIT
"""Tests that fail and then pass alone: what is noted, what is said, what fails a run."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

import pytest
from toolchain import pytest_tests
from toolchain.flaky import RUNS, TOO_OFTEN, Ledger, Sighting
from toolchain.outcome import Outcome
from toolchain.pytest_tests import read_report
from toolchain.suites import MOST_AGAIN, Result, run_suites

NAME = "tests.system.test_x::test_race"
TESTS = """
import os, pathlib, pytest

FILE = pathlib.Path(os.environ["TRIES"])


def test_holds():
    pass


def test_race():
    tries = len(FILE.read_text()) if FILE.exists() else 0
    FILE.write_text("x" * (tries + 1))
    assert tries > 0, "the first try loses"


def test_broken():
    assert False, "it never holds"


@pytest.fixture
def bad():
    raise OSError("no set-up")


def test_without_set_up(bad):
    pass
"""


def note(ledger: Ledger, *tests: str) -> list[int]:
    """Notes a run; returns how often each test has been flaky."""
    sightings = [Sighting(test, "it said so") for test in tests]
    return [one.count for one in ledger.note(sightings, "2026-01-01 00:00", "abc", "1.0")]


def test_a_test_counts_over_the_last_runs_only(tmp_path: Path) -> None:
    ledger = Ledger(tmp_path)
    assert note(ledger, "a") == [1]
    assert note(ledger, "a", "b") == [2, 1]
    for _quiet in range(RUNS - 2):
        assert note(ledger) == []
    # The first run is out of sight, the second is not.
    assert note(ledger, "a") == [2]
    assert {row["test"] for row in ledger.rows()} == {"a", "b", ""}
    logs = [Path(row["log"]) for row in ledger.rows() if row["test"]]
    assert all("it said so" in log.read_text() for log in logs)


def test_a_damaged_ledger_is_no_reason_to_fail(tmp_path: Path) -> None:
    ledger = Ledger(tmp_path)
    note(ledger, "a")
    with ledger.file.open("a") as file:
        file.write("nonsense\n,,\n")
    assert note(ledger, "a") == [2]


class Told:
    """A suite that comes to what it is told."""

    name = "told"

    def __init__(self, first: Result, again: Result) -> None:
        self._first = first
        self._again = again
        self.asked: list[str] = []

    def run(self) -> Result:
        """The first time."""
        return self._first

    def run_again(self, failed: Iterable[str]) -> Result:
        """Alone."""
        self.asked += failed
        return self._again


def judge(first: Result, again: Result, ledger: Ledger) -> Outcome:
    """What a run comes to that has had these results."""
    return run_suites([Told(first, again)], ledger)


def test_a_flaky_test_fails_the_run_from_the_third_time_on(tmp_path: Path) -> None:
    ledger = Ledger(tmp_path)
    first = Result(passed={"other"}, failed={NAME: "lost a race"})
    again = Result(passed={NAME})
    for count in range(1, TOO_OFTEN + 1):
        outcome = judge(first, again, ledger)
        is_last = count == TOO_OFTEN
        assert (outcome.passed, outcome.failed) == ((1, 1) if is_last else (2, 0))
        said = "\n".join(outcome.notes)
        assert f"FLAKY {NAME}: {count} in the last {RUNS} runs" in said
        assert "load " in said
        assert "lost a race" in said


def test_what_fails_again_or_does_not_run_again_fails(tmp_path: Path) -> None:
    first = Result(passed={"other"}, failed={NAME: "broken"})
    for again in (
        Result(failed={NAME: "broken"}),
        Result(passed={"another"}),
        Result(faults=["pytest did not finish (exit 4)"]),
    ):
        outcome = judge(first, again, Ledger(tmp_path))
        assert (outcome.passed, outcome.failed) == (1, 1)
        assert not any("FLAKY" in note for note in outcome.notes)


def test_a_runner_that_does_not_finish_fails_the_run(tmp_path: Path) -> None:
    outcome = judge(Result(passed={"other"}, faults=["exit 4"]), Result(), Ledger(tmp_path))
    assert (outcome.passed, outcome.failed) == (1, 1)
    assert outcome.notes == ["told: exit 4"]


def test_what_is_broken_as_a_whole_does_not_run_again(tmp_path: Path) -> None:
    failed = {f"test {number}": "broken" for number in range(MOST_AGAIN + 1)}
    suite = Told(Result(failed=failed), Result(passed=set(failed)))
    assert run_suites([suite], Ledger(tmp_path)).failed == MOST_AGAIN + 1
    assert suite.asked == []


def test_suites_that_run_together_are_one_run_of_the_ledger(tmp_path: Path) -> None:
    suites = [Told(Result(failed={name: "late"}), Result(passed={name})) for name in "ab"]
    ledger = Ledger(tmp_path)
    outcome = run_suites([*suites], ledger)
    assert (outcome.passed, outcome.failed) == (2, 0)
    assert [suite.asked for suite in suites] == [["a"], ["b"]]
    assert {row["run"] for row in ledger.rows()} == {"1"}


def run(folder: Path, *options: str) -> Result:
    """Runs the tests of the folder by a pytest of its own."""
    report = folder / "report.xml"
    command = [sys.executable, "-m", "pytest", "-p", "toolchain.schedule", f"--junitxml={report}"]
    command += ["-q", "-o", f"cache_dir={folder / 'cache'}", "--rootdir", str(folder), *options]
    plain = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    done = subprocess.run(
        command, cwd=folder, env=plain, capture_output=True, text=True, check=False
    )
    assert report.exists(), done.stdout + done.stderr
    result = read_report(report)
    report.unlink()
    return result


def test_what_failed_runs_again_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TRIES", str(tmp_path / "tries"))
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path / "user"))
    (tmp_path / "test_x.py").write_text(TESTS)
    first = run(tmp_path, "-n", "1", "test_x.py")
    assert first.passed == {"test_x::test_holds"}
    assert set(first.failed) == {
        f"test_x::test_{name}" for name in ("race", "broken", "without_set_up")
    }
    assert "the first try loses" in first.failed["test_x::test_race"]
    again = run(tmp_path, *pytest_tests.AGAIN, "test_x.py")
    assert again.passed == {"test_x::test_race"}
    assert set(again.failed) == {"test_x::test_broken", "test_x::test_without_set_up"}
    outcome = judge(first, again, Ledger(tmp_path))
    assert (outcome.passed, outcome.failed) == (2, 2)
