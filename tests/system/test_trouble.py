# SPDX-License-Identifier: MIT
"""What goes wrong for a single process: wrong options, missing files, servers not there."""

from __future__ import annotations

from toolchain.paths import SERVER_BINARY

from .conftest import World


def test_no_server(world: World) -> None:
    client = world.client("observer", "--connect-timeout=2")
    assert client.await_exit() == 4
    assert f"no server at 127.0.0.1:{world.port}" in client.log()


def test_a_wrong_version_is_refused(world: World) -> None:
    server = world.server()
    client = world.client("observer", "--protocol=999")
    assert client.await_exit() == 3
    assert "protocol version 999, the server 6" in client.log()
    server.await_text("protocol version 999")
    assert server.log().count("protocol version 999") == 1
    assert server.process.poll() is None


def test_the_port_is_in_use(world: World) -> None:
    world.server()
    second = world.server(name="second", wait=False)
    assert second.await_exit() == 1
    assert f"UDP port {world.port} is in use" in second.log()


def test_wrong_options(world: World) -> None:
    for options, words in {
        ("--port=abc",): "--port expects a whole number",
        ("--bvh=walk.bvh",): "--bvh is for trainee, load, not for server",
        ("--nonsense=1",): "no option --nonsense",
        ("--max-client=3",): "did you mean --max-clients?",
        ("--world=hal",): "did you mean hall?",
        ("--role=king",): "--role is one of server, observer",
        ("--port=70000",): "--port is 1 to 65535",
    }.items():
        process = world.server(*options, name="wrong", wait=False)
        assert process.await_exit() == 2, process.log()
        assert words in process.log()


def test_options_come_from_the_environment_too(world: World) -> None:
    process = world.start(
        "environment",
        [str(SERVER_BINARY), "--headless", "--", "--duration=1"],
        {"DISMOUNT_PORT": str(world.port)},
    )
    assert process.await_exit() == 0
    assert f"listening on UDP port {world.port}" in process.log()


def test_a_trainee_without_motion(world: World) -> None:
    missing = world.client("trainee", f"--bvh={world.folder / 'missing.bvh'}", name="missing")
    assert missing.await_exit() == 2
    assert "missing.bvh" in missing.log()
    none = world.client("trainee", name="none")
    assert none.await_exit() == 2
    assert "--bvh=FILE" in none.log()


def test_a_broken_recording(world: World) -> None:
    file = world.folder / "broken"
    file.write_bytes(b"this is no recording at all")
    replay = world.client("replay", f"--file={file}")
    assert replay.await_exit() == 1
    assert "expected a recording" in replay.log()
    file.write_bytes(b"")
    empty = world.client("replay", f"--file={file}", name="empty")
    assert empty.await_exit() == 1
    assert "the recording is empty" in empty.log()
    nothing = world.client("replay", name="nothing")
    assert nothing.await_exit() == 1
    assert "which recording? --file=FILE" in nothing.log()
