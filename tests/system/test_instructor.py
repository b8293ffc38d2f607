# SPDX-License-Identifier: MIT
"""An instructor at a terminal: commands by name, answers by name and outcome, completion."""

from __future__ import annotations

import contextlib
import os
import pty
import select
import signal
import subprocess
import time
from collections.abc import Iterator

import pytest
from toolchain.paths import CLIENT_BINARY

from .conftest import World


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

    def await_text(self, text: str, limit_s: float = 120.0) -> str:
        """What was shown since something was typed, once it has a text."""
        end = time.monotonic() + limit_s
        while text not in self.shown[self._read :]:
            assert time.monotonic() < end, f"'{text}' did not come:\n{self.shown}"
            if select.select([self._terminal], [], [], 0.2)[0]:
                with contextlib.suppress(OSError):  # It has ended: the rest was read.
                    self.shown += os.read(self._terminal, 65536).decode(errors="replace")
        return self.shown[self._read :]

    def await_exit(self) -> int:
        self.await_text("")
        while select.select([self._terminal], [], [], 60)[0]:
            try:
                if not os.read(self._terminal, 65536):
                    break
            except OSError:
                break
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])

    def close(self) -> None:
        with contextlib.suppress(ProcessLookupError, ChildProcessError):
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
        os.close(self._terminal)


@pytest.fixture
def console(world: World) -> Iterator[Console]:
    world.server("--waiting-room=1")
    console = Console(world)
    console.await_text("joined")
    yield console
    console.close()


def test_commands_are_answered_by_name(world: World, console: Console) -> None:
    ada = world.trainee("--name=Ada")
    bob = world.trainee("--name=Bob", name="bob")
    for trainee in (ada, bob):
        trainee.await_text("waiting for an instructor")
    _await_rows(console, ["Ada", "Bob"], "waiting")
    console.type("admit a\t\n")
    console.await_text("Ada: admitted")
    ada.await_text("joined")
    console.type("admit *\n")
    console.await_text("Bob: admitted")
    bob.await_text("joined")
    _await_rows(console, ["Ada", "Bob"], "ms", "°", "trainee", "here")
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


def test_commands_of_a_pipe(world: World) -> None:
    world.server()
    ada = world.trainee("--name=Ada")
    ada.await_text("joined")
    command = [str(CLIENT_BINARY), "--headless", "--", "--role=instructor", f"--port={world.port}"]
    done = subprocess.run(
        command,
        input="who\nkick Ada\nquit\n",
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Ada" in done.stdout and "Ada: kicked" in done.stdout
    assert ada.await_exit() == 3


def _await_rows(console: Console, names: list[str], *words: str) -> None:
    """Asks who is here until the rows of some have all words."""
    for _ in range(120):
        console.type("who\n")
        # The head of the table: who is asked for may not be in it yet.
        table = console.await_text("tracking").replace("\x1b[K", "").splitlines()
        # Of several answers that have come, the newest row of each.
        rows = {line.split(" ")[0]: line for line in table if line.split(" ")[0] in names}
        if len(rows) == len(names) and all(w in row for w in words for row in rows.values()):
            return
        time.sleep(0.5)
    pytest.fail(f"no such rows:\n{console.shown}")
