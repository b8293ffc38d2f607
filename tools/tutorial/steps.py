# SPDX-License-Identifier: MIT
"""The steps of docs/tutorial.md, in its order. Places are in metres."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from toolchain.processes import await_that

from .editor import Editor, Place

LEVEL = "my_range"
# The yard: its corners are 8 m apart.
WEST, EAST, NORTH, SOUTH = 6.0, 14.0, -4.0, 4.0
HALF = 4.0
# Beside a wall, so that the thing is in it.
IN_WALL: Place = (8.0, 0.0, SOUTH + 0.2)


class Tutorial:
    """One walk through the tutorial. Pictures are kept where somebody wants them."""

    def __init__(self, editor: Editor, pictures: Path | None = None) -> None:
        self.editor = editor
        self.pictures = pictures

    def run(self) -> None:
        """All steps but for the last, which starts a session."""
        for step in (
            self.make_level,
            self.drop_house,
            self.build_yard,
            self.hang_door,
            self.put_crates,
            self.mark_zone,
            self.add_spawn_point,
            self.find_fault,
            self.bake,
        ):
            step()

    def make_level(self, name: str = LEVEL) -> None:
        """Makes a level by the dialog and looks at it from above."""
        editor = self.editor
        editor.click("New level")
        editor.await_state(lambda s: s["windows"][0]["title"] == "New level", "the dialog")
        editor.write("Name of the folder", name)
        editor.write("Title", "My range")
        self._take("new_level")
        state = editor.await_state(lambda s: not s["windows"][0]["is_shut"], "Create")
        left, top, width, height = state["windows"][0]["ok"]
        editor.screen.click(left + width / 2.0, top + height / 2.0)
        editor.await_state(lambda s: s["scene"]["path"].endswith(f"/{name}.tscn"), "the level")
        editor.await_state(lambda s: s["view"]["is_shown"], "the 3D view")
        editor.look_from(26.0, 0.93)

    def drop_house(self) -> None:
        """Drags a house, takes it back, drags it again."""
        house = (-4.25, 0.0, -5.0)
        self.editor.drop("House", house)
        self.editor.undo()
        self.editor.await_state(lambda s: "Static/House" not in s["scene"]["nodes"], "no house")
        self.editor.drop("House", house)
        self._take("house")

    def build_yard(self) -> None:
        """Places walls by clicks, some of them turned."""
        along: list[Place | str] = [
            (x, 0.0, z) for z in (SOUTH, NORTH) for x in (WEST, WEST + HALF)
        ]
        # Turned by R they go towards -Z.
        across: list[Place | str] = [(EAST, 0.0, 0.0), (EAST, 0.0, SOUTH), (WEST, 0.0, 0.0)]
        self.editor.place("Wall", [*along, "r", *across])
        self.editor.place("Wall with door", ["r", (WEST, 0.0, SOUTH)])
        self._take("yard")

    def hang_door(self) -> None:
        """Places a door in the opening."""
        # The opening begins 1.5 m from the wall's corner. A little inside, where no jamb hides it.
        self.editor.come_nearer(4)
        self.editor.place("Door", ["r", (WEST - 0.1, 0.0, SOUTH - 1.59)])
        self._take("door")
        self.editor.look_from(26.0, 0.93)

    def put_crates(self) -> None:
        """Places three crates."""
        self.editor.place("Crate", [(10.0, 0.0, 0.0), (11.0, 0.0, 0.0), (10.0, 0.0, 1.0)])
        self._take("crates")

    def mark_zone(self) -> None:
        """Drags a trigger zone and pulls one of its handles."""
        self.editor.drop("Trigger zone", (8.0, 0.0, -1.5))
        # The handle of its right side.
        self.editor.pull(0, (12.0, 1.1, -1.5))
        self._take("zone")

    def add_spawn_point(self) -> None:
        """Drags a spawn point and saves."""
        self.editor.drop("Spawn point", (0.0, 0.0, 6.0))
        self.editor.save()

    def find_fault(self) -> None:
        """Puts a crate into a wall, has it found, looks at it and deletes it."""
        editor = self.editor
        crate = editor.drop("Large crate", IN_WALL)
        editor.click("Check level")
        row = editor.await_state(
            lambda s: [row for row in s["lists"][1] if "it stands in" in row["text"]], "the fault"
        )["lists"][1][0]
        left, top, width, height = row["rect"]
        editor.screen.click(left + min(width, 120.0) / 2.0, top + height / 2.0)
        editor.await_state(lambda s: s["scene"]["selected"] == [crate], f"{crate} is selected")
        editor.come_nearer(5)
        self._take("fault")
        editor.screen.key("delete")
        state = editor.await_state(
            lambda s: s["windows"] or crate not in s["scene"]["nodes"], "the crate goes"
        )
        if state["windows"]:
            left, top, width, height = state["windows"][0]["ok"]
            editor.screen.click(left + width / 2.0, top + height / 2.0)
        editor.await_state(lambda s: crate not in s["scene"]["nodes"], "the crate is gone")
        editor.click("Check level")
        editor.await_state(lambda s: s["controls"]["note"]["text"].startswith("0 faults"), "none")
        self._take("checked")

    def bake(self) -> None:
        """Has the light worked out."""
        self.editor.save()
        self.editor.click("Bake level")
        self.editor.await_state(
            lambda s: s["controls"]["note"]["text"].startswith(f"{LEVEL}.bake:"), "the light"
        )
        self._take("baked")

    def start_trial(self, is_there: Callable[[], bool], limit_s: float) -> float:
        """Presses Try; returns the seconds until all are on the level."""
        begin = time.monotonic()
        self.editor.click("Try level")
        await_that(is_there, "a session", limit_s)
        return time.monotonic() - begin

    @staticmethod
    def is_on_level(log: str, level: str = LEVEL) -> bool:
        """Whether a log has all three programs of a trial on the level."""
        has_server = "listening on UDP port" in log and "net: trainee '" in log
        # Both windows say so.
        return has_server and log.count(f"client: world '{level}' is there") == 2

    def end_trial(self) -> None:
        """Takes a picture of the windows and shuts them: the server ends with the trainee's."""
        time.sleep(8.0)
        self._take("trial")
        for window in self.editor.screen.windows()[1:]:
            self.editor.screen.shut(window)

    def _take(self, name: str) -> None:
        if self.pictures is not None:
            self.editor.take_picture(self.pictures / f"{name}.png")
