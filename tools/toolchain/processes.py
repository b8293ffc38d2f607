# SPDX-License-Identifier: MIT
"""Starts programs, waits for what they say, reads their logs and ends them.

Commands, benchmarks and tests use this, and nothing else.
"""

from __future__ import annotations

import contextlib
import http.client
import json
import os
import random
import socket
import subprocess
import time
import urllib.request
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any, TypeVar

from .console import Failure, tail
from .paths import BUILD

# Below what Linux gives out by itself (ip_local_port_range), above what services use.
PORTS = range(20000, 32768)
MAX_TRIES = 100
# Between two looks at what may have come, s.
LOOK_S = 0.02
# What a server says of its status.
STATUS = "status at http://127.0.0.1:"

Found = TypeVar("Found")


def require_port(port: int) -> None:
    """Gives up where a UDP port is in use."""
    if not is_free(port):
        raise Failure(
            f"UDP port {port} is in use (another server?): end that program, or choose another "
            f"port with --port={port + 1} or DISMOUNT_PORT={port + 1}."
        )


def is_free(port: int) -> bool:
    """Whether nobody uses a UDP port at the moment."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind(("0.0.0.0", port))
        except OSError:
            return False
        return True


def free_port() -> int:
    """A UDP port that nobody uses at the moment.

    It is none of those that the system gives out by itself: between this call and its use a client
    could be given it.
    """
    for _ in range(MAX_TRIES):
        port = random.choice(PORTS)
        if is_free(port):
            return port
    raise Failure(f"No UDP port from {PORTS.start} to {PORTS.stop - 1} is free.")


def await_that(
    holds: Callable[[], Found],
    what: str,
    limit_s: float = 120.0,
    says: Callable[[], str] = str,
    look_s: float = LOOK_S,
) -> Found:
    """Waits until something holds; returns what it is. What it looks at need not be there yet.

    A Failure names what did not come, and what the program in question says.
    """
    end = time.monotonic() + limit_s
    while True:
        with contextlib.suppress(OSError, ValueError, LookupError, http.client.HTTPException):
            if found := holds():
                return found
        if time.monotonic() > end:
            raise Failure(f"{what} did not come in {limit_s:g} s:\n{says()}")
        time.sleep(look_s)


def ask(port: int, path: str = "/") -> dict[str, Any]:
    """What a server's status says at this moment."""
    with urllib.request.urlopen(f"http://127.0.0.1:{port}{path}", timeout=120) as reply:
        report: dict[str, Any] = json.load(reply)
    return report


def json_lines(text: str) -> list[dict[str, Any]]:
    """The objects among the lines that a program has printed, a whole line each."""
    lines = [line for line in text.splitlines() if line.startswith("{") and line.endswith("}")]
    return [json.loads(line) for line in lines]


class Program:
    """A program that runs, and its log."""

    def __init__(
        self,
        command: list[str],
        log_file: Path,
        environment: dict[str, str] | None = None,
        cwd: Path | None = None,
        types: bool = False,
    ) -> None:
        self.log_file = log_file
        self._mark = 0
        with log_file.open("wb") as log:
            self.process = subprocess.Popen(
                command,
                cwd=cwd,
                env=environment,
                stdin=subprocess.PIPE if types else subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
            )

    def __enter__(self) -> Program:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _value: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        self.kill()

    def log(self, since: int | None = None) -> str:
        """What it has said since the last mark, or since another one; 0 is its start."""
        begin = self._mark if since is None else since
        return self.log_file.read_bytes()[begin:].decode(errors="replace")

    def mark(self) -> int:
        """Forgets what it has said so far; returns the mark."""
        self._mark = self.log_file.stat().st_size
        return self._mark

    def type(self, line: str) -> None:
        """Writes a line to its input."""
        assert self.process.stdin is not None
        self.process.stdin.write(f"{line}\n".encode())
        self.process.stdin.flush()

    def await_that(
        self, holds: Callable[[], Found], what: str, limit_s: float = 120.0, look_s: float = LOOK_S
    ) -> Found:
        """Waits until something holds, as long as it runs."""

        def look() -> tuple[bool, Found | None]:
            code = self.process.poll()
            with contextlib.suppress(OSError, ValueError, LookupError, http.client.HTTPException):
                if found := holds():
                    return True, found
            return code is not None, None

        _, found = await_that(lambda: (seen := look())[0] and seen, what, limit_s, self.log, look_s)
        if not found:
            name, code = self.log_file.stem, self.process.returncode
            raise Failure(f"The {name} ended with {code} before {what} came:\n{tail(self.log())}")
        return found

    def await_text(self, text: str, limit_s: float = 120.0, count: int = 1) -> None:
        """Waits until it has said something, so many times."""
        self.await_that(lambda: self.log().count(text) >= count, f"'{text}'", limit_s)

    def await_line(self, *words: str, limit_s: float = 120.0) -> str:
        """The first line that has all of some words, once it has come."""

        def find() -> str:
            lines = self.log().splitlines()
            return next((line for line in lines if all(word in line for word in words)), "")

        return self.await_that(find, f"a line with {words}", limit_s)

    def await_exit(self, limit_s: float = 120.0) -> int:
        """Its exit code, once it has ended."""
        try:
            return self.process.wait(limit_s)
        except subprocess.TimeoutExpired as late:
            name = self.log_file.stem
            raise Failure(f"The {name} does not end:\n{tail(self.log())}") from late

    def end(self, limit_s: float = 120.0) -> int:
        """Asks it to end, as a user would; returns its exit code."""
        self.process.terminate()
        return self.await_exit(limit_s)

    def kill(self, limit_s: float = 0.0) -> None:
        """Ends it, whatever it is at; before, it has a time in which to end by itself."""
        if limit_s > 0.0:
            with contextlib.suppress(Failure):
                self.end(limit_s)
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        if self.process.stdin is not None:
            self.process.stdin.close()


class Group:
    """Programs that end together, with their logs."""

    def __init__(self, logs: Path, environment: dict[str, str]) -> None:
        self._logs = logs
        home = BUILD / "player-home"
        own = {f"XDG_{name}_HOME": str(home / name.lower()) for name in ("DATA", "CONFIG", "CACHE")}
        # Options of the roles may not leak into the session from the environment.
        plain = {k: v for k, v in os.environ.items() if not k.startswith("DISMOUNT_")}
        self._environment = {**plain, **own, **environment}
        self._programs: dict[str, Program] = {}

    def __enter__(self) -> Group:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _value: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        for program in self._programs.values():
            if program.process.poll() is None:
                program.process.terminate()
        for program in self._programs.values():
            program.kill(5.0)

    def start(self, name: str, command: list[str]) -> Program:
        """Starts a program; its output goes to a log."""
        log = self._logs / f"{name}.log"
        self._programs[name] = Program(command, log, self._environment)
        return self._programs[name]

    def log(self, name: str) -> str:
        """What a program has printed."""
        return self._programs[name].log()

    def exit_code(self, name: str) -> int | None:
        """The exit code of a program, or None while it runs."""
        return self._programs[name].process.poll()

    def number(self, name: str) -> int:
        """The system's number of a program."""
        return self._programs[name].process.pid

    def stop(self, name: str) -> None:
        """Ends a program as a user would."""
        self._programs[name].kill(10.0)

    def await_text(self, name: str, text: str, limit_s: float) -> None:
        """Waits until a program has printed something."""
        self._programs[name].await_text(text, limit_s)

    def await_that(
        self, name: str, holds: Callable[[], Found], what: str, limit_s: float = 120.0
    ) -> Found:
        """Waits until something holds, as long as a program runs."""
        return self._programs[name].await_that(holds, what, limit_s)

    def await_status(self, limit_s: float = 90.0) -> int:
        """Waits for the program "server"; returns the port of its status."""
        self.await_text("server", STATUS, limit_s)
        return int(self.log("server").split(STATUS)[1].split("/")[0])

    def await_exit(self, name: str, limit_s: float) -> None:
        """Waits until a program has ended well."""
        code = self._programs[name].await_exit(limit_s)
        if code != 0:
            raise Failure(f"The {name} failed (exit {code}):\n{tail(self.log(name))}")

    def await_any_exit(self, names: list[str]) -> None:
        """Waits until one of the programs has ended, however."""
        while all(self.exit_code(name) is None for name in names):
            time.sleep(0.2)
