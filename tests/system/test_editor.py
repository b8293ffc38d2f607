# SPDX-License-Identifier: MIT
"""Opens the project in the engine's editor, follows docs/tutorial.md by keyboard and mouse, and
plays it as the editor's Play does."""

from __future__ import annotations

import contextlib
import os
import re
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest
from toolchain.display import virtual_display
from toolchain.godot import Godot
from toolchain.paths import ROOT
from toolchain.processes import await_that
from tutorial.steps import LEVEL, Tutorial

from .conftest import SOFTWARE, Process, World
from .editors import EditedProject, complaints, sections
from .ground import Ground, lay_path, shape

pytestmark = pytest.mark.serial

HALL = "res://scenes/world/hall/hall.tscn"
GROUND = "my_ground"
# Enough for the editor to draw a scene and to see which textures it uses in 3D.
FRAMES = 100
# In a busy machine's time; docs/measuring.md has what a quiet one takes.
TRY_LIMIT_S = 600.0


@pytest.fixture(scope="module")
def project(shared_world: World, godot: Godot) -> Iterator[EditedProject]:
    """An editor that opens a copy of the project for the first time, with a scene."""
    with virtual_display("1280x800x24", keeps_shaders=True) as display:
        opened = EditedProject(shared_world, godot, display, HALL)
        try:
            opened.editor.await_start()
            yield opened
        finally:
            opened.screen.close()
            for number in programs_of(opened.folder):
                os.kill(number, signal.SIGKILL)


def test_opening_the_editor_changes_no_file(project: EditedProject) -> None:
    editor = project.editor
    editor.await_state(lambda s: s["scene"]["path"] == HALL and s["view"]["is_shown"], "the scene")
    editor.await_frames(FRAMES)
    assert project.complaints() == []
    assert project.changes() == []


def test_ground_and_a_path(project: EditedProject, godot: Godot) -> None:
    editor = project.editor
    Tutorial(editor).make_level(GROUND)
    shape(editor, Ground(project.folder, godot.program, project.level_file(GROUND, "height")))
    lay_path(editor)
    editor.save()
    nodes = sections(project.level_file(GROUND, "tscn"))
    assert "Static/Ground" not in nodes
    assert nodes["Static/Terrain"]["height_file"].endswith(f'/{GROUND}.height"')
    numbers = [float(n) for n in re.findall(r"-?[\d.]+", nodes["WaypointPath"]["points"][18:])]
    assert len(numbers) == 9, nodes["WaypointPath"]
    # Beside where the node stands: what is pulled goes over the ground, in steps of 5 cm.
    wanted = [0.0, 0.0, 0.0, 3.0, 0.0, -3.0, 5.0, 0.0, 0.0]
    assert all(abs(a - b) < 0.15 for a, b in zip(numbers, wanted, strict=True)), numbers
    assert project.complaints() == []


def test_the_tutorial(project: EditedProject) -> None:
    tutorial = Tutorial(project.editor)
    tutorial.run()
    check_placed(project.level_file(LEVEL, "tscn"))
    assert project.level_file(LEVEL, "bake").stat().st_size > 10_000
    assert project.complaints() == []
    check_trial(tutorial, project.process, project.folder)


def test_the_editor_ends_in_order_and_has_changed_levels_alone(project: EditedProject) -> None:
    project.process.await_rest()
    before = len(project.process.log())
    for window in project.screen.windows():
        project.screen.shut(window)
    assert project.process.await_exit(600) == 0, project.process.log()
    # Before it programs of a trial have said that they have no sound card.
    assert complaints(project.process.log()[before:]) == []
    # What a level uses is saved with it, in the editor's form: all of it has that form already.
    changed = {line.removeprefix("?? scenes/world/").rstrip("/") for line in project.changes()}
    assert changed <= {LEVEL, GROUND}, changed


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
    tutorial.start_trial(lambda: tutorial.is_on_level(process.log()), TRY_LIMIT_S)
    # Its window may be below others, where a click on its cross does not get.
    for number in programs_of(folder, "trainee"):
        os.kill(number, signal.SIGTERM)
    process.await_text("the process that it was to end with has ended")


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
    mark = "the process that it was to end with has ended"
    await_that(lambda: mark in player.log(), f"'{mark}'", 60.0, player.log)
