# SPDX-License-Identifier: MIT
"""The screen of the stage: what a performer does is seen on it while he does it."""

from __future__ import annotations

import json

import pytest

from .conftest import run_in_window

MIN_PERSON = 75
"""Pixels of the screen that a person changes at least, of 178 x 100."""


@pytest.fixture(scope="module")
def seen(display: dict[str, str]) -> dict[str, int]:
    """What stage_screen.gd finds in a window."""
    # A tenth of a second a frame, however long it takes to draw one.
    flags = ["--fixed-fps", "10"]
    said = run_in_window(display, "stage_screen.gd", *flags)
    lines = [line for line in said.splitlines() if line.startswith("{")]
    assert lines, said
    found: dict[str, int] = json.loads(lines[0])
    return found


def test_the_screen_shows_who_performs_and_what_he_does(seen: dict[str, int]) -> None:
    assert seen["still"] < MIN_PERSON / 3, seen
    assert seen["comes"] > MIN_PERSON, seen
    assert seen["moves"] > max(MIN_PERSON / 3, seen["still"] * 2), seen


def test_no_pictures_are_taken_while_nobody_sees_the_screen(seen: dict[str, int]) -> None:
    assert seen["unseen"] == 0, seen
