# SPDX-License-Identifier: MIT
"""Entities of a level, over real processes: a door, a seat, levels that change, recordings."""

from __future__ import annotations

import json
import os
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from toolchain.paths import ROOT

from .conftest import World

LIMIT_S = 120.0
DOOR = "Props/Door/Entity"
TURNTABLE = "Props/Turntable/Disc/Entity"


def entities(recording: Path) -> dict[str, Any]:
    """What a recording holds, see recorded_entities.gd."""
    script = "res://tests/system/recorded_entities.gd"
    command = [os.environ["DISMOUNT_GODOT"], "--headless", "--path", str(ROOT), "-s", script]
    done = subprocess.run(
        [*command, "--", f"--recording={recording}"],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    if "the recording is empty" in done.stderr:
        return {}
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.strip().splitlines()[-1])


def comes(recording: Path, holds: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """Waits until a recording that is being written holds something."""
    end = time.monotonic() + LIMIT_S
    found: dict[str, Any] = {}
    while time.monotonic() < end:
        found = entities(recording) if recording.exists() else {}
        if found.get("entities") and holds(found):
            return found
        time.sleep(0.2)
    raise AssertionError(f"it does not come: {found}")


def test_a_button_opens_a_door_for_everybody(world: World) -> None:
    files = {name: world.folder / f"{name}.dsmt" for name in ("server", "observer", "late")}
    world.server("--world=yard", f"--record={files['server']}")
    world.client("observer", "--use=Door", f"--record={files['observer']}").await_text("joined")
    for name in ("server", "observer"):
        is_open = comes(
            files[name], lambda seen: seen["entities"][DOOR]["fields"]["opening"][-1] == 1
        )
        values = is_open["entities"][DOOR]["fields"]["opening"]
        assert values == sorted(values)
        assert len(values) > 20, "it slides"
        assert is_open["levels"] == ["yard"]
    world.client("observer", f"--record={files['late']}", name="late").await_text("joined")
    late = comes(files["late"], lambda seen: DOOR in seen["entities"])
    late = comes(files["late"], lambda seen: seen["entities"][DOOR]["fields"]["opening"][-1] == 1)
    assert late["entities"][DOOR]["type"] == "door"


def test_a_seat_is_taken_by_one_and_free_when_he_has_left(world: World) -> None:
    file = world.folder / "server.dsmt"
    world.server("--world=yard", f"--record={file}")
    first = world.client("observer", "--use=Turntable", name="first")
    comes(file, lambda seen: seen["entities"][TURNTABLE]["fields"]["occupant"] == [0, 1])
    first.process.terminate()
    assert first.await_exit() == 0
    comes(file, lambda seen: seen["entities"][TURNTABLE]["fields"]["occupant"] == [0, 1, 0])
    world.client("observer", "--use=Turntable", name="second")
    comes(file, lambda seen: seen["entities"][TURNTABLE]["fields"]["occupant"] == [0, 1, 0, 2])


def test_an_instructor_changes_the_level(world: World) -> None:
    file = world.folder / "observer.dsmt"
    server = world.server()
    world.trainee()
    world.client("observer", f"--record={file}").await_text("joined")
    comes(file, lambda seen: "trainee" in seen["entities"])
    world.client("instructor", "--orders=world:yard").await_text("the world is now 'yard'")
    changed = comes(file, lambda seen: DOOR in seen["entities"] and "trainee" in seen["entities"])
    assert changed["levels"] == ["hall", "yard"]
    assert "is not the server's" not in world.processes[2].log()
    assert "ERROR" not in server.log()
    world.client("instructor", "--orders=world:atlantis", name="lost").await_text(
        "there is no world 'atlantis' here: "
    )


def test_a_world_that_is_not_there(world: World) -> None:
    server = world.server("--world=../hall", wait=False)
    assert server.await_exit() == 2
    assert "there is no world '../hall' here: " in server.log()


def test_the_servers_recording_survives_a_kill_and_is_replayed(world: World) -> None:
    file = world.folder / "server.dsmt"
    server = world.server(f"--record={file}")
    world.trainee()
    comes(file, lambda seen: "trainee" in seen["entities"])
    server.kill()
    replay = world.client("replay", f"--file={file}")
    assert replay.await_exit() == 0
    assert replay.report()["snapshots"] > 10


def test_calls_of_a_level_go_where_its_permissions_say(world: World) -> None:
    server = world.server("--world=yard")
    world.client("observer", "--use=Bell", name="eve").await_text(
        "the call of 'ring' was refused: a role of observer may not call 'ring'"
    )
    watcher = world.client("observer", name="watcher")
    watcher.await_text("joined")
    world.trainee("--name=Ada", "--use=Bell").await_text("bell: Ada rings")
    watcher.await_text("bell: Ada rings")
    assert "bell: Ada rings" in server.log() and "ERROR" not in server.log()
    # The level comes anew, with all that is shared in it.
    world.client("instructor", "--orders=world:yard").await_text("the world is now 'yard'")
    world.trainee("--name=Bob", "--use=Bell", name="bob").await_text("bell: Bob rings")
    watcher.await_text("bell: Bob rings")
    for process in (watcher, server):
        process.process.terminate()
        assert process.await_exit() == 0
        assert "ERROR" not in process.log()
