# SPDX-License-Identifier: MIT
"""What ./run level makes of its arguments."""

from __future__ import annotations

from pathlib import Path

import pytest
from toolchain import level
from toolchain.console import Failure


@pytest.fixture
def called(monkeypatch: pytest.MonkeyPatch) -> list[list[str]]:
    calls: list[list[str]] = []

    def note(arguments: list[str]) -> int:
        calls.append(arguments)
        return 0

    monkeypatch.setattr(level, "_call", note)
    monkeypatch.setenv("DISMOUNT_CWD", "/home/me")
    return calls


def test_names_of_ours_stay_and_paths_are_meant_where_the_user_is(
    called: list[list[str]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert level.main(["pack", "hall"]) == 0
    assert level.main(["pack", "hall", "--out=share"]) == 0
    monkeypatch.setenv("DISMOUNT_CWD", str(tmp_path))
    (tmp_path / "range").mkdir()
    assert level.main(["pack", "range", "--out=/srv/levels"]) == 0
    assert level.main(["verify", "range"]) == 0
    assert level.main(["check", "town"]) == 0
    assert called == [
        ["pack", "hall", "--out=/home/me/levels"],
        ["pack", "hall", "--out=/home/me/share"],
        ["pack", str(tmp_path / "range"), "--out=/srv/levels"],
        ["verify", str(tmp_path / "range")],
        ["check", "town"],
    ]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], "pack, verify"),
        (["pak", "hall"], "did you mean pack?"),
        (["pack"], "usage: ./run level pack NAME"),
        (["pack", "hall", "yard"], "usage: ./run level pack NAME"),
        (["pack", "hall", "--ot=x"], "There is no option --ot=x"),
        (["verify"], "usage: ./run level verify FOLDER"),
        (["check"], "usage: ./run level check NAME"),
    ],
)
def test_wrong_calls_say_what_is_right(
    called: list[list[str]], arguments: list[str], words: str
) -> None:
    with pytest.raises(Failure, match=words.replace("?", r"\?")) as failure:
        level.main(arguments)
    assert failure.value.code == 2
    assert not called


def test_help_names_every_verb() -> None:
    for verb in level.VERBS.values():
        assert verb.usage in level.help_text()
