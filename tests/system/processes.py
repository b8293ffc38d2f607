# SPDX-License-Identifier: MIT
"""A process under test: its log, its reports, its end."""

from __future__ import annotations

import http.client
import json
import os
import subprocess
import time
import urllib.request
from collections.abc import Callable
from pathlib import Path

import pytest

# Seconds between two reports of a process, and between two looks at what may have come.
REPORT_EVERY = "0.1"
LOOK_S = 0.02
# So many looks in a row, 0.2 s apart, tell that nothing goes on in the background.
QUIET_LOOKS = 15


def ask(port: int, path: str = "/") -> dict:
    """What a server's status says at this moment."""
    with urllib.request.urlopen(f"http://127.0.0.1:{port}{path}", timeout=60) as reply:
        assert reply.status == 200
        assert reply.headers["Content-Type"] == "application/json"
        return json.load(reply)


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
        types: bool = False,
    ) -> None:
        self.log_file = folder / f"{name}.log"
        self.report_file = folder / f"{name}.json"
        # Where its status is asked for; 0: nowhere.
        self.status_port = 0
        self._mark = 0
        home = {f"XDG_{kind}_HOME": str(folder / kind) for kind in ("DATA", "CONFIG", "CACHE")}
        plain = {k: v for k, v in os.environ.items() if not k.startswith("DISMOUNT_")}
        with self.log_file.open("wb") as log:
            self.process = subprocess.Popen(
                [*command, *([f"--report={self.report_file}"] if reports else [])],
                cwd=cwd,
                env={
                    **plain,
                    **home,
                    "DISMOUNT_REPORT_EVERY": REPORT_EVERY,
                    **environment,
                    "PWD": str(cwd or Path.cwd()),
                },
                stdin=subprocess.PIPE if types else subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
            )

    def log(self) -> str:
        """What it has said since its start, or since the mark."""
        return self.log_file.read_bytes()[self._mark :].decode(errors="replace")

    def mark(self) -> None:
        """Forgets what it has said so far: another test begins."""
        self._mark = self.log_file.stat().st_size

    def type(self, line: str) -> None:
        """Writes a line to its input."""
        assert self.process.stdin is not None
        self.process.stdin.write(f"{line}\n".encode())
        self.process.stdin.flush()

    def report(self) -> dict:
        """The newest report; the first one comes some time after the start."""
        return self.await_report(lambda _report: True)

    def _read_report(self) -> dict:
        # A server's status is of this moment; what it has written last is a moment old.
        if self.status_port and self.process.poll() is None:
            return ask(self.status_port)
        return json.loads(self.report_file.read_text(encoding="utf-8"))

    def await_report(self, holds: Callable[[dict], bool], limit_s: float = 120.0) -> dict:
        """The report as soon as something holds of it."""
        end = time.monotonic() + limit_s
        while True:
            try:
                report = self._read_report()
                if holds(report):
                    return report
            except (OSError, ValueError, LookupError, http.client.HTTPException):
                report = {}  # Not written yet, or not all of it is there.
            assert time.monotonic() < end, f"it did not come in {limit_s} s: {report}"
            assert self.process.poll() is None, f"it ended before:\n{self.log()}"
            time.sleep(LOOK_S)

    def await_text(self, text: str, limit_s: float = 120.0, count: int = 1) -> None:
        end = time.monotonic() + limit_s
        while self.log().count(text) < count:
            assert time.monotonic() < end, f"'{text}' did not come in {limit_s} s:\n{self.log()}"
            assert self.process.poll() is None, f"it ended before '{text}':\n{self.log()}"
            time.sleep(LOOK_S)

    def await_line(self, *words: str, limit_s: float = 120.0) -> str:
        """The first line that has all of some words, once it has come."""
        end = time.monotonic() + limit_s
        while True:
            for line in self.log().splitlines():
                if all(word in line for word in words):
                    return line
            assert time.monotonic() < end, f"no line with {words} in {limit_s} s:\n{self.log()}"
            assert self.process.poll() is None, f"it ended before {words}:\n{self.log()}"
            time.sleep(LOOK_S)

    def await_exit(self, limit_s: float = 120.0) -> int:
        try:
            return self.process.wait(limit_s)
        except subprocess.TimeoutExpired:
            pytest.fail(f"it does not end within {limit_s} s:\n{self.log()}")

    def fresh_report(self) -> dict:
        """A report of what is now: one that lies there is from a moment ago."""
        stale = self.await_report(lambda _report: True)
        return self.await_report(lambda report: report["seconds"] != stale["seconds"])

    def end(self) -> int:
        """Asks it to end; returns its exit code."""
        self.process.terminate()
        return self.await_exit()

    def await_rest(self, limit_s: float = 300.0) -> None:
        """Waits until the engine's threads for work in the background have none for a while.

        An editor that ends meanwhile leaves what they work at.
        """
        end = time.monotonic() + limit_s
        before, since = self._background(), 0
        while since < QUIET_LOOKS:
            assert time.monotonic() < end, f"it does not come to rest:\n{self.describe()}"
            time.sleep(0.2)
            now = self._background()
            # One that waits for a processor is at work as well.
            is_quiet = now == before and not any(": R in" in line for line in now)
            since = since + 1 if is_quiet else 0
            before = now

    def _background(self) -> list[str]:
        return [line for line in thread_states(self.process.pid) if "WorkerThread" in line]

    def describe(self) -> str:
        """How it is and what it has said last, for whoever looks for the reason of a failure."""
        code = self.process.poll()
        state = f"ended with {code}" if code is not None else "runs"
        waits = [] if code is not None else thread_states(self.process.pid)
        self._mark = 0
        last = self.log().splitlines()[-40:]
        return "\n".join([f"--- {self.log_file.name}: {state}", *waits, *last])

    def kill(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        if self.process.stdin is not None:
            self.process.stdin.close()


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
