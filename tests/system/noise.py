# SPDX-License-Identifier: MIT
"""Packets that make no sense, or nearly some: altered ones of docs/protocol-bytes.md, the engine's,
and messages whose parts are chosen by chance."""

from __future__ import annotations

import random
import re
import struct
from pathlib import Path

PAGE = Path(__file__).parents[2] / "docs" / "protocol-bytes.md"
ORDER, LEVEL = 14, 6
# Orders that would end the attack: kick and ban.
_ENDING = (3, 4)

# What readers of bytes stumble over: not finite, very large, broken or invisible text.
_STRANGE = [
    *(struct.pack("<f", number) for number in (float("nan"), float("inf"), -3e38, 1e-40)),
    *(struct.pack("<d", number) for number in (float("nan"), float("-inf"), 1e308)),
    *(b"\xff" * size for size in (1, 2, 4, 8)),
    *(b"\0" * size for size in (1, 4)),
    *(b"\xc0\x80", b"\xed\xa0\x80", b"\xf8\x88\x80\x80", b"\xe2\x80\xae", b"\xf0\x9f"),
]
_SIZES = [0, 1, 2, 5, 6, 9, 33, 34, 38, 40, 100, 400, 1200]


def worked_messages() -> list[bytes]:
    """The messages of the page of worked bytes."""
    page = PAGE.read_text(encoding="utf-8")
    messages = []
    for block in re.findall(r"^```\n(.*?)^```", page, re.DOTALL | re.MULTILINE):
        digits = "".join(line.split("#")[0] for line in block.splitlines())
        messages.append(bytes.fromhex(digits))
    assert len(messages) > 15
    return messages


class Noise:
    """An endless source of it, the same for the same seed."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.messages = worked_messages()

    def packet(self) -> bytes:
        """For the multiplayer API's channels: with its envelope, or with another, or with none."""
        chance = self.random
        kind = chance.random()
        if kind < 0.5:
            return b"\x03" + self.message()
        if kind < 0.6:
            return b"\x07" + bytes([chance.randrange(6)]) + self._bytes()
        if kind < 0.65:
            return b"\x03"
        return bytes([chance.randrange(256)]) + self._bytes()

    def message(self) -> bytes:
        """For the fast path, or behind an envelope. Nobody is sent away."""
        chance = self.random
        while True:
            made = chance.choice([self._altered, self._call, self._command, self._order])()
            if made[:1] != bytes([ORDER]) or len(made) < 4 or made[3] not in _ENDING:
                return made

    def altered(self, message: bytes) -> bytes:
        chance = self.random
        made = bytearray(message)
        for _ in range(chance.choice([1, 1, 2, 3, 8])):
            at = chance.randrange(len(made) + 1)
            match chance.randrange(4):
                case 0 if at < len(made):
                    made[at] ^= 1 << chance.randrange(8)
                case 1:
                    del made[at:]
                case 2:
                    strange = chance.choice(_STRANGE)
                    made[at : at + len(strange)] = strange
                case _:
                    made[at:at] = chance.randbytes(chance.choice([1, 2, 200]))
        return bytes(made)

    def _bytes(self) -> bytes:
        return self.random.randbytes(self.random.choice(_SIZES))

    def _altered(self) -> bytes:
        return self.altered(self.random.choice(self.messages))

    def _text(self, *choices: str) -> bytes:
        text = self.random.choice(choices).encode()
        return struct.pack("<H", len(text)) + text

    def _call(self) -> bytes:
        chance = self.random
        count = chance.choice([0, 1, 2, 16, 17])
        head = b"\x13" + chance.randbytes(2) + self._text("Bell", ".", "..", "", "/root", "%Bell")
        head += self._text("ring", "_sound", "queue_free", "set_script", "_ready", "")
        return head + bytes([count]) + b"".join(self._value(0) for _ in range(count))

    def _value(self, depth: int) -> bytes:
        chance = self.random
        kind = chance.randrange(15)
        sizes = {1: 1, 2: 8, 3: 8, 6: 16, 7: 24, 8: 32, 9: 32, 10: 48}
        if kind in (4, 5):
            return bytes([kind]) + self._text("", "red", "x" * 900, "é")
        if kind in (12, 13) and depth < 6:
            values = [self._value(depth + 1) for _ in range(2 * (kind - 11))]
            return bytes([kind, 2]) + b"".join(values)
        return bytes([kind]) + chance.randbytes(sizes.get(kind, 0))

    def _command(self) -> bytes:
        chance = self.random
        made = b"\x0b" + chance.randbytes(2)
        count = chance.choice([0, 1, 1, 8, 9])
        made += bytes([count])
        for _ in range(count):
            values = chance.randbytes(chance.choice([0, 1, 2, 4, 128]))
            entity = chance.choice([0, 1, chance.randrange(1024, 1060), 65535])
            tick = chance.choice([0, 500, 2**32 - 1])
            made += struct.pack("<IHBB", tick, entity, chance.randrange(4), len(values)) + values
        return made

    def _order(self) -> bytes:
        chance = self.random
        target = chance.choice([0, 1, chance.randrange(40), 2**31 - 1, 2**32 - 1])
        numbers = (chance.randrange(65536), chance.randrange(8), target, *chance.randbytes(2))
        words = self._text("", "why", "hall", "..", "../yard", "icons", "res://x", "%s" * 60)
        return struct.pack("<BHBIBB", ORDER, *numbers) + words
