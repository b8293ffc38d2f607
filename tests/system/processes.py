# SPDX-License-Identifier: MIT
"""A process under test: its log, its reports, its end."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path

from toolchain.console import Failure
from toolchain.processes import Program, ask

# Seconds between two reports of a process.
REPORT_EVERY = "0.1"
# So many looks in a row, 0.2 s apart, tell that nothing goes on in the background.
QUIET_LOOKS = 15


class Process(Program):
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
        self.report_file = folder / f"{name}.json"
        # Where its status is asked for; 0: nowhere.
        self.status_port = 0
        home = {f"XDG_{kind}_HOME": str(folder / kind) for kind in ("DATA", "CONFIG", "CACHE")}
        plain = {k: v for k, v in os.environ.items() if not k.startswith("DISMOUNT_")}
        own = {"DISMOUNT_REPORT_EVERY": REPORT_EVERY, **environment, "PWD": str(cwd or Path.cwd())}
        report = [f"--report={self.report_file}"] if reports else []
        log_file = folder / f"{name}.log"
        super().__init__([*command, *report], log_file, {**plain, **home, **own}, cwd, types)

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
        report: dict = {}

        def look() -> bool:
            nonlocal report
            report = {}  # Not written yet, or not all of it is there.
            report = self._read_report()
            return holds(report)

        try:
            self.await_that(look, "a report", limit_s)
        except Failure as failure:
            raise Failure(f"{failure}\n{report}") from failure
        return report

    def fresh_report(self) -> dict:
        """A report of what is now: one that lies there is from a moment ago."""
        stale = self.await_report(lambda _report: True)
        return self.await_report(lambda report: report["seconds"] != stale["seconds"])

    def await_rest(self, limit_s: float = 300.0) -> None:
        """Waits until the engine's threads for work in the background have none for a while.

        An editor that ends meanwhile leaves what they work at.
        """
        before, since = self._background(), 0

        def is_quiet() -> bool:
            nonlocal before, since
            now = self._background()
            # One that waits for a processor is at work as well.
            is_same = now == before and not any(": R in" in line for line in now)
            before, since = now, since + 1 if is_same else 0
            return since >= QUIET_LOOKS

        self.await_that(is_quiet, "rest", limit_s, 0.2)

    def _background(self) -> list[str]:
        return [line for line in thread_states(self.process.pid) if "WorkerThread" in line]

    def describe(self) -> str:
        """How it is and what it has said last, for whoever looks for the reason of a failure."""
        code = self.process.poll()
        state = f"ended with {code}" if code is not None else "runs"
        waits = [] if code is not None else thread_states(self.process.pid)
        last = self.log(0).splitlines()[-40:]
        return "\n".join([f"--- {self.log_file.name}: {state}", *waits, *last])


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
