# SPDX-License-Identifier: MIT
"""What has passed is known by its content, in all clones."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest
from toolchain import passed
from toolchain.passed import Passed


@pytest.fixture(autouse=True)
def store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path))
    return tmp_path / "dismount" / "passed" / "lint"


def test_a_mark_holds_for_the_same_content_only() -> None:
    marks = Passed("lint", "rules")
    marks.add(marks.key("name", "content"), "12 tests")
    assert Passed("lint", "rules").find(marks.key("name", "content")) == "12 tests"
    assert marks.find(marks.key("name", "other content")) is None
    assert marks.find(marks.key("namec", "ontent")) is None
    other = Passed("lint", "other rules")
    assert other.find(other.key("name", "content")) is None
    assert Passed("format", "rules").find(marks.key("name", "content")) is None


def test_other_tools_pass_everything_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    key = Passed("lint").key("content")
    requirements = tmp_path / "requirements.txt"
    requirements.write_text("gdtoolkit==99\n", encoding="utf-8")
    monkeypatch.setattr(passed, "REQUIREMENTS", requirements)
    assert Passed("lint").key("content") != key


def test_marks_that_nobody_asks_for_go(store: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    marks = Passed("lint")
    for name in ("old", "asked", "new"):
        marks.add(name)
    for name in ("old", "asked"):
        os.utime(store / name, (0, time.time() - passed.OLD_S - 1000))
    assert marks.find("asked") == ""
    marks.prune()
    assert sorted(path.name for path in store.iterdir()) == ["asked", "new"]
    monkeypatch.setattr(passed, "MOST", 1)
    os.utime(store / "asked", (0, time.time() - 1000))
    marks.prune()
    assert [path.name for path in store.iterdir()] == ["new"]
