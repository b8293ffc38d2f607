# SPDX-License-Identifier: MIT
"""Starts the exported server and clients, and sees to it that none outlives us."""

from __future__ import annotations

import os
import random
import socket
import subprocess
import time
from pathlib import Path
from types import TracebackType

from .console import Failure, tail
from .paths import BUILD

# Below what Linux gives out by itself (ip_local_port_range), above what services use.
PORTS = range(20000, 32768)
MAX_TRIES = 100


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


class Group:
    """Processes that end together, with their logs."""

    def __init__(self, logs: Path, environment: dict[str, str]) -> None:
        self._logs = logs
        home = BUILD / "player-home"
        own = {f"XDG_{name}_HOME": str(home / name.lower()) for name in ("DATA", "CONFIG", "CACHE")}
        # Options of the roles may not leak into the session from the environment.
        plain = {k: v for k, v in os.environ.items() if not k.startswith("DISMOUNT_")}
        self._environment = {**plain, **own, **environment}
        self._processes: dict[str, subprocess.Popen[bytes]] = {}

    def __enter__(self) -> Group:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _value: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        for process in self._processes.values():
            if process.poll() is None:
                process.terminate()
        for process in self._processes.values():
            try:
                process.wait(5)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def start(self, name: str, command: list[str]) -> None:
        """Starts a process; its output goes to a log."""
        with open(self.log_file(name), "wb") as log:
            self._processes[name] = subprocess.Popen(
                command,
                env=self._environment,
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
            )

    def log_file(self, name: str) -> Path:
        """Where the output of a process goes."""
        return self._logs / f"{name}.log"

    def log(self, name: str) -> str:
        """What a process has printed."""
        return self.log_file(name).read_text(encoding="utf-8", errors="replace")

    def exit_code(self, name: str) -> int | None:
        """The exit code of a process, or None while it runs."""
        return self._processes[name].poll()

    def number(self, name: str) -> int:
        """The system's number of a process."""
        return self._processes[name].pid

    def stop(self, name: str) -> None:
        """Ends a process as a user would."""
        self._processes[name].terminate()
        try:
            self._processes[name].wait(10)
        except subprocess.TimeoutExpired:
            self._processes[name].kill()
            self._processes[name].wait()

    def await_text(self, name: str, text: str, limit_s: float) -> None:
        """Waits until a process has printed something."""
        end = time.monotonic() + limit_s
        while text not in self.log(name):
            if self.exit_code(name) is not None or time.monotonic() > end:
                raise Failure(f"The {name} did not come up:\n{tail(self.log(name))}")
            time.sleep(0.05)

    def await_exit(self, name: str, limit_s: float) -> None:
        """Waits until a process has ended well."""
        try:
            code = self._processes[name].wait(limit_s)
        except subprocess.TimeoutExpired as late:
            raise Failure(f"The {name} does not end:\n{tail(self.log(name))}") from late
        if code != 0:
            raise Failure(f"The {name} failed (exit {code}):\n{tail(self.log(name))}")

    def await_any_exit(self, names: list[str]) -> None:
        """Waits until one of the processes has ended, however."""
        while all(self.exit_code(name) is None for name in names):
            time.sleep(0.2)
