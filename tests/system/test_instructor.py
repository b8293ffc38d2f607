# SPDX-License-Identifier: MIT
"""An instructor at a terminal: commands by name, answers by name and outcome, completion."""

from __future__ import annotations

import contextlib
import os
import pty
import select
import signal
import time
from collections.abc import Callable, Iterator

import pytest
from toolchain.paths import CLIENT_BINARY

from .conftest import LOOK_S, World, shared
from .own_client import TRAINEE, Crowd, OwnClient

LIMIT_S = 120.0
ASK_AGAIN_S = 1.0


class Console:
    """The instructor's client on a terminal of its own."""

    def __init__(self, world: World, *options: str) -> None:
        home = {f"XDG_{kind}_HOME": str(world.folder / kind) for kind in ("DATA", "CONFIG")}
        command = [str(CLIENT_BINARY), "--headless", "--", "--role=instructor"]
        command += [f"--port={world.port}", "--name=Ida", *options]
        self.shown = ""
        self._read = 0
        self.pid, self._terminal = pty.fork()
        if self.pid == 0:
            os.execvpe(command[0], command, {**os.environ, **home})

    def type(self, text: str) -> None:
        """Forgets what was shown, and types."""
        self._read = len(self.shown)
        os.write(self._terminal, text.encode())

    def shows(self, holds: Callable[[str], bool], limit_s: float) -> bool:
        """Whether something comes to hold of what was shown since something was typed."""
        end = time.monotonic() + limit_s
        while not holds(self.shown[self._read :]):
            if time.monotonic() > end:
                return False
            self._take()
        return True

    def await_text(self, text: str) -> None:
        """Waits until a text was shown since something was typed."""
        assert self.shows(lambda shown: text in shown, LIMIT_S), f"no '{text}':\n{self.shown}"

    def await_rows(self, names: list[str], *words: str) -> None:
        """Asks who is here until the rows of some have all words."""

        def holds(shown: str) -> bool:
            lines = shown.replace("\x1b[K", "").splitlines()
            rows = [line for line in lines if line.split(" ")[0] in names]
            return len(rows) == len(names) and all(word in row for word in words for row in rows)

        end = time.monotonic() + LIMIT_S
        while time.monotonic() < end:
            self.type("who\n")
            # What is not in the answer may be in the next one.
            if self.shows(holds, ASK_AGAIN_S):
                return
        pytest.fail(f"no such rows:\n{self.shown}")

    def await_exit(self) -> int:
        """Its exit code, once it has ended."""
        end = time.monotonic() + LIMIT_S
        while True:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid != 0:
                return os.waitstatus_to_exitcode(status)
            assert time.monotonic() < end, f"it does not end:\n{self.shown}"
            self._take()

    def _take(self) -> None:
        if select.select([self._terminal], [], [], LOOK_S)[0]:
            with contextlib.suppress(OSError):  # It has ended: the rest was read.
                self.shown += os.read(self._terminal, 65536).decode(errors="replace")

    def close(self) -> None:
        with contextlib.suppress(ProcessLookupError, ChildProcessError):
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
        os.close(self._terminal)


class WaitingRoom:
    """A server where everybody waits until an instructor decides."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.server = world.server("--waiting-room=1")


waiting_room = shared(WaitingRoom)


@pytest.fixture
def console(waiting_room: WaitingRoom) -> Iterator[Console]:
    console = Console(waiting_room.world)
    console.await_text("joined")
    yield console
    console.close()


def test_an_order_is_given_as_soon_as_it_can_be(waiting_room: WaitingRoom) -> None:
    world = waiting_room.world
    instructor = world.client("instructor", "--orders=admit:Eve,kick:Eve")
    instructor.await_text("joined")
    with Crowd() as crowd:
        cyd = OwnClient(world.port, TRAINEE, name="Cyd")
        crowd.add(cyd)
        crowd.go_on_until(lambda: "'Cyd' from 127.0.0.1 waits" in waiting_room.server.log())
        trainee = world.trainee("--name=Eve", name="eve")
        crowd.go_on_until(lambda: trainee.process.poll() is not None)
        assert trainee.await_exit() == 3
        assert "waiting for an instructor, position 2" in trainee.log()
        assert "joined" in trainee.log()
        assert "kicked by instructor 'instructor'" in trainee.log()
        assert not cyd.is_joined
    # It waits until its connection is lost, which takes long.
    world.is_spent = True


def test_commands_are_answered_by_name(waiting_room: WaitingRoom, console: Console) -> None:
    ada = waiting_room.world.trainee("--name=Ada")
    bob = waiting_room.world.trainee("--name=Bob", name="bob")
    for trainee in (ada, bob):
        trainee.await_text("waiting for an instructor")
    console.await_rows(["Ada", "Bob"], "waiting")
    console.type("admit a\t\n")
    console.await_text("Ada: admitted")
    ada.await_text("joined")
    console.type("admit *\n")
    console.await_text("Bob: admitted")
    bob.await_text("joined")
    console.await_rows(["Ada", "Bob"], "ms", "°", "trainee", "here")
    console.type("kick Nobody\n")
    console.await_text("nobody is called Nobody")
    console.type("calibrate Ada quick\n")
    console.await_text("Ada: not calibrated: this motion comes calibrated")
    console.type("level atlantis\n")
    console.await_text("atlantis")
    console.type("level yard\n")
    console.await_text("the world is now 'yard'")
    console.type("kick Bob too loud\n")
    console.await_text("Bob: kicked")
    assert bob.await_exit() == 3
    assert "kicked by instructor 'Ida': too loud" in bob.log()
    console.type("quit\n")
    assert console.await_exit() == 0


def test_commands_of_a_pipe(waiting_room: WaitingRoom) -> None:
    """They are there before the connection is, and wait for it."""
    world = waiting_room.world
    with Crowd() as crowd:
        ada = OwnClient(world.port, TRAINEE, name="Ada")
        crowd.add(ada)
        crowd.go_on_until(lambda: "'Ada' from 127.0.0.1 waits" in waiting_room.server.log())
        instructor = world.client("instructor", types=True)
        instructor.type("who\nadmit Ada\nquit")
        crowd.go_on_until(lambda: ada.is_joined and instructor.process.poll() is not None)
    assert instructor.await_exit() == 0, instructor.log()
    assert "Ada: admitted" in instructor.log()
    assert any(line.startswith("Ada ") for line in instructor.log().splitlines())
