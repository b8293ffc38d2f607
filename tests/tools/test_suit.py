# SPDX-License-Identifier: MIT
"""What ./run suit-emulator makes of its options."""

from __future__ import annotations

from pathlib import Path

import pytest
from toolchain import suit
from toolchain.console import Failure
from toolchain.godot import Godot

ENGINE = Godot(Path("godot"), "4.6.3.stable", "4.6.3.stable")


@pytest.fixture(autouse=True)
def _no_engine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(suit, "motion_stream", lambda _godot, bvh: Path("/motion") / bvh.name)


def test_files_are_meant_where_the_user_is(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISMOUNT_CWD", "/home/me")
    options = suit.complete(ENGINE, ["--trace=t.csv", "--log=/tmp/l", "--bvh=walk.bvh"])
    assert "--trace=/home/me/t.csv" in options
    assert "--log=/tmp/l" in options
    assert "--stream=/motion/walk.bvh" in options
    assert not any(option.startswith("--bvh") for option in options)


def test_few_trackers_sit_where_they_tell_most() -> None:
    assert "--limbs=" + ",".join(suit.ORDER) in suit.complete(ENGINE, [])
    five = suit.complete(ENGINE, ["--sensors=5"])
    assert "--limbs=pelvis,left_forearm,right_forearm,left_shank,right_shank" in five
    own = suit.complete(ENGINE, ["--limbs=head,pelvis"])
    assert "--limbs=head,pelvis" in own
    assert sorted(suit.MOUNTS) == sorted(suit.ORDER)


def test_flags_stay_flags_and_words_are_refused() -> None:
    assert "--hold" in suit.complete(ENGINE, ["--hold", "--corrupt=0.1"])
    with pytest.raises(Failure, match="behind '--'"):
        suit.complete(ENGINE, ["walk.bvh"])


def test_no_motion_file_is_a_sentence(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.undo()
    with pytest.raises(Failure, match="There is no file"):
        suit.motion_stream(ENGINE, tmp_path / "none.bvh")
