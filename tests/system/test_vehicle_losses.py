# SPDX-License-Identifier: MIT
"""What becomes of a vehicle whose driver's process is killed."""

from __future__ import annotations

from .conftest import World
from .test_entities import comes

TANK = "Props/Tank/Entity"
FULL_THROTTLE = "--drive=0:0:0:3,1:1:0:600"


def test_a_tank_whose_driver_is_killed_stops_and_is_free_again(world: World) -> None:
    file = world.folder / "server.dsmt"
    server = world.server("--world=desert", f"--record={file}")
    driver = world.client("observer", "--use=Tank/DriverSeat", FULL_THROTTLE, name="driver")
    comes(file, lambda seen: max(seen["entities"][TANK]["fields"]["right_speed"]) > 2.0)
    driver.kill()
    halted = comes(
        file,
        lambda seen: all(
            abs(seen["entities"][TANK]["fields"][f"{side}_speed"][-1]) < 0.1
            for side in ("left", "right")
        ),
    )["entities"][TANK]["fields"]
    # The brake, not an end of the session: that is kept for a while, for who comes back.
    assert halted["brake"][-1] == 1
    assert halted["occupant"] == [0, 1]
    comes(file, lambda seen: seen["entities"][TANK]["fields"]["occupant"] == [0, 1, 0])
    world.client("observer", "--use=Tank/DriverSeat", name="next")
    comes(file, lambda seen: seen["entities"][TANK]["fields"]["occupant"][-1] not in (0, 1))
    assert "ERROR" not in server.log()
