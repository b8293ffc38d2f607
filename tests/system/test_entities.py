# SPDX-License-Identifier: MIT
"""Entities of a level, over real processes: a door, a seat, levels that change, recordings."""

from __future__ import annotations

from .conftest import World, shared
from .recordings import comes, forget

DOOR = "Props/Door/Entity"
TURNTABLE = "Props/Turntable/Disc/Entity"


class Yard:
    """A server that records, and an instructor."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.file = world.folder / "server.dsmt"
        self.server = world.server("--world=yard", f"--record={self.file}")
        self.instructor = world.instructor()


yard = shared(Yard)


def test_a_button_opens_a_door_for_everybody(yard: Yard) -> None:
    files = {name: yard.world.folder / f"{name}.dsmt" for name in ("server", "observer", "late")}
    yard.world.client("observer", "--use=Door", f"--record={files['observer']}")
    for name in ("server", "observer"):
        is_open = comes(
            files[name], lambda seen: seen["entities"][DOOR]["fields"]["opening"][-1] == 1
        )
        values = is_open["entities"][DOOR]["fields"]["opening"]
        assert values == sorted(values)
        assert len(values) > 20, "it slides"
        assert is_open["levels"] == ["yard"]
    yard.world.client("observer", f"--record={files['late']}", name="late").await_text("joined")
    late = comes(files["late"], lambda seen: seen["entities"][DOOR]["fields"]["opening"][-1] == 1)
    assert late["entities"][DOOR]["type"] == "door"


def test_a_seat_is_taken_by_one_and_free_when_he_has_left(yard: Yard) -> None:
    forget(yard.file)
    first = yard.world.client("observer", "--use=Turntable", "--name=First", name="first")

    def session_of(name: str) -> int:
        rows = yard.server.report()["sessions"]
        return next(row["session"] for row in rows if row["name"] == name)

    def occupants(*sessions: int) -> None:
        comes(
            yard.file,
            lambda seen: seen["entities"][TURNTABLE]["fields"]["occupant"] == [0, *sessions],
        )

    first.await_text("joined")
    one = session_of("First")
    occupants(one)
    assert first.end() == 0
    occupants(one, 0)
    second = yard.world.client("observer", "--use=Turntable", "--name=Second", name="second")
    second.await_text("joined")
    occupants(one, 0, session_of("Second"))


def test_calls_of_a_level_go_where_its_permissions_say(yard: Yard) -> None:
    watcher = yard.world.client("observer", "--use=Bell", name="eve")
    watcher.await_text("the call of 'ring' was refused: a role of observer may not call 'ring'")
    yard.world.trainee("--name=Ada", "--use=Bell").await_text("bell: Ada rings")
    for process in (watcher, yard.server):
        process.await_text("bell: Ada rings")
    # The level comes anew, with all that is shared in it.
    yard.instructor.type("level yard")
    yard.instructor.await_text("the world is now 'yard'")
    yard.world.trainee("--name=Bob", "--use=Bell", name="bob").await_text("bell: Bob rings")
    watcher.await_text("bell: Bob rings")
    assert watcher.end() == 0
    assert "ERROR" not in watcher.log()


def test_an_instructor_changes_the_level(yard: Yard) -> None:
    file = yard.world.folder / "changes.dsmt"
    trainee = yard.world.trainee()
    observer = yard.world.client("observer", f"--record={file}")
    comes(file, lambda seen: "trainee" in seen["entities"])
    yard.instructor.type("level hall")
    yard.instructor.await_text("the world is now 'hall'")
    comes(file, lambda seen: seen["levels"] == ["yard", "hall"])
    forget(file)
    yard.instructor.type("level yard")
    yard.instructor.await_text("the world is now 'yard'")
    changed = comes(file, lambda seen: DOOR in seen["entities"] and "trainee" in seen["entities"])
    assert changed["levels"] == ["hall", "yard"]
    for process in (trainee, observer):
        assert "is not the server's" not in process.log()
    yard.instructor.type("level atlantis")
    yard.instructor.await_text("there is no world 'atlantis' here: ")


def test_the_servers_recording_survives_a_kill_and_is_replayed(yard: Yard) -> None:
    yard.world.is_spent = True
    yard.world.trainee()
    people = comes(yard.file, lambda seen: len(seen["people"].get("trainee", [])) > 2)["people"]
    yard.server.kill()
    begin_s = people["trainee"][-2]["time_s"]
    replay = yard.world.client("replay", f"--file={yard.file}", f"--from={begin_s}")
    assert replay.await_exit() == 0
    assert replay.report()["snapshots"] > 10
