# SPDX-License-Identifier: MIT
"""People of MVN's network stream in a session: `./run motion-sender` in place of MVN."""

from __future__ import annotations

import random
import socket
import struct
from collections.abc import Iterator
from contextlib import contextmanager

from toolchain.help_texts import MOTION_SENDER
from toolchain.paths import CLIPS, ROOT
from toolchain.processes import free_port

from .conftest import Process, World, shared
from .recordings import recorded, turned
from .suits import await_people, engine

NAMES = {"Dismount 1", "Dismount 2", "Dismount 3"}


@contextmanager
def sender(world: World, port: int, *options: str) -> Iterator[None]:
    """Sends until its end."""
    godot = engine()
    script = ["--path", str(ROOT), "-s", MOTION_SENDER]
    own = [f"--bvh={CLIPS / '01_01.bvh'}", f"--to=mvn:{port}", *options]
    name = f"sender{len(world.processes)}"
    command = [str(godot.program), "--headless", "--no-header", *script, "--", *own]
    process = world.start(name, command, godot.environment(), reports=False)
    try:
        yield
    finally:
        process.kill()


def datagram(segments: int, items: int, payload: bytes, character: int = 0) -> bytes:
    """A datagram of type 02 that says of itself what it wants."""
    head = struct.pack(">6sIBB", b"MXTP02", 1, 0x80, items)
    return head + struct.pack(">IBBBBHH", 0, character, segments, 0, 0, 0, len(payload)) + payload


class Studio:
    """A server, and a trainee that hears MVN."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.server: Process = world.server()
        self.port = free_port()
        self.trainee: Process = world.client("trainee", f"--source=mvn:{self.port}")
        self.trainee.await_text("joined")


studio = shared(Studio)


def test_three_people_of_mvn_come_move_and_leave(studio: Studio) -> None:
    world, port, trainee = studio.world, studio.port, studio.trainee
    with sender(world, port, "--people=3"):
        await_people(trainee, NAMES)
        recording = world.folder / "three"
        observer = world.client("observer", f"--record={recording}")
        observer.await_report(lambda seen: seen["snapshots"] > 60 * 4)
        assert observer.end() == 0, observer.log()
    people = recorded(recording)
    assert set(people) == NAMES
    for entries in people.values():
        # Limbs turn, and the hips are where those of people are who jump, climb and fall.
        assert turned(entries) > 10.0
        assert all(0.0 < entry["hips"][1] < 2.5 for entry in entries)
    places = [entries[-1]["hips"] for entries in people.values()]
    assert len({round(x, 1) for x, _, _ in places} | {round(z, 1) for _, _, z in places}) > 2
    await_people(trainee, set())
    recording = world.folder / "nobody"
    late = world.client("observer", f"--record={recording}", name="late")
    late.await_report(lambda seen: seen["snapshots"] > 30)
    assert late.end() == 0, late.log()
    assert recorded(recording) == {}
    assert trainee.process.poll() is None
    # Whoever comes back is there again.
    with sender(world, port, "--name=Ada"):
        await_people(trainee, {"Ada"})
    await_people(trainee, set())


def test_one_port_has_one_receiver(studio: Studio) -> None:
    port = studio.port
    second = studio.world.client("trainee", f"--source=mvn:{port}", name="second")
    assert second.await_exit() == 2
    said = [line for line in second.log().splitlines() if f"{port} is in use" in line]
    assert len(said) == 1
    assert "--source=mvn" in said[0]


def test_rubbish_is_counted_and_told(studio: Studio) -> None:
    port, trainee = studio.port, studio.trainee
    dice = random.Random(5)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as rude:
        rude.connect(("127.0.0.1", port))
        rude.send(datagram(255, 255, dice.randbytes(255 * 32)))
        good = datagram(23, 23, dice.randbytes(23 * 32))
        for size in (0, 5, 23, 24, 100, len(good) - 1):
            rude.send(good[:size])
        for _ in range(300):
            rude.send(dice.randbytes(dice.randrange(1, 1400)))
    for why in ("more segments than", "shorter than", "its size does not fit", "not of MVN's form"):
        trainee.await_text(f"sent a datagram that was dropped: {why}")
    assert sum(1 for line in trainee.log().splitlines() if "WARN" in line) < 30
    with sender(studio.world, port):
        await_people(trainee, {"Dismount"})
