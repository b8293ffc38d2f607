# SPDX-License-Identifier: MIT
"""What 80 people who have joined and move cost a server: an exported one, clients on 127.0.0.1.

The server has a processor of its own, its clients another: 80 clients with one person each, and 10
with eight. They move by a clip, 60 samples a second. All is counted when everybody has a body.
Options: --case=NAME (again for more), --seconds=12 (of each), --people=8 of each client and
--clients=10 for a case of one's own, --server=FILE (another build's, to compare).
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
import time
import urllib.request
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

from toolchain.console import Failure
from toolchain.paths import ROOT, SERVER_BINARY
from toolchain.process_times import thread_seconds
from toolchain.processes import Group, free_port
from toolchain.project import prepare
from toolchain.stats import Stats

SCRIPT = "res://tests/bench/moving/moving_clients.gd"
MIN_TICKS = 58.0
MIN_SNAPSHOTS = 50.0
OBSERVERS = 2
# Frames a second of the clients' process, and the share of them that shows that it keeps up.
FRAMES = 60.0
KEPT_UP = 0.9
JOIN_S = 180.0
SETTLE_S = 3.0
OPTIONS = {"seconds": "12", "clients": "0", "people": "0", "server": str(SERVER_BINARY)}
CASES = {"80 clients, 1 person each": (80, 1), "10 clients, 8 people each": (10, 8)}


@dataclass(frozen=True)
class Look:
    """What the server reports, what the system says of it, and what the clients have seen."""

    status: dict[str, Any]
    threads: dict[int, tuple[str, float]]
    row: dict[str, Any]


class Session:
    """A server and its clients, each on a processor of its own."""

    def __init__(self, group: Group, server: Path, clients: list[str]) -> None:
        self._group = group
        cores = sorted(os.sched_getaffinity(0))
        if len(cores) < 2:
            raise Failure("This needs two processors: one for the server, one for its clients.")
        port = free_port()
        options = [f"--port={port}", "--max-clients=200"]
        group.start("server", [str(server), "--headless", "--", "--role=server", *options])
        mark = "status at http://127.0.0.1:"
        group.await_text("server", mark, 60)
        self._status = int(group.log("server").split(mark)[1].split("/")[0])
        _pin(group.number("server"), cores[-2])
        group.start("clients", [*clients, f"--port={port}", f"--observers={OBSERVERS}"])
        _pin(group.number("clients"), cores[-1])

    def rows(self) -> list[dict[str, Any]]:
        """What the clients have seen, second by second."""
        lines = self._group.log("clients").splitlines()
        return [json.loads(line) for line in lines if line.startswith("{") and line.endswith("}")]

    def await_bodies(self, people: int) -> None:
        """Waits until everybody has a body."""
        end = time.monotonic() + JOIN_S
        while not any(row["bodies"] >= people for row in self.rows()):
            if time.monotonic() > end or self._group.exit_code("clients") is not None:
                log = self._group.log("clients")[-1000:]
                raise Failure(f"not all of {people} people have a body:\n{log}")
            time.sleep(0.2)

    def look(self) -> Look:
        """What there is to see now. The clients tell it once a second."""
        seen = len(self.rows())
        while len(self.rows()) == seen and self._group.exit_code("clients") is None:
            time.sleep(0.01)
        with urllib.request.urlopen(f"http://127.0.0.1:{self._status}/", timeout=120) as reply:
            status: dict[str, Any] = json.load(reply)
        return Look(status, thread_seconds(self._group.number("server")), self.rows()[-1])


def _pin(process: int, core: int) -> None:
    """Gives all threads of a process one processor; those that they start inherit it."""
    for task in Path(f"/proc/{process}/task").glob("*"):
        os.sched_setaffinity(int(task.name), {core})


def measure(arguments: list[str]) -> int:
    """Runs the cases and prints their stats."""
    given, names = dict(OPTIONS), []
    for option in arguments:
        name, _, value = option.removeprefix("--").partition("=")
        if name == "case":
            names.append(value)
        elif name in given:
            given[name] = value
        elif option != "--json":
            known = ", ".join(f"--{one}" for one in ("case", *OPTIONS, "json"))
            raise Failure(f"'{option}' is no option: {known}.", 2)
    unknown = [name for name in names if name not in CASES]
    if unknown:
        raise Failure(f"There is no case '{unknown[0]}': {', '.join(CASES)}.", 2)
    cases = {name: CASES[name] for name in names or CASES}
    if int(given["clients"]) > 0:
        clients, people = int(given["clients"]), int(given["people"])
        cases = {f"{clients} clients, {people} people each": (clients, people)}
    stats = Stats("moving", "--json" in arguments)
    for name, (clients, people) in cases.items():
        _run_case(stats, name, clients, people, float(given["seconds"]), Path(given["server"]))
    return stats.finish()


def _run_case(
    stats: Stats, name: str, clients: int, people: int, seconds: float, server: Path
) -> None:
    godot = prepare(export=False)
    program = [str(godot.program), "--headless", "--no-header", "--path", str(ROOT), "-s", SCRIPT]
    program += ["--", f"--clients={clients}", f"--people={people}"]
    with (
        tempfile.TemporaryDirectory(prefix="dismount-") as folder,
        Group(Path(folder), godot.environment()) as group,
    ):
        session = Session(group, server, program)
        session.await_bodies(clients * people)
        time.sleep(SETTLE_S)
        before = session.look()
        time.sleep(seconds)
        after = session.look()
    _add(stats, name, before, after)


def _add(stats: Stats, name: str, before: Look, after: Look) -> None:
    first, last = before.status, after.status
    ticks = last["ticks"] - first["ticks"]
    span = last["seconds"] - first["seconds"]
    stats.add(name, "ticks", ticks / span, "/s", at_least=MIN_TICKS)
    span = (after.row["usec"] - before.row["usec"]) / 1e6
    rates = [
        (b - a) / span for a, b in zip(before.row["snapshots"], after.row["snapshots"], strict=True)
    ]
    watching, moving = rates[:OBSERVERS], rates[OBSERVERS:]
    stats.add(name, "snapshots of an observer", min(watching), "/s", at_least=MIN_SNAPSHOTS)
    stats.add(name, "snapshots of a trainee, p50", median(moving), "/s")
    stats.add(name, "snapshots of a trainee, least", min(moving), "/s")
    used = {
        number: 1000.0 * (seconds - before.threads.get(number, ("", 0.0))[1]) / ticks
        for number, (_, seconds) in after.threads.items()
    }
    # The main thread has the process' own number, the lowest.
    main = used.pop(min(used))
    transport = last["transport"]["cpu_usec"] - first["transport"]["cpu_usec"]
    transport /= 1000.0 * ticks
    stats.add(name, "main thread, a tick", main, "ms")
    recent = last["recent"]
    stats.add(name, "main thread's work of a tick, p50", recent["work_ms_p50"], "ms")
    stats.add(name, "main thread's work of a tick, p99", recent["work_ms_p99"], "ms")
    stats.add(name, "main thread, of it the network, p50", recent["network_ms_p50"], "ms")
    stats.add(name, "transport thread, a tick", transport, "ms")
    stats.add(name, "other threads (physics), a tick", sum(used.values()) - transport, "ms")
    stats.add(name, "all threads, a tick", main + sum(used.values()), "ms")
    frames = (after.row["frames"] - before.row["frames"]) / span
    stats.add(name, "frames of the clients", frames, "/s")
    stats.add(name, "clients: they are the limit", float(frames < KEPT_UP * FRAMES), "")


if __name__ == "__main__":
    sys.exit(measure(sys.argv[1:]))
