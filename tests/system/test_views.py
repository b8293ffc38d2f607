# SPDX-License-Identifier: MIT
"""Looks at pixels of a real window: the three worlds of the thesis."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from toolchain.paths import CLIPS

from .conftest import World
from .pictures import Picture, Window, channels, light, read_png

MIN_SHADOWED = 55.0
"""Of 255: median brightness of a back in the shade."""


def share(picture: Picture, wanted: Callable[[Picture], Picture]) -> float:
    """Share of the pixels that a test holds for, without the lines of text."""
    return float(wanted(picture[45:150]).mean())


def wire_of_limb(picture: Picture) -> Picture:
    red, green, blue = channels(picture)
    return (green > 180) & (red < 110) & (blue < 150)


def wood(picture: Picture) -> Picture:
    red, green, blue = channels(picture)
    # The wires around crates are of a deeper colour.
    return (red > 80) & (red > green * 1.08) & (green > blue * 1.08) & (blue > red * 0.4)


def wire_of_hall(picture: Picture) -> Picture:
    red, green, blue = channels(picture)
    return (blue > 180) & (red < 130) & (blue > green + 40)


def still_clip(folder: Path) -> Path:
    """Somebody who stands as at the beginning of a clip."""
    head, _, frames = (CLIPS / "01_01.bvh").read_text(encoding="ascii").partition("Frame Time:")
    first = frames.splitlines()[1]
    skeleton = head[: head.index("Frames:")]
    made = folder / "still.bvh"
    lines = [f"{skeleton}Frames: 200", "Frame Time: 0.0166667", *[first] * 200]
    made.write_text("\n".join(lines) + "\n", encoding="ascii")
    return made


@pytest.fixture(scope="module")
def still(shared_world: World) -> World:
    """Somebody stands still, so that all pictures show the same."""
    shared_world.server()
    clip = str(still_clip(shared_world.folder))
    shared_world.trainee(clip=clip, name="still").await_text("joined")
    return shared_world


@pytest.fixture(scope="module")
def window(still: World, display: dict[str, str]) -> Iterator[Window]:
    """A window that shows the mesh world."""
    window = Window(still, display, "--views=mesh", "--camera=30,25,7", "--quality=low")
    window.await_people()
    yield window
    window.close()


def test_the_three_worlds(window: Window) -> None:
    mesh = window.picture()
    window.press("1", "2")
    static = window.picture()
    window.press("2", "3")
    physics = window.picture()
    window.press("1", "2")
    both = window.picture()
    # Wire frames of limbs and of the hall are in the physics world alone.
    assert share(mesh, wire_of_limb) < 0.0002
    assert share(static, wire_of_limb) < 0.0002
    assert share(physics, wire_of_limb) > 0.001
    assert share(both, wire_of_limb) > 0.0005
    assert share(physics, wire_of_hall) > 0.002
    assert share(mesh, wire_of_hall) < 0.0005
    # Crates belong to the mesh world alone.
    assert share(mesh, wood) > 0.005
    assert share(both, wood) > 0.005
    assert share(static, wood) < 0.0005
    # Of the edges of wires something is left.
    assert share(physics, wood) < share(mesh, wood) * 0.75


def test_the_picture_changes_while_a_person_moves(window: Window, still: World) -> None:
    still.trainee(name="walker").await_text("joined")
    picture = window.picture()
    # First the walker may come, then only move.
    for _ in range(2):
        picture = window.await_picture(lambda now, old=picture: is_changed(old, now), "a step")


def is_changed(before: Picture, now: Picture) -> bool:
    return int((np.abs(now - before)[45:150].max(axis=2) > 40).sum()) > 75


def test_the_shadowed_side_of_a_person_is_readable(still: World, display: dict[str, str]) -> None:
    """The sun shines from azimuth 35 degrees; the camera looks at the other side."""
    file = still.folder / "shadow.png"
    options = ["--views=mesh,static", "--camera=215,5,2.2", f"--screenshot={file}"]
    window = Window(still, display, *options, name="shadow", at=(400, 0))
    window.await_people()
    window.close()
    picture = read_png(file)
    assert picture.shape == (180, 320, 3)
    # The hips are in the middle: back, belt and thighs are around it.
    body = np.sort(light(picture[60:120, 150:170]).ravel())
    assert body[len(body) // 2] > MIN_SHADOWED, body[len(body) // 2]
    # It has parts that differ: light does not wash out cloth, belt and pouches.
    assert body[len(body) * 9 // 10] > 1.4 * body[len(body) // 10]
