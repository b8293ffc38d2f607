# SPDX-License-Identifier: MIT
"""The effects studio in a window, driven by keys and mouse, and effects that change meanwhile.

How soon a key is seen, and how soon a loop is ended, is measured by `./run bench studio`.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from toolchain.display import virtual_display
from toolchain.godot import Godot
from toolchain.paths import ROOT
from toolchain.processes import await_that
from tutorial.screen import Screen

from .conftest import HEADLESS_FPS, SOFTWARE, Process, World

pytestmark = pytest.mark.serial

# One particle that fills the picture, of a colour that one key changes: the last digit typed.
SQUARE = """shader_type particles;
// @effect Square
// @count 1
// @life 60
// @size 60
// @bounds 50
void start() { TRANSFORM = at(vec3(0.0, 1.0, 0.0), 60.0); }
void process() {
	COLOR = vec4(0.9, 0.1, 0.1, 1.0);
}
"""
SCENE = "res://scenes/studio/studio.tscn"
LIMIT_S = 600.0
SHIFTED = {":": "semicolon", "(": "9", ")": "0", "{": "bracketleft"}
# The middle of the picture, in a window of 1280x720.
MIDDLE = (900, 200)
# A line of the code beside no text, and where "Save" and "Send" are.
LINE_END = (560, 90)


class Studio:
    """The studio in a window that fills a display."""

    def __init__(self, world: World, godot: Godot, display: dict[str, str], folder: Path) -> None:
        self.file = folder / "square.gdshader"
        folder.mkdir()
        self.file.write_text(SQUARE, encoding="utf-8")
        command = [str(godot.program), *SOFTWARE, "--resolution", "1280x720", "--path", str(ROOT)]
        command += [SCENE, "--", f"--effects={folder}", "--effect=square"]
        self.process = world.start("studio", command, display, reports=False)
        self.screen = Screen(display["DISPLAY"])
        await_that(self.is_red, "the picture", LIMIT_S)

    def colour(self) -> np.ndarray:
        """The colour in the middle of the picture."""
        return self.screen.picture()[MIDDLE[1], MIDDLE[0]].astype(int)

    def is_red(self) -> bool:
        red, green, blue = self.colour()[:3]
        return bool(red > 180 and green < 90 and blue < 90)

    def is_purple(self) -> bool:
        red, green, blue = self.colour()[:3]
        return bool(red > 180 and green < 90 and blue > 180)

    def type(self, text: str) -> None:
        """Writes a text; some signs need the key of another and Shift."""
        for letter in text:
            if letter in SHIFTED:
                self.screen.key("shift", SHIFTED[letter])
            else:
                self.screen.type(letter)

    def press(self, *keys: str) -> None:
        self.screen.key(*keys)
        time.sleep(0.3)

    def line_is_marked(self) -> bool:
        """Whether a line of the code has the colour of a problem."""
        picture = self.screen.picture()[40:680, 400:570].astype(int)
        reddish = (picture[:, :, 0] > picture[:, :, 1] + 10) & (picture[:, :, 0] < 140)
        return bool(reddish.sum() > 1000)


def start_line_of_colour(studio: Studio) -> None:
    """Puts the caret behind the last component of the colour but one."""
    studio.screen.click(*LINE_END)
    studio.press("Control_L", "End")
    for _ in range(2):
        studio.press("Up")
    studio.press("End")
    for _ in range(len(", 1.0);")):
        studio.press("Left")


class Session(NamedTuple):
    """A server that watches a folder of effects, and an observer, both from the sources."""

    folder: Path
    server: Process
    observer: Process

    def taken(self) -> int:
        """How many effects the observer has taken over."""
        return int(self.observer.report()["effects"]["taken"])

    def await_taken(self, count: int) -> None:
        self.observer.await_report(lambda report: report["effects"]["taken"] == count)


@pytest.fixture(scope="module")
def session(shared_world: World, godot: Godot) -> Session:
    folder = shared_world.folder / "effects"
    folder.mkdir()
    engine = [str(godot.program), "--headless", "--path", str(ROOT), "--"]
    port = f"--port={shared_world.port}"
    command = [*engine, "--role=server", port, "--world=hall", f"--effects={folder}"]
    server = shared_world.start("server", command)
    server.await_text("listening on UDP port")
    command = [*engine, "--role=observer", port, f"--fps={HEADLESS_FPS}"]
    observer = shared_world.start("observer", command)
    server.await_text("joined")
    return Session(folder, server, observer)


@pytest.fixture(scope="module")
def studio(shared_world: World, godot: Godot) -> Iterator[Studio]:
    with virtual_display(keeps_shaders=True) as display:
        opened = Studio(shared_world, godot, display, shared_world.folder / "edited")
        yield opened
        opened.screen.close()


def test_a_saved_file_is_seen_and_a_broken_one_is_not(session: Session) -> None:
    file = session.folder / "square.gdshader"
    before = session.taken()
    file.write_text(SQUARE, encoding="utf-8")
    session.await_taken(before + 1)
    for number in range(20):
        file.write_text(SQUARE.replace("@life 60", f"@life {'x' * (number + 1)}"))
    session.server.await_text("not taken over: line 4")
    file.write_text(SQUARE.replace("@life 60", "@life 30"), encoding="utf-8")
    session.await_taken(before + 2)
    assert session.observer.report()["effects"]["refused"] == 0


def test_the_studio_sends_to_a_session(
    studio: Studio, session: Session, shared_world: World
) -> None:
    before = session.taken()
    said = session.server.log().count("'square' goes to all clients")
    address, send = (812, 15), (903, 15)
    studio.screen.click(*address)
    studio.press("Control_L", "a")
    studio.type(f"127.0.0.1:{shared_world.port}")
    studio.screen.click(*send)
    session.server.await_text("'square' goes to all clients", count=said + 1)
    session.await_taken(before + 1)


def test_keys_change_the_picture(studio: Studio) -> None:
    start_line_of_colour(studio)
    studio.press("BackSpace")
    studio.type("9")
    await_that(studio.is_purple, "the new colour", LIMIT_S)
    # A mistake: the picture goes on, the line is marked.
    studio.type("x")
    await_that(studio.line_is_marked, "the mark of the mistake", LIMIT_S)
    assert studio.is_purple()
    studio.press("BackSpace")
    await_that(lambda: not studio.line_is_marked(), "the end of the mark", LIMIT_S)
    # An endless loop, typed in: it is never shown, and the studio goes on.
    studio.press("End")
    studio.type(" while (true) {")
    await_that(studio.line_is_marked, "the mark of the loop", LIMIT_S)
    studio.press("Control_L", "s")
    await_that(
        lambda: "while" in studio.file.read_text(encoding="utf-8"), "the saved text", LIMIT_S
    )
    assert studio.is_purple()
    assert "0.9, 1.0);" in studio.file.read_text(encoding="utf-8")
    assert not list(studio.file.parent.glob("*.tmp"))
    assert studio.process.process.poll() is None
