# SPDX-License-Identifier: MIT
"""Sends messages to the client's port on this machine; needs only Python's own library."""

from __future__ import annotations

import json
import os
import socket
import time
from collections.abc import Callable
from typing import Any

# A datagram is no longer than this, bytes.
MOST_BYTES = 60000
STATUS_S = 0.5


class Sender:
    """Sends messages to a UDP port of this machine, or writes them as lines on standard output."""

    def __init__(self, port: int) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._port = port

    def send(self, message: dict[str, Any]) -> None:
        """Sends a message; without a port it is a line."""
        text = json.dumps(message, separators=(",", ":"))
        if self._port == 0:
            print(text)
        else:
            self.send_bytes(text.encode())

    def send_bytes(self, data: bytes) -> None:
        """Sends a datagram; without a port nobody wants it."""
        if self._port > 0 and len(data) <= MOST_BYTES:
            try:
                self._socket.sendto(data, ("127.0.0.1", self._port))
            except OSError:
                # The client is closing, or starting: its port is not open now.
                return

    def send_fault(self, text: str) -> None:
        """Says what is wrong, to be shown."""
        self.send({"status": {"faults": [text]}})


def is_alive(parent: int) -> bool:
    """Whether the client, whose process is our parent, still runs; 0 is nobody to end with."""
    return parent == 0 or os.getppid() == parent


def wait(seconds: float, parent: int) -> None:
    """Waits, or until the client ends."""
    end = time.monotonic() + seconds
    while time.monotonic() < end and is_alive(parent):
        time.sleep(0.1)


def say_until(fault: Callable[[], str], port: int, parent: int) -> bool:
    """Tells the client of a fault until it is gone: returns True; or the client is: False."""
    sender = Sender(port)
    while is_alive(parent):
        text = fault()
        if not text:
            return True
        sender.send_fault(text)
        wait(STATUS_S, parent)
    return False
