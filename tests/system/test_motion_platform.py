# SPDX-License-Identifier: MIT
"""What a motion platform is sent by a client whose session sits in a seat; 127.0.0.1 only."""

from __future__ import annotations

import math
import socket
import time
from collections.abc import Callable

import pytest
from toolchain.platform_watch import Cue, OutSim, decode

from .conftest import World

LIMIT_S = 600.0


class Platform:
    """A platform that is not there: it listens on a free port."""

    def __init__(self) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self._socket.settimeout(LIMIT_S)

    @property
    def address(self) -> str:
        return f"127.0.0.1:{self._socket.getsockname()[1]}"

    def take(self) -> Cue | OutSim:
        return decode(self._socket.recv(2048))

    def comes(self, holds: Callable[[Cue | OutSim], bool]) -> Cue | OutSim:
        end = time.monotonic() + LIMIT_S
        found = self.take()
        while not holds(found) and time.monotonic() < end:
            found = self.take()
        assert holds(found), found
        return found


@pytest.fixture(scope="module")
def yard(shared_world: World) -> World:
    shared_world.server("--world=yard")
    return shared_world


def test_a_seat_moves_the_platform_and_who_leaves_brings_it_to_neutral(yard: World) -> None:
    platform = Platform()
    options = [f"--platform={platform.address}", "--platform-rate=100", "--use=Turntable"]
    client = yard.client("observer", *options)
    first = platform.take()
    assert first.position == (0.0, 0.0, 0.0)
    assert first.gain == 0.0
    seated = platform.comes(lambda cue: cue.gain == 1.0)
    assert seated.flags == []
    length = math.hypot(*seated.specific_force)
    assert length == pytest.approx(9.81, abs=0.5), "at rest, or slowly turning"
    after = platform.take()
    assert after.sequence > seated.sequence
    assert after.tick >= seated.tick
    assert client.end() == 0, client.log()


def test_outsim_with_an_id(yard: World) -> None:
    platform = Platform()
    options = [f"--platform={platform.address}:outsim-7", "--use=Turntable"]
    client = yard.client("observer", *options, name="outsim")
    found = platform.take()
    assert isinstance(found, OutSim)
    assert found.id == 7
    platform.comes(lambda packet: math.hypot(*packet.position) > 0.5)
    assert client.end() == 0, client.log()


def test_an_address_that_is_none_is_refused(yard: World) -> None:
    client = yard.client("observer", "--platform=127.0.0.1:99999", name="refused")
    assert client.await_exit() == 2
    assert "1 to 65535" in client.log()
