# SPDX-License-Identifier: MIT
"""The screen of the stage: what a performer does is seen on it while he does it."""

from __future__ import annotations

import json
import os
import subprocess

import pytest
from toolchain.paths import ROOT

from .conftest import SOFTWARE, WINDOW_LIMIT_S

MIN_PERSON = 300
"""Pixels of the screen that a person changes at least, of 356 x 200."""


@pytest.fixture(scope="module")
def seen(request: pytest.FixtureRequest) -> dict[str, int]:
    """What stage_screen.gd finds in a window."""
    display = request.getfixturevalue("display")
    command = [os.environ["DISMOUNT_GODOT"], "--path", str(ROOT), *SOFTWARE]
    done = subprocess.run(
        [*command, "--resolution", "320x180", "-s", "res://tests/system/stage_screen.gd"],
        capture_output=True,
        text=True,
        check=False,
        timeout=WINDOW_LIMIT_S,
        env={**os.environ, **display},
    )
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    assert lines, done.stdout + done.stderr
    found: dict[str, int] = json.loads(lines[0])
    return found


def test_the_screen_shows_who_performs_and_what_he_does(seen: dict[str, int]) -> None:
    assert seen["still"] < MIN_PERSON / 3, seen
    assert seen["comes"] > MIN_PERSON, seen
    assert seen["moves"] > max(MIN_PERSON / 3, seen["still"] * 2), seen


def test_no_pictures_are_taken_while_nobody_sees_the_screen(seen: dict[str, int]) -> None:
    assert seen["unseen"] == 0, seen
