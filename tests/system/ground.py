# SPDX-License-Identifier: MIT
"""Shapes ground by the brushes and lays a path by its handles, by the mouse in the real editor."""

from __future__ import annotations

import json
import subprocess
import time
from pathlib import Path

from tutorial.editor import Editor

# In a busy machine's time.
WRITE_LIMIT_S = 300.0


class Ground:
    """The file of heights beside the level."""

    def __init__(self, project: Path, engine: Path, file: Path) -> None:
        self.project = project
        self.engine = engine
        self.file = file

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
    editor.paint((-6.0, 0.0, 3.0), (6.0, 0.0, 3.0))
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
    editor.paint((-6.0, 0.0, -6.0), (6.0, 0.0, -6.0))
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
