# SPDX-License-Identifier: MIT
"""`./run motion-sender --to=mvn`, heard by a socket and read by what docs/mvn.md tells alone."""

from __future__ import annotations

import collections
import socket
import struct
import threading
from typing import NamedTuple

from .test_commands import run


class Head(NamedTuple):
    type: int
    sample: int
    part: int
    is_last: bool
    items: int
    time_code_ms: int
    character: int
    segments: int
    payload: bytes


def read(datagram: bytes) -> Head:
    mark, sample, part, items, time_code, character, segments, _, _, _, size = struct.unpack_from(
        ">6sIBBIBBBBHH", datagram
    )
    assert mark[:4] == b"MXTP"
    assert size == len(datagram) - 24
    last = bool(part & 0x80)
    return Head(
        int(mark[4:]),
        sample,
        part & 0x7F,
        last,
        items,
        time_code,
        character,
        segments,
        datagram[24:],
    )


def send(*options: str) -> list[Head]:
    """What comes of the sender on a port of our own."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as here:
        here.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 8 << 20)
        here.bind(("127.0.0.1", 0))
        port = here.getsockname()[1]
        datagrams: list[bytes] = []
        # Meanwhile: a second of all types is more than a socket's buffer need hold.
        reader = threading.Thread(target=_receive, args=(here, datagrams), daemon=True)
        reader.start()
        done = run("motion-sender", "--to", f"mvn:{port}", "--bvh", "01_01.bvh", *options)
        here.sendto(b"", ("127.0.0.1", port))
        reader.join(60)
        assert done.returncode == 0, done.stderr
        return [read(datagram) for datagram in datagrams]


def _receive(here: socket.socket, datagrams: list[bytes]) -> None:
    """Until an empty one comes."""
    while datagram := here.recv(65536):
        datagrams.append(datagram)


def test_every_type_of_two_people_comes_at_its_rate() -> None:
    types = "01,02,03,05,12,13,20,21,22,23,24,25"
    heads = send("--types", types, "--people=2", "--seconds=1", "--rate=30")
    assert {head.character for head in heads} == {0, 1}
    samples: dict[tuple[int, int], set[int]] = collections.defaultdict(set)
    for head in heads:
        samples[head.type, head.character].add(head.sample)
    for kind in (1, 2, 3, 5, 20, 21, 22, 23, 24, 25):
        for character in (0, 1):
            assert samples[kind, character] == set(range(30))
    sizes = {1: 28, 2: 32, 3: 16, 5: 32, 20: 20, 21: 40, 22: 44, 23: 68}
    for head in heads:
        assert len(head.payload) <= 1376
        if head.type in sizes:
            assert len(head.payload) == head.items * sizes[head.type]
            assert head.segments == 23
    quaternions = [head for head in heads if head.type == 2]
    assert all(head.items == 23 and head.is_last and head.part == 0 for head in quaternions)
    identifiers = [struct.unpack_from(">i", quaternions[0].payload, 32 * i)[0] for i in range(23)]
    assert identifiers == list(range(1, 24))
    # The pelvis is at the height of hips: Z is up, in metres.
    assert 0.7 < struct.unpack_from(">f", quaternions[0].payload, 12)[0] < 1.2
    assert [head.time_code_ms for head in quaternions if head.character == 0][:3] == [0, 33, 67]
    names = {head.payload.split(b"name:")[1].split(b"\n")[0] for head in heads if head.type == 12}
    assert names == {b"Dismount 1", b"Dismount 2"}


def test_loss_is_what_was_asked_for() -> None:
    heads = send("--types=02", "--seconds=2", "--rate=200", "--loss=0.3")
    assert 200 < len(heads) < 360


def test_what_is_wrong_is_said_in_one_line() -> None:
    for options, text in (
        (["--bvh", "nothing.bvh"], "nothing.bvh"),
        (["--bvh=01_01.bvh", "--types=02,99"], "'99'"),
        (["--bvh=01_01.bvh", "--people=1.5"], "--people"),
        (["--bvh=01_01.bvh", "--wrong=1"], "--wrong"),
    ):
        done = run("motion-sender", "--to=mvn", *options)
        assert done.returncode == 2, (options, done.stderr)
        # ./run knows the options itself, and says so before anything is set up.
        begins = ("motion-sender: ", "./run motion-sender has no option ")
        lines = [line for line in done.stderr.splitlines() if line.startswith(begins)]
        assert len(lines) == 1, (options, done.stderr)
        assert text in lines[0]
