# SPDX-License-Identifier: MIT
"""What people who come, go and change cost the others: an exported server, clients on 127.0.0.1.

While two observers and a trainee watch: 80 people (10 clients with 8) join at once; 50 clients
come and go, each staying for a second; one client sends lists of 8 people of other sizes 60 times
a second; to 32 people one joins after the other; a hostile observer, trainee or instructor sends
valid messages of every kind that its role may send, as fast as it may, chosen by a seed; and an
instructor asks for another level 20 times a second. Options: --case=NAME (again for more),
--seconds=8 (of each), --seed=1 (of hostile clients), --server=FILE (another build's, to compare).
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

from bench import Bench, Options, main
from toolchain.paths import SERVER_BINARY
from toolchain.processes import Group, ask, free_port, json_lines
from toolchain.stats import Stats

SCRIPT = "res://tests/bench/joins/joins_clients.gd"
WATCHERS = 3
MIN_TICKS = 58.0
MIN_SNAPSHOTS = 57.0
MAX_WORK_MS = 1.0
MAX_GAP_MS = 50.0
MAX_MEMORY = 1.1
MAX_LOG_BYTES = 1000.0
# What a tick may take more because of a hostile client, and what it may hold, MiB.
MAX_COST_MS = 1.0
MAX_HELD_MIB = 16.0
# Times that an honest client and the hostile one are compared, one after the other.
PAIRS = 3
# Ticks that the server's recent stats are made of.
RECENT_TICKS = 600
SETTLE_S = 4.0
# Ends long after the driver has ended it.
LONG_S = 600


@dataclass(frozen=True)
class Case:
    """What a crowd does, and what it may cost."""

    plan: str
    clients: int
    people: int
    present: int = 0
    goal_gap: bool = False
    # An honest client with as many people comes first.
    compares: bool = False
    role: str = "trainee"


CASES = {
    "80 people join at once": Case("join", 10, 8),
    "50 clients churn": Case("churn", 50, 1),
    "lists at 60 Hz": Case("lists", 1, 8),
    "joins at 32 people": Case("single", 6, 1, present=4, goal_gap=True),
    # A trainee.
    "a hostile client": Case("hostile", 0, 8, compares=True),
    "a hostile observer": Case("hostile", 0, 0, role="observer"),
    "a hostile instructor": Case("hostile", 0, 0, role="instructor"),
    "levels at 20/s": Case("levels", 0, 0, role="instructor"),
}


@dataclass(frozen=True)
class Seen:
    """What was seen of a crowd: the server's reports, and the clients' rows."""

    before: dict[str, Any]
    after: dict[str, Any]
    later: dict[str, Any]
    watched: list[dict[str, Any]]
    crowd: list[dict[str, Any]]


class Session:
    """A server with those who watch."""

    def __init__(self, group: Group, server: Path, environment: list[str]) -> None:
        self._group = group
        self._godot = environment
        self.port = free_port()
        options = [f"--port={self.port}", "--max-clients=200", "--max-per-address=0"]
        group.start("server", [str(server), "--headless", "--", "--role=server", *options])
        self._status = group.await_status(30)
        self.crowd("observers", "join", 2, 0)
        self.crowd("trainee", "join", 1, 1)

    def crowd(
        self,
        name: str,
        plan: str,
        clients: int,
        people: int,
        begin: str = "",
        seed: int = 1,
        role: str = "trainee",
    ) -> None:
        """Starts clients, who wait for a file if one is named."""
        options = [f"--plan={plan}", f"--port={self.port}", f"--clients={clients}"]
        options += [f"--begin={begin}", f"--seed={seed}", f"--role={role}"]
        options += [f"--people={people}", f"--seconds={LONG_S}"]
        self._group.start(name, [*self._godot, "--", *options])

    def await_row(self, name: str, key: str, least: int, limit_s: float = 60.0) -> None:
        """Waits until so many are there."""
        self._group.await_that(
            name,
            lambda: any(row[key] >= least for row in self.rows(name)),
            f"{key} {least}",
            limit_s,
        )

    def await_ticks(self, ticks: int, limit_s: float = 120.0) -> dict[str, Any]:
        """Waits for so many ticks more and returns what the server reports then."""
        last = self.look()["ticks"] + ticks
        report: dict[str, Any] = {}

        def has_made() -> bool:
            report.update(self.look())
            return report["ticks"] >= last

        self._group.await_that("server", has_made, f"{ticks} ticks", limit_s)
        return report

    def rows(self, name: str) -> list[dict[str, Any]]:
        """What clients have seen, second by second."""
        return json_lines(self._group.log(name))

    def look(self) -> dict[str, Any]:
        """What the server reports, and what the system and its log say of it."""
        status = ask(self._status)
        number = self._group.number("server")
        rows = Path(f"/proc/{number}/status").read_text(encoding="utf-8").splitlines()
        status["rss_kb"] = next(int(row.split()[1]) for row in rows if row.startswith("VmRSS"))
        status["log_bytes"] = len(self._group.log("server"))
        return status


def measure(arguments: list[str]) -> int:
    """Runs the cases and prints their stats."""
    options = Options(
        arguments,
        {"case": tuple(CASES), "seconds": 8.0, "seed": 1, "server": str(SERVER_BINARY)},
    )
    bench = Bench("joins", options.json)
    for name in options["case"]:
        run_case(bench, name, options["seconds"], options["seed"], Path(options["server"]))
    return bench.finish()


def run_case(bench: Bench, name: str, seconds: float, seed: int, server: Path) -> None:
    """Runs one case and adds its stats."""
    case, stats = CASES[name], bench.stats
    program = bench.command("--headless", "-s", SCRIPT)
    with bench.session() as (group, folder):
        session = Session(group, server, program)
        for watcher, count in (("observers", 2), ("trainee", 1)):
            session.await_row(watcher, "joined", count)
        if case.present:
            session.crowd("present", "join", case.present, 8)
            session.await_row("present", "people", 8 * case.present + 1)
        pairs: list[tuple[dict[str, float], Seen]] = []
        for pair in range(PAIRS if case.compares else 1):
            honest = _watch_honest(session, group, case, f"honest {pair}") if case.compares else {}
            begin = folder / f"begin{pair}"
            crowd = (case.plan, case.clients, case.people, str(begin), seed + pair, case.role)
            session.crowd(f"crowd {pair}", *crowd)
            least_s = RECENT_TICKS / 60.0 if case.compares else 0.0
            pairs.append((honest, _watch_crowd(session, group, pair, begin, max(seconds, least_s))))
    _add(stats, name, case, pairs[0][1])
    if case.clients == 0:
        _add_attack(stats, name, seed, pairs)
    if case.compares:
        _add_cost(stats, name, pairs)


def _watch_honest(session: Session, group: Group, case: Case, name: str) -> dict[str, float]:
    session.crowd(name, "join", 1, case.people)
    session.await_row(name, "bodies", case.people)
    recent: dict[str, float] = session.await_ticks(RECENT_TICKS)["recent"]
    group.stop(name)
    return recent


def _watch_crowd(session: Session, group: Group, pair: int, begin: Path, seconds: float) -> Seen:
    # The crowd's program starts before, so that its start takes nothing from the server.
    time.sleep(SETTLE_S)
    before = session.look()
    seen = len(session.rows("observers"))
    begin.touch()
    time.sleep(seconds)
    after = session.look()
    watched = session.rows("observers")[seen + 1 :]
    crowd = session.rows(f"crowd {pair}")
    group.stop(f"crowd {pair}")
    time.sleep(2.0 * SETTLE_S)
    return Seen(before, after, session.look(), watched, crowd)


def _add(stats: Stats, name: str, case: Case, seen: Seen) -> None:
    before, after, later = seen.before, seen.after, seen.later
    watched, crowd = seen.watched, seen.crowd
    span = after["seconds"] - before["seconds"]
    ticks = (after["ticks"] - before["ticks"]) / span
    stats.add(name, "ticks", ticks, "/s", at_least=MIN_TICKS)
    first, last = watched[0], watched[-1]
    seconds = max(last["second"] - first["second"], 1)
    grown = [b - a for a, b in zip(first["snapshots"], last["snapshots"], strict=True)]
    stats.add(name, "snapshots of an observer", min(grown) / seconds, "/s", at_least=MIN_SNAPSHOTS)
    sent = (after["sent_ticks"] - before["sent_ticks"]) / span if "sent_ticks" in after else 0.0
    stats.add(name, "ticks of which the server sent the state", sent, "/s")
    gap = max(max(row["gaps_ms"]) for row in watched)
    stats.add(name, "longest gap", gap, "ms", at_most=MAX_GAP_MS if case.goal_gap else None)
    if "changes" in after:
        changes = after["changes"]
        stats.add(name, "making and removing people, ticks", changes["ticks"], "")
        stats.add(name, "the same, p50", changes["ms_p50"], "ms")
        stats.add(name, "the same, p99", changes["ms_p99"], "ms", at_most=MAX_WORK_MS)
        stats.add(name, "the same, most", changes["ms_max"], "ms")
    stats.add(name, "bodies of the crowd", max(row.get("bodies", 0) for row in crowd), "")
    stats.add(name, "joins of the crowd", crowd[-1]["joins"], "")
    stats.add(name, "a frame of the crowd", crowd[-1]["frame_ms"], "ms")
    stats.add(name, "memory before", before["rss_kb"] / 1024.0, "MiB")
    grown_by = later["rss_kb"] / before["rss_kb"]
    stats.add(name, "memory afterwards, of that before", grown_by, "", at_most=MAX_MEMORY)
    log = (after["log_bytes"] - before["log_bytes"]) / span
    stats.add(name, "log", log, "B/s", at_most=MAX_LOG_BYTES)


def _add_attack(
    stats: Stats, name: str, seed: int, pairs: list[tuple[dict[str, float], Seen]]
) -> None:
    """What was sent, and what the server holds because of it."""
    looks = [seen for _, seen in pairs]
    stats.add(name, "first seed", seed, "")
    stats.add(name, "messages of the crowd", sum(seen.crowd[-1]["sent"] for seen in looks), "")
    most = max(max(seen.after["rss_kb"], seen.later["rss_kb"]) for seen in looks)
    held = (most - looks[0].before["rss_kb"]) / 1024.0
    stats.add(name, "memory that it took", held, "MiB", at_most=MAX_HELD_MIB)


def _add_cost(stats: Stats, name: str, pairs: list[tuple[dict[str, float], Seen]]) -> None:
    """Medians of the pairs: the machine is not always as fast."""
    for part in ("p50", "p99"):
        key = f"work_ms_{part}"
        costs = [seen.after["recent"][key] - honest[key] for honest, seen in pairs]
        beside = median(honest[key] for honest, _ in pairs)
        stats.add(name, f"a tick beside an honest client, {part}", beside, "ms")
        text = f"a tick takes longer than beside an honest one, {part}"
        stats.add(name, text, median(costs), "ms", at_most=MAX_COST_MS)
        stats.add(name, f"the same, least of {PAIRS}", min(costs), "ms")
        stats.add(name, f"the same, most of {PAIRS}", max(costs), "ms")


if __name__ == "__main__":
    main(measure)
