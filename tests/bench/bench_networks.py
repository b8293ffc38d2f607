# SPDX-License-Identifier: MIT
"""What networks do to a session of exported programs on 127.0.0.1, through a network of our own.

Cost: what a trainee of one person and an observer of one send and get, whole IP packets. Networks:
how many of 60 snapshots/s an observer gets where packets are small, lost or overtaken. Addresses:
how long an observer gets nothing after his address has changed. Silence: how long a client takes to
notice that its server is gone, after eight stalls of a second. Options: --part=NAME (cost,
networks, addresses, silence; again for more), --seconds=10 (of each network), --seed=1.
"""

from __future__ import annotations

import json
import os
import signal
import time
from pathlib import Path
from statistics import median

from bench import Bench, Options, main
from toolchain.paths import CLIENT_BINARY, CLIPS, SERVER_BINARY
from toolchain.processes import Group, await_that, free_port
from toolchain.stats import Stats
from toolchain.udp_relay import Relay

MIN_SNAPSHOTS = 57.0
# Of a loss of more than this no snapshot rate is asked, but that one can play.
MAX_LOSS = 0.05
MIN_LOSSY_SNAPSHOTS = 40.0
NETWORKS = [
    (mtu, loss, jitter_s)
    for mtu in (1500, 1280, 576)
    for loss, jitter_s in ((0.0, 0.0), (0.05, 0.0), (0.2, 0.0), (0.0, 0.05), (0.05, 0.05))
]
ONE_WAY_S = (0.001, 0.025, 0.1)
MOVES = 10
# Besides two round trips.
MAX_MOVE_S = 0.2
MAX_SILENCE_S = 6.0
STALLS = 8
MAX_UP_KBIT = 30.0
MAX_DOWN_KBIT = 38.0
MAX_ACKNOWLEDGEMENTS_KBIT = 4.0
# What the observer's user sees of 60 frames a second: acknowledgements leave with frames.
FPS = 60


class Session:
    """A server with a person who moves, and clients that come through networks."""

    def __init__(self, group: Group, folder: Path) -> None:
        self._group = group
        self._folder = folder
        self.port = free_port()
        options = [f"--port={self.port}", "--world=hall", "--max-per-address=0"]
        group.start("server", [str(SERVER_BINARY), "--headless", "--", *options])
        group.await_text("server", "listening on UDP port", 60)

    def add(self, name: str, role: str, port: int, *options: str) -> None:
        command = [str(CLIENT_BINARY), "--headless", "--", f"--role={role}", f"--port={port}"]
        report = f"--report={self._folder / name}.json"
        self._group.start(name, [*command, f"--fps={FPS}", report, *options])
        self._group.await_text(name, "is there after", 60)

    def snapshots(self, name: str) -> int:
        """Snapshots that a client has taken in; its report is a moment old."""
        try:
            report = json.loads((self._folder / f"{name}.json").read_text(encoding="utf-8"))
        except (OSError, json.JSONDecodeError):
            return 0
        return int(report["snapshots"])

    def await_more(self, name: str, count: int, limit_s: float = 60.0) -> None:
        before = self.snapshots(name)
        await_that(
            lambda: self.snapshots(name) >= before + count, f"{name}: more", limit_s, look_s=0.002
        )

    def stop(self, name: str) -> None:
        self._group.stop(name)


def measure_cost(stats: Stats, session: Session, seconds: float) -> None:
    """Whole IP packets of one person, both ways, on loopback."""
    with Relay(session.port) as up, Relay(session.port) as down:
        session.add("mover", "trainee", up.port, f"--bvh={CLIPS / '01_01.bvh'}")
        session.add("watcher", "observer", down.port)
        session.await_more("watcher", 300)
        before = (up.to_server, down.to_client, down.to_server)
        packets = (up.datagrams_to_server, down.datagrams_to_client, down.datagrams_to_server)
        time.sleep(seconds)
        after = (up.to_server, down.to_client, down.to_server)
        more = (up.datagrams_to_server, down.datagrams_to_client, down.datagrams_to_server)
        # Acknowledgements, and beside them the clock, stats and ENet's own.
        names = ("a trainee of one person, up", "an observer of one person, down", "the same, up")
        goals = (MAX_UP_KBIT, MAX_DOWN_KBIT, MAX_ACKNOWLEDGEMENTS_KBIT)
        for index, name in enumerate(names):
            kbit = (after[index] - before[index]) * 8 / 1000.0 / seconds
            count = more[index] - packets[index]
            stats.add("cost", name, kbit, "kbit/s", at_most=goals[index])
            stats.add("cost", f"{name}: packets", count / seconds, "/s")
            size = (after[index] - before[index]) / max(count, 1)
            stats.add("cost", f"{name}: a packet", size, "bytes")
        session.stop("watcher")
        session.stop("mover")


def measure_networks(stats: Stats, session: Session, seconds: float, seed: int) -> None:
    session.add("mover", "trainee", session.port, f"--bvh={CLIPS / '01_01.bvh'}")
    for mtu, loss, jitter_s in NETWORKS:
        name = f"MTU {mtu}, {100 * loss:.0f} % lost, {1000 * jitter_s:.0f} ms of reordering"
        with Relay(session.port, seed) as relay:
            relay.mtu, relay.loss, relay.jitter_s = mtu, loss, jitter_s
            session.add("watcher", "observer", relay.port)
            session.await_more("watcher", 60)
            before, passed = session.snapshots("watcher"), relay.datagrams_to_client
            time.sleep(seconds)
            came = session.snapshots("watcher") - before
            through = relay.datagrams_to_client - passed
            session.stop("watcher")
        goal = MIN_SNAPSHOTS if loss <= MAX_LOSS else MIN_LOSSY_SNAPSHOTS
        stats.add(name, "snapshots of an observer", came / seconds, "/s", at_least=goal)
        stats.add(name, "packets that the network let through", through / seconds, "/s")
    session.stop("mover")


def _move(relay: Relay) -> float:
    """Gives a client another address; returns how long it gets nothing then, s."""
    relay.move()
    began = time.monotonic()
    # What is under way comes from the old one.
    time.sleep(2 * relay.delay_s + 0.005)
    before = relay.sealed_to_client
    await_that(lambda: relay.sealed_to_client > before + 1, "what goes on", 20.0, look_s=0.002)
    return time.monotonic() - began


def measure_addresses(stats: Stats, session: Session) -> None:
    session.add("mover", "trainee", session.port, f"--bvh={CLIPS / '01_01.bvh'}")
    for one_way_s in ONE_WAY_S:
        gaps_s: list[float] = []
        with Relay(session.port) as relay:
            relay.delay_s = one_way_s
            session.add("watcher", "observer", relay.port)
            session.await_more("watcher", 120)
            for _ in range(MOVES):
                gaps_s.append(_move(relay))
                session.await_more("watcher", 30)
            session.stop("watcher")
        name = f"another address, {2000 * one_way_s:.0f} ms there and back"
        goal_s = 4 * one_way_s + MAX_MOVE_S
        stats.add(name, "until snapshots come again, median", 1000 * median(gaps_s), "ms")
        stats.add(name, "the same, most", 1000 * max(gaps_s), "ms", at_most=1000 * goal_s)
    session.stop("mover")


def measure_silence(stats: Stats, session: Session, group: Group) -> None:
    session.add("mover", "trainee", session.port, f"--bvh={CLIPS / '01_01.bvh'}")
    session.add("watcher", "observer", session.port)
    session.await_more("watcher", 60)
    server = group.number("server")
    for _ in range(STALLS):
        os.kill(server, signal.SIGSTOP)
        time.sleep(1.0)
        os.kill(server, signal.SIGCONT)
        session.await_more("watcher", 30)
    os.kill(server, signal.SIGKILL)
    began = time.monotonic()
    await_that(lambda: "is lost" in group.log("watcher"), "the notice", 60.0, look_s=0.002)
    silence_s = time.monotonic() - began
    name = f"a server that is gone, after {STALLS} stalls of 1 s"
    stats.add(name, "noticed after", silence_s, "s", at_most=MAX_SILENCE_S)


def measure(arguments: list[str]) -> int:
    """Runs the parts and prints their stats."""
    defaults = {"part": ("cost", "networks", "addresses", "silence"), "seconds": 10.0, "seed": 1}
    options = Options(arguments, defaults)
    bench = Bench("networks", options.json, export=True)
    stats, seconds = bench.stats, options["seconds"]
    for part in options["part"]:
        with bench.session({"DISMOUNT_REPORT_EVERY": "0.1"}) as (group, folder):
            session = Session(group, folder)
            if part == "cost":
                measure_cost(stats, session, seconds)
            elif part == "networks":
                measure_networks(stats, session, seconds, options["seed"])
            elif part == "addresses":
                measure_addresses(stats, session)
            else:
                measure_silence(stats, session, group)
    return bench.finish()


if __name__ == "__main__":
    main(measure)
