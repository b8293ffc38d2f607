# SPDX-License-Identifier: MIT
"""Shapes ground by the brushes and lays a path by its handles in the real editor, by the mouse."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import time
from pathlib import Path

from toolchain.godot import Godot
from tutorial.editor import Editor
from tutorial.screen import Screen
from tutorial.steps import LEVEL, Tutorial

from .conftest import SOFTWARE, World
from .test_editor import complaints, copy, godot  # noqa: F401
from .test_level_kit import sections, wide  # noqa: F401

# In a busy machine's time.
WRITE_LIMIT_S = 60.0
SLOW_STEPS = 80


class Ground:
    """The file of heights beside the level."""

    def __init__(self, project: Path, engine: Path) -> None:
        self.project = project
        self.engine = engine
        self.file = project / "scenes" / "world" / LEVEL / f"{LEVEL}.height"

    def read(self, *places: tuple[float, float]) -> dict:
        script = "res://tests/system/height_map.gd"
        command = [str(self.engine), "--headless", "--path", str(self.project), "-s", script, "--"]
        command += [str(self.file), *(f"{x},{z}" for x, z in places)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        return json.loads(next(line for line in done.stdout.splitlines() if line.startswith("{")))

    def await_written(self, before: bytes, what: str) -> bytes:
        """Waits until the file is another and stays so; returns its bytes."""
        end = time.monotonic() + WRITE_LIMIT_S
        while (now := self.file.read_bytes()) == before or now != self.read_later():
            assert time.monotonic() < end, f"{self.file.name} is not written: {what}"
        return now

    def read_later(self) -> bytes:
        time.sleep(0.5)
        return self.file.read_bytes()


def shape(editor: Editor, ground: Ground) -> None:
    """Makes flat ground, raises a bank, takes it back, makes it again, paints a road."""
    editor.drop("Terrain", (0.0, 0.0, 0.0))
    editor.click("Make flat ground")
    editor.await_state(lambda s: "Static/Ground" not in s["scene"]["nodes"], "no ground block")
    flat = ground.file.read_bytes()
    editor.undo()
    editor.await_state(lambda s: "Static/Ground" in s["scene"]["nodes"], "the ground block again")
    editor.redo()
    editor.await_state(lambda s: "Static/Ground" not in s["scene"]["nodes"], "no ground block")
    assert ground.read() == {"lowest": 0.0, "highest": 0.0, "road": 0, "heights": []}
    editor.choose("Brush", "Raise")
    # Slowly: a brush works once a frame, of which a busy machine has few.
    ends = editor.on_screen((-6.0, 0.0, 3.0)), editor.on_screen((6.0, 0.0, 3.0))
    editor.screen.drag(*ends, steps=SLOW_STEPS)
    bank = ground.await_written(flat, "a bank")
    told = ground.read((0.0, 3.0), (0.0, -12.0))
    assert told["highest"] > 0.2, told
    assert told["lowest"] == 0.0, told
    # Under the pull, and far from it.
    assert told["heights"][0] > 0.1, told
    assert told["heights"][1] == 0.0, told
    editor.undo()
    assert ground.await_written(bank, "ctrl+z") == flat
    editor.redo()
    assert ground.await_written(flat, "ctrl+shift+z") == bank
    editor.choose("Brush", "Road")
    editor.screen.drag(editor.on_screen((-6.0, 0.0, -6.0)), editor.on_screen((6.0, 0.0, -6.0)))
    ground.await_written(bank, "a road")
    told = ground.read()
    assert told["road"] > 50, told
    editor.choose("Brush", "No brush")


def lay_path(editor: Editor) -> None:
    """Places a path, pulls its end, adds a point, adds another and takes it back."""
    path = editor.drop("Waypoint path", (0.0, 0.0, -8.0))
    editor.await_state(lambda s: s["scene"]["selected"] == [path], "the path is selected")
    for title, to, count in (
        ("point 1", (5.0, 0.0, -8.0), 2),
        ("a new point", (3.0, 0.0, -11.0), 3),
        ("a new point", (-1.0, 0.0, -12.0), 4),
    ):
        before = points(editor.state())
        pull(editor, title, to)
        # All handles move with a point: only then the next one can be taken where it is.
        editor.await_state(
            lambda s, n=count, old=before: len(points(s)) == n and points(s) != old,
            f"{count} points, others than before",
        )
    editor.undo()
    editor.await_state(lambda s: len(points(s)) == 3, "ctrl+z takes the last one back")


def points(state: dict) -> list[dict]:
    return [row for row in state["scene"]["handles"] if row["title"].startswith("point ")]


def pull(editor: Editor, title: str, to: tuple[float, float, float]) -> None:
    rows = editor.await_state(lambda s: s["scene"]["handles"], "handles")["scene"]["handles"]
    editor.pull([row["title"] for row in rows].index(title), to)


def test_ground_and_a_path(copy: Path, godot: Godot, world: World, wide: dict[str, str]) -> None:  # noqa: F811
    probe = world.folder / "probe.json"
    shutil.rmtree(copy / ".godot" / "editor", ignore_errors=True)
    command = [str(godot.program), *SOFTWARE, "--single-window", "--path", str(copy), "--editor"]
    process = world.start(
        "editor", command, {**wide, "DISMOUNT_KIT_PROBE": str(probe)}, reports=False
    )
    screen = Screen(wide["DISPLAY"])
    editor = Editor(screen, probe, lambda: process.process.poll() is None)
    try:
        editor.await_start()
        Tutorial(editor, world.folder / "pictures").make_level()
        shape(editor, Ground(copy, godot.program))
        lay_path(editor)
        editor.save()
        editor.state()
        nodes = sections(copy / "scenes" / "world" / LEVEL / f"{LEVEL}.tscn")
        assert "Static/Ground" not in nodes
        assert nodes["Static/Terrain"]["height_file"].endswith(f'/{LEVEL}.height"')
        numbers = [float(n) for n in re.findall(r"-?[\d.]+", nodes["WaypointPath"]["points"][18:])]
        assert len(numbers) == 9, nodes["WaypointPath"]
        # Beside where the node stands: what is pulled goes over the ground, in steps of 5 cm.
        wanted = [0.0, 0.0, 0.0, 3.0, 0.0, -3.0, 5.0, 0.0, 0.0]
        assert all(abs(a - b) < 0.15 for a, b in zip(numbers, wanted, strict=True)), numbers
        assert complaints(process.log()) == []
    finally:
        screen.close()
