# SPDX-License-Identifier: MIT
"""Recordings of an emulated suit's raw bytes, by a process that is killed while it records."""

from __future__ import annotations

import itertools
import json
import os
import signal
import struct
import subprocess
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from toolchain.processes import await_that
from toolchain.project import EXTENSIONS

EMULATOR = EXTENSIONS / "xbus" / "suit_emulator"
STREAM = EXTENSIONS / "xbus" / "suit_stream"
DECODE = EXTENSIONS / "xbus" / "xbus_decode"
BENCH = EXTENSIONS / "xbus" / "xbus_bench"
LIMIT_S = 120.0
ENOUGH_BYTES = 200_000

pytestmark = pytest.mark.skipif(not EMULATOR.exists(), reason="built without umockdev")


class Record(NamedTuple):
    kind: int
    stream: int
    time_usec: int
    payload: bytes


def read(data: bytes) -> Iterator[Record]:
    """The records of a file, read as docs/recordings.md tells, to the cut."""
    assert data[:8] == b"DMTRAW1\n"
    at = 8
    while len(data) - at >= 28:
        mark, size, kind, zero, stream, time_usec, payload_crc, head_crc = struct.unpack_from(
            "<IIBBHQII", data, at
        )
        assert (mark, zero) == (0x524D44A5, 0)
        assert zlib.crc32(data[at : at + 24]) == head_crc
        payload = data[at + 28 : at + 28 + size]
        if len(payload) < size:
            return
        assert zlib.crc32(payload) == payload_crc
        yield Record(kind, stream, time_usec, payload)
        at += 28 + size


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What a suit of 15 trackers said until the recording process was killed."""
    folder = tmp_path_factory.mktemp("recording")
    file = folder / "suit.raw"
    pid_file = folder / "pid"
    script = f'echo $$ > "{pid_file}"; exec "{STREAM}" --seconds=60 --record="{file}"'
    command = [str(EMULATOR), "--devices=ftdi", "--sensors=15", "--", "sh", "-c", script]
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL) as process:
        try:
            await_that(lambda: file.stat().st_size >= ENOUGH_BYTES, "a recording", LIMIT_S)
            os.kill(int(pid_file.read_text(encoding="ascii")), signal.SIGKILL)
            process.wait(LIMIT_S)
        finally:
            process.kill()
    return file


def test_a_killed_recording_holds_everything_up_to_the_kill(recording: Path) -> None:
    records = list(read(recording.read_bytes()))
    kinds = [record.kind for record in records]
    assert kinds[:2] == [0, 1]
    assert 6 not in kinds
    about = records[1].payload.decode()
    assert "kind=bus\n" in about
    assert "usb=0403:d38" in about
    assert sum(len(record.payload) for record in records if record.kind == 2) > ENOUGH_BYTES / 2
    assert {2, 3} <= set(kinds)
    times = [record.time_usec for record in records[1:]]
    assert times == sorted(times)


def test_a_recording_is_decoded_without_being_told_anything(recording: Path) -> None:
    done = subprocess.run([DECODE, recording, "--json"], capture_output=True, check=True)
    report = json.loads(done.stdout)
    frames = [m for m in report["messages"] if m["name"] == "MTData"]
    assert len(frames) > 100
    counters = [m["samples"][0]["counter"] for m in frames]
    # A busy machine may be late for a sample; none comes twice or in another order.
    steps = [(after - before) % 65536 for before, after in itertools.pairwise(counters)]
    assert all(0 < step < 1000 for step in steps), steps
    assert all(len(m["samples"]) == 15 for m in frames)


def test_bytes_that_came_are_measured_as_any_raw_file(recording: Path, tmp_path: Path) -> None:
    raw = tmp_path / "bus.bin"
    came = [record.payload for record in read(recording.read_bytes()) if record.kind == 2]
    raw.write_bytes(b"".join(came))
    stats = [
        subprocess.run([BENCH, ".", file], capture_output=True, check=True, text=True).stdout
        for file in (recording, raw)
    ]
    counts = [
        [line for line in text.splitlines() if '"bytes"' in line or '"messages"' in line]
        for text in stats
    ]
    assert counts[0]
    assert counts[0] == counts[1]
