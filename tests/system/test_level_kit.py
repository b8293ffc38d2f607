# SPDX-License-Identifier: MIT
"""Follows docs/tutorial.md in the real editor, by keyboard and mouse, and tries the level."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest
from toolchain.display import virtual_display
from toolchain.godot import Godot
from tutorial.editor import Editor
from tutorial.screen import Screen
from tutorial.steps import LEVEL, Tutorial

from .conftest import SOFTWARE, Process, World
from .test_editor import call_git, complaints, copy, godot  # noqa: F401

# In a busy machine's time; docs/measuring.md has what a quiet one takes.
TRY_LIMIT_S = 240.0


@pytest.fixture
def wide() -> Iterator[dict[str, str]]:
    with virtual_display("1280x800x24") as environment:
        yield environment


def sections(scene: Path) -> dict[str, dict[str, str]]:
    """Nodes of a scene as the editor has saved it: their properties by their paths."""
    found: dict[str, dict[str, str]] = {}
    text = scene.read_text(encoding="utf-8")
    for match in re.finditer(r'^\[node name="([^"]+)"([^\n]*)\]\n((?:[^\[\n].*\n)*)', text, re.M):
        parent = re.search(r'parent="([^"]+)"', match.group(2))
        path = match.group(1)
        if parent is not None and parent.group(1) != ".":
            path = f"{parent.group(1)}/{path}"
        found[path] = dict(re.findall(r"^(\S+) = (.*)$", match.group(3), re.M))
    return found


def place(node: dict[str, str]) -> tuple[float, ...]:
    numbers = re.findall(r"-?[\d.]+(?:e-?\d+)?", node.get("transform", "")[12:])
    return tuple(round(float(each), 2) for each in numbers[-3:])


def is_turned(node: dict[str, str]) -> bool:
    """By R: its X goes along -Z."""
    numbers = [float(each) for each in re.findall(r"-?[\d.]+(?:e-?\d+)?", node["transform"][12:])]
    return abs(numbers[0]) < 0.01 and abs(numbers[6] + 1.0) < 0.01


def check_placed(scene: Path) -> None:
    nodes = sections(scene)
    assert place(nodes["Static/House"]) == (-4.25, 0.0, -5.0)
    walls = [name for name in nodes if name.startswith("Static/Wall")]
    assert sorted(place(nodes[name]) for name in walls) == sorted(
        [(6.0, 0.0, 4.0), (10.0, 0.0, 4.0), (6.0, 0.0, -4.0), (10.0, 0.0, -4.0)]
        + [(14.0, 0.0, 0.0), (14.0, 0.0, 4.0), (6.0, 0.0, 0.0), (6.0, 0.0, 4.0)]
    )
    assert sum(is_turned(nodes[name]) for name in walls) == 4
    assert is_turned(nodes["Static/WallWithDoor"])
    assert place(nodes["Props/Door"]) == (6.0, 0.0, 2.5)
    assert is_turned(nodes["Props/Door"])
    crates = [place(nodes[name]) for name in nodes if name.startswith("Props/Crate")]
    assert sorted(crates) == [(10.0, 0.25, 0.0), (10.0, 0.25, 1.0), (11.0, 0.25, 0.0)]
    zone = nodes["TriggerZone"]
    width = float(re.findall(r"[\d.]+", zone["size"][8:])[0])
    assert 5.3 < width < 5.7, zone
    # Its left side has stayed where it was.
    assert abs(place(zone)[0] - width / 2.0 - 6.5) < 0.06, zone
    assert place(nodes["Spawns/SpawnPoint"]) == (0.0, 0.0, 6.0)
    assert "Props/LargeCrate" not in nodes


def test_the_tutorial(copy: Path, godot: Godot, world: World, wide: dict[str, str]) -> None:  # noqa: F811
    probe = world.folder / "probe.json"
    shutil.rmtree(copy / ".godot" / "editor", ignore_errors=True)
    command = [str(godot.program), *SOFTWARE, "--single-window", "--path", str(copy), "--editor"]
    process = world.start(
        "editor", command, {**wide, "DISMOUNT_KIT_PROBE": str(probe)}, reports=False
    )
    screen = Screen(wide["DISPLAY"])
    editor = Editor(screen, probe, lambda: process.process.poll() is None)
    tutorial = Tutorial(editor, world.folder / "pictures")
    try:
        editor.await_start()
        tutorial.run()
        check_placed(copy / "scenes" / "world" / LEVEL / f"{LEVEL}.tscn")
        assert (copy / "scenes" / "world" / LEVEL / f"{LEVEL}.bake").stat().st_size > 10_000
        assert complaints(process.log()) == []
        # What a level uses is saved with it, in the editor's form: all of it has that form already.
        assert call_git(copy, "status", "--porcelain").split() == ["??", f"scenes/world/{LEVEL}/"]
        check_trial(tutorial, process, copy)
    finally:
        screen.close()
        for number in programs_of(copy):
            os.kill(number, signal.SIGKILL)


def programs_of(folder: Path, role: str = "") -> list[int]:
    """Processes that a trial of a project has started, of a role or all."""
    found = []
    for entry in Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):
            words = entry.read_bytes().decode(errors="replace").split("\0")
            if str(folder) in " ".join(words) and any(
                word.startswith(f"--role={role}") for word in words
            ):
                found.append(int(entry.parent.name))
    return found


def check_trial(tutorial: Tutorial, process: Process, folder: Path) -> None:
    """The three programs of a trial write into the editor's log."""
    seconds = tutorial.start_trial(lambda: tutorial.is_on_level(process.log()), TRY_LIMIT_S)
    print(f"Try level: {seconds:.1f} s")
    # Its window may be below others, where a click on its cross does not get.
    for number in programs_of(folder, "trainee"):
        os.kill(number, signal.SIGTERM)
    process.await_text("the process that it was to end with has ended")
