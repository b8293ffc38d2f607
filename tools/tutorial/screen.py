# SPDX-License-Identifier: MIT
"""The keyboard, the mouse and the picture of an X display."""

from __future__ import annotations

import contextlib
import struct
import time
import zlib
from pathlib import Path

import numpy as np
from Xlib import XK, X
from Xlib.display import Display
from Xlib.error import BadWindow
from Xlib.ext import xtest
from Xlib.protocol.event import ClientMessage
from Xlib.xobject.drawable import Window

# Between two things that a hand does, s: editors look at where the mouse is once a frame.
PAUSE_S = 0.05
# Steps of a drag, and the time of each, s: a busy machine draws few frames a second.
DRAG_STEPS = 8
DRAG_S = 0.15

KEYS = {
    "ctrl": "Control_L",
    "shift": "Shift_L",
    "delete": "Delete",
    "escape": "Escape",
    "return": "Return",
    "down": "Down",
}


class Screen:
    """What a hand does at a display, in pixels from its upper left corner."""

    def __init__(self, name: str) -> None:
        self.display = Display(name)
        # The engine asks for it at its start, and can't be told to shut where nobody has named it.
        self.wish = self.display.intern_atom("WM_DELETE_WINDOW")
        self.root = self.display.screen().root

    def close(self) -> None:
        """Leaves the display."""
        self.display.close()

    def windows(self) -> list[Window]:
        """The windows that are shown."""
        found = []
        for one in self.root.query_tree().children:
            # One that programs show at their start may be gone by now.
            with contextlib.suppress(BadWindow):
                if one.get_attributes().map_state == X.IsViewable:
                    found.append(one)
        return found

    def fill_with(self, window: Window) -> None:
        """Gives a window the whole display and the keyboard: nothing manages windows here."""
        size = self.root.get_geometry()
        window.configure(x=0, y=0, width=size.width, height=size.height)
        self.give_keys(window)

    def give_keys(self, window: Window) -> None:
        """Lets a window have the keyboard."""
        window.set_input_focus(X.RevertToParent, X.CurrentTime)
        self.display.sync()

    def shut(self, window: Window) -> None:
        """Asks a program to shut its window, as a click on its cross does."""
        kind = self.display.intern_atom("WM_PROTOCOLS")
        data = (32, [self.wish, X.CurrentTime, 0, 0, 0])
        event = ClientMessage(window=window, client_type=kind, data=data)
        window.send_event(event, event_mask=0)
        self.display.sync()

    def move(self, x: float, y: float) -> None:
        """Puts the pointer somewhere."""
        xtest.fake_input(self.display, X.MotionNotify, x=int(x), y=int(y))
        self._rest()

    def press(self, button: int = 1) -> None:
        """Presses a button of the mouse."""
        xtest.fake_input(self.display, X.ButtonPress, button)
        self._rest()

    def release(self, button: int = 1) -> None:
        """Lets a button of the mouse go."""
        xtest.fake_input(self.display, X.ButtonRelease, button)
        self._rest()

    def click(self, x: float, y: float, button: int = 1, count: int = 1) -> None:
        """Clicks somewhere, once or several times."""
        # As a hand does: it is there before it presses.
        self.move(x - 2, y)
        self.move(x, y)
        time.sleep(2 * PAUSE_S)
        for _ in range(count):
            self.press(button)
            self.release(button)

    def drag(
        self,
        begin: tuple[float, float],
        end: tuple[float, float],
        button: int = 1,
        steps: int = DRAG_STEPS,
    ) -> None:
        """Pulls something from one place to another; the more steps, the slower."""
        self.move(*begin)
        time.sleep(DRAG_S)
        self.press(button)
        for step in range(1, steps + 1):
            share = step / steps
            self.move(*(a + (b - a) * share for a, b in zip(begin, end, strict=True)))
            time.sleep(DRAG_S)
        self.move(end[0] + 1, end[1])
        self.move(*end)
        time.sleep(2 * DRAG_S)
        self.release(button)

    def key(self, *names: str) -> None:
        """Presses keys together: the last one while the others are down."""
        for name in names:
            self.hold(name)
        for name in reversed(names):
            self.let_go(name)

    def hold(self, name: str) -> None:
        """Presses a key and keeps it down."""
        xtest.fake_input(self.display, X.KeyPress, self._code(KEYS.get(name, name)))
        self._rest()

    def let_go(self, name: str) -> None:
        """Lets a key go that is held."""
        xtest.fake_input(self.display, X.KeyRelease, self._code(KEYS.get(name, name)))
        self._rest()

    def type(self, text: str) -> None:
        """Writes a text with the keyboard."""
        names = {" ": "space", "_": "underscore", ".": "period", "-": "minus"}
        for letter in text:
            name = names.get(letter, letter)
            if letter.isupper() or letter == "_":
                self.key("shift", name)
            else:
                self.key(name)

    def picture(self) -> np.ndarray:
        """What is shown, as rows of pixels of red, green and blue."""
        size = self.root.get_geometry()
        image = self.root.get_image(0, 0, size.width, size.height, X.ZPixmap, 0xFFFFFFFF)
        pixels = np.frombuffer(image.data, np.uint8).reshape(size.height, size.width, 4)
        return pixels[:, :, 2::-1].copy()

    def _code(self, name: str) -> int:
        code = self.display.keysym_to_keycode(XK.string_to_keysym(name))
        if code == 0:
            raise ValueError(f"the display's keyboard has no key {name!r}")
        return code

    def _rest(self) -> None:
        self.display.sync()
        time.sleep(PAUSE_S)


def write_png(pixels: np.ndarray, file: Path) -> None:
    """Saves a picture; a row is stored as its difference from the one above, which packs well."""
    height, width, _ = pixels.shape
    above = np.vstack([np.zeros((1, width, 3), np.uint8), pixels[:-1]])
    rows = np.full((height, 1 + width * 3), 2, np.uint8)
    rows[:, 1:] = (pixels - above).reshape(height, -1)
    head = struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)
    parts = [(b"IHDR", head), (b"IDAT", zlib.compress(rows.tobytes(), 9)), (b"IEND", b"")]
    body = b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in parts
    )
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + body)
