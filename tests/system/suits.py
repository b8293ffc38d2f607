# SPDX-License-Identifier: MIT
"""People in emulated suits, for the whole-process tests."""

from __future__ import annotations

import json
import os
import shutil
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from toolchain import suit
from toolchain.godot import Godot
from toolchain.paths import CLIENT_BINARY, CLIPS

from .conftest import SOFTWARE, Process, World
from .recordings import recorded as recorded
from .recordings import turned as turned

WALK = CLIPS / "01_01.bvh"
CALIBRATION_S = 60.0

needs_emulator = pytest.mark.skipif(not suit.PROGRAM.exists(), reason="built without umockdev")


def engine() -> Godot:
    """The engine that ./test has found."""
    return Godot(Path(os.environ["DISMOUNT_GODOT"]), "", "")


class Suit:
    """A trainee's client in an emulated suit, whose wearer stands still until told otherwise."""

    def __init__(
        self,
        world: World,
        name: str,
        emulator: list[str],
        options: list[str],
        display: dict[str, str] | None = None,
    ) -> None:
        pipe = world.folder / f"{name}.commands"
        os.mkfifo(pipe)
        self._commands = os.open(pipe, os.O_RDWR)
        own = [f"--bvh={WALK}", "--hold", f"--commands={pipe}", *emulator]
        command = [str(suit.PROGRAM), *suit.complete(engine(), own), "--", str(CLIENT_BINARY)]
        command += ["--headless"] if display is None else [*SOFTWARE, "--resolution", "1280x720"]
        command += ["--", "--role=trainee", f"--port={world.port}", "--xbus", f"--name={name}"]
        self.client: Process = world.start(name, [*command, *options], display)

    def command(self, line: str) -> None:
        """Tells the emulator something."""
        os.write(self._commands, f"{line}\n".encode())

    def await_calibrated(self, kind: str) -> str:
        """Waits until a calibration has come to its end; returns what the log says of it."""
        self.client.await_text(f"calibrating ({kind})")
        # The wearer begins with what the guide asks for.
        self.command("go")
        self.client.await_text("calibrated", CALIBRATION_S)
        return next(line for line in self.client.log().splitlines() if "calibrated" in line)

    def quit(self) -> None:
        """Ends emulator and client."""
        if self.client.process.poll() is None:
            self.command("quit")
            self.client.await_exit()

    def close(self) -> None:
        """Lets go of the emulator, however it is."""
        if self.client.process.poll() is None:
            self.client.process.terminate()
            self.client.process.wait(20)
        os.close(self._commands)


@contextmanager
def suits_of(world: World) -> Iterator[Callable[..., Suit]]:
    """Starts people in suits, who end with it."""
    started: list[Suit] = []

    def start(name: str, emulator: list[str], options: list[str], **more: dict) -> Suit:
        started.append(Suit(world, name, emulator, options, **more))
        return started[-1]

    try:
        yield start
    finally:
        for one in started:
            one.close()


def await_that(holds: Callable[[], bool], what: str, limit_s: float = 120.0) -> None:
    """Waits until something holds; reports may be half-written or not there yet."""
    end = time.monotonic() + limit_s
    while time.monotonic() < end:
        try:
            if holds():
                return
        except (FileNotFoundError, json.JSONDecodeError, KeyError, IndexError):
            pass
        time.sleep(0.1)
    pytest.fail(f"{what} did not come in {limit_s} s")


def await_people(client: Process, names: set[str], limit_s: float = 120.0) -> None:
    """Waits until a client says in its report that it brings these people."""

    def holds() -> bool:
        return {person["name"] for person in client.report()["people"]} == names

    await_that(holds, f"{sorted(names)}", limit_s)


def profiles_in(folder: Path) -> list[Path]:
    """What is kept of people in a data folder."""
    return sorted(folder.rglob("calibrations/*.json"))


def take_over(data: Path, world: World) -> None:
    """Gives a world's programs the user's folder of an earlier session."""
    shutil.copytree(data, world.folder / "DATA", dirs_exist_ok=True)
