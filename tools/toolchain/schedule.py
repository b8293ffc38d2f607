# SPDX-License-Identifier: MIT
"""A plugin of pytest: which of several workers runs which test, and when.

Tests that share something that was set up for their whole file stay together. Those that are
marked `serial` (windows, headsets, editors: each takes a processor for itself) all go to one
worker, so that no two of them run at the same time. What took longest last time begins first, so
that the workers end together.
"""

from __future__ import annotations

import json
import os
from collections import Counter, defaultdict
from pathlib import Path

import pytest
from xdist.remote import Producer
from xdist.scheduler.loadscope import LoadScopeScheduling
from xdist.workermanage import WorkerController

from .durations import keep_durations, read_durations
from .paths import cache, write_whole

# What a test above is listed at the end, s.
LONG_S = 20.0
# What is assumed of a test that has not been run on this machine, s.
UNKNOWN_S = 5.0
GROUPS = "dismount_groups"
COUNTS = "dismount_started"
SERIAL = "serial"


# How many processes of each kind tests have started: they are most of the time.
started: Counter[str] = Counter()


def group_of(item: pytest.Item) -> str:
    """What is run by one worker in one go: a file that shares a fixture, or the test alone."""
    fixtures = item._fixtureinfo.name2fixturedefs  # type: ignore[attr-defined]
    shares = any(one.scope in ("module", "package") for defs in fixtures.values() for one in defs)
    return item.nodeid.split("::")[0] if shares else item.nodeid


class LongestFirst(LoadScopeScheduling):
    """Gives each worker the longest group that it may run."""

    def __init__(self, config: pytest.Config, log: Producer, groups_file: Path) -> None:
        super().__init__(config, log)
        self._file = groups_file
        self._groups: dict[str, str] = {}
        self._serial: set[str] = set()
        self._weights: dict[str, float] = defaultdict(float)
        self._serial_node: WorkerController | None = None

    def schedule(self) -> None:
        """Distributes the tests that the workers have collected."""
        if self.collection is None and self._file.exists():
            rows = json.loads(self._file.read_text(encoding="utf-8"))
            self._groups = {name: group for name, (group, _) in rows.items()}
            self._serial = {group for group, is_serial in rows.values() if is_serial}
            durations = read_durations()
            for name, group in self._groups.items():
                self._weights[group] += durations.get(name, UNKNOWN_S)
        super().schedule()

    def _split_scope(self, nodeid: str) -> str:
        return self._groups.get(nodeid, nodeid)

    def _choose(self, node: WorkerController) -> str | None:
        """The group that a worker gets next; None if what is left is for another one."""
        if self._serial_node not in self.assigned_work:
            self._serial_node = node
        is_serial = self._serial_node is node
        allowed = [one for one in self.workqueue if is_serial or one not in self._serial]
        # The other worker can do the rest, but nobody else those.
        return max(allowed, key=lambda one: (one in self._serial, self._weights[one]), default=None)

    def _assign_work_unit(self, node: WorkerController) -> None:
        chosen = self._choose(node)
        if chosen is None:
            node.shutdown()
            return
        self.workqueue.move_to_end(chosen, last=False)
        super()._assign_work_unit(node)


class Schedule:
    """The hooks, of the process that leads as of the workers."""

    def __init__(self, config: pytest.Config) -> None:
        self._config = config
        self._seconds: dict[str, float] = defaultdict(float)
        self._folder = cache() / "schedule"
        self._groups_file = self._folder / f"{os.getpid()}.json"

    @pytest.hookimpl(tryfirst=True)
    def pytest_collection_finish(self, session: pytest.Session) -> None:
        """A worker notes the groups of its tests: who leads knows their names alone."""
        target = getattr(self._config, "workerinput", {}).get(GROUPS)
        if target is None or os.environ.get("PYTEST_XDIST_WORKER") != "gw0":
            return
        rows = {
            item.nodeid: (group_of(item), item.get_closest_marker(SERIAL) is not None)
            for item in session.items
        }
        write_whole(Path(target), json.dumps(rows))

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Adds up how long a test takes, with its set-up and its end."""
        self._seconds[report.nodeid] += report.duration

    @pytest.hookimpl(tryfirst=True)
    def pytest_sessionfinish(self) -> None:
        """A worker tells what it has started."""
        if hasattr(self._config, "workeroutput"):
            self._config.workeroutput[COUNTS] = dict(started)

    @pytest.hookimpl(trylast=True)
    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        """Keeps the times, and names the tests that take long."""
        if hasattr(self._config, "workerinput"):
            return
        self._groups_file.unlink(missing_ok=True)
        keep_durations(self._seconds)
        if started:
            counts = ", ".join(f"{count} {kind}" for kind, count in sorted(started.items()))
            terminalreporter.write_line(f"started: {counts}")
        long = {name: s for name, s in self._seconds.items() if s > LONG_S}
        for name, seconds in sorted(long.items(), key=lambda row: -row[1]):
            terminalreporter.write_line(f"longer than {LONG_S:.0f} s: {seconds:.0f} s {name}")


class WithWorkers:
    """The hooks of xdist."""

    def __init__(self, schedule: Schedule) -> None:
        self._schedule = schedule

    def pytest_configure_node(self, node: WorkerController) -> None:
        """Tells a worker where the groups are wanted."""
        self._schedule._folder.mkdir(parents=True, exist_ok=True)
        node.workerinput[GROUPS] = str(self._schedule._groups_file)

    def pytest_testnodedown(self, node: WorkerController) -> None:
        """A worker has ended."""
        started.update(getattr(node, "workeroutput", {}).get(COUNTS, {}))

    def pytest_xdist_make_scheduler(self, config: pytest.Config, log: Producer) -> LongestFirst:
        """The order is ours."""
        return LongestFirst(config, log, self._schedule._groups_file)


def pytest_configure(config: pytest.Config) -> None:
    """Begins."""
    config.addinivalue_line(
        "markers", f"{SERIAL}: takes a processor for itself; no two of these run at the same time"
    )
    schedule = Schedule(config)
    config.pluginmanager.register(schedule, "dismount-schedule")
    if config.pluginmanager.hasplugin("dsession") or config.getoption("numprocesses", None):
        config.pluginmanager.register(WithWorkers(schedule), "dismount-workers")
