# SPDX-License-Identifier: MIT
"""Starts the exported server and clients for whole-process tests, on 127.0.0.1 only."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from toolchain.display import virtual_display
from toolchain.godot import Godot, find
from toolchain.paths import CLIENT_BINARY, CLIPS, ROOT, SERVER_BINARY
from toolchain.processes import LOOK_S, ask, free_port
from toolchain.schedule import started

from .processes import Process

__all__ = ["LOOK_S", "Process", "World", "ask", "shared"]

SOFTWARE = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]
WINDOW_LIMIT_S = 600.0
# Frames a second of a client without a window: it takes in and sends less often, and costs a third.
HEADLESS_FPS = 30


class World:
    """Starts processes that end with the test."""

    # Those that are not closed yet.
    all: list[World] = []

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.port = free_port()
        self.processes: list[Process] = []
        self.is_spent = False
        World.all.append(self)

    def server(self, *options: str, name: str = "server", wait: bool = True) -> Process:
        # The small world that most tests are about, where none is named.
        own = any(option.startswith(("--world", "--config")) for option in options)
        world = [] if own else ["--world=hall"]
        if not any(option.startswith(("--max-per-address", "--config")) for option in options):
            # All clients of a test come from one address.
            options = ("--max-per-address=0", *options)
        command = [str(SERVER_BINARY), "--headless", "--", f"--port={self.port}", *world, *options]
        ports = [
            o.partition("=")[2] for o in options if o.startswith(("--port=", "--status-port="))
        ]
        started["servers"] += 1
        process = self.start(name, command)
        if wait:
            process.await_text("listening on UDP port")
            if "there is no status" not in process.log():
                process.status_port = int(ports[-1]) if ports else self.port
        return process

    def client(
        self,
        role: str,
        *options: str,
        name: str = "",
        cwd: Path | None = None,
        types: bool = False,
    ) -> Process:
        if role not in ("replay", "load") and not any("--fps=" in o for o in options):
            options = (f"--fps={HEADLESS_FPS}", *options)
        is_named = role == "replay" or any(o.startswith("--port=") for o in options)
        port = [] if is_named else [f"--port={self.port}"]
        command = [str(CLIENT_BINARY), "--headless", "--", f"--role={role}", *port, *options]
        started["clients"] += 1
        # What somebody who stays has got from the server is not the others'.
        own_home = {"XDG_DATA_HOME": str(self.folder / f"{role}-data")} if types else {}
        return self.start(name or role, command, own_home, cwd, types=types)

    def trainee(self, *options: str, name: str = "trainee", clip: str = "01_01.bvh") -> Process:
        return self.client("trainee", f"--bvh={CLIPS / clip}", *options, name=name)

    def instructor(self, *options: str, name: str = "instructor") -> Process:
        """One that is there, and gives the orders that are typed."""
        process = self.client("instructor", *options, name=name, types=True)
        # Before its level is there, it does not know what is in it.
        process.await_line("world '", "is there after")
        return process

    def start(
        self,
        name: str,
        command: list[str],
        environment: dict[str, str] | None = None,
        cwd: Path | None = None,
        reports: bool = True,
        types: bool = False,
    ) -> Process:
        # The log of one that had the name before is still of use.
        before = sum(1 for one in self.processes if one.log_file.stem.split("~")[0] == name)
        file = f"{name}~{before + 1}" if before else name
        process = Process(file, command, self.folder, environment or {}, cwd, reports, types)
        self.processes.append(process)
        return process

    def describe(self) -> str:
        """How all processes are, for whoever looks for the reason of a failure."""
        return "\n".join(process.describe() for process in self.processes)

    def close(self) -> None:
        World.all.remove(self)
        for process in self.processes:
            process.kill()


class SharedWorld(World):
    """Processes that last for several tests: starting them takes longer than most tests do.

    What a test starts besides ends with it. What lasts is as the test found it, or is started anew
    for the next: after a failure, and where a test has spent it.
    """

    def __init__(self, factory: pytest.TempPathFactory, begin: Callable[[World], Any]) -> None:
        super().__init__(factory.getbasetemp())
        self._factory = factory
        self._begin = begin
        self._lasting: list[Process] = []
        self._here: list[str] = []
        self.begun: Any = None
        # Whether the next test can't have what is there.
        self.is_spent = True

    def enter(self) -> None:
        """A test begins."""
        if self.is_spent:
            self._kill_all()
            self.folder, self.port = self._factory.mktemp("shared"), free_port()
            self.processes.clear()
            self.begun = self._begin(self)
            self._lasting = self.processes.copy()
            self._here = self._who_is_here()
            self.is_spent = False
        for process in self._lasting:
            process.mark()

    def leave(self) -> None:
        """A test ends: whom it has brought leave, and nothing has happened to the others."""
        if self.is_spent:
            return
        self.is_spent = True
        for process in self.processes:
            name = process.log_file.name
            if process in self._lasting:
                assert process.process.poll() is None, f"{name} has ended:\n{process.log()}"
                assert "ERROR" not in process.log(), f"{name}:\n{process.log()}"
            elif process.process.poll() is None:
                process.process.terminate()
        for process in self.processes:
            if process not in self._lasting:
                process.await_exit()
        self._lasting[0].await_report(lambda _report: self._who_is_here() == self._here)
        self.is_spent = False

    def end(self) -> None:
        """No more tests come."""
        if self.is_spent:
            return
        for process in self._lasting:
            process.mark()
            process.process.terminate()
        for process in self._lasting:
            assert process.await_exit() == 0, process.log()
            assert "ERROR" not in process.log(), process.log()

    def _who_is_here(self) -> list[str]:
        """Names of the sessions that are connected, as the server tells; it is the first."""
        rows = self._lasting[0].report()["sessions"]
        return sorted(row["name"] for row in rows if row["state"] == "here")

    def _kill_all(self) -> None:
        for process in self.processes:
            process.kill()


class SharedWorlds:
    """The shared world that a file's tests use at the moment: one that nobody uses takes time."""

    def __init__(self, factory: pytest.TempPathFactory) -> None:
        self._factory = factory
        self._begin: Callable[[World], Any] | None = None
        self.world: SharedWorld | None = None

    @contextmanager
    def visit(self, begin: Callable[[World], Any]) -> Iterator[Any]:
        """Lets a test have the world that begins so, and what `begin` returned."""
        if self.world is None or self._begin is not begin:
            self.close()
            self._begin = begin
            self.world = SharedWorld(self._factory, begin)
        self.world.enter()
        yield self.world.begun
        self.world.leave()

    def close(self) -> None:
        """Ends it: what lasted so long ends in order, too."""
        if self.world is None:
            return
        world, self.world = self.world, None
        try:
            world.end()
        finally:
            world.close()


def shared(begin: Callable[[World], Any]) -> Any:
    """Makes a fixture of what `begin` returns, which starts a server, and clients that stay.

    Tests of one file share it, one after the other: see SharedWorld. Tests that want the same stand
    together, as another shared world ends it.
    """

    @pytest.fixture
    def visited(shared_worlds: SharedWorlds) -> Iterator[Any]:
        with shared_worlds.visit(begin) as begun:
            yield begun

    return visited


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


@pytest.fixture(scope="module")
def shared_worlds(tmp_path_factory: pytest.TempPathFactory) -> Iterator[SharedWorlds]:
    """For the fixtures that `shared` makes."""
    worlds = SharedWorlds(tmp_path_factory)
    yield worlds
    worlds.close()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo) -> Any:
    """Adds to a failure how each process is and what it has said last."""
    report = yield
    if report.failed:
        report.sections += [("processes", world.describe()) for world in World.all]
        for world in World.all:
            # Nobody knows what it has left behind.
            world.is_spent = True
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
    started["windows"] += 1
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
