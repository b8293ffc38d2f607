# SPDX-License-Identifier: MIT
"""Attacks and faults, beside a trainee and an observer that must not notice.

An attack goes on until the server has counted a number of its datagrams, and the others have got
a number of theirs meanwhile: nothing here depends on how fast the machine is.
"""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import pytest
from toolchain.processes import await_that

from .attackers import (
    Attack,
    Disconnects,
    FewChannels,
    Garbage,
    HalfOpen,
    PortZero,
    ZeroLength,
    flood,
    may_send_raw,
    outer_port,
)
from .conftest import World, shared
from .own_client import Crowd, OwnClient

UNSEALED = "--sealing=0"
PASSWORD = "--password=sesame"
RAW = pytest.mark.skipif(not may_send_raw(), reason="only root may send from any port")
# Datagrams of an attack that the server must have counted.
MANY = 400
# Clients of one address that a server takes by default.
SHARE = 8
# Snapshots that the observer gets meanwhile, and steps that the trainee's body makes.
SNAPSHOTS = 60
STEPS = 30
# Times that somebody guesses passwords, until the log names him.
GUESSERS = 5


def count_of(made: dict, name: str) -> int:
    """Limbs of a person that were compared, of a server's report; 16 in a step."""
    return next((person["count"] for person in made["people"] if person["name"] == name), 0)


class Scene:
    """A server with two legitimate clients, and what they get."""

    def __init__(self, world: World, *options: str) -> None:
        self.world = world
        self.server = world.server(*options)
        self.trainee = world.trainee("--name=Good", *options, name="good")
        self.observer = world.client("observer", *options)
        self.go_on()

    def go_on(self) -> None:
        """Waits until the observer has got more snapshots, and the trainee's body has moved on."""
        seen = self.observer.report()["snapshots"]
        made = count_of(self.server.report(), "Good")
        self.observer.await_report(lambda later: later["snapshots"] > seen + SNAPSHOTS)
        self.server.await_report(lambda later: count_of(later, "Good") > made + 16 * STEPS)

    def counts(self) -> dict:
        """What the server's transport has counted."""
        return self.server.report()["transport"]

    @contextmanager
    def nobody_notices(self) -> Iterator[None]:
        """What is done meanwhile costs nobody the connection, and leads to few lines."""
        yield
        self.go_on()
        for process in (self.trainee, self.observer):
            assert process.process.poll() is None, process.log()
            assert "lost" not in process.log()
            assert "joined" not in process.log()
        assert len(self.server.log().splitlines()) < 40, self.server.log()

    def endure(self, attack: Attack, counted: str) -> dict:
        """Lets an attack go on until the server has counted much of it; returns all counts."""
        before = self.counts()[counted]
        with self.nobody_notices(), attack:
            report = self.server.await_report(
                lambda made: made["transport"][counted] > before + MANY
            )
            self.go_on()
        return report["transport"]


unsealed = shared(lambda world: Scene(world, UNSEALED))
guarded = shared(lambda world: Scene(world, PASSWORD))


def _join(world: World, password: str = "", seals: bool = True) -> None:
    """Somebody comes, and leaves."""
    with Crowd() as crowd:
        crowd.join([OwnClient(world.port, sealed=seals, password=password, name="late")])


def _pause(scene: Scene, holds: Callable[[], bool]) -> None:
    """The server stands still until something holds."""
    os.kill(scene.server.process.pid, signal.SIGSTOP)
    await_that(holds, "what it waits for")
    os.kill(scene.server.process.pid, signal.SIGCONT)


def test_half_open_handshakes_keep_nobody_out(world: World) -> None:
    """Neither do those of its own address, where no password has to be found."""
    server = world.server()
    with Crowd() as crowd:
        stays = OwnClient(world.port, name="stays")
        crowd.join([stays])
        seen = flood("half-open", world.port, 5000, 8, "127.0.0.1")
        _join(world)
        before = stays.snapshots
        crowd.go_on_until(lambda: stays.snapshots > before)
        assert not stays.is_gone
    counts = server.report()["transport"]
    print(seen, counts)
    # That none of the honest takes a second is what test_relay_hostile.cpp holds.
    assert seen["opened"] == 8
    assert seen["refused"] == 0
    assert counts["cookies"] > 8
    assert counts["handshakes_dropped"] > 0
    assert "lost" not in server.log()
    assert "ERROR" not in server.log()


def test_one_machine_does_not_fill_a_server(world: World) -> None:
    """It gets its share, and some of its clients wait; whoever comes from elsewhere is in."""
    world.server("--max-per-address=-1")
    with Crowd() as crowd:
        many = [OwnClient(world.port, name=f"many {number}") for number in range(60)]
        crowd.add(*many)
        crowd.go_on_until(
            lambda: all(one.is_joined or one.position or one.is_refused for one in many)
        )
        crowd.go_on_until(lambda: sum(one.is_joined for one in many) == SHARE)
        waiting = [one for one in many if one.position and not one.is_refused]
        assert sorted(one.position for one in waiting) == [*range(1, SHARE + 1)]
        assert all(one.waits_for == 2 for one in waiting)
        crowd.join([OwnClient(world.port, address="127.0.0.2", name="elsewhere")])
        # A client of ours from the same address does not give up.
        late = world.client("observer", name="late")
        crowd.go_on_until(lambda: "too many wait here already; trying again" in late.log())
        # Who waits comes in, in order, when somebody leaves or is gone.
        first, second = (next(one for one in waiting if one.position == at) for at in (1, 2))
        second.disconnect()
        next(one for one in many if one.is_joined).leave()
        crowd.go_on_until(lambda: first.is_joined and min(one.position for one in waiting) == 1)
        crowd.go_on_until(lambda: late.process.poll() is None and "position" in late.log())
        for one in many:
            if one.is_joined:
                one.leave()
            else:
                one.disconnect()
        crowd.go_on_until(lambda: "joined" in late.log())
    assert late.end() == 0


def test_a_client_that_seals_is_told_that_the_server_does_not(unsealed: Scene) -> None:
    client = unsealed.world.client("observer", name="sealing")
    assert client.await_exit() == 3
    assert "does not seal connections" in client.log()
    unsealed.server.await_text("refused a client from 127.0.0.1: it")


def test_garbage_without_sealing(unsealed: Scene) -> None:
    unsealed.endure(Garbage(unsealed.world.port, 1000.0), "stray")


def test_too_few_channels(unsealed: Scene) -> None:
    unsealed.endure(FewChannels(unsealed.world.port, 1000.0), "too_few_channels")


@RAW
def test_datagrams_from_port_zero_at_a_starved_server(unsealed: Scene) -> None:
    before = unsealed.counts()["from_port_zero"]
    with unsealed.nobody_notices(), PortZero(unsealed.world.port, 1000.0) as attack:
        for _pause_number in range(3):
            sent = attack.sent
            _pause(unsealed, lambda sent=sent: attack.sent > sent + MANY)
            unsealed.go_on()
    counts = unsealed.counts()
    assert counts["from_port_zero"] > before + 3 * MANY
    assert "errors" not in counts


def test_half_open_connects_without_sealing_and_a_late_client(unsealed: Scene) -> None:
    """More than ENet has places for: those who do not go on make room."""
    with HalfOpen(unsealed.world.port, 1500.0) as attack:
        unsealed.server.await_report(lambda made: made["transport"]["half_open_evicted"] > MANY)
        with unsealed.nobody_notices():
            _join(unsealed.world, seals=False)
    print(f"{attack.sent} datagrams; {unsealed.counts()}")
    assert unsealed.counts()["half_open"] < 1100


@RAW
def test_forged_disconnects_without_sealing_end_no_session(unsealed: Scene) -> None:
    port = outer_port(unsealed.trainee.process.pid, unsealed.world.port)
    with Disconnects(unsealed.world.port, 500.0, [port]):
        unsealed.server.await_text("from 127.0.0.1 is lost")
    unsealed.server.await_text("from 127.0.0.1 is back")
    assert " left" not in unsealed.server.log()
    people = [p for p in unsealed.server.report()["people"] if p["name"] == "Good"]
    assert len(people) == 1
    unsealed.go_on()


def test_zero_length_datagrams(guarded: Scene) -> None:
    guarded.endure(ZeroLength(guarded.world.port, 1000.0), "stray")


def test_garbage(guarded: Scene) -> None:
    guarded.endure(Garbage(guarded.world.port, 1000.0), "stray")


@RAW
def test_forged_disconnects_change_nothing(guarded: Scene) -> None:
    clients = (guarded.trainee, guarded.observer)
    ports = [outer_port(one.process.pid, guarded.world.port) for one in clients]
    guarded.endure(Disconnects(guarded.world.port, 1000.0, ports), "not_opened")


def test_a_client_that_does_not_seal_is_told_so(guarded: Scene) -> None:
    client = guarded.world.client("observer", UNSEALED, name="open")
    assert client.await_exit() == 3
    assert "wants sealed connections" in client.log()
    guarded.server.await_text("refused a client from 127.0.0.1: it")


def test_forged_datagrams(guarded: Scene) -> None:
    before = guarded.counts()["stray"]
    with guarded.nobody_notices():
        assert flood("forged", guarded.world.port, 10000, "127.0.0.2")["sent"] == 10000
    assert guarded.counts()["stray"] > before + 2500


def test_half_open_handshakes_of_one_address_leave_the_passwords_of_others(guarded: Scene) -> None:
    before = guarded.counts()["handshakes_later"]
    with guarded.nobody_notices():
        seen = flood("half-open", guarded.world.port, 1000, 8, "127.0.0.2", "sesame")
        _join(guarded.world, "sesame")
    assert seen["opened"] == 8
    assert seen["refused"] == 0
    assert guarded.counts()["handshakes_later"] > before, "that address has no tries left"


def test_wrong_passwords(guarded: Scene) -> None:
    before = guarded.counts()["wrong_passwords"]
    with guarded.nobody_notices():
        # Before it believes that its password is wrong, a client has tried it three times.
        wrong = guarded.world.client("observer", "--password=guess", name="wrong")
        assert wrong.await_exit() == 3
        assert "the password is wrong" in wrong.log()
        with Crowd() as crowd:
            guessers = [OwnClient(guarded.world.port, password="guess") for _ in range(2)]
            crowd.add(*guessers)
            crowd.go_on_until(lambda: all(one.is_refused for one in guessers))
    made = guarded.server.report()
    assert made["transport"]["wrong_passwords"] == before + 5
    everything = guarded.server.log() + guarded.trainee.log() + str(made)
    assert "sesame" not in everything
    assert "guess" not in everything


def test_guesses_at_speed_from_many_ports_of_one_address(guarded: Scene) -> None:
    before = guarded.counts()["wrong_passwords"]
    answered = 0
    seconds = 0.0
    lines: list[str] = []
    # The log has a line in 5 s: it may be about somebody who came just before.
    for _ in range(GUESSERS):
        with guarded.nobody_notices():
            seen = flood("guess", guarded.world.port, 60, "127.0.0.3", "sesame")
        assert seen["opened"] == 60, "honest clients from elsewhere join meanwhile"
        answered += seen["answered"]
        seconds += seen["seconds"]
        lines = [line for line in guarded.server.log().splitlines() if "127.0.0.3" in line]
        if lines:
            break
    assert 0 < answered <= 5 + seconds
    assert guarded.counts()["wrong_passwords"] - before == answered, "each is counted"
    assert 0 < len(lines) <= 2 + seconds


def test_killed_and_frozen_clients_are_lost_and_come_back_into_their_bodies(guarded: Scene) -> None:
    names = ("Killed", "Frozen")
    killed, frozen = (
        guarded.world.trainee(PASSWORD, f"--name={name}", name=name.lower()) for name in names
    )
    for name in names:
        guarded.server.await_report(lambda made, name=name: count_of(made, name) > 60)
    killed.kill()
    os.kill(frozen.process.pid, signal.SIGSTOP)
    with guarded.nobody_notices():
        for name in names:
            guarded.server.await_line(f"'{name}' (", "from 127.0.0.1 is lost")
        people = [person["name"] for person in guarded.server.report()["people"]]
        assert people.count("Killed") == 1, "its body is kept for a minute"
        assert people.count("Frozen") == 1
        os.kill(frozen.process.pid, signal.SIGCONT)
        guarded.server.await_line("'Frozen' (", "from 127.0.0.1 is back")
    made = guarded.server.report()
    assert [person["name"] for person in made["people"]].count("Frozen") == 1
    before = count_of(made, "Frozen")
    # The same body moves on.
    guarded.server.await_report(lambda later: count_of(later, "Frozen") > before + 16 * STEPS)


def test_a_frozen_server_gets_its_people_back(guarded: Scene) -> None:
    clients = (guarded.trainee, guarded.observer)
    # Until both have given it up; where it stands still for less, the connections outlast it.
    _pause(guarded, lambda: all("trying again" in client.log() for client in clients))
    guarded.go_on()
    assert " left" not in guarded.server.log()
    people = [person["name"] for person in guarded.server.report()["people"]]
    assert people.count("Good") == 1


def test_a_killed_server_is_found_again(guarded: Scene) -> None:
    guarded.world.is_spent = True
    guarded.server.kill()
    guarded.observer.await_text("trying again")
    guarded.world.server(PASSWORD, name="second")
    for client in (guarded.observer, guarded.trainee):
        client.await_text("joined")
