# SPDX-License-Identifier: MIT
"""Starts the exported server and clients for whole-process tests, on 127.0.0.1 only."""

from __future__ import annotations

import json
import os
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from toolchain.display import virtual_display
from toolchain.godot import Godot, find
from toolchain.paths import CLIENT_BINARY, CLIPS, ROOT, SERVER_BINARY
from toolchain.processes import free_port

SOFTWARE = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]
WINDOW_LIMIT_S = 600.0
# Frames a second of a client without a window: it takes in and sends less often, and costs a third.
HEADLESS_FPS = 30


class Process:
    """A server or client with its log and its stats."""

    def __init__(
        self,
        name: str,
        command: list[str],
        folder: Path,
        environment: dict[str, str],
        cwd: Path | None = None,
        reports: bool = True,
    ) -> None:
        self.log_file = folder / f"{name}.log"
        self.report_file = folder / f"{name}.json"
        home = {f"XDG_{kind}_HOME": str(folder / kind) for kind in ("DATA", "CONFIG", "CACHE")}
        plain = {k: v for k, v in os.environ.items() if not k.startswith("DISMOUNT_")}
        with self.log_file.open("wb") as log:
            self.process = subprocess.Popen(
                [*command, *([f"--report={self.report_file}"] if reports else [])],
                cwd=cwd,
                env={**plain, **home, **environment, "PWD": str(cwd or Path.cwd())},
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
            )

    def log(self) -> str:
        return self.log_file.read_text(encoding="utf-8", errors="replace")

    def report(self) -> dict:
        """The newest report; the first one comes some time after the start."""
        return self.await_report(lambda _report: True)

    def _read_report(self) -> dict:
        return json.loads(self.report_file.read_text(encoding="utf-8"))

    def await_report(self, holds: Callable[[dict], bool], limit_s: float = 120.0) -> dict:
        """The report as soon as something holds of it."""
        end = time.monotonic() + limit_s
        while True:
            try:
                report = self._read_report()
                if holds(report):
                    return report
            except (OSError, ValueError, LookupError):
                report = {}  # Not written yet, or only in part.
            assert time.monotonic() < end, f"it did not come in {limit_s} s: {report}"
            assert self.process.poll() is None, f"it ended before:\n{self.log()}"
            time.sleep(0.1)

    def await_text(self, text: str, limit_s: float = 120.0, count: int = 1) -> None:
        end = time.monotonic() + limit_s
        while self.log().count(text) < count:
            assert time.monotonic() < end, f"'{text}' did not come in {limit_s} s:\n{self.log()}"
            assert self.process.poll() is None, f"it ended before '{text}':\n{self.log()}"
            time.sleep(0.05)

    def await_exit(self, limit_s: float = 120.0) -> int:
        try:
            return self.process.wait(limit_s)
        except subprocess.TimeoutExpired:
            pytest.fail(f"it does not end within {limit_s} s:\n{self.log()}")

    def fresh_report(self) -> dict:
        """A report that has just been written: one that lies there is up to a second old."""
        stale = self.await_report(lambda _report: True)
        return self.await_report(lambda report: report["seconds"] != stale["seconds"])

    def end(self) -> int:
        """Asks it to end; returns its exit code."""
        self.process.terminate()
        return self.await_exit()

    def describe(self) -> str:
        """How it is and what it has said last, for whoever looks for the reason of a failure."""
        code = self.process.poll()
        state = f"ended with {code}" if code is not None else "runs"
        waits = [] if code is not None else thread_states(self.process.pid)
        last = self.log().splitlines()[-40:]
        return "\n".join([f"--- {self.log_file.name}: {state}", *waits, *last])

    def kill(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()


class World:
    """Starts processes that end with the test."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.port = free_port()
        self.processes: list[Process] = []

    def server(self, *options: str, name: str = "server", wait: bool = True) -> Process:
        # The small world that most tests are about, where none is named.
        own = any(option.startswith(("--world", "--config")) for option in options)
        world = [] if own else ["--world=hall"]
        command = [str(SERVER_BINARY), "--headless", "--", f"--port={self.port}", *world, *options]
        process = self.start(name, command)
        if wait:
            process.await_text("listening on UDP port")
        return process

    def client(
        self,
        role: str,
        *options: str,
        name: str = "",
        cwd: Path | None = None,
    ) -> Process:
        if role != "replay" and not any("--fps=" in o for o in options):
            options = (f"--fps={HEADLESS_FPS}", *options)
        is_named = role == "replay" or any(o.startswith("--port=") for o in options)
        port = [] if is_named else [f"--port={self.port}"]
        command = [str(CLIENT_BINARY), "--headless", "--", f"--role={role}", *port, *options]
        return self.start(name or role, command, cwd=cwd)

    def trainee(self, *options: str, name: str = "trainee", clip: str = "01_01.bvh") -> Process:
        return self.client("trainee", f"--bvh={CLIPS / clip}", *options, name=name)

    def start(
        self,
        name: str,
        command: list[str],
        environment: dict[str, str] | None = None,
        cwd: Path | None = None,
        reports: bool = True,
    ) -> Process:
        process = Process(name, command, self.folder, environment or {}, cwd, reports)
        self.processes.append(process)
        return process

    def describe(self) -> str:
        """How all processes are, for whoever looks for the reason of a failure."""
        return "\n".join(process.describe() for process in self.processes)

    def close(self) -> None:
        for process in self.processes:
            process.kill()


def thread_states(pid: int) -> list[str]:
    """What each thread of a process does: whether it runs, or in which call it waits."""
    lines = []
    for task in sorted(Path(f"/proc/{pid}/task").glob("*")):
        try:
            # The state comes after the name, which may itself have brackets.
            rest = (task / "stat").read_text().rpartition(")")[2].split()
            name = (task / "comm").read_text().strip()
            waits = (task / "wchan").read_text().strip()
        except OSError:
            continue  # It has just ended.
        ticks = int(rest[11]) + int(rest[12])
        lines.append(f"    thread {task.name} {name}: {rest[0]} in '{waits}', {ticks} ticks")
    return lines


@pytest.fixture
def world(tmp_path: Path) -> Iterator[World]:
    """Processes of this test alone."""
    world = World(tmp_path)
    yield world
    world.close()


@pytest.fixture(scope="module")
def shared_world(tmp_path_factory: pytest.TempPathFactory) -> Iterator[World]:
    """Processes that all tests of a file share: starting them anew takes longer than most tests."""
    world = World(tmp_path_factory.mktemp("shared"))
    yield world
    world.close()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo) -> Any:
    """Adds to a failure how each process is and what it has said last."""
    report = yield
    if report.failed:
        worlds = {one for one in item.funcargs.values() if isinstance(one, World)}
        report.sections += [("processes", world.describe()) for world in worlds]
    return report


@pytest.fixture(scope="session")
def display() -> Iterator[dict[str, str]]:
    with virtual_display(keeps_shaders=True) as environment:
        yield environment


@pytest.fixture(scope="session")
def godot() -> Godot:
    return find()


def run_in_window(display: dict[str, str], script: str, *flags: str) -> str:
    """What a script of this folder prints that the engine runs in a small window."""
    command = [os.environ["DISMOUNT_GODOT"], "--path", str(ROOT), *SOFTWARE, *flags]
    done = subprocess.run(
        [*command, "--resolution", "320x180", "-s", f"res://tests/system/{script}"],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
        timeout=WINDOW_LIMIT_S,
        env={**os.environ, **display},
    )
    assert done.returncode == 0, done.stdout
    return done.stdout
