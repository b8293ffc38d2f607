# SPDX-License-Identifier: MIT
"""Pictures as rows of pixels of red, green and blue, and windows of clients that show them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from PIL import Image
from toolchain.paths import CLIENT_BINARY
from toolchain.schedule import started
from tutorial.screen import Screen
from Xlib.xobject.drawable import Window as Drawable

from .conftest import SOFTWARE, WINDOW_LIMIT_S, Process, World

Picture = np.ndarray
# Enough for what a test looks for, and drawn quickly by a processor.
SMALL = (320, 180)
WINDOW_FPS = 20


def read_png(file: Path) -> Picture:
    """A picture that a program has saved."""
    with Image.open(file) as image:
        return np.asarray(image.convert("RGB")).astype(int)


def channels(picture: Picture) -> tuple[Picture, Picture, Picture]:
    """Red, green and blue, 0 to 255."""
    return picture[:, :, 0], picture[:, :, 1], picture[:, :, 2]


def light(picture: Picture) -> Picture:
    """How bright each pixel is for an eye, 0 to 255."""
    return picture @ np.array([0.2126, 0.7152, 0.0722])


def colours(picture: Picture) -> int:
    """How many colours a picture has."""
    return len(np.unique(picture.reshape(-1, 3), axis=0))


class Window:
    """A client's window at a place of a display, of which pictures are taken while it goes on."""

    def __init__(
        self,
        world: World,
        display: dict[str, str],
        *options: str,
        name: str = "window",
        size: tuple[int, int] = SMALL,
        at: tuple[int, int] = (0, 0),
    ) -> None:
        started["windows"] += 1
        command = [str(CLIENT_BINARY), *SOFTWARE, "--resolution", f"{size[0]}x{size[1]}"]
        command += ["--max-fps", str(WINDOW_FPS), "--position", f"{at[0]},{at[1]}"]
        command += ["--", f"--port={world.port}"]
        roles = [] if any("--role=" in option for option in options) else ["--role=observer"]
        self.process: Process = world.start(name, [*command, *roles, *options], display)
        self.screen = Screen(display["DISPLAY"])
        self._place = (*at, *size)

    def await_people(self) -> None:
        """Waits until people are shown, and the camera has come to them."""
        shown = self.process.await_report(
            lambda seen: seen["shown_frames"] > 4 and seen["latency_count"] > 0, WINDOW_LIMIT_S
        )
        # After 2 s it has come within 0.001 %.
        self.process.await_report(
            lambda seen: (
                seen["seconds"] > shown["seconds"] + 2.0
                and seen["shown_frames"] > shown["shown_frames"] + 4
            ),
            WINDOW_LIMIT_S,
        )

    def await_frames(self) -> None:
        """Waits until frames have been shown that began after the call."""
        before = self.process.fresh_report()["shown_frames"]
        self.process.await_report(lambda seen: seen["shown_frames"] > before + 2, WINDOW_LIMIT_S)

    def press(self, *names: str) -> None:
        """Presses keys, one after the other, and waits until what they change is shown."""
        self.press_at_once(*names)
        self.await_frames()

    def press_at_once(self, *names: str) -> None:
        """Presses keys, and waits for nothing: there may be no world yet."""
        self.screen.give_keys(self._find())
        for name in names:
            self.screen.key(name)

    @contextmanager
    def holding(self, name: str) -> Iterator[None]:
        """Keeps a key down meanwhile."""
        self.screen.give_keys(self._find())
        self.screen.hold(name)
        try:
            yield
        finally:
            self.screen.let_go(name)

    def resize(self, width: int, height: int) -> None:
        """Gives it another size, which may be larger than the display."""
        self._find().configure(width=width, height=height)
        self.screen.display.sync()
        self._place = (*self._place[:2], width, height)
        self.await_frames()

    def picture(self) -> Picture:
        """What it shows now, as far as that is on the display."""
        left, top, width, height = self._place
        return self.screen.picture()[top : top + height, left : left + width].astype(int)

    def await_picture(self, holds: Callable[[Picture], bool], what: str) -> Picture:
        """The picture as soon as something holds of it."""
        shown: list[Picture] = []

        def look() -> bool:
            shown[:] = [self.picture()]
            return holds(shown[0])

        self.process.await_that(look, what, WINDOW_LIMIT_S, 0.1)
        return shown[0]

    def close(self) -> None:
        """Ends it, as SIGTERM does."""
        self.screen.close()
        assert self.process.end() == 0, self.process.log()

    def _find(self) -> Drawable:
        geometries = [(one, one.get_geometry()) for one in self.screen.windows()]
        return next(one for one, at in geometries if (at.x, at.y) == self._place[:2])
