# SPDX-License-Identifier: MIT
"""What works in a build folder stays until something better stands."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from toolchain import compiler_cache
from toolchain.cmake import BuildFolder
from toolchain.console import Failure

PROJECT = """cmake_minimum_required(VERSION 3.22)
project(tiny NONE)
set(TASTE "" CACHE STRING "")
if(TASTE STREQUAL none)
	message(FATAL_ERROR "error: there is no such taste")
endif()
add_custom_command(OUTPUT cake COMMAND ${CMAKE_COMMAND} -E echo ${TASTE} > cake VERBATIM)
add_custom_command(OUTPUT burnt COMMAND ${CMAKE_COMMAND} -E false)
add_custom_target(good DEPENDS cake)
add_custom_target(bad DEPENDS burnt)
"""


class Clone:
    """A tiny project with a build folder."""

    def __init__(self, folder: Path) -> None:
        folder.mkdir(exist_ok=True)
        (folder / "CMakeLists.txt").write_text(PROJECT, encoding="utf-8")
        self.build = BuildFolder(folder / "build", "a cake", folder)

    def make(self, taste: str, target: str = "good") -> None:
        self.build.make({"TASTE": taste}, [target], "")

    def cake(self) -> str:
        return (self.build.folder / "cake").read_text(encoding="utf-8").strip()


@pytest.fixture
def clone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Clone:
    monkeypatch.setattr(compiler_cache, "environment", lambda: dict(os.environ))
    return Clone(tmp_path / "clone")


def test_what_has_not_changed_is_not_configured(
    clone: Clone, capsys: pytest.CaptureFixture[str]
) -> None:
    clone.make("apple")
    assert "configure a cake" in capsys.readouterr().err
    clone.make("apple")
    assert "configure" not in capsys.readouterr().err
    assert clone.cake() == "apple"


def test_a_change_says_itself_and_throws_nothing_away(
    clone: Clone, capsys: pytest.CaptureFixture[str]
) -> None:
    clone.make("apple")
    kept = clone.build.folder / "kept"
    kept.touch()
    clone.make("plum")
    assert "configure a cake: TASTE has changed" in capsys.readouterr().err
    assert clone.cake() == "plum"
    assert kept.exists()


def test_what_cannot_be_configured_leaves_what_works(clone: Clone) -> None:
    clone.make("apple")
    with pytest.raises(Failure, match="there is no such taste"):
        clone.make("none")
    assert clone.cake() == "apple"
    clone.make("plum")
    assert clone.cake() == "plum"


def test_a_first_attempt_that_failed_is_made_again(clone: Clone) -> None:
    with pytest.raises(Failure, match="there is no such taste"):
        clone.make("none")
    clone.make("apple")
    assert clone.cake() == "apple"


def test_a_moved_clone_builds_anew_and_says_so(
    clone: Clone, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    clone.make("apple")
    shutil.move(tmp_path / "clone", tmp_path / "moved")
    moved = Clone(tmp_path / "moved")
    moved.make("apple")
    assert "configure a cake: the clone was moved" in capsys.readouterr().err
    assert sorted(path.name for path in tmp_path.glob("moved/build*")) == ["build"]


def test_the_old_build_stays_while_the_new_one_does_not_stand(clone: Clone, tmp_path: Path) -> None:
    clone.make("apple")
    shutil.move(tmp_path / "clone", tmp_path / "moved")
    moved = Clone(tmp_path / "moved")
    with pytest.raises(Failure, match="Building a cake failed"):
        moved.make("plum", "bad")
    assert moved.cake() == "apple"
    assert sorted(path.name for path in tmp_path.glob("moved/build*")) == ["build"]
    # Whoever is killed in between leaves both.
    shutil.move(moved.build.folder, tmp_path / "moved" / "build.before")
    moved.build.folder.mkdir()
    moved.make("plum")
    assert moved.cake() == "plum"
    assert sorted(path.name for path in tmp_path.glob("moved/build*")) == ["build"]


def test_a_build_goes_on_with_the_tool_it_has(
    clone: Clone, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = str(clone.build.folder)
    source = str(clone.build.folder.parent)
    generate = ["cmake", "-S", source, "-B", folder, "-G", "Unix Makefiles", "-DTASTE=apple"]
    subprocess.run(generate, check=True, capture_output=True)
    clone.make("apple")
    assert clone.cake() == "apple"
    assert "configure" not in capsys.readouterr().err
    assert clone.build.record()["CMAKE_GENERATOR"] == "Unix Makefiles"


def test_a_tool_that_is_gone_is_named(
    clone: Clone, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    clone.make("apple")
    file = clone.build.folder / "CMakeCache.txt"
    text = file.read_text(encoding="utf-8")
    program = clone.build.record()["CMAKE_MAKE_PROGRAM"]
    file.write_text(text.replace(f"={program}\n", f"={tmp_path}/gone\n"), encoding="utf-8")
    clone.make("apple")
    assert f"configure a cake: {tmp_path}/gone is gone" in capsys.readouterr().err
    assert clone.cake() == "apple"
