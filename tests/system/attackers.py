# SPDX-License-Identifier: MIT
"""Datagrams that nobody should send, for the tests under fire."""

from __future__ import annotations

import itertools
import json
import os
import random
import socket
import struct
import subprocess
import threading
import time
from pathlib import Path

from toolchain.project import EXTENSIONS

FLOOD = EXTENSIONS / "transport" / "transport_flood"


def connect_datagram(peer_id: int, connect_id: int) -> bytes:
    """ENet's CONNECT, as the first datagram of a client."""
    header = struct.pack(">HHBBH", 0x8FFF, 1, 0x82, 0xFF, 1)
    body = struct.pack(
        ">HBB9II", 0, 0xFF, 0xFF, 1392, 65536, 8, 0, 0, 5000, 2, 2, connect_id, peer_id
    )
    return header + body


def garbage(count: int, seed: int) -> list[bytes]:
    """Empty, random, and beginning like ENet's connect command."""
    source = random.Random(seed)
    result = []
    for i in range(count):
        size = source.choice([0, 1, 4, 20, 52, 200, 1200, 1400])
        body = source.randbytes(size)
        if i % 4 == 3 and size >= 52:
            body = struct.pack(">HHBBH", 0x8FFF, 0, 0x82, 0xFF, 1) + body[8:]
        result.append(body)
    return result


class Attack(threading.Thread):
    """Sends datagrams at a rate until it is stopped."""

    def __init__(self, port: int, rate: float) -> None:
        super().__init__(daemon=True)
        self.target = ("127.0.0.1", port)
        self.period = 1.0 / rate
        self.sent = 0
        self._stop_now = threading.Event()

    def run(self) -> None:
        self.prepare()
        due = time.monotonic()
        while not self._stop_now.is_set():
            while due <= time.monotonic():
                self.attack()
                self.sent += 1
                due += self.period
            time.sleep(0.0005)

    def stop(self) -> None:
        self._stop_now.set()
        self.join()

    def prepare(self) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

    def attack(self) -> None:
        self.socket.sendto(b"", self.target)

    def __enter__(self) -> Attack:
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()


class ZeroLength(Attack):
    """Datagrams without anything in them: each ends a round of ENet's reading."""


class Garbage(Attack):
    def prepare(self) -> None:
        super().prepare()
        self.datagrams = garbage(500, 1)

    def attack(self) -> None:
        self.socket.sendto(self.datagrams[self.sent % 500], self.target)


class HalfOpen(Attack):
    """CONNECTs, each from another port: each holds one of ENet's places, and takes no answer."""

    def attack(self) -> None:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
            one.sendto(connect_datagram(1000 + self.sent, self.sent + 1), self.target)


class Forger(Attack):
    """Sends from ports that are not its own. Needs root."""

    def prepare(self) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_UDP)

    def forge(self, source: int, datagram: bytes) -> None:
        header = struct.pack(">HHHH", source, self.target[1], 8 + len(datagram), 0)
        self.socket.sendto(header + datagram, ("127.0.0.1", 0))


class PortZero(Forger):
    """CONNECTs from port 0: no answer can be sent there."""

    def attack(self) -> None:
        self.forge(0, connect_datagram(5000 + self.sent, self.sent + 1))


class Disconnects(Forger):
    """Ends the connections of clients whose ports it knows, as if they left."""

    def __init__(self, port: int, rate: float, victims: list[int]) -> None:
        super().__init__(port, rate)
        self.aims = list(itertools.product(victims, range(8), range(4)))

    def attack(self) -> None:
        port, peer, session = self.aims[self.sent % len(self.aims)]
        self.forge(port, struct.pack(">HBBHI", peer | session << 12, 0x44, 0xFF, 0, 1))


class FewChannels(Attack):
    """CONNECTs that ask for 1 or 2 channels: there would be none to send snapshots on."""

    def attack(self) -> None:
        whole = bytearray(connect_datagram(7000 + self.sent, self.sent + 1))
        struct.pack_into(">I", whole, 20, 1 + self.sent % 2)
        self.socket.sendto(whole, self.target)


def outer_port(pid: int, server: int) -> int:
    """The port from which a process speaks to a server."""
    folder = Path(f"/proc/{pid}/fd")
    own = {os.readlink(one) for one in folder.iterdir() if one.is_symlink()}
    for line in Path("/proc/net/udp").read_text(encoding="ascii").splitlines()[1:]:
        fields = line.split()
        if int(fields[2].split(":")[1], 16) == server and f"socket:[{fields[9]}]" in own:
            return int(fields[1].split(":")[1], 16)
    raise AssertionError(f"process {pid} speaks to nobody on port {server}")


def flood(*arguments: object) -> dict:
    """Runs the attacker that is written in C++ (gdextension/transport/tests/flood.cpp)."""
    command = [str(FLOOD), *(str(argument) for argument in arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def may_send_raw() -> bool:
    """Whether we may send from port 0."""
    try:
        socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_UDP).close()
    except PermissionError:
        return False
    return True
