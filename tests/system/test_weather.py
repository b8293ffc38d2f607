# SPDX-License-Identifier: MIT
"""Time of day and weather over whole processes: an instructor changes them, everybody sees it."""

from __future__ import annotations

from .conftest import World
from .pictures import Picture, Window, channels


def brightness(picture: Picture) -> float:
    """Mean of all pixels but the lines of text, 0 to 255."""
    return float(picture[45:150].mean())


def is_dusty(picture: Picture) -> bool:
    """The blue sky is gone: dust is yellow everywhere."""
    red, _, blue = channels(picture[40:70])
    return bool((red > blue + 10).mean() > 0.9)


def test_night_falls_where_an_instructor_orders_it(world: World, display: dict[str, str]) -> None:
    server = world.server("--world=desert", "--time=12")
    world.trainee().await_text("joined")
    instructor = world.instructor()
    instructor.type("time 23:30")
    server.await_text("gave an order: the world has time_of_day=23.5")
    # Who joins now was not there when it was ordered.
    window = Window(world, display, "--quality=low", "--camera=35,0,4")
    window.await_people()
    night = brightness(window.picture())
    instructor.type("time noon")
    server.await_text("gave an order: the world has time_of_day=12.0")
    window.await_picture(
        lambda seen: night < 0.5 * brightness(seen) and not is_dusty(seen), "a clear day"
    )
    instructor.type("weather dust")
    server.await_text("gave an order: the world has weather=2.0 weather_strength=1.0")
    storm = window.await_picture(is_dusty, "the dust")
    assert brightness(storm) > 2.0 * night
    window.close()


def test_a_time_that_is_none_is_refused_at_the_start(world: World) -> None:
    server = world.server("--world=desert", "--time=noonish", wait=False)
    assert server.await_exit() == 2
    assert "--time=noonish: it must be one of hours from 0 to 24" in server.log()
