# SPDX-License-Identifier: MIT
"""Vehicles over real processes: driven by a list, predicted, ridden, directed."""

from __future__ import annotations

from .conftest import World
from .test_entities import comes

TANK = "Props/Tank/Entity"
STRAIGHT = "--drive=0:0:0:3,1:0:0:600"


def test_a_tank_is_driven_and_obeys_at_once_on_the_drivers_screen(world: World) -> None:
    file = world.folder / "server.dsmt"
    server = world.server("--world=desert", f"--record={file}")
    driver = world.client("observer", "--use=Tank/DriverSeat", STRAIGHT, "--fps=60")
    driver.await_report(lambda seen: seen["driving"]["is_active"])
    comes(file, lambda seen: max(seen["entities"][TANK]["fields"]["left_speed"]) > 3.0)
    driven = comes(file, lambda seen: 2 in seen["entities"][TANK]["fields"]["gear"])
    fields = driven["entities"][TANK]["fields"]
    assert max(fields["rpm"]) > 1500.0
    assert fields["occupant"] == [0, 1]
    # A busy machine may have lost some ticks meanwhile, but it finds back.
    driver.await_report(
        lambda seen: seen["driving"]["is_active"] and seen["driving"]["error_m"] < 0.1
    )
    driver.process.terminate()
    assert driver.await_exit() == 0
    comes(file, lambda seen: seen["entities"][TANK]["fields"]["occupant"] == [0, 1, 0])
    assert "ERROR" not in server.log()


def test_a_trainee_stands_in_the_hatch_and_others_see_him_ride(world: World) -> None:
    files = {name: world.folder / f"{name}.dsmt" for name in ("server", "observer")}
    server = world.server("--world=desert", f"--record={files['server']}")
    commander = world.client(
        "trainee", "--use=Tank/Turret/CommanderSeat", "--bvh=assets/motion/01_01.bvh"
    )
    commander.await_text("joined")
    comes(files["server"], lambda seen: seen["entities"][TANK]["fields"]["commander"] == [0, 1])
    world.client("observer", f"--record={files['observer']}", name="observer").await_text("joined")
    world.client("observer", "--use=Tank/DriverSeat", STRAIGHT, name="driver")
    for file in files.values():
        ridden = comes(file, lambda seen: max(seen["entities"][TANK]["fields"]["left_speed"]) > 2.0)
        # 0 is the ground; people are numbered below 1024.
        assert ridden["entities"]["trainee"]["fields"]["carrier"][-1] >= 1024
    assert "ERROR" not in server.log()


def test_vehicles_are_put_upright_by_instructors_only(world: World) -> None:
    world.server("--world=desert")
    world.client("instructor", "--orders=upright:Tank", name="ida").await_text("upright: Tank")
    world.client("instructor", "--orders=upright:Boat", name="ivo").await_text(
        "nothing to upright is called 'Boat': Carrier, Scootmobile, Tank, Truck"
    )


def test_a_list_to_drive_by_that_is_none_is_named(world: World) -> None:
    world.server()
    client = world.client("observer", "--drive=1:2")
    assert client.await_exit() == 2
    assert "--drive is THROTTLE:STEERING:BRAKE:SECONDS" in client.log()
