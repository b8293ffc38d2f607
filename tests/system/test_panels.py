# SPDX-License-Identifier: MIT
"""Opens and closes the panels of an exported client: they are made of the engine's containers."""

from __future__ import annotations

from toolchain.paths import CLIPS

from .conftest import World
from .pictures import Window

# All buttons of the menu: continue, keys, full screen, quality, sound, wheel, leave.
TO_SOUND = ["Down"] * 4
TO_WHEEL = ["Down"] * 5


def test_panels_of_containers_open_and_close_without_an_error(
    world: World, display: dict[str, str]
) -> None:
    world.server()
    options = ["--role=trainee", f"--bvh={CLIPS / '01_01.bvh'}", "--panel=1", "--quality=low"]
    window = Window(world, display, *options, size=(640, 360))
    window.process.await_text("joined")
    window.await_frames()
    full = window.picture()
    window.press("escape")
    # Of the world and nothing else.
    assert (window.picture() != full).any()
    window.press("F1", "escape")
    window.press("escape", *TO_SOUND, "Return", "Left", "escape")
    window.press("escape")
    window.press("escape", *TO_WHEEL, "Return", "escape")
    window.press("M", "M")
    window.close()
    said = window.process.log()
    assert "ERROR" not in said, said
    assert "leaked" not in said, said
