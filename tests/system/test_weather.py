# SPDX-License-Identifier: MIT
"""Time of day and weather over whole processes: an instructor changes them, everybody sees it."""

from __future__ import annotations

from .conftest import World
from .test_views import Pixel, read_png


def brightness(rows: list[list[Pixel]]) -> float:
    """Mean of all pixels but the lines of text, 0 to 255."""
    inner = [pixel for row in rows[30:-40] for pixel in row]
    return sum(sum(pixel) for pixel in inner) / len(inner) / 3


def test_night_falls_where_an_instructor_orders_it(world: World, display: dict[str, str]) -> None:
    server = world.server("--world=desert", "--time=12")
    world.trainee().await_text("joined")
    day, night, storm = (world.folder / f"{name}.png" for name in ("day", "night", "storm"))
    world.take_picture(display, day, name="observer-day")
    world.client("instructor", "--orders=time:23:30", name="instructor-night")
    server.await_text("gave an order: the world has time_of_day=23.5")
    # Who joins now was not there when it was ordered.
    world.take_picture(display, night, name="observer-night")
    assert brightness(read_png(night)) < 0.5 * brightness(read_png(day))
    world.client("instructor", "--orders=time:noon,weather:dust", name="instructor-storm")
    server.await_text("gave an order: the world has weather=2.0 weather_strength=1.0")
    world.take_picture(display, storm, name="observer-storm")
    shown = read_png(storm)
    assert brightness(shown) > 2.0 * brightness(read_png(night))
    # The blue sky is gone: dust is yellow everywhere.
    sky = [pixel for row in shown[40:90] for pixel in row]
    assert sum(1 for red, _, blue in sky if red > blue + 10) > 0.9 * len(sky)


def test_a_time_that_is_none_is_refused_at_the_start(world: World) -> None:
    server = world.server("--world=desert", "--time=noonish", wait=False)
    assert server.await_exit() == 2
    assert "--time=noonish: it must be one of hours from 0 to 24" in server.log()
