# SPDX-License-Identifier: MIT
"""What 80 people who have joined and move cost a server: an exported one, clients on 127.0.0.1.

The server has a processor of its own, its clients another: 80 clients with one person each, and 10
with eight. They move by a clip, 60 samples a second. All is counted when everybody has a body.
Options: --case=NAME (again for more), --seconds=12 (of each), --people=8 of each client and
--clients=10 for a case of one's own, --server=FILE (another build's, to compare).
"""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

from bench import Bench, Options, main
from toolchain.console import Failure
from toolchain.paths import SERVER_BINARY
from toolchain.process_times import thread_seconds
from toolchain.processes import Group, ask, free_port, json_lines
from toolchain.stats import Stats

SCRIPT = "res://tests/bench/joins/joins_clients.gd"
MIN_TICKS = 58.0
MIN_SNAPSHOTS = 50.0
OBSERVERS = 2
# Frames a second of the clients' process, and the share of them that shows that it keeps up.
FRAMES = 60.0
KEPT_UP = 0.9
JOIN_S = 180.0
SETTLE_S = 3.0
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
        self._status = group.await_status(60)
        _pin(group.number("server"), cores[-2])
        group.start("clients", [*clients, f"--port={port}", f"--observers={OBSERVERS}"])
        _pin(group.number("clients"), cores[-1])

    def rows(self) -> list[dict[str, Any]]:
        """What the clients have seen, second by second."""
        return json_lines(self._group.log("clients"))

    def await_bodies(self, people: int) -> None:
        """Waits until everybody has a body."""
        self._group.await_that(
            "clients",
            lambda: any(row["bodies"] >= people for row in self.rows()),
            f"the bodies of {people} people",
            JOIN_S,
        )

    def look(self) -> Look:
        """What there is to see now. The clients tell it once a second."""
        seen = len(self.rows())
        self._group.await_that("clients", lambda: len(self.rows()) > seen, "what the clients see")
        status = ask(self._status)
        return Look(status, thread_seconds(self._group.number("server")), self.rows()[-1])


def _pin(process: int, core: int) -> None:
    """Gives all threads of a process one processor; those that they start inherit it."""
    for task in Path(f"/proc/{process}/task").glob("*"):
        os.sched_setaffinity(int(task.name), {core})


def measure(arguments: list[str]) -> int:
    """Runs the cases and prints their stats."""
    options = Options(
        arguments,
        {
            "case": tuple(CASES),
            "seconds": 12.0,
            "clients": 0,
            "people": 0,
            "server": str(SERVER_BINARY),
        },
    )
    cases = {name: CASES[name] for name in options["case"]}
    if options["clients"] > 0:
        clients, people = options["clients"], options["people"]
        cases = {f"{clients} clients, {people} people each": (clients, people)}
    bench = Bench("moving", options.json)
    for name, (clients, people) in cases.items():
        _run_case(bench, name, clients, people, options["seconds"], Path(options["server"]))
    return bench.finish()


def _run_case(
    bench: Bench, name: str, clients: int, people: int, seconds: float, server: Path
) -> None:
    # They end long after the server does.
    options = ["--plan=move", "--seconds=3600", f"--clients={clients}", f"--people={people}"]
    program = bench.command("--headless", "-s", SCRIPT, "--", *options)
    with bench.session() as (group, _):
        session = Session(group, server, program)
        session.await_bodies(clients * people)
        time.sleep(SETTLE_S)
        before = session.look()
        time.sleep(seconds)
        after = session.look()
    _add(bench.stats, name, before, after)


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
    main(measure)
