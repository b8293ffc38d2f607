# SPDX-License-Identifier: MIT
"""Stereo and walls in real windows of virtual displays, drawn by the processor."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any

import pytest
from toolchain import wall
from toolchain.console import Failure
from toolchain.godot import Godot
from toolchain.paths import ROOT
from toolchain.screens import monitors

from .conftest import SOFTWARE
from .test_commands import run

SCRIPTS = "res://tests/bench/displays/"
LIMIT_S = 600.0
# What half a wall of 2 m by 1 m is, on a monitor by its name.
HALF = """[screen {name}]
bottom-left = {left} 1 -1.5
bottom-right = {right} 1 -1.5
top-left = {left} 2 -1.5
top-right = {right} 2 -1.5
monitor = {monitor}
"""


def find(
    engine: Godot, script: str, options: list[str], display: dict[str, str]
) -> list[dict[str, Any]]:
    """What a script of the benchmark finds in a window."""
    command = [str(engine.program), "--path", str(ROOT), *SOFTWARE, "--resolution", "640x360"]
    done = subprocess.run(
        [*command, "-s", SCRIPTS + script, "--", *options],
        env={**os.environ, **engine.environment(), **display},
        capture_output=True,
        text=True,
        timeout=LIMIT_S,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "SCRIPT ERROR" not in done.stderr, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]


def test_both_eyes_see_a_target_where_they_should(godot: Godot, display: dict[str, str]) -> None:
    """Of rows, also after the window has moved by one."""
    options = ["--modes=rows", "--origins=40:20,40:21"]
    rows = find(godot, "stereo_targets.gd", options, display)
    rows += find(godot, "stereo_targets.gd", ["--modes=side-by-side"], display)
    assert len(rows) == 5 * 3
    for row in rows:
        assert abs(row["got"] - row["wanted"]) <= 0.1, row


def test_two_monitors_show_one_picture(godot: Godot, tmp_path: Path) -> None:
    layout = tmp_path / "row.cfg"
    text = "[station]\neye = 0.2 1.6 0\n"
    for number, left in enumerate((-1.0, 0.0)):
        text += HALF.format(name=f"s{number}", left=left, right=left + 1.0, monitor=f"m{number}")
    layout.write_text(text)
    with monitors([400, 400], 400, keeps_shaders=True) as display:
        options = ["--case=monitors", f"--layout={layout}", "--pictures="]
        found = find(godot, "wall_pictures.gd", options, display)[-1]
    assert found["screens"] == 2
    assert found["mean"] <= 0.3


def test_a_wall_with_a_bad_layout_says_where_and_how(godot: Godot, tmp_path: Path) -> None:
    layout = tmp_path / "bad.cfg"
    text = HALF.format(name="front", left=-1.0, right=1.0, monitor=0)
    layout.write_text(text.replace("top-left = -1.0 2", "top-left = 3 1"))
    done = run("wall", f"--layout={layout}")
    assert done.returncode == 2, done.stderr
    assert f"{layout}:1: screen front: its corners are in a line" in done.stderr
    text = "[station]\nclients = each\nsync = 127.0.0.1:7790\n" + text
    layout.write_text(text + HALF.format(name="other", left=1.0, right=2.0, monitor=0))
    with pytest.raises(Failure, match="screens other and front share pixels") as raised:
        wall.check(godot, layout)
    assert raised.value.code == 2
