# SPDX-License-Identifier: MIT
"""The sealing of a client of our own, made from docs/protocol.md alone."""

from __future__ import annotations

import ctypes
import hashlib
import os
import struct

from toolchain.paths import SERVER_BINARY

VERSION = 9

_SODIUM = ctypes.CDLL(str(SERVER_BINARY.parent / "libsodium.so.23"))


def _with_length(part: bytes) -> bytes:
    left, length = len(part), b""
    while True:
        length += bytes([left & 127 | (128 if left > 127 else 0)])
        left >>= 7
        if left == 0:
            return length + part


class Seal:
    """The handshake, and what seals datagrams after it."""

    def __init__(self, role: int, password: str = "") -> None:
        self.role = role
        self.password = password.encode()
        self.client = os.urandom(8)
        self.numbers = 0
        self.newest = -1
        self.reply: bytes | None = None

    def init(self) -> bytes:
        head = b"\x41DSMT" + struct.pack("<IB", VERSION, self.role) + self.client
        return head.ljust(64, b"\0")

    def start(self, cookie: bytes) -> bytes:
        self.sid = self.client + cookie
        parts = [b"CPaceRistretto255", self.password]
        used = 1 + sum(len(_with_length(part)) for part in reversed(parts))
        channel = b"\x0fDismount client\x0fDismount server"
        parts += [bytes(max(128 - used, 0)), channel, self.sid]
        generator = ctypes.create_string_buffer(32)
        text = hashlib.sha512(b"".join(map(_with_length, parts))).digest()
        _SODIUM.crypto_core_ristretto255_from_hash(generator, text)
        self.scalar = ctypes.create_string_buffer(32)
        _SODIUM.crypto_core_ristretto255_scalar_random(self.scalar)
        self.share = self._times(generator.raw)
        self.associated = struct.pack("<IB16x", VERSION, self.role)
        return b"\x43" + self.client + cookie + self.associated + self.share

    def take_reply(self, share: bytes) -> None:
        parts = [b"CPaceRistretto255_ISK", self.sid, self._times(share)]
        parts += [self.share, self.associated, share, b""]
        key = hashlib.sha512(b"".join(map(_with_length, parts))).digest()

        def derive(label: bytes) -> bytes:
            return hashlib.blake2b(label, key=key, digest_size=32).digest()

        self.to_server = derive(b"dismount client to server")
        self.to_client = derive(b"dismount server to client")
        self.exporter = derive(b"dismount exporter")
        self.reply = share

    def seal(self, plain: bytes) -> bytes:
        """A datagram for ENet, with the client's number before it."""
        number = struct.pack("<I", self.numbers & 0xFFFFFF)[:3]
        return self._encrypt(b"\x46" + self.client + number, plain)

    def seal_fast(self, plain: bytes) -> bytes:
        """A message beside ENet."""
        return self._encrypt(struct.pack(">H", 0xC000 | self.numbers & 0x3FFF), plain)

    def _encrypt(self, head: bytes, plain: bytes) -> bytes:
        nonce = struct.pack("<4xQ", self.numbers)
        self.numbers += 1
        made = ctypes.create_string_buffer(len(plain) + 16)
        _SODIUM.crypto_aead_chacha20poly1305_ietf_encrypt(
            made,
            None,
            plain,
            ctypes.c_ulonglong(len(plain)),
            head,
            ctypes.c_ulonglong(len(head)),
            None,
            nonce,
            self.to_server,
        )
        return head + made.raw

    def open(self, sealed: bytes) -> tuple[bool, bytes] | None:
        """Whether it goes beside ENet, and what is in it."""
        if len(sealed) < 18 or sealed[0] < 0x80 or self.reply is None:
            return None
        low = struct.unpack_from(">H", sealed)[0] & 0x3FFF
        number = self.newest + 1
        number += (low - number + 0x2000) % 0x4000 - 0x2000
        plain = ctypes.create_string_buffer(len(sealed) - 18)
        failed = number < 0 or _SODIUM.crypto_aead_chacha20poly1305_ietf_decrypt(
            plain,
            None,
            None,
            sealed[2:],
            ctypes.c_ulonglong(len(sealed) - 2),
            sealed[:2],
            ctypes.c_ulonglong(2),
            struct.pack("<4xQ", max(number, 0)),
            self.to_client,
        )
        if failed:
            return None
        self.newest = max(self.newest, number)
        return bool(sealed[0] & 0x40), plain.raw

    def _times(self, point: bytes) -> bytes:
        made = ctypes.create_string_buffer(32)
        assert _SODIUM.crypto_scalarmult_ristretto255(made, self.scalar, point) == 0
        return made.raw
