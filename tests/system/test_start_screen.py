# SPDX-License-Identifier: MIT
"""The start screen as its user has it: a window of the exported program, and a few keys."""

from __future__ import annotations

from .conftest import World
from .pictures import Picture, Window, colours

SIZE = (960, 540)


def open_start(world: World, display: dict[str, str], *options: str) -> Window:
    """The start screen, once its film is seen behind the choices. It asks this machine only."""
    window = Window(
        world, display, "--role=start", "--discovery=0", *options, name="start", size=SIZE
    )
    window.process.await_text("the start screen is open")
    window.await_picture(shows_world, "the film of a world")
    return window


def shows_world(picture: Picture) -> bool:
    """Whether a living world is behind the choices: a flat ground has few colours."""
    return colours(picture[:, picture.shape[1] // 2 :]) > 2000


def test_a_newcomer_begins_a_session_with_two_keys_and_comes_back(
    world: World, display: dict[str, str]
) -> None:
    window = open_start(world, display)
    # To Host, open it, begin.
    window.press_at_once("Down", "Return")
    window.await_picture(lambda picture: not shows_start(picture), "the screen to host")
    window.press_at_once("Return")
    window.process.await_text("beside this program")
    window.process.await_text("is there after")
    window.process.await_text("1 people")
    window.press_at_once("Escape", "Up", "Return")
    window.process.await_text("back at the start screen")
    # Its server has ended with the session.
    window.process.await_text("stopped by a signal: ending all sessions")
    window.close()


def shows_start(picture: Picture) -> bool:
    """Whether the column of choices is at the left edge: dark from top to bottom."""
    return bool(picture[:, 4:20].max() < 90)


def test_a_refused_client_says_so_costs_little_and_ends_when_asked(
    world: World, display: dict[str, str]
) -> None:
    world.server("--password=right")
    window = Window(world, display, "--role=trainee", "--password=wrong", name="refused")
    window.process.await_text("password")
    window.await_picture(lambda picture: bool((picture.min(axis=2) > 200).sum() > 50), "why")
    window.screen.close()
    assert window.process.end() == 3
