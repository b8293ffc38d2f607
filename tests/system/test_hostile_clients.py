# SPDX-License-Identifier: MIT
"""Clients that have joined, or are about to, and send what no client of ours does."""

from __future__ import annotations

import re
import socket
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from toolchain.processes import free_port

from .conftest import Process, SharedWorlds, World
from .noise import LEVEL, ORDER, Noise
from .own_client import (
    INSTRUCTOR,
    OBSERVER,
    TRAINEE,
    Crowd,
    OwnClient,
    fragment_command,
    reliable_command,
    unreliable_command,
)

# Of the multiplayer API and its transfer channels.
CHANNELS = [0, 1, 2, 3, 4, 5, 6]
MIB = 1 << 20
ENGINE_LINES = re.compile(r"ERROR|WARNING|^\s+at: |backtrace", re.MULTILINE)
# Of those that come to others while much is held back: few, where nobody moves.
SNAPSHOTS = 4


class Target:
    """A server, and clients of our own for it."""

    def __init__(self, world: World, sealed: bool) -> None:
        self.port = world.port
        self.sealed = sealed
        # A level with much that can be called and commanded.
        self.server = world.server("--world=yard", f"--sealing={int(sealed)}", name=f"{sealed}")

    def client(self, role: int = OBSERVER, **options: Any) -> OwnClient:
        return OwnClient(self.port, role, sealed=self.sealed, **options)

    def counts(self) -> Counter[str]:
        """What the transport has counted, and what was refused."""
        report = self.server.report()
        numbers = {k: v for k, v in report["transport"].items() if not isinstance(v, dict)}
        return Counter(numbers | report["refused"])

    def await_counts(self, before: Counter[str], **least: int) -> None:
        """Waits until each has grown by more than so much."""

        def holds(_report: dict) -> bool:
            now = self.counts()
            return all(now[name] > before[name] + least[name] for name in least)

        self.server.await_report(holds)


BEGINS = {
    "sealed": lambda world: Target(world, True),
    "open": lambda world: Target(world, False),
}


@pytest.fixture(scope="module", params=list(BEGINS))
def sealing(request: pytest.FixtureRequest) -> str:
    """Of a module, so that the tests of each stand together."""
    name: str = request.param
    return name


@pytest.fixture
def target(sealing: str, shared_worlds: SharedWorlds) -> Iterator[Target]:
    """A server that tests share."""
    with shared_worlds.visit(BEGINS[sealing]) as begun:
        yield begun


def _memory(process: Process) -> int:
    pages = Path(f"/proc/{process.process.pid}/statm").read_text(encoding="ascii").split()[1]
    return int(pages) * 4096


def _no_engine_lines(server: Process) -> None:
    log = server.log()
    found = ENGINE_LINES.search(log)
    assert found is None, log[max(found.start() - 500, 0) : found.start() + 1000]


def _send_noise(client: OwnClient, noise: Noise) -> None:
    match noise.random.randrange(5):
        case 0 | 1:
            client.send(noise.packet(), noise.random.choice(CHANNELS))
        case 2 | 3:
            client.send_fast(noise.message())
        case _:
            client.send_unsequenced(noise.packet(), noise.random.choice(CHANNELS))


def test_noise_of_every_role_makes_no_engine_error(target: Target) -> None:
    server, noise = target.server, Noise(13)
    began, began_s = target.counts(), server.report()["seconds"]
    with Crowd() as crowd:
        clients = [target.client(role) for role in (OBSERVER, TRAINEE, INSTRUCTOR)]
        crowd.join(clients)
        # A level without shared nodes after one that has some: the engine's own API goes on.
        clients[2].send(bytes([3, ORDER, 1, 0, LEVEL, *bytes(6), 4, 0]) + b"hall")
        for _round in range(400):
            for client in clients:
                # Less than what is too much in a second: that would only be dropped.
                for _ in range(4):
                    _send_noise(client, noise)
            crowd.go_on()
            # A busy server throws out who has sent more than it can take in.
            for client in [client for client in clients if client.is_gone]:
                clients.remove(client)
                clients.append(target.client(client.role))
                crowd.join(clients[-1:])
        crowd.join([target.client()])
    # The slower the server, the more of it is dropped before its turn.
    target.await_counts(began, kind=5, role=5, dropped_in=100)
    seconds = server.report()["seconds"] - began_s
    _no_engine_lines(server)
    assert len(server.log()) < 1000 * seconds + 3000


def test_noise_before_a_join_makes_no_engine_error(target: Target) -> None:
    noise = Noise(14)
    began = target.counts()
    with Crowd() as crowd:
        for channels in (0, 1, 2, 255, 256, 0xFFFFFFFF, *([7] * 14)):
            client = target.client(joins=False, channels=channels)
            crowd.add(client)
            if channels < 7 or channels > 255:
                # Dropped: ENet never answers it.
                for _ in range(40):
                    crowd.go_on()
                assert client.peer is None
                continue
            crowd.go_on_until(lambda client=client: client.peer is not None)
            for _ in range(60):
                if noise.random.random() < 0.5:
                    client.send(b"\x07\x00" + noise.altered(client.join_request()))
                _send_noise(client, noise)
                crowd.go_on()
        crowd.join([target.client()])
    least = {"join request": 5, "too_few_channels": 0, "malformed": 0, "dropped_in": 50}
    target.await_counts(began, **least)
    _no_engine_lines(target.server)


def test_who_has_not_joined_takes_nothing_from_those_who_do(target: Target) -> None:
    """200 connections without a join request hold back all that they may; others join."""
    server = target.server
    began = target.counts()
    with Crowd() as crowd:
        joiners: list[OwnClient] = []
        before = _memory(server)
        for _burst in range(3):
            arriving = [target.client(joins=False) for _ in range(200)]
            crowd.add(*arriving)
            crowd.go_on_until(lambda arriving=arriving: all(c.peer is not None for c in arriving))
            for round_ in range(7 * 20):
                for client in arriving:
                    client.write_commands(_behind_a_gap(client, round_))
                if round_ % 20 == 0:
                    crowd.go_on()
            joiners.append(target.client())
            crowd.join(joiners[-1:])
        assert all(joiner.is_joined for joiner in joiners)
        target.await_counts(began, held_too_much=1000)
        assert target.counts()["held_bytes"] < 8 * MIB
        assert _memory(server) - before < 32 * MIB
    _no_engine_lines(server)


def _first_fragments(client: OwnClient, round_: int) -> bytes:
    first = round_ * 16 % 900 + 1 + client.numbers[0]
    return fragment_command(0, first, 0, 16, 16384, 1024, bytes(1024))


def _behind_a_gap(client: OwnClient, round_: int) -> bytes:
    channel = CHANNELS[round_ % 7]
    return reliable_command(channel, client.numbers[channel] + 2 + round_ // 7, bytes(1100))


def _waiting(client: OwnClient, round_: int) -> bytes:
    channel = CHANNELS[round_ % 7]
    return unreliable_command(channel, client.numbers[channel] + 1, round_, bytes(1100))


def test_packets_that_never_complete_hold_little_and_not_for_long(world: World) -> None:
    """At a server that seals and at one that does not: their silence is waited for together."""
    targets = []
    for sealed in (True, False):
        world.port = free_port()
        targets.append(Target(world, sealed))
        with Crowd() as crowd:
            _hold_back(targets[-1], crowd)
    for target in targets:
        target.server.await_report(lambda r: r["transport"]["held_bytes"] == 0)
        _no_engine_lines(target.server)


def _hold_back(target: Target, crowd: Crowd) -> None:
    """Twenty clients send what never completes, and are silent from then on."""
    kinds = [_first_fragments, _behind_a_gap, _waiting]
    observer = target.client()
    clients = [target.client() for _ in range(20)]
    crowd.join([observer, *clients])
    before = _memory(target.server)
    for round_ in range(260):
        for index, client in enumerate(clients):
            client.write_commands(kinds[index % 3](client, round_))
        crowd.go_on()
    grown = _memory(target.server) - before
    report = target.server.await_report(lambda r: r["transport"]["held_too_much"] > 100)
    held = report["transport"]["held_bytes"]
    print(f"{held / MIB:.1f} MiB held, {grown / MIB:.1f} MiB more in memory")
    assert MIB < held <= 20 * (256 << 10)
    assert grown < 16 * MIB
    seen = observer.snapshots
    crowd.go_on_until(lambda: observer.snapshots > seen + SNAPSHOTS)
    for client in clients:
        client.is_gone = True


def _ask(port: int, request: bytes) -> bytes:
    with socket.create_connection(("127.0.0.1", port), timeout=120.0) as client:
        client.sendall(request)
        answer = b""
        try:
            while more := client.recv(65536):
                answer += more
        except ConnectionError:
            pass
        return answer.split(b"\r\n")[0]


def test_garbage_at_the_status_port(target: Target) -> None:
    server, port = target.server, target.port
    before = server.report()["status_requests"]
    noise = Noise(15)
    good = b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"
    wrong = [
        (b"GET /\xff\xfe HTTP/1.1\r\n\r\n", b"404"),
        (b"\xff" * 200 + b"\r\n\r\n", b"400"),
        (b"GET / HTTP/1.1\r\nHost: \xc3\xa9\r\n\r\n", b"421"),
        (b"GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n", b"421"),
        (b"GET /\0 HTTP/1.1\r\n\r\n", b"400"),
        (b"A" * 5000, b"431"),
        (b"GET / HTTP/1.1\r\n" + b"X: y\r\n" * 800, b"431"),
        (b"POST / HTTP/1.1\r\nContent-Length: -5\r\n\r\n", b"405"),
        (b"\r\n\r\n", b"400"),
    ]
    for request, code in wrong:
        assert code in _ask(port, request)
    for _ in range(20):
        _ask(port, noise.random.randbytes(300) + b"\0\r\n\r\n")
    assert b"200" in _ask(port, good * 40)
    # Connections that ask nothing, and many of them: those who do ask still get their answer.
    for _ in range(10):
        idle = [socket.create_connection(("127.0.0.1", port)) for _ in range(8)]
        for one in idle:
            one.close()
    assert b"200" in _ask(port, good)
    report = server.await_report(
        lambda r: r["status_requests"]["dropped"] >= before["dropped"] + 60
    )
    assert report["status_requests"]["refused"] >= before["refused"] + len(wrong) + 20
    _no_engine_lines(server)
