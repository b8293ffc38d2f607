# SPDX-License-Identifier: MIT
"""A server without a password is known again by its key, and another one is not joined."""

from __future__ import annotations

from pathlib import Path

from .conftest import Process, World
from .pictures import Window

REFUSED = 3
WRONG_OPTIONS = 2


def fingerprint(server: Process) -> str:
    """The server's key, as staff read it out of its log."""
    return server.await_line("the server's key is").split()[-1]


def known_servers(world: World) -> Path:
    (file,) = (world.folder / "DATA").rglob("known_servers")
    return file


def join(world: World, *options: str) -> str:
    """Lets a client join and leave; returns what it has said."""
    client = world.client("observer", *options)
    client.await_line("client: joined")
    assert client.end() == 0, client.log()
    return client.log()


def test_a_server_is_known_again_and_another_one_is_not_joined(world: World) -> None:
    server = world.server()
    first = fingerprint(server)
    assert server.report()["server_key"] == first
    said = join(world)
    assert f"first time at 127.0.0.1:{world.port}: its key {first} is remembered in" in said
    assert server.end() == 0

    # The same server again.
    server = world.server()
    assert fingerprint(server) == first
    assert "key" not in join(world).replace("only the server proves its key", "")
    assert server.end() == 0

    # Another one at the same place.
    remembered = known_servers(world).read_text(encoding="utf-8")
    server = world.server(f"--server-key={world.folder / 'other.key'}")
    other = fingerprint(server)
    assert other != first
    for role, options in (("observer", []), ("load", ["--trainees=0", "--observers=2"])):
        client = world.client(role, *options, name=f"{role}-refused")
        assert client.await_exit() == REFUSED, client.log()
        for part in (first, other, str(known_servers(world)), "--trust-new-key"):
            assert part in client.log()
    assert known_servers(world).read_text(encoding="utf-8") == remembered
    assert server.fresh_report()["sessions"] == []
    assert "joined" not in server.log()

    said = join(world, "--trust-new-key")
    assert f"the new key of 127.0.0.1:{world.port}, {other}, is remembered" in said
    assert "key" not in join(world).replace("only the server proves its key", "")
    assert server.end() == 0


def test_a_client_that_comes_back_joins_the_same_server_only(world: World) -> None:
    server = world.server()
    first = fingerprint(server)
    client = world.client("observer")
    client.await_line("client: joined")
    server.kill()
    # Its session's token, which it has still, is not for this one.
    other = world.server(f"--server-key={world.folder / 'other.key'}")
    assert client.await_exit() == REFUSED, client.log()
    told = other.fresh_report()
    assert told["sessions"] == [] and told["refused"] == {}
    assert first in client.log() and fingerprint(other) in client.log()
    assert "joined" not in other.log()


def test_staff_hand_out_the_fingerprint(world: World) -> None:
    server = world.server()
    join(world, f"--server-fingerprint={fingerprint(server)}")
    wrong = "SHA256:" + "A" * 43
    client = world.client("observer", f"--server-fingerprint={wrong}", name="wrong")
    assert client.await_exit() == REFUSED, client.log()
    assert wrong in client.log() and fingerprint(server) in client.log()
    client = world.client("observer", "--server-fingerprint=SHA256:12", name="unreadable")
    assert client.await_exit() == WRONG_OPTIONS, client.log()


def test_a_damaged_key_is_an_error_and_stays(world: World) -> None:
    file = world.folder / "server.key"
    file.write_text("nonsense\n", encoding="utf-8")
    server = world.server(f"--server-key={file}", wait=False)
    assert server.await_exit() == WRONG_OPTIONS, server.log()
    assert f"the server's key {file} is damaged" in server.log()
    assert file.read_text(encoding="utf-8") == "nonsense\n"


def test_somebody_at_a_window_is_asked(world: World, display: dict[str, str]) -> None:
    server = world.server()
    join(world)
    assert server.end() == 0
    server = world.server(f"--server-key={world.folder / 'other.key'}")
    window = Window(world, display, "--quality=low", size=(1280, 720), name="asked")
    window.process.await_line("shows another key than the last time")
    assert "joined" not in server.log()
    # To leave is what Return does by itself.
    window.press_at_once("Right", "Return")
    server.await_line("observer 'observer' (", "joined")
    window.process.await_line("the new key of", fingerprint(server))
    window.close()
    assert "ERROR" not in window.process.log()
