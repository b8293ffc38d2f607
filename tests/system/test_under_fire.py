# SPDX-License-Identifier: MIT
"""Attacks and faults, each with a trainee and an observer that must not notice."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from .attackers import Attack, Garbage, HalfOpen, PortZero, ZeroLength, may_send_raw
from .conftest import World

MEASURED_S = 5.0
# At least these shares of the snapshots and samples come. A busy machine starves the clients
# themselves of some, the one that computes samples of half; an attack that gets through takes
# nearly all.
SNAPSHOTS_KEPT = 0.5
SAMPLES_KEPT = 0.25
# Ticks that two reports, each written once a second, can be apart.
APART_TICKS = 60


class Scene:
    """A server with two legitimate clients, and what they get."""

    def __init__(self, world: World, *options: str) -> None:
        self.world = world
        self.server = world.server(*options)
        password = [o for o in options if o.startswith("--password")]
        self.trainee = world.trainee("--name=Good", *password, name="good")
        self.observer = world.client("observer", *password)
        self.trainee.await_text("joined")
        self.observer.await_text("joined")
        time.sleep(2.5)

    def stats(self) -> tuple[int, int, int, int]:
        """Snapshots of the observer, ticks of the server, steps of the body, work on the network.

        All but the last (microseconds of processor time) are counted, not timed: a busy machine
        makes fewer ticks a second, and an attack must not take any of them from anybody.
        """
        made = self.server.report()
        seen = self.observer.report()
        people = {person["name"]: person for person in made["people"]}
        steps = people["Good"]["count"] // 16
        return seen["snapshots"], made["ticks"], steps, made["network_cpu_usec"]

    @contextmanager
    def nobody_notices(self) -> Iterator[None]:
        """What is done meanwhile takes no snapshot and no sample from the legitimate clients."""
        before = self.stats()
        lines = len(self.server.log().splitlines())
        yield
        time.sleep(1.2)
        after = self.stats()
        # The two reports are up to a second apart, at the beginning and at the end.
        ticks = after[1] - before[1]
        rate = (after[0] - before[0] + APART_TICKS) / ticks
        moved = (after[2] - before[2] + 1) / ticks
        work_ms = (after[3] - before[3]) / ticks / 1000.0
        print(f"{rate:.2f} snapshots and {moved:.2f} steps a tick of {ticks}, {work_ms:.2f} ms")
        assert rate > SNAPSHOTS_KEPT
        assert moved > SAMPLES_KEPT
        assert work_ms < 8.0
        for process in (self.trainee, self.observer):
            assert process.process.poll() is None, process.log()
            assert "lost" not in process.log()
            assert process.log().count("joined") == 1
        assert len(self.server.log().splitlines()) - lines < 40, self.server.log()


def _endure(world: World, attack: Attack) -> None:
    scene = Scene(world)
    with scene.nobody_notices(), attack:
        time.sleep(MEASURED_S)
    assert attack.sent > 0
    print(f"{attack.sent} datagrams; {scene.server.report()['transport']}")


@pytest.mark.skipif(not may_send_raw(), reason="only root may send from port 0")
def test_datagrams_from_port_zero(world: World) -> None:
    _endure(world, PortZero(world.port, 50.0))


def test_zero_length_datagrams(world: World) -> None:
    _endure(world, ZeroLength(world.port, 1000.0))


def test_garbage(world: World) -> None:
    _endure(world, Garbage(world.port, 1000.0))


def test_half_open_flood_and_a_late_client(world: World) -> None:
    scene = Scene(world)
    with scene.nobody_notices(), HalfOpen(world.port, 100.0):
        time.sleep(MEASURED_S)
        late = world.client("observer", name="late")
        late.await_text("joined")


def test_slot_exhaustion(world: World) -> None:
    """All of ENet's places are taken: whoever is here stays undisturbed."""
    _endure(world, HalfOpen(world.port, 1500.0))


def test_wrong_passwords_at_speed(world: World) -> None:
    scene = Scene(world, "--password=sesame")
    with scene.nobody_notices():
        for number in range(4):
            wrong = world.client("observer", "--password=guess", name=f"wrong{number}")
            assert wrong.await_exit() == 3
            assert "the password is wrong" in wrong.log()
    everything = scene.server.log() + scene.trainee.log() + str(scene.server.report())
    assert "sesame" not in everything
    assert "guess" not in everything


def test_a_killed_client_is_lost_and_its_place_kept(world: World) -> None:
    scene = Scene(world)
    victim = world.trainee("--name=Victim", name="victim")
    victim.await_text("joined")
    time.sleep(2.0)
    with scene.nobody_notices():
        victim.kill()
        scene.server.await_text("'Victim' (3) from 127.0.0.1 is lost")
        time.sleep(1.5)
        names = [person["name"] for person in scene.server.report()["people"]]
        assert "Victim" in names, "its body is kept for a minute"


def test_a_client_frozen_for_five_seconds_comes_back_into_its_body(world: World) -> None:
    scene = Scene(world)
    victim = world.trainee("--name=Victim", name="victim")
    victim.await_text("joined")
    time.sleep(2.0)
    with scene.nobody_notices():
        os.kill(victim.process.pid, signal.SIGSTOP)
        time.sleep(5.0)
        os.kill(victim.process.pid, signal.SIGCONT)
        scene.server.await_text("'Victim' (3) from 127.0.0.1 is back")
    people = [p for p in scene.server.report()["people"] if p["name"] == "Victim"]
    assert len(people) == 1
    before = people[0]["count"]
    time.sleep(2.5)
    people = [p for p in scene.server.report()["people"] if p["name"] == "Victim"]
    assert people[0]["count"] > before + 16 * 60, "the same body moves on"


def test_a_server_frozen_for_five_seconds_gets_its_people_back(world: World) -> None:
    scene = Scene(world)
    before = scene.stats()
    os.kill(scene.server.process.pid, signal.SIGSTOP)
    time.sleep(5.0)
    os.kill(scene.server.process.pid, signal.SIGCONT)
    # The connections may have outlasted it, or the clients come back by themselves.
    time.sleep(8.0)
    after = scene.stats()
    assert after[3] > before[3] + 3 * 60
    assert " left" not in scene.server.log()
    assert [p["name"] for p in scene.server.report()["people"]] == ["Good"]


def test_a_killed_server_is_found_again(world: World) -> None:
    scene = Scene(world)
    scene.server.kill()
    scene.observer.await_text("trying again")
    world.server(name="second")
    scene.observer.await_text("joined", count=2)
    scene.trainee.await_text("joined", count=2)


def test_an_instructor_decides(world: World) -> None:
    world.server("--waiting-room=1")
    instructor = world.client("instructor", "--orders=admit:Ada,kick:Ada", name="instructor")
    instructor.await_text("joined")
    trainee = world.trainee("--name=Ada", name="ada")
    assert trainee.await_exit() == 3
    assert "waiting for an instructor, position 1" in trainee.log()
    assert "joined" in trainee.log()
    assert "kicked by instructor 'instructor'" in trainee.log()
    bob = world.trainee("--name=Bob", name="bob")
    bob.await_text("waiting for an instructor")
    time.sleep(1.0)
    assert "joined" not in bob.log()
