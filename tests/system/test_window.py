# SPDX-License-Identifier: MIT
"""Looks at a window: texts that grow with it, a name over a person, what is left at its end."""

from __future__ import annotations

import numpy as np

from .conftest import World, run_in_window
from .pictures import Picture, Window


def text_height(picture: Picture, width: int) -> int:
    """Height of the first line of text within a width at the top left, pixels."""
    lines = (picture[:, :width].min(axis=2) > 225).any(axis=1)
    begin = int(np.argmax(lines))
    return int(np.argmin(lines[begin:]))


def test_texts_grow_with_the_window_and_people_have_names(
    world: World, display: dict[str, str]
) -> None:
    world.server()
    world.trainee("--name=Ada").await_text("joined")
    window = Window(world, display, "--camera=0,20,4", "--quality=low", size=(1280, 720))
    window.await_people()
    small = text_height(window.picture(), 160)
    # Of which the display shows two thirds.
    window.resize(1920, 1080)
    large = window.await_picture(
        lambda picture: 1.25 < text_height(picture, 240) / small < 1.8, "larger text"
    )
    assert large.shape[1] > 1000
    # The name: white before the wall, where nothing else is so bright.
    window.await_picture(
        lambda picture: (picture[215:315, 700:1220].min(axis=2) > 150).sum() > 40, "a name"
    )
    window.close()


def test_levels_that_are_given_up_undrawn_leave_nothing(display: dict[str, str]) -> None:
    said = run_in_window(display, "levels_given_up.gd")
    assert "gave up all" in said
    assert "ERROR" not in said
    assert "leaked" not in said


def test_a_window_that_is_shut_while_it_loads_ends_in_order(
    world: World, display: dict[str, str]
) -> None:
    world.server()
    window = Window(world, display, "--quality=low")
    process = window.process
    process.await_report(lambda seen: seen["level"]["name"] == "hall")
    world.client("instructor", "--orders=world:town", name="instructor")
    # A thread reads it for the first half of the progress.
    process.await_report(
        lambda seen: seen["level"]["waits_for"] == "load" and seen["level"]["progress"] < 0.5
    )
    for shown in window.screen.windows():
        window.screen.shut(shown)
    window.screen.close()
    assert process.await_exit() == 0
    # The engine may say that a sound leaked which began in that moment, but nothing of a picture.
    assert "GL ID" not in process.log()
    assert "never freed" not in process.log()
