# SPDX-License-Identifier: MIT
"""Displays in a session: what a window shows of another display, and of one that cannot be."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from .conftest import WINDOW_LIMIT_S, World
from .pictures import Picture, Window, channels, colours

WALL = """[station]
eye = 0 1.7 0

[screen front]
bottom-left = -1 1 -1.5
bottom-right = 1 1 -1.5
top-left = -1 2.125 -1.5
top-right = 1 2.125 -1.5
position = 0 0
size = 320 180
"""


@pytest.fixture(scope="module")
def session(shared_world: World) -> World:
    """Somebody walks about."""
    shared_world.server()
    shared_world.trainee().await_text("joined")
    return shared_world


def look(world: World, display: dict[str, str], name: str, *options: str) -> tuple[Picture, str]:
    """What the window of an observer with such a display shows, and what it has said."""
    window = Window(world, display, "--quality=low", "--camera=0,20,4", *options, name=name)
    window.await_people()
    picture = window.picture()
    window.close()
    return picture, window.process.log()


def test_both_eyes_see_the_session_side_by_side(session: World, display: dict[str, str]) -> None:
    picture, _ = look(session, display, "stereo", "--display=side-by-side")
    # The same world, from places that are apart.
    assert 0.3 < np.abs(picture[:, :160] - picture[:, 160:]).mean() < 40.0


def test_a_wall_shows_the_session(session: World, display: dict[str, str], tmp_path: Path) -> None:
    layout = tmp_path / "one.wall"
    layout.write_text(WALL, encoding="utf-8")
    picture, _ = look(session, display, "wall", "--display=wall", f"--layout={layout}")
    assert colours(picture[45:150]) > 200, "nothing of the world is seen"


def test_what_cannot_be_shown_is_said_and_the_window_goes_on(
    session: World, display: dict[str, str], tmp_path: Path
) -> None:
    flat = tmp_path / "flat.wall"
    flat.write_text(WALL.replace("top-left = -1 2.125", "top-left = -1 1"), encoding="utf-8")
    picture, said = look(session, display, "flat", "--display=wall", f"--layout={flat}")
    assert "flat.wall:" in said
    assert colours(picture[45:150]) > 200


def test_a_wearer_without_a_headset_sees_the_session_and_why(
    session: World, display: dict[str, str]
) -> None:
    environment = {**display, "XR_RUNTIME_JSON": "/nonexistent.json"}
    options = ["--role=trainee", "--display=hmd", "--quality=low"]
    wearer = Window(session, environment, *options, name="wearer")
    # Nothing moves a body instead of the headset, and nothing keeps its wearer out.
    seen = wearer.process.await_report(
        lambda report: report["shown_frames"] > 4 and report["latency_count"] > 0, WINDOW_LIMIT_S
    )
    assert seen["people"] == []
    # What the window says for as long as it waits: the news of it have gone by then.
    wearer.process.await_report(
        lambda report: report["seconds"] > seen["seconds"] + 8.0, WINDOW_LIMIT_S
    )
    assert notes(wearer.picture()[:90]) > 40
    assert colours(wearer.picture()[45:150]) > 200
    wearer.close()
    assert "No headset: the OpenXR runtime" in wearer.process.log()
    assert "needs a motion source" not in wearer.process.log()


def notes(picture: Picture) -> int:
    """Pixels of notes, which are amber."""
    red, green, blue = channels(picture)
    return int(((red > 200) & (green > 150) & (green < 220) & (blue > 60) & (blue < 130)).sum())
