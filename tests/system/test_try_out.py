# SPDX-License-Identifier: MIT
"""A trainee sees himself in the device panel's mirror before there is a server, then joins one."""

from __future__ import annotations

import numpy as np
from toolchain.paths import CLIPS

from .conftest import World
from .pictures import Picture, Window, channels, light

SIZE = (640, 360)
# The mirror's wall, behind a person from the knees up: rows and columns.
WALL = (slice(50, 220), slice(20, 335))
# Columns of it at its edges, where nobody stands.
EDGE = 40
GROUND = (23, 28, 34)


def _person(picture: Picture) -> Picture:
    """Where somebody in green and brown stands before the grey wall."""
    _, green, blue = channels(picture[WALL])
    return green - blue > 6


def _is_somebody_there(picture: Picture) -> bool:
    seen = _person(picture)
    edges = seen[:, :EDGE].sum() + seen[:, -EDGE:].sum()
    return bool(seen.sum() > 1500 and edges < 50)


def test_a_trainee_sees_himself_and_then_joins(world: World, display: dict[str, str]) -> None:
    options = ["--role=trainee", f"--bvh={CLIPS / '01_01.bvh'}", "--try", "--quality=low"]
    window = Window(world, display, *options, size=SIZE)
    first = window.await_picture(_is_somebody_there, "somebody in the mirror")

    def has_moved(picture: Picture) -> bool:
        changed = np.abs(light(picture[WALL]) - light(first[WALL])) > 30
        return bool(changed.sum() > 400) and _is_somebody_there(picture)

    window.await_picture(has_moved, "movement in the mirror")
    assert "joined" not in window.process.log()
    # The button has the keyboard. There is no server yet.
    window.press_at_once("Return")
    window.process.await_text("trying again")
    assert _is_somebody_there(window.picture()), "who waits still sees himself"
    server = world.server()
    window.process.await_text("joined")
    window.await_people()
    assert tuple(window.picture()[4, 4]) != GROUND, "the world has taken the mirror's place"
    server.await_text("trainee 'trainee'")
    window.close()
    said = window.process.log()
    assert "ERROR" not in said, said
    assert "leaked" not in said, said


def test_without_a_window_nobody_could_join(world: World) -> None:
    client = world.client("trainee", f"--bvh={CLIPS / '01_01.bvh'}", "--try")
    assert client.await_exit() == 2
    assert "--try needs a window" in client.log()
