# SPDX-License-Identifier: MIT
"""Stands between one client and a server and counts what passes."""

from __future__ import annotations

import selectors
import socket
import threading

# What IPv4 and UDP add to each datagram.
HEADERS = 28


class Relay(threading.Thread):
    """Passes datagrams on; clients send to its port."""

    def __init__(self, server_port: int) -> None:
        super().__init__(daemon=True)
        self.target = ("127.0.0.1", server_port)
        self.near = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.near.bind(("127.0.0.1", 0))
        self.far = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.far.bind(("127.0.0.1", 0))
        self.port = self.near.getsockname()[1]
        self.to_client = 0  # Bytes, with headers.
        self.to_server = 0
        self._client: tuple[str, int] | None = None
        self._stop_now = threading.Event()

    def run(self) -> None:
        with selectors.DefaultSelector() as waiting:
            for one in (self.near, self.far):
                one.setblocking(False)
                waiting.register(one, selectors.EVENT_READ)
            while not self._stop_now.is_set():
                for key, _ in waiting.select(0.1):
                    self._pass_on(key.fileobj)

    def _pass_on(self, source: socket.socket) -> None:
        try:
            data, sender = source.recvfrom(65536)
        except OSError:
            return
        if source is self.near:
            self._client = sender
            self.to_server += len(data) + HEADERS
            self.far.sendto(data, self.target)
        elif self._client is not None and sender == self.target:
            self.to_client += len(data) + HEADERS
            self.near.sendto(data, self._client)

    def __enter__(self) -> Relay:
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._stop_now.set()
        self.join()
        self.near.close()
        self.far.close()
