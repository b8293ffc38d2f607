# SPDX-License-Identifier: MIT
"""A client of our own, made from docs/protocol.md alone: it can say what no client of ours does."""

from __future__ import annotations

import hmac
import os
import selectors
import socket
import struct
import time
from collections import defaultdict
from collections.abc import Callable, Iterable
from contextlib import suppress

from .own_seal import VERSION, Seal

OBSERVER, TRAINEE, INSTRUCTOR = 0, 1, 2

_ACK, _CONNECT, _VERIFY, _DISCONNECT, _PING = 1, 2, 3, 4, 5
_RELIABLE, _UNRELIABLE, _FRAGMENT, _UNSEQUENCED = 6, 7, 8, 9
# Bytes of each kind of ENet's commands, without what it carries.
_SIZES = [0, 8, 48, 44, 8, 4, 6, 8, 24, 8, 12, 16, 24]
_WANTS_ACK = 0x80
# First bytes of what goes beside ENet: a part of something, the server's probe and its answer.
_PART, _PROBE, _PROBED = 0x60, 0x62, 0x63
_OPEN_FAST = b"\x4a"
_RESENT_S = 0.25
_PING_S = 0.5
_LEAVES = 5


class OwnClient:
    """One connection. Its state is told by the members; `Crowd` lets many go on."""

    def __init__(
        self,
        port: int,
        role: int = OBSERVER,
        *,
        sealed: bool = True,
        password: str = "",
        name: str = "own",
        address: str = "127.0.0.1",
        channels: int = 7,
        joins: bool = True,
    ) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
        self.socket.bind((address, 0))
        self.socket.connect(("127.0.0.1", port))
        self.socket.setblocking(False)
        self.seal = Seal(role, password) if sealed else None
        self.role, self.name, self.channels, self.joins = role, name, channels, joins
        self.id = int.from_bytes(os.urandom(4), "big") & 0x7FFFFFFF | 2
        self.peer: int | None = None
        self.header = 0xFFF
        self.token = b""
        self.is_joined = self.is_refused = self.is_gone = False
        self.position = 0  # Among those who wait, from 1.
        self.waits_for = 0
        self.numbers: dict[int, int] = defaultdict(int)  # Of reliable commands, by channel.
        self.groups = 0
        self.unacknowledged: dict[tuple[int, int], tuple[float, bytes]] = {}
        self.snapshots = self.datagrams = 0
        self.packets: list[bytes] = []  # Reliable ones, without those of the handshake.
        self.keeps_packets = False
        self._come: dict[int, int] = defaultdict(int)
        self._early: dict[int, dict[int, bytes]] = defaultdict(dict)
        self._parts: dict[int, dict[int, bytes]] = defaultdict(dict)
        self._asked = self._pinged = 0.0
        self._challenge = b"DSMT sealed" if sealed else b""
        self._cookie: bytes | None = None

    # What leaves.

    def write(self, datagram: bytes) -> None:
        """A datagram for ENet, as it is."""
        with suppress(OSError):  # Lost, as on a network.
            self.socket.send(self.seal.seal(datagram) if self.seal else datagram)

    def write_commands(self, *commands: bytes) -> None:
        self.write(struct.pack(">HH", self.header | 0x8000, 0) + b"".join(commands))

    def reliable(self, channel: int, payload: bytes) -> bytes:
        self.numbers[channel] = number = self.numbers[channel] + 1 & 0xFFFF
        return reliable_command(channel, number, payload)

    def send(self, payload: bytes, channel: int = 0) -> None:
        """A reliable packet; a long one in fragments."""
        sent = [self.reliable(channel, payload)] if len(payload) < 1200 else []
        if not sent:
            parts = [payload[at : at + 1000] for at in range(0, len(payload), 1000)]
            first = self.numbers[channel] + 1 & 0xFFFF
            for index, part in enumerate(parts):
                self.numbers[channel] = self.numbers[channel] + 1 & 0xFFFF
                sent.append(
                    fragment_command(channel, first, index, len(parts), len(payload), 1000, part)
                )
        for command in sent:
            number = struct.unpack_from(">H", command, 2)[0]
            self.unacknowledged[channel, number] = (time.monotonic(), command)
            self.write_commands(command)

    def send_fast(self, payload: bytes) -> None:
        """A message beside ENet."""
        with suppress(OSError):
            self.socket.send(self.seal.seal_fast(payload) if self.seal else _OPEN_FAST + payload)

    def send_unsequenced(self, payload: bytes, channel: int) -> None:
        self.groups = self.groups + 1 & 0xFFFF
        head = struct.pack(">BBHHH", 0x40 | _UNSEQUENCED, channel, 0, self.groups, len(payload))
        self.write_commands(head + payload)

    def leave(self) -> None:
        self.send(b"\x03\x12" + self.token)

    def disconnect(self) -> None:
        """Ends ENet's connection: whoever has not joined has no other way to leave."""
        if self.peer is not None and not self.is_gone:
            self.write_commands(struct.pack(">BBHI", 0x40 | _DISCONNECT, 0xFF, 0, 0))

    def close(self) -> None:
        self.socket.close()

    # What comes.

    def go_on(self) -> None:
        """Reads what has come, and says again what is unanswered."""
        for _ in range(256):
            try:
                datagram = self.socket.recv(8192)
            except (BlockingIOError, ConnectionError):
                break
            self._take(datagram)
        now = time.monotonic()
        if self.is_gone:
            return
        if self.peer is None:
            if now - self._asked > _RESENT_S:
                self._asked = now
                self._ask()
            return
        if now - self._pinged > _PING_S:
            self._pinged = now
            self.numbers[0xFF] = self.numbers[0xFF] + 1 & 0xFFFF
            self.write_commands(struct.pack(">BBH", _WANTS_ACK | _PING, 0xFF, self.numbers[0xFF]))
        for key, (sent, command) in list(self.unacknowledged.items()):
            if now - sent > _RESENT_S:
                self.unacknowledged[key] = (now, command)
                self.write_commands(command)

    def _ask(self) -> None:
        if self.seal is None or self.seal.reply is not None:
            self.write(self._connect())
        elif self._cookie is None:
            self.socket.send(self.seal.init())
        else:
            self.socket.send(self._start)

    def _connect(self) -> bytes:
        head = struct.pack(">HHBBH", 0x8FFF, 0, _WANTS_ACK | _CONNECT, 0xFF, 1)
        connect = self.id ^ 0x12345678
        return head + struct.pack(
            ">HBB9II",
            *(0, 0xFF, 0xFF, 1392, 65536, self.channels, 0, 0, 5000, 2, 2, connect, self.id),
        )

    def _take(self, datagram: bytes) -> None:
        self.datagrams += 1
        if self.seal is None:
            if datagram[:1] == _OPEN_FAST:
                self._take_fast(datagram[1:], len(datagram))
            else:
                self._take_enet(datagram)
            return
        kind = datagram[0]
        if kind == 0x42 and self._cookie is None:
            self._cookie = datagram[9:25]
            self._start = self.seal.start(self._cookie)
            self.socket.send(self._start)
        elif kind == 0x44 and self.seal.reply is None and self._cookie is not None:
            self.seal.take_reply(datagram[9:])
            self.numbers[0xFF] = 1
            self.write(self._connect())
        elif kind == 0x45 and self.peer is None:
            self.is_refused = datagram[9] != 2
        elif (opened := self.seal.open(datagram)) is not None:
            is_fast, plain = opened
            if is_fast:
                self._take_fast(plain, len(datagram))
            elif plain:
                self._take_enet(plain)

    def _take_fast(self, message: bytes, size: int) -> None:
        if not message:
            return
        if message[0] in (0, 2, 10):
            self.snapshots += 1
        elif message[0] == _PROBE:
            self.send_fast(bytes([_PROBED]) + struct.pack("<H", size))
        elif message[0] == _PART:
            number, kind = struct.unpack_from("<HB", message, 1)
            parts = self._parts[number]
            parts[kind & 7] = message[4:]
            if len(parts) == kind >> 3 & 7:
                whole = b"".join(parts[index] for index in sorted(parts))
                del self._parts[number]
                if kind & 0x40:
                    self._take_fast(whole, len(whole))
                else:
                    self._take_enet(whole)

    def _take_enet(self, datagram: bytes) -> None:
        sent = 0
        at = 2
        if datagram[0] & 0x80:
            sent = struct.unpack_from(">H", datagram, 2)[0]
            at = 4
        answers = []
        while at + 4 <= len(datagram):
            kind, channel, number = struct.unpack_from(">BBH", datagram, at)
            size = _SIZES[kind & 15]
            carried = b""
            if kind & 15 in (_RELIABLE, _UNRELIABLE, _FRAGMENT, _UNSEQUENCED):
                place = at + (4 if kind & 15 == _RELIABLE else 6)
                length = struct.unpack_from(">H", datagram, place)[0]
                carried = datagram[at + size : at + size + length]
            command = datagram[at : at + size]
            at += size + len(carried)
            if kind & _WANTS_ACK:
                answers.append(struct.pack(">BBHHH", _ACK, channel, number, number, sent))
            if kind & 15 == _VERIFY and self.peer is None:
                self.peer, _inner, outer = struct.unpack_from(">HBB", command, 4)
                self.header = self.peer | (outer & 3) << 12
                self.numbers[0xFF] = 1
        if answers:
            self.write_commands(*answers)
        self._take_commands(datagram)

    def _take_commands(self, datagram: bytes) -> None:
        at = 4 if datagram[0] & 0x80 else 2
        while at + 4 <= len(datagram):
            kind, channel, number = struct.unpack_from(">BBH", datagram, at)
            size = _SIZES[kind & 15]
            body = datagram[at + 4 : at + size]
            at += size
            if kind & 15 == _VERIFY:
                self._on_connected()
            elif kind & 15 == _ACK:
                self.unacknowledged.pop((channel, struct.unpack_from(">H", body)[0]), None)
            elif kind & 15 == _DISCONNECT:
                self.is_gone = True
            elif kind & 15 == _RELIABLE:
                length = struct.unpack(">H", body)[0]
                self._take_reliable(channel, number, datagram[at : at + length])
                at += length
            elif kind & 15 in (_UNRELIABLE, _UNSEQUENCED):
                at += struct.unpack_from(">H", body, 2)[0]
            elif kind & 15 == _FRAGMENT:
                # Nothing of ours is so large; it only has to be counted.
                length = struct.unpack_from(">H", body, 2)[0]
                self._take_reliable(channel, number, b"")
                at += length

    def _take_reliable(self, channel: int, number: int, payload: bytes) -> None:
        if (number - self._come[channel] - 1) & 0xFFFF >= 0x8000:
            return
        self._early[channel][number] = payload
        while (following := self._come[channel] + 1 & 0xFFFF) in self._early[channel]:
            self._come[channel] = following
            whole = self._early[channel].pop(following)
            if channel == 0:
                self._take_packet(whole)

    def _on_connected(self) -> None:
        if self.joins and self.seal is not None and not self.token:
            self.send(b"\x07\x00" + self.join_request())

    def _take_packet(self, packet: bytes) -> None:
        if packet[:2] == b"\xff\x4d":
            self.send(b"\xff\x52" + packet[2:])
        elif packet[:2] == b"\x07\x00" and not self.is_joined:
            self._take_reply(packet[2:])
        elif self.keeps_packets:
            self.packets.append(packet)

    def _take_reply(self, said: bytes) -> None:
        if not said:
            self.send(b"\x07\x00")
            self.is_joined = True
        elif said[:4] == b"DSMT":
            self._challenge = said
            if self.joins:
                self.send(b"\x07\x00" + self.join_request())
        elif said[0] == 0:
            self.token = said[5:21]
        elif said[0] == 2:
            self.position, self.waits_for = struct.unpack_from("<HB", said, 1)
        elif said[0] in (1, 3):
            self.is_refused = True

    def join_request(self) -> bytes:
        name = self.name.encode()
        signed = b"DSMT" + struct.pack("<IBB", VERSION, self.role, 0) + os.urandom(32) + bytes(16)
        signed += struct.pack("<H", len(name)) + name
        key = self.seal.exporter if self.seal else bytes(32)
        text = b"DSMT client"
        for part in (self._challenge, signed):
            text += struct.pack("<I", len(part)) + part
        return signed + hmac.digest(key, text, "sha256")


def reliable_command(channel: int, number: int, payload: bytes) -> bytes:
    return struct.pack(">BBHH", _WANTS_ACK | _RELIABLE, channel, number, len(payload)) + payload


def unreliable_command(channel: int, behind: int, number: int, payload: bytes) -> bytes:
    """A packet that waits until the reliable one `behind` has come."""
    head = struct.pack(">BBHHH", _UNRELIABLE, channel, behind, number, len(payload))
    return head + payload


def fragment_command(
    channel: int, first: int, index: int, count: int, whole: int, part: int, payload: bytes
) -> bytes:
    """Fragment `index` of a packet of `whole` bytes that is cut into parts of `part` bytes."""
    numbers = (first + index & 0xFFFF, first, len(payload), count, index, whole, part * index)
    return struct.pack(">BBHHHIIII", _WANTS_ACK | _FRAGMENT, channel, *numbers) + payload


class Crowd:
    """Own clients that go on together, in the caller's thread."""

    def __init__(self) -> None:
        self.clients: list[OwnClient] = []
        self._waiting = selectors.DefaultSelector()

    def add(self, *clients: OwnClient) -> None:
        for client in clients:
            self.clients.append(client)
            self._waiting.register(client.socket, selectors.EVENT_READ)

    def go_on(self) -> None:
        self._waiting.select(0.005)
        for client in self.clients:
            client.go_on()

    def go_on_until(self, holds: Callable[[], bool], limit_s: float = 60.0) -> None:
        end = time.monotonic() + limit_s
        while not holds():
            assert time.monotonic() < end, f"not in {limit_s} s"
            self.go_on()

    def go_on_for(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.go_on()

    def join(self, clients: Iterable[OwnClient]) -> None:
        joining = list(clients)
        self.add(*joining)
        self.go_on_until(lambda: all(client.is_joined for client in joining))

    def close(self) -> None:
        """All leave, as far as the server still listens."""
        here = [client for client in self.clients if client.is_joined and not client.is_gone]
        # Again, as a server drops what comes from somebody who has sent too much.
        for _try in range(_LEAVES):
            for client in here:
                client.leave()
            with suppress(AssertionError):
                self.go_on_until(lambda: all(client.is_gone for client in here), 1.0)
                break
        self._waiting.close()
        for client in self.clients:
            client.disconnect()
            client.close()

    def __enter__(self) -> Crowd:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
