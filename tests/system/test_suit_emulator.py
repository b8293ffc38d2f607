# SPDX-License-Identifier: MIT
"""Emulated suits behind umockdev, read by a program with the real libusb."""

from __future__ import annotations

import csv
import json
import os
import re
import resource
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from toolchain.project import EXTENSIONS

EMULATOR = EXTENSIONS / "xbus" / "suit_emulator"
STREAM = EXTENSIONS / "xbus" / "suit_stream"
LIMIT_S = 30.0

pytestmark = pytest.mark.skipif(not EMULATOR.exists(), reason="built without umockdev")


class Emulated:
    """A program under the emulator, with the emulator's files."""

    def __init__(self, folder: Path, options: list[str], command: list[str]) -> None:
        self.trace_file = folder / "trace.csv"
        self.log_file = folder / "log.txt"
        pipe = folder / "commands"
        os.mkfifo(pipe)
        self._commands = os.open(pipe, os.O_RDWR)
        files = [f"--trace={self.trace_file}", f"--log={self.log_file}", f"--commands={pipe}"]
        self.output_file = folder / "output.txt"
        with self.output_file.open("wb") as output:
            self.process = subprocess.Popen(
                [str(EMULATOR), *files, *options, *(["--", *command] if command else [])],
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
            )

    def command(self, line: str) -> None:
        os.write(self._commands, f"{line}\n".encode())

    def output(self) -> str:
        return self.output_file.read_text(encoding="utf-8", errors="replace")

    def log(self) -> list[str]:
        """What the emulator has noted, without times and places."""
        text = self.log_file.read_text(encoding="utf-8")
        return [line.split(" ", 2)[2] for line in text.splitlines()]

    def await_text(self, text: str, count: int = 1) -> None:
        end = time.monotonic() + LIMIT_S
        while self.output().count(text) < count:
            assert time.monotonic() < end, f"'{text}' did not come:\n{self.output()}"
            assert self.process.poll() is None, f"it ended before '{text}':\n{self.output()}"
            time.sleep(0.02)

    def finish(self) -> int:
        return self.process.wait(LIMIT_S)

    def stats(self) -> dict[str, Any]:
        """The stats at the end of suit_stream's output."""
        stats: dict[str, Any] = json.loads(self.output().strip().splitlines()[-1])
        return stats

    def close(self) -> None:
        if self.process.poll() is None:
            self.process.terminate()
            self.process.wait(LIMIT_S)
        os.close(self._commands)


Start = Callable[..., Emulated]


@pytest.fixture
def start(tmp_path: Path) -> Any:
    """Starts suit_stream, or another program, under the emulator."""
    started: list[Emulated] = []

    def _start(*options: str, command: list[str] | None = None) -> Emulated:
        folder = tmp_path / str(len(started))
        folder.mkdir()
        program = [str(STREAM), "--frames=60"] if command is None else command
        started.append(Emulated(folder, list(options), program))
        return started[-1]

    yield _start
    for one in started:
        one.close()


@pytest.mark.parametrize(
    ("kind", "trackers"),
    [("ftdi", [6]), ("ftdi-fast", [6]), ("native", [6]), ("two-masters", [3, 3]), ("mti", [1])],
)
def test_every_kind_of_device_streams(start: Start, kind: str, trackers: list[int]) -> None:
    emulated = start(f"--devices={kind}", "--sensors=6")
    assert emulated.finish() == 0
    devices = emulated.stats()["devices"]
    assert sorted(len(device["trackers"]) for device in devices) == trackers
    # A busy machine may fetch too late once or twice: then the chip's buffer runs over, as a real
    # one's does, and what is cut in two is left out.
    for device in devices:
        assert device["malformed_bytes"] < 1000
        for tracker in device["trackers"]:
            assert tracker["lost"] <= 1 + tracker["received"] // 20


def test_the_host_s_requests_can_be_read(start: Start) -> None:
    emulated = start("--devices=ftdi", "--sensors=2")
    assert emulated.finish() == 0
    log = emulated.log()
    # As the kernel's driver does it, but with a latency of 1 ms.
    requests = [line.split()[1:4] for line in log if line.startswith("control")]
    assert ["40", "09", "0001"] in requests
    opened = [["40", "00", "0000"], ["40", "03", "4006"], ["40", "01", "0303"]]
    assert all(one in requests for one in opened)
    assert requests[-2:] == [["40", "02", "0000"], ["40", "01", "0300"]]
    drivers = [line for line in log if line.startswith(("driver", "claim", "release"))]
    assert drivers == [
        "driver attached 0",
        "driver detached 0",
        "claim 0",
        "release 0",
        "driver attached 0",
    ]
    messages = [line.split()[3] for line in log if line.startswith("message")]
    order = ["GoToConfig", "ReqDID", "InitBus", "ReqConfiguration", "SetOutputMode", "SetPeriod"]
    places = [messages.index(name) for name in [*order, "GoToMeasurement"]]
    assert places == sorted(places)


def test_the_trace_has_every_sample(start: Start) -> None:
    emulated = start("--devices=ftdi", "--sensors=6", "--first-counter=65510")
    assert emulated.finish() == 0
    with emulated.trace_file.open(encoding="utf-8") as file:
        rows = [{name: int(value) for name, value in row.items()} for row in csv.DictReader(file)]
    counters = [row["counter"] for row in rows]
    assert counters[:60] == [(65510 + i) % 65536 for i in range(60)]
    begin = rows[0]["sampled_usec"]
    for i, row in enumerate(rows):
        # 100 Hz exactly; then the line takes its time, and the chip at most its latency.
        assert abs(row["sampled_usec"] - begin - i * 10000) <= 1
        assert row["sampled_usec"] < row["on_chip_usec"] <= row["handed_over_usec"]


def test_a_device_comes_and_goes(start: Start) -> None:
    emulated = start("--devices=native", "--sensors=3", command=[str(STREAM), "--seconds=20"])
    emulated.await_text("measures")
    emulated.command("unplug")
    emulated.await_text("was unplugged")
    emulated.command("plug")
    # It has a new number, as on a real bus.
    emulated.await_text("001/003: Xbus Master")
    emulated.command("unplug")
    emulated.await_text("was unplugged")
    emulated.command("quit")
    emulated.finish()
    assert [line for line in emulated.log() if "plugged" in line] == [
        "plugged",
        "unplugged",
        "plugged",
        "unplugged",
    ]
    assert emulated.log().count("driver detached 1") == 2


def test_faults_on_the_line_are_survived(start: Start) -> None:
    emulated = start(
        "--sensors=6", "--corrupt=0.0005", "--drop=0.0002", command=[str(STREAM), "--frames=300"]
    )
    emulated.await_text("measures")
    assert emulated.finish() == 0
    (device,) = emulated.stats()["devices"]
    assert device["malformed_bytes"] > 0
    assert device["trackers"][0]["lost"] > 0


def test_orders_while_it_runs(start: Start) -> None:
    emulated = start("--devices=native", "--sensors=3", command=[str(STREAM), "--seconds=20"])
    emulated.await_text("measures")
    emulated.command("error 2a")
    emulated.await_text("2A")
    emulated.command("nonsense")
    emulated.await_text("there is no command 'nonsense'")
    emulated.command("corrupt")
    emulated.await_text("'corrupt' needs a number")
    emulated.command("quit")
    emulated.finish()


def test_a_device_that_nobody_may_open(start: Start) -> None:
    emulated = start("--devices=native", "--forbidden", command=[str(STREAM), "--seconds=1"])
    emulated.finish()
    assert "no permission" in emulated.output()
    assert ".rules" in emulated.output()
    assert "claim 1" not in emulated.log()


def test_a_program_that_waits_does_not_turn_in_circles(start: Start) -> None:
    """libusb polls the node: one that is always ready would keep a processor busy."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    emulated = start("--devices=native", "--sensors=3", command=[str(STREAM), "--seconds=3"])
    assert emulated.finish() == 0
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = (after.ru_utime + after.ru_stime) - (before.ru_utime + before.ru_stime)
    assert spent < 1.5


def test_a_second_terminal_finds_the_devices(start: Start) -> None:
    emulated = start("--devices=native", "--sensors=3", command=[])
    emulated.await_text("UMOCKDEV_DIR=")
    own = dict(re.findall(r"(\w+)=(\S+)", emulated.output().splitlines()[0]))
    environment = {**os.environ, **own}
    # One that is killed lets go of the device, as with the kernel.
    with subprocess.Popen([str(STREAM)], env=environment, stdout=subprocess.DEVNULL) as killed:
        end = time.monotonic() + LIMIT_S
        while "state measurement" not in emulated.log():
            assert time.monotonic() < end
            time.sleep(0.02)
        killed.kill()
    done = subprocess.run(
        [str(STREAM), "--frames=30"],
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=LIMIT_S,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "measures: 3 trackers" in done.stdout + done.stderr
    emulated.command("quit")
    assert emulated.finish() == 0
    assert len(emulated.output().splitlines()) == 1


def test_the_exit_code_is_the_program_s(start: Start) -> None:
    assert start(command=["sh", "-c", "exit 7"]).finish() == 7
    assert start(command=["/no/such/program"]).finish() == 127


@pytest.mark.parametrize("option", ["--sensors=0", "--devices=toaster", "--stream=/nothing", "x"])
def test_wrong_options_are_a_sentence(start: Start, option: str) -> None:
    emulated = start(option)
    assert emulated.finish() == 2
    assert emulated.output().startswith("suit_emulator: ")
    assert len(emulated.output().splitlines()) == 1
