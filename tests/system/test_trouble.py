# SPDX-License-Identifier: MIT
"""What goes wrong: hostile datagrams, vanishing clients, servers that are not there."""

from __future__ import annotations

import random
import socket
import struct
import time

import pytest
from toolchain.paths import SERVER_BINARY

from .conftest import World


def _datagrams(count: int, seed: int) -> list[bytes]:
    """Garbage: empty, random, and beginning like ENet's connect command."""
    source = random.Random(seed)
    result = []
    for i in range(count):
        size = source.choice([0, 1, 4, 20, 52, 200, 1200, 1400])
        body = source.randbytes(size)
        if i % 4 == 3 and size >= 52:
            # peer id "none", command connect with acknowledgement, the rest by chance
            body = struct.pack(">HHBBH", 0x8FFF, 0, 0x82, 0xFF, 1) + body[8:]
        result.append(body)
    return result


def test_garbage_disturbs_nobody(world: World) -> None:
    server = world.server()
    trainee = world.trainee("--duration=10")
    trainee.await_text("joined")
    time.sleep(1)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as attacker:
        for datagram in _datagrams(1500, 1):
            attacker.sendto(datagram, ("127.0.0.1", world.port))
            time.sleep(0.002)
    assert trainee.await_exit() == 0, trainee.log()
    # 60 a second for about nine seconds, less what the garbage delayed.
    assert trainee.report()["snapshots"] > 350
    assert "lost" not in trainee.log()
    time.sleep(1.2)
    assert 58.0 < server.report()["ticks_per_second"] < 62.0
    assert len(server.log().splitlines()) < 60
    assert server.process.poll() is None


def test_a_datagram_from_port_zero(world: World) -> None:
    """It makes ENet close the server's port: the server has to open it again."""
    server = world.server()
    observer = world.client("observer")
    observer.await_text("joined")
    attack = struct.pack(">HHBBH", 0x8FFF, 1, 0x82, 0xFF, 1)
    attack += struct.pack(">HBB9II", 0, 0xFF, 0xFF, 1392, 65536, 2, 0, 0, 5000, 2, 2, 7, 77)
    try:
        attacker = socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_UDP)
    except PermissionError:
        pytest.skip("only root may send from port 0")
    with attacker:
        header = struct.pack(">HHHH", 0, world.port, 8 + len(attack), 0)
        for _ in range(5):
            attacker.sendto(header + attack, ("127.0.0.1", 0))
    server.await_text("it is open again", 10)
    end = time.monotonic() + 20
    while observer.log().count("joined") < 2:
        assert time.monotonic() < end, observer.log()
        time.sleep(0.1)


def test_a_vanished_client_is_noticed(world: World) -> None:
    server = world.server()
    victim = world.trainee("--name=Victim", name="victim")
    witness = world.client("observer")
    victim.await_text("joined")
    witness.await_text("joined")
    time.sleep(1)
    victim.kill()
    server.await_text("'Victim'", 1)
    end = time.monotonic() + 15
    while "left" not in server.log() and time.monotonic() < end:
        time.sleep(0.1)
    assert "left" in server.log()
    before = witness.report()["snapshots"]
    time.sleep(2.5)
    assert witness.report()["snapshots"] > before + 60
    assert witness.process.poll() is None


def test_a_client_finds_the_server_again(world: World) -> None:
    first = world.server(name="first")
    observer = world.client("observer")
    observer.await_text("joined")
    first.kill()
    observer.await_text("trying again", 20)
    world.server(name="second")
    end = time.monotonic() + 20
    while observer.log().count("joined") < 2:
        assert time.monotonic() < end, observer.log()
        time.sleep(0.1)


def test_no_server(world: World) -> None:
    client = world.client("observer", "--connect-timeout=2")
    assert client.await_exit(30) == 4
    assert f"no server at 127.0.0.1:{world.port}" in client.log()


def test_a_wrong_version_is_refused(world: World) -> None:
    server = world.server()
    client = world.client("observer", "--protocol=999")
    assert client.await_exit(20) == 3
    assert "protocol version 999" in client.log()
    assert server.log().count("protocol version 999") == 1
    assert server.process.poll() is None


def test_the_port_is_in_use(world: World) -> None:
    world.server()
    second = world.server(name="second", wait=False)
    assert second.await_exit(20) == 1
    assert f"UDP port {world.port} is in use" in second.log()


def test_wrong_options(world: World) -> None:
    for options, words in {
        ("--port=abc",): "--port expects a whole number",
        ("--nonsense=1",): "no option --nonsense",
        ("--role=king",): "no role 'king'",
        ("--port=70000",): "between 1 and 65535",
    }.items():
        process = world.server(*options, name="wrong", wait=False)
        assert process.await_exit(20) == 2, process.log()
        assert words in process.log()


def test_options_come_from_the_environment_too(world: World) -> None:
    process = world._start(
        "environment",
        [str(SERVER_BINARY), "--headless", "--", "--duration=1"],
        {"DISMOUNT_PORT": str(world.port)},
    )
    assert process.await_exit(20) == 0
    assert f"listening on UDP port {world.port}" in process.log()


def test_a_trainee_without_motion(world: World) -> None:
    missing = world.client("trainee", f"--bvh={world.folder / 'missing.bvh'}", name="missing")
    assert missing.await_exit(20) == 2
    assert "missing.bvh" in missing.log()
    none = world.client("trainee", name="none")
    assert none.await_exit(20) == 2
    assert "--bvh=FILE" in none.log()


def test_a_broken_recording(world: World) -> None:
    file = world.folder / "broken"
    file.write_bytes(b"this is no recording at all")
    replay = world.client("replay", f"--file={file}")
    assert replay.await_exit(20) == 1
    assert "expected a recording" in replay.log()
