# SPDX-License-Identifier: MIT
"""The bad network of ./run load, over real sockets of 127.0.0.1."""

from __future__ import annotations

import select
import socket
import time
from collections.abc import Iterator

import pytest
from toolchain.udp_proxy import HEADERS, LOCAL, Conditions, Proxy, ProxyProcess

LIMIT_S = 60.0


def make_socket(port: int = 0) -> socket.socket:
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    made.setblocking(False)
    if port:
        made.connect((LOCAL, port))
    else:
        made.bind((LOCAL, 0))
    return made


@pytest.fixture
def server() -> Iterator[socket.socket]:
    with make_socket() as made:
        yield made


def port_of(one: socket.socket) -> int:
    return one.getsockname()[1]


def receive(proxy: Proxy, end: socket.socket, count: int) -> list[tuple[bytes, tuple[str, int]]]:
    """Lets the proxy work until so many datagrams have come."""
    found: list[tuple[bytes, tuple[str, int]]] = []
    limit = time.monotonic() + LIMIT_S
    while len(found) < count:
        assert time.monotonic() < limit, f"only {len(found)} of {count} datagrams come"
        wait = proxy.wait_s()
        ready, _, _ = select.select([proxy, end], [], [], 1.0 if wait is None else wait)
        proxy.turn()
        while end in ready:
            try:
                found.append(end.recvfrom(2048))
            except BlockingIOError:
                break
    return found


def settle(proxy: Proxy, count: int) -> None:
    """Lets the proxy work until so many datagrams have come to it and none waits in it."""
    limit = time.monotonic() + LIMIT_S
    while True:
        rows = proxy.stats()["clients"]
        came = sum(row["up"]["datagrams"] for row in rows)
        if came >= count and proxy.wait_s() is None:
            return
        assert time.monotonic() < limit, f"only {came} of {count} datagrams come"
        proxy.turn()


def test_conditions_are_those_that_were_asked_for() -> None:
    draws = [Conditions(20.0, 25.0, 10.0, 7).draw() for _ in range(1)]
    assert draws == [Conditions(20.0, 25.0, 10.0, 7).draw()]
    conditions = Conditions(20.0, 25.0, 10.0, 7)
    delays = [conditions.draw() for _ in range(20000)]
    kept = [delay / 1e6 for delay in delays if delay is not None]
    assert 0.18 < 1.0 - len(kept) / len(delays) < 0.22
    assert 15.0 <= min(kept) < 15.1
    assert 34.9 < max(kept) <= 35.0
    assert 24.8 < sum(kept) / len(kept) < 25.2


def test_a_jitter_above_the_delay_is_never_before_its_time() -> None:
    conditions = Conditions(0.0, 1.0, 5.0, 1)
    assert all((conditions.draw() or 0) >= 0 for _ in range(1000))


def test_each_client_has_an_address_of_its_own_and_gets_its_own_answers(
    server: socket.socket,
) -> None:
    proxy = Proxy(port_of(server), Conditions(0.0, 0.0, 0.0, 1))
    clients = [make_socket(proxy.port) for _ in range(3)]
    for number, client in enumerate(clients):
        client.send(bytes([number]) * 100)
    addresses = {}
    for data, address in receive(proxy, server, 3):
        addresses[data[0]] = address
    assert len(set(addresses.values())) == 3
    for number, address in addresses.items():
        server.sendto(bytes([number, 42]), address)
    for number, client in enumerate(clients):
        assert receive(proxy, client, 1)[0][0] == bytes([number, 42])
    for row in proxy.stats()["clients"]:
        assert row["up"] == {
            "datagrams": 1,
            "wire_bytes": 100 + HEADERS,
            "lost": 0,
            "delivered": 1,
            "failed": 0,
        }
        assert row["down"]["wire_bytes"] == 2 + HEADERS
    proxy.restart()
    assert all(row["up"]["datagrams"] == 0 for row in proxy.stats()["clients"])
    proxy.close()


def test_nothing_comes_too_early_and_jitter_changes_the_order(server: socket.socket) -> None:
    proxy = Proxy(port_of(server), Conditions(0.0, 30.0, 20.0, 3))
    client = make_socket(proxy.port)
    begin = time.monotonic()
    for number in range(100):
        client.send(bytes([number]))
    first = receive(proxy, server, 1)
    assert time.monotonic() - begin >= 0.0099
    order = [data[0] for data, _ in first + receive(proxy, server, 100 - len(first))]
    assert sorted(order) == list(range(100))
    assert order != sorted(order)
    assert proxy.stats()["late"]["p99_ms"] > 0.0
    proxy.close()


def test_what_is_lost_is_counted_and_never_comes(server: socket.socket) -> None:
    proxy = Proxy(port_of(server), Conditions(30.0, 0.0, 0.0, 5))
    client = make_socket(proxy.port)
    for number in range(100):
        client.send(bytes([number]))
    settle(proxy, 100)
    row = proxy.stats()["clients"][0]["up"]
    assert row["datagrams"] == 100
    assert row["lost"] + row["delivered"] == 100
    assert 15 <= row["lost"] <= 45
    came = 0
    while True:
        try:
            server.recv(2048)
        except BlockingIOError:
            break
        came += 1
    assert came == row["delivered"]
    proxy.close()


def test_a_server_that_is_gone_does_not_end_the_proxy() -> None:
    with make_socket() as gone:
        port = port_of(gone)
    proxy = Proxy(port, Conditions(0.0, 0.0, 0.0, 1))
    client = make_socket(proxy.port)
    for _ in range(20):
        client.send(b"anybody?")
    settle(proxy, 20)
    row = proxy.stats()["clients"][0]["up"]
    assert row["delivered"] + row["failed"] == 20
    proxy.close()


def test_a_process_of_its_own(server: socket.socket) -> None:
    server.settimeout(LIMIT_S)
    with ProxyProcess(port_of(server), (0.0, 1.0, 0.5, 1)) as proxy:
        client = make_socket(proxy.port)
        client.send(b"there")
        data, address = server.recvfrom(100)
        assert data == b"there"
        server.sendto(b"back", address)
        client.settimeout(LIMIT_S)
        assert client.recv(100) == b"back"
        stats = proxy.stats()
        assert stats["clients"][0]["up"]["delivered"] == 1
        assert stats["overflowed"] == 0
        proxy.restart()
        assert proxy.stats()["clients"][0]["up"]["delivered"] == 0
