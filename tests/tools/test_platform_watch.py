# SPDX-License-Identifier: MIT
"""What ./run platform-watch reads out of datagrams."""

from __future__ import annotations

import struct
import zlib

import pytest
from toolchain.platform_watch import CUE, Cue, OutSim, Watch, decode, describe

# Written down by hand from docs/motion-platform.md: sequence 7, tick 60, 1.5 s, stale, half way.
HEAD = bytes.fromhex("44534d43 0100 0400 07000000 3c000000 60e3160000000000".replace(" ", ""))
BODY = struct.pack("<17f", 0, 0, 0, 1, 0, 9.81, 0, 0, 0, 0.5, 0.01, 0, 0, 0, 0, 0.25, 0.5)


def datagram(head: bytes = HEAD) -> bytes:
    whole = head + BODY + bytes(4)
    return whole + struct.pack("<I", zlib.crc32(whole))


def test_our_datagram() -> None:
    data = datagram()
    assert len(data) == 100 == CUE.size
    found = decode(data)
    assert isinstance(found, Cue)
    assert (found.sequence, found.tick, found.time_s) == (7, 60, 1.5)
    assert found.flags == ["stale"]
    assert found.orientation == (0, 0, 0, 1)
    assert found.specific_force[1] == pytest.approx(9.81)
    assert found.rates == (0, 0, 0.5)
    assert found.position[0] == pytest.approx(0.01)
    assert found.attitude == (0, 0, 0.25)
    assert found.gain == 0.5
    assert "10.0" in describe(found)


def test_outsim() -> None:
    body = struct.pack(
        "<I12f3i", 2500, 1, 2, 3, 0.5, 0.25, 0.125, 4, 5, 6, 7, 8, 9, 65536, -32768, 0
    )
    found = decode(body)
    assert isinstance(found, OutSim)
    assert found.time_s == 2.5
    assert (found.heading, found.pitch, found.roll) == (0.5, 0.25, 0.125)
    assert found.rates == (1, 2, 3)
    assert found.acceleration == (4, 5, 6)
    assert found.velocity == (7, 8, 9)
    assert found.position == (1.0, -0.5, 0.0)
    assert found.id is None
    assert decode(body + struct.pack("<i", 12)).id == 12


@pytest.mark.parametrize(
    "data", [b"", datagram()[:-1], b"X" * 100, datagram()[:50] + b"\x01" + datagram()[51:]]
)
def test_what_is_broken_is_counted(data: bytes) -> None:
    watch = Watch()
    assert watch.take(data) is None
    assert (watch.count, watch.broken) == (0, 1)


def test_lost_datagrams_are_counted() -> None:
    watch = Watch()
    for sequence in (7, 8, 12):
        watch.take(datagram(HEAD[:8] + struct.pack("<I", sequence) + HEAD[12:]))
    assert (watch.count, watch.lost) == (3, 3)
    assert "3 lost" in watch.summary()
