# SPDX-License-Identifier: MIT
"""A server, a trainee in an emulated suit who calibrates, and observers who record, on loopback."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from types import TracebackType

from . import suit
from .console import Failure, tail
from .godot import Godot
from .paths import CLIENT_BINARY, ROOT, SERVER_BINARY
from .processes import Group, require_port

SAMPLE = "res://tests/bench/suit/sample_suit.gd"
COMPARE = "res://tests/bench/suit/compare_recording.gd"
# A calibration of the kind "full", with time to spare.
CALIBRATION_S = 60.0


class SuitSession:
    """The processes of one session; they end with it. Calibrations are kept in its folder."""

    def __init__(self, folder: Path, port: int, root: str = "inertial") -> None:
        require_port(port)
        self._folder = folder
        self._port = port
        self._root = root
        self._group = Group(folder, {"XDG_DATA_HOME": str(folder / "data")})
        self._pipes: dict[str, int] = {}

    def __enter__(self) -> SuitSession:
        self._group.__enter__()
        command = [str(SERVER_BINARY), "--headless", "--", "--role=server", f"--port={self._port}"]
        self._group.start("server", [*command, f"--root={self._root}"])
        self._group.await_text("server", "listening on UDP port", 30)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        for pipe in self._pipes.values():
            os.close(pipe)
        self._pipes.clear()
        self._group.__exit__(kind, error, trace)

    def start_bvh(self, bvh: Path) -> None:
        """A trainee who moves by the file itself."""
        self._group.start("trainee", self.trainee(f"--bvh={bvh}"))
        self._group.await_text("trainee", "joined", 30)

    def calibrate(self, godot: Godot, bvh: Path, options: list[str]) -> None:
        """Lets somebody in an emulated suit be calibrated, and leave."""
        name = "calibration"
        command = self.trainee("--xbus", "--calibrate=full")
        self.start_emulator(godot, bvh, options, command, name)
        self._group.await_text(name, "calibrating (", 30)
        self.command("go", name)
        self._group.await_text(name, "calibrated", CALIBRATION_S)
        if "not calibrated" in self._group.log(name):
            raise Failure("The suit was not calibrated:\n" + tail(self._group.log(name), 5))
        self.command("quit", name)
        self._group.await_exit(name, 30)

    def start_suit(self, godot: Godot, bvh: Path, options: list[str]) -> None:
        """A trainee in an emulated suit, calibrated before; the motion of the file begins now."""
        self.calibrate(godot, bvh, options)
        self.start_emulator(godot, bvh, options, self.trainee("--xbus"))
        self._group.await_text("trainee", "joined", 30)
        masters = 2 if any(option.startswith("--devices=two-") for option in options) else 1
        for master in range(masters):
            self._group.await_text("trainee", f"Xbus Master 0013050{master} measures", 30)
        self.command("clip")

    def start_emulator(
        self,
        godot: Godot,
        bvh: Path,
        options: list[str],
        command: list[str],
        name: str = "trainee",
    ) -> None:
        """An emulated suit, whose wearer stands still, and a program that finds it."""
        own = [f"--bvh={bvh}", *options]
        pipe = self._folder / f"{name}.commands"
        self._pipes[name] = _start_emulator(self._group, godot, own, command, pipe, name)

    def trainee(self, *options: str) -> list[str]:
        """The command of a trainee without a window."""
        common = ["--role=trainee", f"--port={self._port}", "--name=wearer", "--person=wearer"]
        return [str(CLIENT_BINARY), "--headless", "--", *common, *options]

    def command(self, line: str, name: str = "trainee") -> None:
        """Sends an emulator a command."""
        os.write(self._pipes[name], f"{line}\n".encode())

    def await_text(self, name: str, text: str, limit_s: float = 30.0) -> None:
        """Waits until a process has said something."""
        self._group.await_text(name, text, limit_s)

    def log(self, name: str) -> str:
        """What a process has said."""
        return self._group.log(name)

    def record(self, recording: Path, seconds: float, name: str = "observer") -> None:
        """Lets an observer record for a while."""
        options = ["--role=observer", f"--port={self._port}", f"--duration={seconds}"]
        options.append(f"--record={recording}")
        self._group.start(name, [str(CLIENT_BINARY), "--headless", "--", *options])
        self._group.await_exit(name, seconds + 60)
        if not recording.exists():
            raise Failure(f"The observer recorded nothing:\n{tail(self._group.log(name))}")


def sample(
    godot: Godot, bvh: Path, options: list[str], masters: int, seconds: float, folder: Path
) -> dict:
    """How far the samples of an emulated suit are from a motion file: sample_suit.gd."""
    folder.mkdir()
    own = [f"--bvh={bvh}", *options]
    command = [str(godot.program), "--headless", "--no-header", "--path", str(ROOT), "-s", SAMPLE]
    command += ["--", f"--bvh={bvh}", f"--masters={masters}", f"--seconds={seconds}"]
    with Group(folder, godot.environment()) as group:
        commands = _start_emulator(group, godot, own, command, folder / "commands", "suit")
        try:
            group.await_text("suit", "ready", 60)
            os.write(commands, b"go\n")
            group.await_exit("suit", CALIBRATION_S + seconds + 60)
        finally:
            os.close(commands)
        return _result(group.log("suit"), "The suit was not sampled")


def compare(
    godot: Godot, recording: Path, bvh: Path, begin: float, end: float, slack_s: float = 0.0
) -> dict:
    """How far the person in a recording is from a part of a motion file: compare_recording.gd."""
    options = [f"--recording={recording}", f"--bvh={bvh}", f"--from={begin}", f"--slack={slack_s}"]
    command = [str(godot.program), "--headless", "--no-header", "--path", str(ROOT), "-s", COMPARE]
    done = subprocess.run(
        [*command, "--", *options, f"--to={end}"],
        env=godot.environment(),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    failure = "The recording could not be compared"
    if done.returncode != 0:
        raise Failure(f"{failure}:\n{tail(done.stdout + done.stderr)}")
    return _result(done.stdout, failure)


def _start_emulator(
    group: Group, godot: Godot, options: list[str], command: list[str], pipe: Path, name: str
) -> int:
    """An emulated suit, whose wearer stands still, and a program; the end that takes commands."""
    os.mkfifo(pipe)
    commands = os.open(pipe, os.O_RDWR)
    own = [*options, "--hold", f"--commands={pipe}"]
    group.start(name, [str(suit.PROGRAM), *suit.complete(godot, own), "--", *command])
    return commands


def _result(said: str, failure: str) -> dict:
    """What a program found, a line of JSON among what it said."""
    found = [line for line in said.splitlines() if line.startswith("{")]
    if not found:
        raise Failure(f"{failure}:\n{tail(said)}")
    result: dict = json.loads(found[0])
    return result
