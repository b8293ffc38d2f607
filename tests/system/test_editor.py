# SPDX-License-Identifier: MIT
"""Opens the project in the engine's editor, and plays it as the editor's Play does."""

from __future__ import annotations

import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest
from toolchain.godot import Godot, find
from toolchain.paths import ROOT

from .conftest import SOFTWARE, World

# Enough for the editor to load a scene, draw it and see which textures it uses in 3D; fewer leave
# threads of it at work when it ends.
FRAMES = 4000
HALL = "res://scenes/world/hall/hall.tscn"
# What a virtual display without Vulkan and V-Sync says of itself, and the bindings' own project,
# which is none of this one.
KNOWN = ("VK_KHR_surface", "err != OK", "V-Sync", "Detected another project.godot")


@pytest.fixture(scope="session")
def godot() -> Godot:
    return find()


def call_git(folder: Path, *arguments: str) -> str:
    named = ["-c", "user.name=test", "-c", "user.email=test@localhost", "-c", "core.autocrlf=false"]
    done = subprocess.run(
        ["git", *named, *arguments], cwd=folder, capture_output=True, text=True, check=True
    )
    return done.stdout


def complaints(log: str) -> list[str]:
    found = [line for line in log.splitlines() if "WARNING" in line or "ERROR" in line]
    return [line for line in found if not any(known in line for known in KNOWN)]


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """The project in a repository of its own, with what ./run has built and imported."""
    folder = tmp_path / "project"
    listed = call_git(ROOT, "ls-files", "-co", "--exclude-standard", "-z")
    for name in filter(None, listed.split("\0")):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name)
    shutil.copytree(ROOT / "gdextension" / "bin", folder / "gdextension" / "bin")
    shutil.copytree(ROOT / ".godot", folder / ".godot")
    call_git(folder, "init", "-q")
    call_git(folder, "add", "-A")
    call_git(folder, "commit", "-q", "-m", "as it is")
    return folder


def test_opening_the_editor_changes_no_file(
    copy: Path, godot: Godot, world: World, display: dict[str, str]
) -> None:
    shutil.rmtree(copy / ".godot" / "editor", ignore_errors=True)
    command = [str(godot.program), *SOFTWARE, "--path", str(copy), "--editor", HALL]
    command += ["--quit-after", str(FRAMES)]
    editor = world.start("editor", command, display, reports=False)
    assert editor.await_exit(600) == 0, editor.log()
    assert HALL in (copy / ".godot" / "editor" / "editor_layout.cfg").read_text(encoding="utf-8")
    assert complaints(editor.log()) == []
    assert call_git(copy, "status", "--porcelain") == ""


def test_play_starts_a_session(godot: Godot, world: World, display: dict[str, str]) -> None:
    # With the engine's own debugger, as the editor starts it.
    command = [str(godot.program), *SOFTWARE, "--debug", "--path", str(ROOT)]
    player = world.start("player", command, display, reports=False)
    player.await_text("joined 127.0.0.1:")
    # Any number: a try before the server listened may have taken the first one.
    player.await_text(" from 127.0.0.1 joined")
    assert complaints(player.log()) == []
    assert player.log().count("Dismount ") == 2, "a trainee and a server"
    player.process.send_signal(signal.SIGKILL)
    player.process.wait()
    # The server writes into the same log: it has no window, and nobody who would end it.
    end = time.monotonic() + 60.0
    while "the process that it was to end with has ended" not in player.log():
        assert time.monotonic() < end, player.log()
        time.sleep(0.1)
