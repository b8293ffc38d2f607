# SPDX-License-Identifier: MIT
"""People in emulated suits, for the whole-process tests."""

from __future__ import annotations

import functools
import json
import os
import struct
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from toolchain import suit
from toolchain.godot import Godot
from toolchain.paths import CLIENT_BINARY, CLIPS, ROOT
from toolchain.processes import await_that

from .conftest import HEADLESS_FPS, Process, World
from .recordings import recorded as recorded
from .recordings import turned as turned

WALK = CLIPS / "01_01.bvh"
CALIBRATION_S = 600.0
# How near a body that has come to rest is to the wearer's pose, over limbs with a tracker: it is
# 0.3 and 2 degrees besides what calibration leaves, 1 or 2 on average.
MEAN_DEG = 2.5
WORST_DEG = 15.0

needs_emulator = pytest.mark.skipif(not suit.PROGRAM.exists(), reason="built without umockdev")


def engine() -> Godot:
    """The engine that ./test has found."""
    return Godot(Path(os.environ["DISMOUNT_GODOT"]), "", "")


@functools.cache
def motion() -> Path:
    """How the wearer moves: through a calibration, then as a walk."""
    return suit.motion_stream(engine(), WALK)


@functools.cache
def walk_begins_s() -> float:
    """When the wearer's walk begins, s: see motion_stream.cpp."""
    rate, _, begins = struct.unpack_from("<dII", motion().read_bytes(), 16)
    return begins / rate


class Suit:
    """A trainee's client in an emulated suit, whose wearer stands still until told otherwise."""

    def __init__(self, world: World, name: str, emulator: list[str], options: list[str]) -> None:
        pipe = world.folder / f"{name}.{len(world.processes)}.commands"
        os.mkfifo(pipe)
        self._commands = os.open(pipe, os.O_RDWR)
        own = [f"--stream={motion()}", "--hold", f"--commands={pipe}", *emulator]
        command = [str(suit.PROGRAM), *suit.complete(engine(), own), "--", str(CLIENT_BINARY)]
        command += ["--headless", "--", "--role=trainee", f"--port={world.port}", "--xbus"]
        command += [f"--fps={HEADLESS_FPS}", f"--name={name}"]
        self.client: Process = world.start(f"{name}.{len(world.processes)}", [*command, *options])

    def command(self, line: str) -> None:
        """Tells the emulator something."""
        os.write(self._commands, f"{line}\n".encode())

    def strike(self, moment_s: float) -> None:
        """Lets the wearer stand still as at a moment of the walk."""
        self.command(f"motion {walk_begins_s() + moment_s}\nhold")

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

    def start(name: str, emulator: list[str], options: list[str]) -> Suit:
        started.append(Suit(world, name, emulator, options))
        return started[-1]

    try:
        yield start
    finally:
        for one in started:
            one.close()


def await_people(client: Process, names: set[str], limit_s: float = 120.0) -> None:
    """Waits until a client says in its report that it brings these people."""

    def holds() -> bool:
        return {person["name"] for person in client.report()["people"]} == names

    await_that(holds, f"{sorted(names)}", limit_s)


def profiles_in(folder: Path) -> list[Path]:
    """What is kept of people in a data folder."""
    return sorted(folder.rglob("calibrations/*.json"))


def find_poses(recording: Path, name: str, moments_s: list[float]) -> list[dict]:
    """How near somebody comes to moments of the walk, in their order: see struck_poses.gd."""
    at = ",".join(str(moment) for moment in moments_s)
    options = [f"--recording={recording}", f"--name={name}", f"--bvh={WALK}", f"--at={at}"]
    limits = [f"--mean={MEAN_DEG}", f"--worst={WORST_DEG}"]
    found: list[dict] = _ask("struck_poses.gd", *options, *limits)
    return found


def _ask(script: str, *options: str) -> Any:
    """What a script of this folder finds, a line of JSON among what it says."""
    arguments = ["--path", str(ROOT), "-s", f"res://tests/system/{script}", "--", *options]
    code, text = engine().call(arguments, 600)
    lines = [line for line in text.splitlines() if line.startswith(("{", "["))]
    assert code == 0, text
    assert lines, text
    return json.loads(lines[0])
