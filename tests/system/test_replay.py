# SPDX-License-Identifier: MIT
"""Recordings of a server, and replays of those that somebody has forged to take a machine's
memory."""

from __future__ import annotations

import os
import struct
import time
from contextlib import suppress
from pathlib import Path

import pytest

from . import recordings
from .conftest import LOOK_S, World

MAGIC = b"DSMTREC4"
#: What a replay of the hall takes, and what its people and a level beside it may add, MiB.
LIMIT_MIB = 450


def _record(time_usec: int, message: bytes) -> bytes:
    return struct.pack("<IQ", len(message), time_usec) + message


def _text(text: str) -> bytes:
    return struct.pack("<H", len(text)) + text.encode()


def _level() -> bytes:
    return bytes([13]) + _text("hall") + bytes(8)


def _crowd() -> bytes:
    """A table in which all is new: a type with the body of a person, and 249 of them."""
    kind = _text("p") + bytes([2, 0, 0, 0, 0])
    row = struct.pack("<BIiB", 0, 0, 0, 0) + _text("") + bytes([0]) + _text("x") + bytes([0])
    rows = b"".join(struct.pack("<H", number) + row for number in range(1, 250))
    head = bytes([3, 1]) + struct.pack("<If", 1, 0.1) + bytes([1]) + kind
    return head + struct.pack("<HH", 0, 249) + rows


FORGED = {
    "levels": _record(0, _level()) * 200_000,
    "crowds": _record(0, _level()) + _record(0, _crowd()) * 20,
}


@pytest.mark.parametrize("name", FORGED)
def test_memory_is_bounded(world: World, name: str) -> None:
    file = world.folder / f"{name}.dismount"
    file.write_bytes(MAGIC + FORGED[name])
    replay = world.client("replay", f"--file={file}", "--duration=4")
    most_kib, end = 0, time.monotonic() + 240.0
    # All that is made at once is made in the first frame.
    while replay.process.poll() is None:
        with suppress(OSError):
            status = Path(f"/proc/{replay.process.pid}/status").read_text(encoding="ascii")
            peak = next((line for line in status.splitlines() if line.startswith("VmHWM")), "")
            most_kib = max([most_kib, *(int(word) for word in peak.split()[1:2])])
        assert most_kib < LIMIT_MIB * 1024, f"{most_kib >> 10} MiB"
        assert time.monotonic() < end, replay.log()
        time.sleep(LOOK_S)
    assert most_kib > 0
    assert replay.await_exit() == 0, replay.log()
    assert os.path.getsize(replay.log_file) < 100_000


def test_a_server_records_who_joins_all_at_once(world: World) -> None:
    # People come in the tick after their client: tables, which go out together, are later.
    file = world.folder / "server.dismount"
    world.server(f"--record={file}")
    world.client("load", "--trainees=0", "--observers=0", "--walkers=4", name="crowd")
    found = recordings.comes(
        file, lambda seen: sum(len(entries) > 2 for entries in seen["people"].values()) == 4
    )
    assert len(found["people"]) == 4
