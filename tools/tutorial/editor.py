# SPDX-License-Identifier: MIT
"""The Godot editor with the level kit, as somebody who looks and clicks has it."""

from __future__ import annotations

import contextlib
import json
import math
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .screen import Screen, write_png

# A processor that draws, beside eight others that are busy, takes seconds for a frame.
LIMIT_S = 600.0

# What a turn of the wheel makes of the distance, what a pixel turns, rad, and how far is pulled.
PER_TURN = 1.36
PER_PIXEL = 0.004
MOST_PULL = 180.0

# Between two looks while something is waited for: a look takes 20 ms of the editor's.
LOOK_S = 0.05
# Frames of the editor after which something that was done has come to nothing, and how often it is
# done then.
PATIENCE_FRAMES = 120
TRIES = 4

State = dict[str, Any]
Point = tuple[float, float]
Place = tuple[float, float, float]


def _fresh(state: State, before: list[str]) -> list[str]:
    # What shows where it will stand has no name of its own.
    return [one for one in state["scene"]["nodes"] if one not in before and "@" not in one]


class Editor:
    """Waits for what the editor shows (addons/level_kit/probe.gd tells it), then acts."""

    limit_s = LIMIT_S

    def __init__(self, screen: Screen, probe: Path, is_alive: Callable[[], bool]) -> None:
        self.screen = screen
        self.probe = probe
        self.is_alive = is_alive
        self._number = 0

    def state(self) -> State:
        """What it shows now: a look that began after the call."""
        return self.await_state(lambda _state: True, "a look")

    def await_state(self, holds: Callable[[State], Any], what: str) -> State:
        """Waits until something holds of what it shows; returns that."""
        end = time.monotonic() + self.limit_s
        self._ask()
        while True:
            state = self._read()
            # A look is not there yet, or not what it is about.
            with contextlib.suppress(LookupError, TypeError):
                if state["number"] == self._number:
                    if holds(state):
                        return state
                    time.sleep(LOOK_S)
                    self._ask()
            if time.monotonic() > end:
                raise AssertionError(
                    f"in {self.limit_s:.0f} s not seen: {what}. {json.dumps(state)}"
                )
            if not self.is_alive():
                raise AssertionError(f"the editor has ended before: {what}")
            time.sleep(0.01)

    def await_frames(self, count: int) -> None:
        """Waits until it has shown so many more frames."""
        begin = self.state()["frame"]
        self.await_state(lambda s: s["frame"] >= begin + count, f"{count} frames")

    def await_start(self) -> None:
        """Waits for the window and the dock, and gives it the display and the keyboard."""
        end = time.monotonic() + self.limit_s
        while not self.screen.windows():
            assert time.monotonic() < end and self.is_alive(), "the editor shows no window"
            time.sleep(0.2)
        self.await_state(lambda s: s["dock"] and not s["is_scanning"], "the dock 'Level kit'")
        self.screen.fill_with(self.screen.windows()[-1])
        # A window's first clicks only give it the keyboard.
        while not self.state()["controls"]["Search"]["has_focus"]:
            self.click("Search")
        # Pictures are drawn once; until then a frame takes its time.
        self.await_state(lambda s: len(s["lists"][0]) > 3, "things to place")

    def click(self, name: str) -> None:
        """Clicks a button or a field of the dock or of a dialog."""
        rect: list[float] = []

        def rests(state: State) -> bool:
            nonlocal rect
            control, before = state["controls"][name], rect
            rect = control["rect"]
            return rect == before and not control.get("is_shut", False)

        # What comes to the dock moves what is there.
        self.await_state(rests, f"{name!r} to click")
        self.screen.click(*middle(rect))

    def write(self, field: str, text: str) -> None:
        """Writes into a field in place of what is there."""
        self.click(field)
        self.await_state(lambda s: s["controls"][field]["has_focus"], f"{field!r} takes keys")
        self.screen.key("ctrl", "a")
        if text == "":
            self.screen.key("delete")
        self.screen.type(text)
        self.await_state(lambda s: s["controls"][field]["text"] == text, f"{text!r} in {field!r}")

    def choose(self, field: str, text: str) -> None:
        """Chooses an entry from a list that opens, by the arrow keys."""
        self.click(field)
        self.await_state(lambda s: self._marked(s, field) is not None, f"the list of {field!r}")
        passed: list[str] = []
        while (marked := self._marked(self.state(), field)) != text:
            # A whole round over all entries, and it was not among them.
            assert passed.count(marked) < 2, f"{field!r} has no entry {text!r}: {passed}"
            passed.append(marked)
            self.screen.key("down")
            self.await_state(lambda s, old=marked: self._marked(s, field) != old, "another entry")
        self.screen.key("return")
        self.await_state(lambda s: s["controls"][field]["text"] == text, f"{text!r} in {field!r}")

    @staticmethod
    def _marked(state: State, field: str) -> str | None:
        return state["controls"][field]["marked"]

    def find(self, title: str) -> Point:
        """Looks for a thing by its title and says where its picture is."""
        self.write("Search", title.lower())
        state = self.await_state(
            lambda s: any(row["text"] == title for row in s["lists"][0]), f"{title!r} in the dock"
        )
        return middle(next(row["rect"] for row in state["lists"][0] if row["text"] == title))

    def drop(self, title: str, place: Place) -> str:
        """Drags a thing to a place of the level; returns the path of the new node."""
        before = self.state()["scene"]["nodes"]
        self._act(
            lambda: self.screen.drag(self.find(title), self.on_screen(place)),
            lambda s: _fresh(s, before),
            f"a new {title!r}",
        )
        return self.await_new(before, title)[-1]

    def place(self, title: str, places: list[Place | str]) -> list[str]:
        """Double-clicks a thing, then clicks at each place; a text is a key in between."""
        before = self.state()["scene"]["nodes"]
        self._act(
            lambda: self.screen.click(*self.find(title), count=2),
            lambda s: "Each click" in s["controls"]["note"]["text"],
            "placing begins",
        )
        count = 0
        for each in places:
            if isinstance(each, str):
                self.screen.key(each)
                continue
            count += 1
            self._place_one(each, before, count, title)
        self.screen.key("escape")
        self.await_state(
            lambda s: "Each click" not in s["controls"]["note"]["text"], "placing has ended"
        )
        return self.await_new(before, title, count)

    def _place_one(self, at: Place, before: list[str], count: int, what: str) -> None:
        self._act(
            lambda: self.screen.click(*self.on_screen(at)),
            lambda s: len(_fresh(s, before)) >= count,
            f"{count} of {what!r}",
        )
        self.await_new(before, what, count)

    def _act(self, act: Callable[[], None], holds: Callable[[State], Any], what: str) -> None:
        """Does something, and again where nothing has come of it in many frames: on a busy machine
        an editor takes two clicks for two single ones, and a drag for a click."""
        for _ in range(TRIES):
            act()
            last = self.state()["frame"] + PATIENCE_FRAMES

            def is_over(state: State, last: int = last) -> bool:
                return bool(holds(state)) or state["frame"] > last

            if holds(self.await_state(is_over, what)):
                return
        raise AssertionError(f"{TRIES} times nothing came of it: {what}")

    def await_new(self, before: list[str], what: str, count: int = 1) -> list[str]:
        """Waits for so many nodes that were not there before; returns their paths."""
        state = self.await_state(lambda s: len(_fresh(s, before)) == count, f"{count} of {what!r}")
        return _fresh(state, before)

    def on_screen(self, place: Place) -> Point:
        """Where a place of the level is in the 3D view."""
        view = self.state()["view"]
        away = [a - b for a, b in zip(place, view["origin"], strict=True)]
        x, y, z = (sum(a * b for a, b in zip(away, axis, strict=True)) for axis in view["axes"])
        left, top, width, height = view["rect"]
        assert z < 0.0, f"{place} is behind the camera"
        half = height / 2.0 / tan_half(view["fov"])
        at = (left + width / 2.0 - x / z * half, top + height / 2.0 + y / z * half)
        inside = left < at[0] < left + width and top < at[1] < top + height
        assert inside, f"{place} is at {at}, out of the view {view['rect']}"
        return at

    def look_from(self, distance: float, height: float) -> None:
        """Turns the wheel and pulls with its button until the view is from so far, m, and so
        high, as the sine of the angle above the ground."""
        centre = middle(self.state()["view"]["rect"])
        self.screen.move(*centre)
        while (missing := distance / length(self.state()["view"]["origin"])) > 1.0:
            for _ in range(max(int(math.log(missing) / math.log(PER_TURN)), 1)):
                self._turn_wheel(5)
            self.await_rest()
        for _ in range(20):
            now = self.state()["view"]["axes"][2][1]
            if abs(height - now) < 0.03:
                self.await_rest()
                return
            pull = (math.asin(height) - math.asin(now)) / PER_PIXEL
            pull = max(min(pull, MOST_PULL), -MOST_PULL)
            self.screen.drag(centre, (centre[0], centre[1] + pull), button=2)
        raise AssertionError(f"the view does not turn: {self.state()['view']}")

    def come_nearer(self, steps: int) -> None:
        """Turns the wheel over the middle of the view."""
        self.screen.move(*middle(self.state()["view"]["rect"]))
        for _ in range(steps):
            self._turn_wheel(4)
        self.await_rest()

    def await_rest(self) -> None:
        """Waits until the view does not glide any more."""
        last = self.state()["view"]
        while True:
            time.sleep(0.3)
            now = self.state()["view"]
            if now == last:
                return
            last = now

    def _turn_wheel(self, button: int) -> None:
        for _ in range(2):
            self.screen.press(button)
            self.screen.release(button)

    def pull(self, handle: int, to: Place) -> None:
        """Pulls a handle of what is selected to a place."""
        state = self.await_state(lambda s: s["scene"]["handles"][handle], "handles")
        at = state["scene"]["handles"][handle]["at"]
        self.screen.drag(self.on_screen(at), self.on_screen(to))

    def paint(self, begin: Place, end: Place, steps: int = 16) -> None:
        """Pulls a brush, which works once a frame: each step waits for some frames."""
        ends = self.on_screen(begin), self.on_screen(end)
        self.screen.move(*ends[0])
        self.screen.press()
        for step in range(1, steps + 1):
            share = step / steps
            self.screen.move(*(a + (b - a) * share for a, b in zip(*ends, strict=True)))
            self.await_frames(5)
        self.screen.release()

    def save(self) -> None:
        """Saves the level, and waits until its file is another."""
        file = Path(self.state()["scene"]["file"])
        before = file.stat()
        self.screen.key("ctrl", "s")
        self.await_state(
            lambda _s: (
                (file.stat().st_ino, file.stat().st_mtime_ns) != (before.st_ino, before.st_mtime_ns)
            ),
            "the saved level",
        )

    def redo(self) -> None:
        """Makes it again."""
        self.screen.key("ctrl", "shift", "z")

    def undo(self) -> None:
        """Takes the last change back."""
        self.screen.key("ctrl", "z")

    def take_picture(self, file: Path) -> None:
        """Saves what the display shows."""
        self.state()
        time.sleep(0.6)
        file.parent.mkdir(parents=True, exist_ok=True)
        write_png(self.screen.picture(), file)

    def _ask(self) -> None:
        """Asks for a look."""
        self._number += 1
        fresh = self.probe.with_name(f"{self.probe.name}.new-asked")
        fresh.write_text(str(self._number), encoding="ascii")
        # As a whole or not at all: the editor reads it at once.
        fresh.replace(self.probe.with_name(f"{self.probe.name}.asked"))

    def _read(self) -> State:
        try:
            return json.loads(self.probe.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return {}


def middle(rect: list[float]) -> Point:
    """The middle of a rectangle of x, y, width and height."""
    return (rect[0] + rect[2] / 2.0, rect[1] + rect[3] / 2.0)


def length(place: Place) -> float:
    """Distance from the origin, m."""
    return math.sqrt(sum(each * each for each in place))


def tan_half(degrees: float) -> float:
    """Half the height of what a camera sees at a distance of one."""
    return math.tan(math.radians(degrees) / 2.0)
