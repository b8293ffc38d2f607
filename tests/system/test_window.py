# SPDX-License-Identifier: MIT
"""Looks at a window: texts that grow with it, a name over a person, what is left at its end."""

from __future__ import annotations

from tutorial.screen import Screen

from .conftest import World, run_in_window
from .test_views import Pixel, read_png


def is_text(pixel: Pixel) -> bool:
    return min(pixel) > 225


def is_name(pixel: Pixel) -> bool:
    """Names are a little transparent; nothing else in the hall is so bright."""
    return min(pixel) > 195


def take(
    world: World, display: dict[str, str], size: str, camera: str = "0,20,4"
) -> list[list[Pixel]]:
    """What an observer's window of a size shows."""
    picture = world.folder / f"{size}.png"
    options = {"name": f"window-{size}", "size": size}
    world.take_picture(display, picture, f"--camera={camera}", **options)
    return read_png(picture)


def text_height(rows: list[list[Pixel]]) -> int:
    """Height of the first line of text at the top left, pixels."""
    lines = [any(is_text(pixel) for pixel in row[: len(row) // 8]) for row in rows]
    begin = lines.index(True)
    return lines.index(False, begin) - begin


def test_texts_grow_with_the_window_and_people_have_names(
    world: World, display: dict[str, str]
) -> None:
    world.server()
    world.trainee("--name=Ada").await_text("joined")
    small = take(world, display, "1280x720")
    large = take(world, display, "1920x1080")
    assert (len(small[0]), len(large[0])) == (1280, 1920)
    assert 1.25 < text_height(large) / text_height(small) < 1.8
    # The name: white above the middle, where there is no other text.
    middle = [row[700:1220] for row in large[130:540]]
    assert sum(is_name(pixel) for row in middle for pixel in row) > 40


def test_levels_that_are_given_up_undrawn_leave_nothing(display: dict[str, str]) -> None:
    said = run_in_window(display, "levels_given_up.gd")
    assert "gave up all" in said
    assert "ERROR" not in said
    assert "leaked" not in said


def test_a_window_that_is_shut_while_it_loads_ends_in_order(
    world: World, display: dict[str, str]
) -> None:
    screen = Screen(display["DISPLAY"])
    world.server()
    window = world.client("observer", "--quality=low", display=display)
    window.await_report(lambda seen: seen["level"]["name"] == "hall")
    world.client("instructor", "--orders=world:town", name="instructor")
    # A thread reads it for the first half of the progress.
    window.await_report(
        lambda seen: seen["level"]["waits_for"] == "load" and seen["level"]["progress"] < 0.5
    )
    for shown in screen.windows():
        screen.shut(shown)
    screen.close()
    assert window.await_exit() == 0
    # The engine may say that a sound leaked which began in that moment, but nothing of a picture.
    assert "GL ID" not in window.log()
    assert "never freed" not in window.log()
