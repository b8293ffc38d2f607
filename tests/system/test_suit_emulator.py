# SPDX-License-Identifier: MIT
"""Emulated suits behind umockdev, read by a program with the real libusb."""

from __future__ import annotations

import csv
import json
import os
import re
import resource
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from toolchain.paths import CLIENT_BINARY
from toolchain.processes import Program, await_that, free_port
from toolchain.project import EXTENSIONS

EMULATOR = EXTENSIONS / "xbus" / "suit_emulator"
STREAM = EXTENSIONS / "xbus" / "suit_stream"
LIMIT_S = 600.0

pytestmark = pytest.mark.skipif(not EMULATOR.exists(), reason="built without umockdev")


class Emulated:
    """A program under the emulator, with the emulator's files."""

    def __init__(
        self,
        folder: Path,
        options: list[str],
        command: list[str],
        environment: dict[str, str] | None = None,
    ) -> None:
        self.trace_file = folder / "trace.csv"
        self.log_file = folder / "log.txt"
        pipe = folder / "commands"
        os.mkfifo(pipe)
        self._commands = os.open(pipe, os.O_RDWR)
        files = [f"--trace={self.trace_file}", f"--log={self.log_file}", f"--commands={pipe}"]
        whole = [str(EMULATOR), *files, *options, *(["--", *command] if command else [])]
        own = {**os.environ, **(environment or {})}
        self.program = Program(whole, folder / "output.txt", own)
        self.process, self.output = self.program.process, self.program.log
        self.await_text = self.program.await_text

    def command(self, line: str) -> None:
        os.write(self._commands, f"{line}\n".encode())

    def log(self) -> list[str]:
        """What the emulator has noted, without times and places."""
        text = self.log_file.read_text(encoding="utf-8")
        return [line.split(" ", 2)[2] for line in text.splitlines()]

    def finish(self) -> int:
        return self.program.await_exit(LIMIT_S)

    def stats(self) -> dict[str, Any]:
        """The stats at the end of suit_stream's output."""
        stats: dict[str, Any] = json.loads(self.output().strip().splitlines()[-1])
        return stats

    def close(self) -> None:
        self.program.kill(LIMIT_S)
        os.close(self._commands)


Start = Callable[..., Emulated]


@pytest.fixture
def start(tmp_path: Path) -> Any:
    """Starts suit_stream, or another program, under the emulator."""
    started: list[Emulated] = []

    def _start(
        *options: str,
        command: list[str] | None = None,
        environment: dict[str, str] | None = None,
    ) -> Emulated:
        folder = tmp_path / str(len(started))
        folder.mkdir()
        program = [str(STREAM), "--frames=60"] if command is None else command
        started.append(Emulated(folder, list(options), program, environment))
        return started[-1]

    yield _start
    for one in started:
        one.close()


@pytest.mark.parametrize(
    ("kind", "trackers"),
    [
        ("ftdi", [6]),
        ("ftdi-fast", [6]),
        ("native", [6]),
        ("two-masters", [3, 3]),
        ("two-native-masters", [3, 3]),
        ("mti", [1]),
    ],
)
def test_every_kind_of_device_streams(start: Start, kind: str, trackers: list[int]) -> None:
    emulated = start(f"--devices={kind}", "--sensors=6")
    assert emulated.finish() == 0
    devices = emulated.stats()["devices"]
    assert sorted(len(device["trackers"]) for device in devices) == trackers
    # A busy machine may fetch too late now and then: the chip's buffer runs over, as a real one's
    # does, for as long as nobody fetches, and what is cut in two is left out.
    for device in devices:
        assert device["malformed_bytes"] < 1000
        for tracker in device["trackers"]:
            assert tracker["received"] >= 10
            assert tracker["lost"] <= max(10, tracker["received"] // 2)


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
    """libusb polls the node: at one that is always ready it would ask ten times as often."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    emulated = start("--devices=native", "--sensors=3")
    assert emulated.finish() == 0
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    samples = emulated.stats()["devices"][0]["trackers"][0]["received"]
    # Each question waits for the emulator's answer.
    assert (after.ru_nvcsw - before.ru_nvcsw) / samples < 200


def test_a_second_terminal_finds_the_devices(start: Start) -> None:
    emulated = start("--devices=native", "--sensors=3", command=[])
    emulated.await_text("UMOCKDEV_DIR=")
    own = dict(re.findall(r"(\w+)=(\S+)", emulated.output().splitlines()[0]))
    environment = {**os.environ, **own}
    # One that is killed lets go of the device, as with the kernel.
    with subprocess.Popen([str(STREAM)], env=environment, stdout=subprocess.DEVNULL) as killed:
        await_that(lambda: "state measurement" in emulated.log(), "a measurement", LIMIT_S)
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


def test_a_program_with_a_window_finds_the_suit(
    start: Start, tmp_path: Path, display: dict[str, str]
) -> None:
    """A window looks for joysticks and graphics cards in /dev, most of which are not there."""
    client = [str(CLIENT_BINARY), "--audio-driver", "Dummy", "--resolution", "320x180", "--"]
    client += ["--role=trainee", f"--port={free_port()}"]
    options = ["--xbus", "--calibrate=full", "--name=Ada"]
    home = {f"XDG_{kind}_HOME": str(tmp_path / kind) for kind in ("DATA", "CONFIG", "CACHE")}
    emulated = start(command=[*client, *options], environment={**display, **home})
    emulated.await_text("measures:")
    emulated.await_text("calibrating (full)")
    emulated.command("quit")
    emulated.finish()
    assert "umockdev" not in emulated.output()


def test_real_devices_are_none_of_umockdev_s_business(start: Start) -> None:
    """Its table has 50 rows, and it would keep those of failed and of real ones."""
    script = """
import os
failed = 0
def refused(name):
    try:
        os.open(name, os.O_RDWR)
    except OSError:
        return 1
    return 0
failed += sum(refused(f"/dev/nothing{i}") for i in range(200))
kept = [open("/dev/null") for _ in range(100)]
node = next(os.path.join(p, f) for p, _, found in os.walk("/dev/bus/usb") for f in found)
failed += sum(refused(node) for _ in range(200))
print(failed, "failed")
"""
    emulated = start("--forbidden", command=[sys.executable, "-c", script])
    assert emulated.finish() == 0, emulated.output()
    assert emulated.output() == "400 failed\n"


def test_the_exit_code_is_the_program_s(start: Start) -> None:
    assert start(command=["sh", "-c", "exit 7"]).finish() == 7
    assert start(command=["/no/such/program"]).finish() == 127


@pytest.mark.parametrize("option", ["--sensors=0", "--devices=toaster", "--stream=/nothing", "x"])
def test_wrong_options_are_a_sentence(start: Start, option: str) -> None:
    emulated = start(option)
    assert emulated.finish() == 2
    assert emulated.output().startswith("suit_emulator: ")
    assert len(emulated.output().splitlines()) == 1
