# SPDX-License-Identifier: MIT
"""Sanitizers run where what they look at has changed."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from toolchain import cpp_tests, passed, tracked
from toolchain.cpp_tests import Sanitized, run_sanitizers
from toolchain.outcome import Outcome


class Runs:
    """Sanitized tests that come to what they are told, and the sources that they are made from."""

    def __init__(self, root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.root = root
        self.result = Outcome(3, 0)
        self.ran: list[str] = []
        (root / "gdextension" / "wire" / "tests" / "corpus" / "people").mkdir(parents=True)
        self.write("wire/a.cpp", "1")
        subprocess.run(["git", "init", "-q", str(root)], check=True)
        monkeypatch.setattr(tracked, "ROOT", root)
        monkeypatch.setattr(cpp_tests, "contents", lambda names: passed.contents(names, root))
        monkeypatch.setattr(cpp_tests, "_run_sanitized", self._run)

    def write(self, name: str, text: str) -> None:
        (self.root / "gdextension" / name).write_text(text, encoding="utf-8")

    def _run(self, build: Sanitized) -> Outcome:
        self.ran.append(build.folder)
        return self.result

    def look(self, again: bool = False) -> tuple[list[str], Outcome]:
        self.ran = []
        outcome = run_sanitizers(again)
        return self.ran, outcome


ALL = ["sanitized-memory", "sanitized-threads"]


@pytest.fixture
def runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Runs:
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path / "cache"))
    return Runs(tmp_path / "clone", monkeypatch)


def test_what_is_not_run_is_not_counted(runs: Runs) -> None:
    assert runs.look() == (ALL, Outcome(6, 0))
    ran, outcome = runs.look()
    assert ran == []
    assert (outcome.passed, outcome.failed) == (0, 0)
    assert len(outcome.notes) == 2
    assert outcome.notes[0].startswith(
        "sanitizers (address,undefined): not run, unchanged since 3 tests passed on 20"
    )
    assert runs.look(again=True) == (ALL, Outcome(6, 0))


def test_sources_and_corpora_count(runs: Runs) -> None:
    for name in ("wire/a.cpp", "wire/b.hpp", "wire/w.cmake", "wire/tests/corpus/people/crash.bin"):
        runs.look()
        runs.write(name, "changed")
        assert runs.look()[0] == ALL, name
    runs.write("wire/README.md", "changed")
    assert runs.look()[0] == []


def test_a_failure_runs_again(runs: Runs) -> None:
    for result in (Outcome(2, 1), Outcome(0, 0)):
        runs.result = result
        assert runs.look()[0] == ALL
        assert runs.look()[0] == ALL
    runs.result = Outcome(3, 0)
    assert runs.look()[0] == ALL
    assert runs.look()[0] == []
