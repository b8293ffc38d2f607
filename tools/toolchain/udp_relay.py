# SPDX-License-Identifier: MIT
"""A network of one's own between one client and a server: counts what passes, and spoils it."""

from __future__ import annotations

import heapq
import itertools
import random
import selectors
import socket
import threading
import time

# What IPv4 and UDP add to each datagram.
HEADERS = 28


class Relay(threading.Thread):
    """Passes datagrams on; a client sends to its port. What it does may change at any time."""

    def __init__(self, server_port: int, seed: int = 1) -> None:
        super().__init__(daemon=True)
        self.target = ("127.0.0.1", server_port)
        self.near = _socket()
        self.far = _socket()
        self.port = self.near.getsockname()[1]
        self.to_client = 0  # Bytes, with headers.
        self.to_server = 0
        self.datagrams_to_client = 0
        self.datagrams_to_server = 0
        # Of those to the client, the ones that belong to an open connection.
        self.sealed_to_client = 0
        # Bytes of the largest packet that passes, with headers; others are lost without a word.
        self.mtu = 65535
        # Of all datagrams, the part that is lost.
        self.loss = 0.0
        # How long each takes, and how much longer some of them: those are overtaken. Seconds.
        self.delay_s = 0.0
        self.jitter_s = 0.0
        # Whether nothing passes.
        self.is_cut = False
        self._random = random.Random(seed)
        self._client: tuple[str, int] | None = None
        self._late: list[tuple[float, int, bool, bytes]] = []
        self._count = itertools.count()
        self._moves = threading.Event()
        self._stop_now = threading.Event()

    def move(self) -> None:
        """The server sees the client at another address now, as after a change of network."""
        self._moves.set()

    def run(self) -> None:
        """Passes on until it is left."""
        with selectors.DefaultSelector() as waiting:
            for one in (self.near, self.far):
                waiting.register(one, selectors.EVENT_READ)
            while not self._stop_now.is_set():
                if self._moves.is_set():
                    self._moves.clear()
                    waiting.unregister(self.far)
                    self.far.close()
                    self.far = _socket()
                    waiting.register(self.far, selectors.EVENT_READ)
                due_s = self._late[0][0] - time.monotonic() if self._late else 0.1
                for key, _ in waiting.select(min(max(due_s, 0.0), 0.1)):
                    self._read(key.fileobj is self.near)
                while self._late and self._late[0][0] <= time.monotonic():
                    _, _, is_up, data = heapq.heappop(self._late)
                    self._pass_on(is_up, data)

    def _read(self, is_up: bool) -> None:
        try:
            data, sender = (self.near if is_up else self.far).recvfrom(65536)
        except OSError:
            return
        if is_up:
            self._client = sender
        elif self._client is None or sender != self.target:
            return
        is_lost = self.is_cut or len(data) + HEADERS > self.mtu
        if is_lost or self._random.random() < self.loss:
            return
        delay_s = self.delay_s + self._random.random() * self.jitter_s
        if delay_s > 0.0:
            late = (time.monotonic() + delay_s, next(self._count), is_up, data)
            heapq.heappush(self._late, late)
        else:
            self._pass_on(is_up, data)

    def _pass_on(self, is_up: bool, data: bytes) -> None:
        try:
            if is_up:
                self.far.sendto(data, self.target)
                self.to_server += len(data) + HEADERS
                self.datagrams_to_server += 1
            elif self._client is not None:
                self.near.sendto(data, self._client)
                self.to_client += len(data) + HEADERS
                self.datagrams_to_client += 1
                self.sealed_to_client += data[0] >= 0x80
        except OSError:
            return  # Lost, as on a network.

    def __enter__(self) -> Relay:
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._stop_now.set()
        self.join()
        self.near.close()
        self.far.close()


def _socket() -> socket.socket:
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    made.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
    made.bind(("127.0.0.1", 0))
    made.setblocking(False)
    return made
