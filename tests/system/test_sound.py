# SPDX-License-Identifier: MIT
"""What a client hears of a real session, without a display and a sound card."""

from __future__ import annotations

import struct

from .conftest import World

IMPACTS = 24
METAL = 9


def records(data: bytes) -> list[bytes]:
    """The messages of a recording."""
    found = []
    at = 8
    while at + 12 <= len(data):
        size = struct.unpack_from("<I", data, at)[0]
        found.append(data[at + 12 : at + 12 + size])
        at += 12 + size
    return found


def test_steps_of_others_are_heard_and_a_server_makes_no_sound(world: World) -> None:
    server = world.server()
    world.trainee()
    listener = world.client("observer", "--sound=on", "--volume=50")
    heard = listener.await_report(lambda seen: seen["sound"]["begun"] > 10)["sound"]
    assert heard["peak"] <= 48
    assert "sound" not in server.report()
    silent = world.client("observer", name="silent")
    assert silent.await_report(lambda seen: seen["shown_frames"] > 10)["sound"] == {}


def test_a_truck_that_drives_into_a_house_is_heard(world: World) -> None:
    recording = world.folder / "crash.rec"
    server = world.server("--world=town", f"--record={recording}")
    driver = world.client(
        "observer",
        "--sound=on",
        "--use=Truck/DriverSeat",
        "--drive=1:0:0:12,1:0.6:0:600",
    )
    driver.await_report(lambda seen: seen["sound"]["begun"] > 10)

    def crashes() -> list[bytes]:
        found = [r for r in records(recording.read_bytes()) if r[:1] == bytes([IMPACTS])]
        return [message for message in found if message[6 + 15] == METAL]

    server.await_report(lambda _report: crashes() != [])
    message = crashes()[0]
    assert len(message) == 6 + 17 * message[5]
    # Some tonnes at some metres a second.
    assert 0.01 * 2.0 ** (message[6 + 13] / 12.0) > 1000.0
    assert server.end() == 0
