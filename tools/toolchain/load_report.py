# SPDX-License-Identifier: MIT
"""What `./run load` found, as stats with goals."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from .stats import Stats
from .udp_proxy import HEADERS

TICK_RATE = 60.0
MAX_NETWORK_MS = 2.0
# 60 % of a tick, with the step of physics.
MAX_WORK_MS = 10.0
MAX_KBIT = 256.0
# The process with the clients keeps up if it polls each this share as often as it wants to.
MIN_POLLS_SHARE = 0.9
# The engine names a thread after its function: here TransportThread._run.
THREAD = "_run"
TROUBLE = ("ERROR", "WARN ", "WARNING")


@dataclass
class Measured:
    """A session between two looks at it."""

    settings: dict[str, Any]
    before: dict[str, Any]
    after: dict[str, Any]
    load: dict[str, Any]
    wire: dict[str, Any] | None
    logs: dict[str, str]

    def grown(self, read: Callable[[dict[str, Any]], float]) -> float:
        """By how much a counter of the server's status grew."""
        return read(self.after["status"]) - read(self.before["status"])

    @property
    def ticks(self) -> float:
        """Ticks of the server."""
        return max(self.grown(lambda status: status["ticks"]), 1.0)

    @property
    def seconds(self) -> float:
        """Time between the looks."""
        return max(self.grown(lambda status: status["seconds"]), 0.001)

    @property
    def is_generator_late(self) -> bool:
        """Whether the process with the clients is too slow: what it measures is then its own."""
        polls: float = self.load["polls_per_second"]
        wanted: float = self.load["polls_wanted"]
        return polls < MIN_POLLS_SHARE * wanted

    @property
    def clients(self) -> list[dict[str, Any]]:
        """What each client counted."""
        return self.load["clients"]

    def troubles(self) -> list[str]:
        """Lines of the logs that report something wrong."""
        lines = [f"{name}: {one}" for name, log in self.logs.items() for one in log.splitlines()]
        return [line for line in lines if any(word in line for word in TROUBLE)]

    def whole(self) -> dict[str, Any]:
        """Everything, for a file."""
        looks = {"before": self.before, "after": self.after}
        found = {"settings": self.settings, "troubles": self.troubles()}
        return {**found, "clients": self.load, "wire": self.wire, "server": looks}


def add_stats(stats: Stats, found: Measured) -> None:
    """Adds everything that was found."""
    _add_server(stats, found)
    _add_networking(stats, found)
    if found.wire is None:
        _add_counted_traffic(stats, found)
    else:
        _add_wire(stats, found, found.wire)
    for role in ("trainees", "walkers", "observers"):
        if found.settings[role]:
            _add_knowledge(stats, found, role)
    _add_health(stats, found)


def _add_server(stats: Stats, found: Measured) -> None:
    status = found.after["status"]
    stats.add(
        "server", "tick rate held", found.ticks / found.seconds, "/s", at_least=0.98 * TICK_RATE
    )
    stats.add("server", "speed of the last second", status["speed"], "")
    slow = found.grown(lambda one: one["slow_seconds"])
    stats.add("server", "slow seconds", slow, "s")
    recent = status["recent"]
    for part in ("script", "send"):
        for rank in ("p50", "p99"):
            name = f"{part} time per tick, {rank}"
            stats.add("server", name, recent[f"{part}_ms_{rank}"], "ms")
    for rank, goal in (("p50", MAX_WORK_MS), ("p99", None)):
        name = f"main thread, CPU per tick, {rank}"
        stats.add("server", name, recent[f"work_ms_{rank}"], "ms", at_most=goal)


def _add_networking(stats: Stats, found: Measured) -> None:
    main = found.grown(lambda status: status["network_cpu_usec"]) / 1000.0 / found.ticks
    thread = found.grown(lambda status: status["transport"]["cpu_usec"]) / 1000.0 / found.ticks
    case = "server networking"
    stats.add(case, "main thread, CPU per tick", main, "ms")
    recent = found.after["status"]["recent"]
    stats.add(case, "main thread, CPU per tick, p99", recent["network_ms_p99"], "ms")
    stats.add(case, "transport thread, CPU per tick", thread, "ms")
    stats.add(case, "both, CPU per tick", main + thread, "ms", at_most=MAX_NETWORK_MS)
    used = _thread_growth(found.before["threads"], found.after["threads"])
    named = [used[number] for number, row in found.after["threads"].items() if row[0] == THREAD]
    stats.add(case, "transport thread (/proc)", 1000.0 * sum(named) / found.ticks, "ms")
    stats.add("server", "CPU of all threads", 100.0 * sum(used.values()) / found.seconds, "%")
    used = _thread_growth(found.before["client_threads"], found.after["client_threads"])
    cpu = 100.0 * sum(used.values()) / found.seconds
    stats.add("clients", "CPU of all of them", cpu, "%")
    stats.add("clients", "polls of each", found.load["polls_per_second"], "/s")
    stats.add("clients", "polls of each that they want", found.load["polls_wanted"], "/s")
    rate = found.settings["snapshot_rate"] or TICK_RATE
    stats.add("clients", "snapshots that each asks for", rate, "/s")
    stats.add("clients", "they are the limit, not the server", float(found.is_generator_late), "")


def _thread_growth(before: dict[int, Any], after: dict[int, Any]) -> dict[int, float]:
    """Processor time of each thread between two looks, s."""
    return {
        number: seconds - before.get(number, ("", 0.0))[1] for number, (_, seconds) in after.items()
    }


def _add_counted_traffic(stats: Stats, found: Measured) -> None:
    """Without a proxy: what the server's ENet has counted, and headers of UDP and IP."""
    count = max(len(found.clients), 1)
    for name, way in (("down", "sent"), ("up", "received")):
        size = found.grown(lambda status, way=way: status["transport"][f"{way}_bytes"])
        number = found.grown(lambda status, way=way: status["transport"][f"{way}_packets"])
        kbit = (size + HEADERS * number) * 8.0 / 1000.0 / found.seconds / count
        goal = MAX_KBIT if name == "down" else None
        stats.add("traffic", f"{name}, mean of the clients", kbit, "kbit/s", at_most=goal)
        rate = number / found.seconds / count
        stats.add("traffic", f"{name}, datagrams of a client", rate, "/s")


def _add_wire(stats: Stats, found: Measured, wire: dict[str, Any]) -> None:
    """What the proxy has counted."""
    seconds = wire["seconds"]
    rows = [row for row in wire["clients"] if row["up"]["datagrams"] + row["down"]["datagrams"]]
    for way in ("down", "up"):
        kbit = [row[way]["wire_bytes"] * 8.0 / 1000.0 / seconds for row in rows] or [0.0]
        goal = MAX_KBIT if way == "down" else None
        mean = statistics.fmean(kbit)
        stats.add("wire", f"{way}, mean of the clients", mean, "kbit/s", at_most=goal)
        stats.add("wire", f"{way}, most of a client", max(kbit), "kbit/s")
        rate = statistics.fmean([row[way]["datagrams"] / seconds for row in rows] or [0.0])
        stats.add("wire", f"{way}, datagrams of a client", rate, "/s")
        sent = sum(row[way]["datagrams"] for row in rows)
        lost = sum(row[way]["lost"] + row[way]["failed"] for row in rows)
        stats.add("wire", f"{way}, loss made", 100.0 * lost / max(sent, 1), "%")
    seen = [row["loss_percent"] for row in found.after["status"]["sessions"] if "datagrams" in row]
    stats.add("wire", "loss of snapshots, as the server sees it", _mean(seen), "%")
    stats.add("proxy", "late by, p50", wire["late"]["p50_ms"], "ms")
    stats.add("proxy", "late by, p99", wire["late"]["p99_ms"], "ms")
    stats.add("proxy", "dropped by full sockets", wire["overflowed"], "")
    stats.add("proxy", "CPU", 100.0 * wire["cpu_seconds"] / seconds, "%")


def _mean(values: Iterable[float]) -> float:
    known = list(values)
    return statistics.fmean(known) if known else 0.0


def _add_knowledge(stats: Stats, found: Measured, role: str) -> None:
    """What clients of a role know, and how old it is."""
    rows = [row for row in found.clients if row["role"] == role[:-1]]
    group = found.load["groups"][role]
    rate = _mean(row["snapshots"] for row in rows) / found.load["seconds"]
    stats.add(role, "snapshots of a client", rate, "/s")
    for rank in ("p50", "p95", "p99"):
        stats.add(role, f"age of people, {rank}", group["age"][f"{rank}_ms"], "ms")
    known = min(row["people_known"] for row in rows)
    people = found.settings["trainees"] + found.settings["walkers"]
    stats.add(role, "people known", known, "", at_least=people)
    for rank in ("p50", "p99"):
        delay = group["latency"][f"{rank}_ms"]
        stats.add(role, f"from sample to snapshot, {rank}", delay, "ms")


def _add_health(stats: Stats, found: Measured) -> None:
    rows = found.clients
    for name in ("stale", "lacks_baseline"):
        count = sum(row["outcomes"][name] for row in rows)
        stats.add("snapshots", name.replace("_", " "), count, "")
    broken = sum(row["outcomes"]["broken"] for row in rows)
    stats.add("snapshots", "broken", broken, "", at_most=0.0)
    stats.add("snapshots", "poses compared", found.load["compared_poses"], "")
    different = found.load["different_poses"]
    stats.add("snapshots", "poses that differ between clients", different, "", at_most=0.0)
    lost = sum(row["lost"] for row in rows)
    stats.add("sessions", "connections lost", lost, "", at_most=0.0)
    here = found.after["status"]["clients"]
    stats.add("sessions", "clients at the end", here, "", at_least=len(rows))
    troubles = found.troubles()
    errors = [line for line in troubles if "ERROR" in line]
    stats.add("logs", "errors", len(errors), "", at_most=0.0)
    stats.add("logs", "warnings", len(troubles) - len(errors), "")
