# SPDX-License-Identifier: MIT
"""A bad network in userspace: forwards UDP datagrams late, in another order, or not at all.

Clients talk to the proxy's port; each gets a socket of its own towards the server, so that the
server sees as many addresses as there are clients. Both directions are treated alike, and what is
on the wire is counted. 127.0.0.1 only.

As a program (`python -m toolchain.udp_proxy TARGET_PORT LOSS DELAY JITTER SEED`) it prints the
port that it listens on, then obeys lines on its standard input: "restart" begins to count anew,
"stats" prints what was counted as a line of JSON. It ends when its input does.
"""

from __future__ import annotations

import contextlib
import gc
import heapq
import json
import os
import random
import select
import socket
import struct
import subprocess
import sys
import time
from pathlib import Path
from types import TracebackType
from typing import Any

LOCAL = "127.0.0.1"
# IPv4 without options, and UDP.
HEADERS = 28
# Linux: the kernel's time of a datagram's arrival comes with it.
SO_TIMESTAMPNS = 35
TIMESPEC = struct.Struct("qq")
SPACE = socket.CMSG_SPACE(TIMESPEC.size) if hasattr(socket, "CMSG_SPACE") else 64
LONGEST = 65536
BUFFER = 4 << 20
MAX_CLIENTS = 4096
# A client that has been silent for so long is forgotten.
IDLE_NS = 60_000_000_000
BIN_NS = 20_000
BINS = 2500


class Conditions:
    """What happens to a datagram."""

    def __init__(self, loss_percent: float, delay_ms: float, jitter_ms: float, seed: int) -> None:
        self._random = random.Random(seed)
        self._loss = loss_percent / 100.0
        self._delay_ns = delay_ms * 1e6
        self._jitter_ns = jitter_ms * 1e6

    def draw(self) -> int | None:
        """How long the next datagram takes, ns; None if it is lost."""
        if self._loss > 0.0 and self._random.random() < self._loss:
            return None
        if self._jitter_ns == 0.0:
            return int(self._delay_ns)
        delay = self._delay_ns + self._random.uniform(-self._jitter_ns, self._jitter_ns)
        return max(0, int(delay))


class Way:
    """One direction of one client's traffic."""

    def __init__(self) -> None:
        self.restart()

    def restart(self) -> None:
        """Counts anew."""
        self.datagrams = 0
        self.bytes = 0
        self.lost = 0
        self.delivered = 0
        self.failed = 0

    def stats(self) -> dict[str, int]:
        """What came in (bytes with headers), and what became of it."""
        return {
            "datagrams": self.datagrams,
            "wire_bytes": self.bytes + HEADERS * self.datagrams,
            "lost": self.lost,
            "delivered": self.delivered,
            "failed": self.failed,
        }


class Client:
    """A client, and the socket that stands for it before the server."""

    def __init__(self, address: tuple[str, int], target: tuple[str, int]) -> None:
        self.address = address
        self.socket = _make_socket()
        self.socket.connect(target)
        self.up = Way()
        self.down = Way()
        self.heard_ns = 0


class Lateness:
    """By how much datagrams left later than they should have."""

    def __init__(self) -> None:
        self.restart()

    def restart(self) -> None:
        """Counts anew."""
        self._bins = [0] * BINS
        self._count = 0
        self._worst = 0

    def add(self, late_ns: int) -> None:
        """Counts one datagram."""
        self._bins[min(late_ns // BIN_NS, BINS - 1)] += 1
        self._count += 1
        self._worst = max(self._worst, late_ns)

    def percentile_ms(self, fraction: float) -> float:
        """What a fraction of them does not exceed."""
        wanted = fraction * self._count
        total = 0
        for index, count in enumerate(self._bins):
            total += count
            if count and total >= wanted:
                return (index + 1) * BIN_NS / 1e6
        return 0.0

    def stats(self) -> dict[str, float]:
        """For a report."""
        found = {f"p{n}_ms": self.percentile_ms(n / 100) for n in (50, 95, 99)}
        return {**found, "worst_ms": self._worst / 1e6}


def _make_socket() -> socket.socket:
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    made.setblocking(False)
    for option in (socket.SO_RCVBUF, socket.SO_SNDBUF):
        made.setsockopt(socket.SOL_SOCKET, option, BUFFER)
    with contextlib.suppress(OSError):
        made.setsockopt(socket.SOL_SOCKET, SO_TIMESTAMPNS, 1)
    return made


class Proxy:
    """Forwards between the clients that come to its port and a server's port."""

    def __init__(self, target_port: int, conditions: Conditions) -> None:
        self._target = (LOCAL, target_port)
        self._conditions = conditions
        self._listener = _make_socket()
        self._listener.bind((LOCAL, 0))
        self._clients: dict[tuple[str, int], Client] = {}
        self._by_file: dict[int, Client] = {}
        self._waiting: list[tuple[int, int, bool, Client, bytes]] = []
        self._number = 0
        self._lateness = Lateness()
        self._began_ns = time.time_ns()
        self._began_cpu = time.process_time()
        self._overflowed = 0
        self._epoll = select.epoll()
        self._epoll.register(self._listener.fileno(), select.EPOLLIN)

    @property
    def port(self) -> int:
        """The port that clients talk to."""
        return self._listener.getsockname()[1]

    def fileno(self) -> int:
        """Readable when something has come."""
        return self._epoll.fileno()

    def wait_s(self) -> float | None:
        """How long nothing is to be sent; None for ever."""
        if not self._waiting:
            return None
        return max(0.0, (self._waiting[0][0] - time.time_ns()) / 1e9)

    def turn(self) -> None:
        """Takes in what has come and sends what is due."""
        for file, _ in self._epoll.poll(0):
            client = self._by_file.get(file)
            if client is not None:
                self._take_down(client)
            else:
                self._take_up()
        self._send_due()

    def stats(self) -> dict[str, Any]:
        """What was counted since the last restart."""
        rows = [
            {"port": c.address[1], "up": c.up.stats(), "down": c.down.stats()}
            for c in self._clients.values()
        ]
        return {
            "seconds": (time.time_ns() - self._began_ns) / 1e9,
            "cpu_seconds": time.process_time() - self._began_cpu,
            "clients": rows,
            "late": self._lateness.stats(),
            "overflowed": self._count_overflows() - self._overflowed,
        }

    def restart(self) -> None:
        """Counts anew, and forgets clients that are gone."""
        self._began_ns = time.time_ns()
        self._began_cpu = time.process_time()
        self._lateness.restart()
        self._forget_idle()
        self._overflowed = self._count_overflows()
        for client in self._clients.values():
            client.up.restart()
            client.down.restart()

    def close(self) -> None:
        """Closes all sockets."""
        self._epoll.close()
        self._listener.close()
        for client in self._clients.values():
            client.socket.close()

    def _take_up(self) -> None:
        for _ in range(64):
            try:
                data, extra, _, address = self._listener.recvmsg(LONGEST, SPACE)
            except OSError:
                return
            client = self._clients.get(address) or self._admit(address)
            if client is not None:
                client.heard_ns = self._queue(client, True, data, extra)

    def _take_down(self, client: Client) -> None:
        for _ in range(64):
            try:
                data, extra, _, _ = client.socket.recvmsg(LONGEST, SPACE)
            except OSError:
                return
            self._queue(client, False, data, extra)

    def _admit(self, address: tuple[str, int]) -> Client | None:
        if len(self._clients) >= MAX_CLIENTS:
            self._forget_idle()
        if len(self._clients) >= MAX_CLIENTS:
            return None
        client = Client(address, self._target)
        self._clients[address] = client
        self._by_file[client.socket.fileno()] = client
        self._epoll.register(client.socket.fileno(), select.EPOLLIN)
        return client

    def _forget_idle(self) -> None:
        oldest = time.time_ns() - IDLE_NS
        for address, client in list(self._clients.items()):
            if client.heard_ns < oldest:
                self._epoll.unregister(client.socket.fileno())
                del self._by_file[client.socket.fileno()]
                del self._clients[address]
                client.socket.close()

    def _queue(self, client: Client, is_up: bool, data: bytes, extra: list) -> int:
        arrived = time.time_ns()
        for _, kind, value in extra:
            if kind == SO_TIMESTAMPNS:
                seconds, nanoseconds = TIMESPEC.unpack(value)
                arrived = seconds * 1_000_000_000 + nanoseconds
        way = client.up if is_up else client.down
        way.datagrams += 1
        way.bytes += len(data)
        delay = self._conditions.draw()
        if delay is None:
            way.lost += 1
        else:
            self._number += 1
            entry = (arrived + delay, self._number, is_up, client, data)
            heapq.heappush(self._waiting, entry)
        return arrived

    def _send_due(self) -> None:
        while self._waiting:
            now = time.time_ns()
            if self._waiting[0][0] > now:
                return
            due, _, is_up, client, data = heapq.heappop(self._waiting)
            way = client.up if is_up else client.down
            try:
                if is_up:
                    client.socket.send(data)
                else:
                    self._listener.sendto(data, client.address)
            except OSError:
                # Whom it was meant for is gone, or its buffer is full.
                way.failed += 1
                continue
            way.delivered += 1
            self._lateness.add(now - due)

    def _count_overflows(self) -> int:
        """Datagrams that the kernel dropped, because a socket's buffer was full."""
        sockets = [self._listener, *(client.socket for client in self._clients.values())]
        inodes = {str(os.fstat(one.fileno()).st_ino) for one in sockets}
        with contextlib.suppress(OSError, ValueError, IndexError):
            rows = Path("/proc/net/udp").read_text(encoding="ascii").splitlines()[1:]
            return sum(int(row.split()[12]) for row in rows if row.split()[9] in inodes)
        return 0


class ProxyProcess:
    """A proxy in a process of its own."""

    def __init__(self, target_port: int, conditions: tuple[float, float, float, int]) -> None:
        command = [sys.executable, "-m", "toolchain.udp_proxy", str(target_port)]
        command += [str(value) for value in conditions]
        tools = str(Path(__file__).resolve().parents[1])
        self._process = subprocess.Popen(
            command,
            env={**os.environ, "PYTHONPATH": tools, "PYTHONDONTWRITEBYTECODE": "1"},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self.port = int(self._read())

    def __enter__(self) -> ProxyProcess:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _value: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        self._process.kill()
        self._process.wait()

    def restart(self) -> None:
        """Counts anew."""
        self._write("restart")
        self._read()

    def stats(self) -> dict[str, Any]:
        """What was counted."""
        self._write("stats")
        return json.loads(self._read())

    def _write(self, line: str) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write(line + "\n")
        self._process.stdin.flush()

    def _read(self) -> str:
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        if not line:
            raise RuntimeError("the proxy has ended")
        return line


def _obey(proxy: Proxy, line: str) -> None:
    if line == "restart":
        proxy.restart()
        print("{}", flush=True)
    elif line == "stats":
        print(json.dumps(proxy.stats()), flush=True)


def main(arguments: list[str]) -> int:
    """Runs until the standard input ends."""
    port, loss, delay, jitter, seed = arguments
    proxy = Proxy(int(port), Conditions(float(loss), float(delay), float(jitter), int(seed)))
    print(proxy.port, flush=True)
    # Nothing here refers to itself: pauses for collecting would only make datagrams late.
    gc.disable()
    orders = sys.stdin.fileno()
    text = b""
    while True:
        # A time in µs, other than epoll's own, which is in ms.
        ready, _, _ = select.select([proxy, orders], [], [], proxy.wait_s())
        if orders in ready:
            read = os.read(orders, 4096)
            if not read:
                proxy.close()
                return 0
            *lines, text = (text + read).split(b"\n")
            for line in lines:
                _obey(proxy, line.decode("ascii", "replace"))
        proxy.turn()


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        sys.exit(main(sys.argv[1:]))
