# SPDX-License-Identifier: MIT
"""What goes wrong for a single process: a wrong option, missing files, a server that is not there.

Which options, files and motions are wrong, and what is said of each, is in the tests of the classes
that read them: a case of each kind stands here for the way to the user.
"""

from __future__ import annotations

import socket

import pytest
from toolchain.paths import SERVER_BINARY

from .conftest import World


def test_no_server(world: World) -> None:
    client = world.client("observer", "--connect-timeout=0.5")
    assert client.await_exit() == 4
    assert f"no server at 127.0.0.1:{world.port}" in client.log()


def test_the_port_is_in_use_and_options_come_from_the_environment(world: World) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as occupant:
        occupant.bind(("0.0.0.0", world.port))
        command = [str(SERVER_BINARY), "--headless", "--"]
        process = world.start("server", command, {"DISMOUNT_PORT": str(world.port)})
        assert process.await_exit() == 1
        assert f"UDP port {world.port} is in use" in process.log()


@pytest.mark.parametrize(
    ("option", "words"),
    [
        ("--max-client=3", "did you mean --max-clients?"),
        ("--role=king", "--role is one of start, server"),
    ],
)
def test_a_wrong_option(world: World, option: str, words: str) -> None:
    process = world.server(option, wait=False)
    assert process.await_exit() == 2, process.log()
    assert words in process.log()


@pytest.mark.parametrize(
    ("role", "option", "code", "words"),
    [
        ("trainee", "--bvh=nowhere.bvh", 2, "nowhere.bvh"),
        ("replay", f"--file={__file__}", 1, "expected a recording"),
        ("observer", "--latency-csv=/nowhere/latency.csv", 1, "/nowhere/latency.csv"),
        ("observer", "--drive=1:2", 2, "--drive is THROTTLE:STEERING:BRAKE:SECONDS"),
    ],
    ids=["motion", "recording", "latency", "drive"],
)
def test_a_file_that_is_of_no_use(
    world: World, role: str, option: str, code: int, words: str
) -> None:
    client = world.client(role, option)
    assert client.await_exit() == code
    assert words in client.log()
