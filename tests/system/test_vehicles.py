# SPDX-License-Identifier: MIT
"""Vehicles over real processes: driven by a list, predicted, ridden, directed, left alone."""

from __future__ import annotations

from typing import Any

from .conftest import Process, World, shared
from .recordings import comes, forget

TANK = "Props/Tank/Entity"
SEAT = "--use=Tank/DriverSeat"
STRAIGHT = "--drive=0:0:0:3,1:0:0:600"
TURNING = "--drive=0:0:0:3,1:1:0:600"


class Desert:
    """A server that records, and an instructor."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.file = world.folder / "server.dsmt"
        self.server = world.server("--world=desert", f"--record={self.file}")
        self.instructor = world.instructor()

    def session_of(self, client: Process, name: str) -> int:
        """The number of somebody's session."""
        client.await_text("joined")
        rows = self.server.report()["sessions"]
        return next(row["session"] for row in rows if row["name"] == name)


desert = shared(Desert)


def tank(seen: dict[str, Any]) -> dict[str, list[float]]:
    """The different values of each field of the tank, in order."""
    fields: dict[str, list[float]] = seen["entities"][TANK]["fields"]
    return fields


def drives(seen: dict[str, Any], speed: float) -> bool:
    """Whether both tracks have gone so fast, in m/s."""
    return all(max(map(abs, tank(seen)[f"{side}_speed"])) > speed for side in ("left", "right"))


def stands(seen: dict[str, Any]) -> bool:
    return all(abs(tank(seen)[f"{side}_speed"][-1]) < 0.1 for side in ("left", "right"))


def test_vehicles_are_put_upright_by_instructors_only(desert: Desert) -> None:
    desert.instructor.type("upright Tank")
    desert.instructor.await_text("upright: Tank")
    desert.instructor.type("upright Boat")
    desert.instructor.await_text(
        "nothing to upright is called 'Boat': Carrier, Scootmobile, Tank, Truck"
    )


def test_a_tank_whose_driver_is_killed_stops_and_is_free_again(desert: Desert) -> None:
    forget(desert.file)
    driver = desert.world.client("observer", SEAT, TURNING, "--name=Driver", name="driver")
    session = desert.session_of(driver, "Driver")
    comes(desert.file, lambda seen: max(map(abs, tank(seen)["right_speed"])) > 2.0)
    driver.kill()
    halted = tank(comes(desert.file, stands))
    # The brake, not an end of the session: that is kept for a minute, for who comes back.
    assert halted["brake"][-1] == 1
    assert halted["occupant"] == [0, session]
    desert.instructor.type("kick Driver")
    comes(desert.file, lambda seen: tank(seen)["occupant"] == [0, session, 0])
    following = desert.world.client("observer", SEAT, "--name=Next", name="next")
    session = desert.session_of(following, "Next")
    comes(desert.file, lambda seen: tank(seen)["occupant"][-1] == session)


def test_a_tank_obeys_at_once_on_the_drivers_screen_and_others_see_who_rides(
    desert: Desert,
) -> None:
    files = (desert.file, desert.world.folder / "observer.dsmt")
    forget(desert.file)
    commander = desert.world.trainee("--use=Tank/Turret/CommanderSeat", "--name=Rider")
    rider = desert.session_of(commander, "Rider")
    comes(desert.file, lambda seen: tank(seen)["commander"][-1] == rider)
    desert.world.client("observer", f"--record={files[1]}").await_text("joined")
    options = (SEAT, STRAIGHT, "--fps=60", "--name=Driver")
    driver = desert.world.client("observer", *options, name="driver")
    session = desert.session_of(driver, "Driver")
    driver.await_report(lambda seen: seen["driving"]["is_active"])
    for file in files:
        ridden = comes(file, lambda seen: drives(seen, 3.0) and 2 in tank(seen)["gear"])
        # 0 is the ground; people are numbered below 1024.
        assert ridden["entities"]["Rider"]["fields"]["carrier"][-1] >= 1024
        assert max(tank(ridden)["rpm"]) > 1500.0
        assert tank(ridden)["occupant"][-1] == session
    # A busy machine may have lost some ticks meanwhile, but it finds back.
    driver.await_report(
        lambda seen: seen["driving"]["is_active"] and seen["driving"]["error_m"] < 0.1
    )
    assert driver.end() == 0
    comes(desert.file, lambda seen: tank(seen)["occupant"][-1] == 0)
