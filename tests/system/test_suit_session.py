# SPDX-License-Identifier: MIT
"""Somebody in an (emulated) suit, from the first calibration to a recording that is played.

How well and how soon a body follows is measured by `./run bench suit`: a wearer strikes poses here,
and the body comes into them, however long it takes.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from .conftest import Process, World
from .pictures import Picture, Window
from .suits import (
    WALK,
    Suit,
    await_people,
    find_poses,
    needs_emulator,
    profiles_in,
    recorded,
    suits_of,
    turned,
)

pytestmark = needs_emulator

# Two masters, trackers at any angle, norths that differ by up to 30 degrees.
TWO = ["--sensors=17", "--devices=two-native-masters", "--heading=30"]
MASTERS = ("00130500", "00130501")
# Moments of the walk, s: arms and legs are elsewhere at each of them, by 13 degrees and more on
# average, and no arm hangs in the soldier's vest, which the body would keep out of it by 4 degrees.
POSES = [4.25, 4.75, 6.25]
# In ticks of the world: by then a body has come to rest in a pose.
REST = 90
TRIES = 20

Start = Callable[[str, list[str], list[str]], Suit]


class Session(NamedTuple):
    """A session of Ada's: what was said, and what observers have recorded."""

    said: str
    moving: Path
    again: Path
    raw: Path


@pytest.fixture(scope="module")
def hall(shared_world: World) -> World:
    """A server; what is kept of people is kept for all tests."""
    shared_world.server()
    return shared_world


@pytest.fixture(scope="module")
def start(hall: World) -> Iterator[Start]:
    """Starts people in suits."""
    with suits_of(hall) as started:
        yield started


@pytest.fixture(scope="module")
def calibrated(start: Start) -> str:
    """Ada has been calibrated, guided by the texts on the screen; what was said of it."""
    ada = start("ada", TWO, ["--person=ada", "--calibrate=full"])
    said = ada.await_calibrated("full")
    ada.quit()
    return said


@pytest.fixture(scope="module")
def worn(calibrated: str, hall: World, start: Start) -> Session:
    """Ada has worn the suit again: an instructor's calibration, poses, a pulled plug, poses."""
    assert calibrated
    raw = hall.folder / "suit.raw"
    ada = start("ada", TWO, ["--person=ada", f"--suit-record={raw}"])
    ada.client.await_text("was plugged in")
    ada.client.await_text("joined")
    _await_masters(ada.client, 1)
    orders = "--orders=calibrate-quick:ada"
    instructor = hall.client("instructor", orders, "--name=Ida")
    instructor.await_text("ada: calibrating")
    ada.client.await_text(": limbs are off by about")
    instructor.await_text("ada: calibrated, ")
    assert instructor.end() == 0, instructor.log()
    moving = _record_poses(hall, ada, "moving")
    ada.command("unplug")
    ada.client.await_text("was unplugged", count=2)
    await_people(ada.client, {"ada"})
    ada.command("plug")
    _await_masters(ada.client, 2)
    again = _record_poses(hall, ada, "again")
    ada.quit()
    return Session(ada.client.log(), moving, again, raw)


def _await_masters(client: Process, count: int) -> None:
    for master in MASTERS:
        client.await_text(f"Xbus Master {master} measures", count=count)


def _record_poses(world: World, ada: Suit, name: str) -> Path:
    """Lets Ada strike the poses until an observer has seen her in them, one after the other."""
    file = world.folder / name
    observer = world.client("observer", f"--record={file}", name=name)
    for number in range(TRIES):
        for moment in POSES:
            ada.strike(moment)
            # Longer each time: on a busy machine the trainee's samples come late.
            _await_snapshots(observer, REST * min(number + 1, 3))
        if _is_seen(file):
            break
    assert observer.end() == 0, observer.log()
    return file


def _await_snapshots(observer: Process, count: int) -> None:
    before = observer.fresh_report()["snapshots"]
    observer.await_report(lambda seen: seen["snapshots"] > before + count)


def _is_seen(recording: Path) -> bool:
    found = find_poses(recording, "ada", POSES)
    print(found)
    return all(pose["is_struck"] for pose in found)


def test_a_guided_calibration_is_good_and_kept(calibrated: str, hall: World) -> None:
    assert "not calibrated" not in calibrated
    off = re.search(r"limbs are off by about (\d+)°", calibrated)
    assert off is not None and int(off[1]) <= 4, calibrated
    (file,) = profiles_in(hall.folder / "DATA")
    kept = json.loads(file.read_text(encoding="utf-8"))
    assert kept["name"] == "ada"
    assert file.stem == "ada"


def test_the_next_session_needs_no_calibration(worn: Session) -> None:
    assert "ada: as kept in" in worn.said
    before = worn.said.split("was asked")[0]
    assert "calibrating (full)" not in before


def test_an_instructor_lets_the_wearer_be_calibrated(worn: Session) -> None:
    assert "calibrating (quick reset)" in worn.said
    assert ": limbs are off by about" in worn.said


def test_an_observer_sees_the_wearer_move_as_the_wearer_does(worn: Session) -> None:
    assert _is_seen(worn.moving)


def test_a_pulled_plug_ends_nothing(worn: Session, hall: World) -> None:
    assert worn.said.count("was unplugged") == 2
    # Everybody is as before: the same trackers on the same limbs, calibrated.
    assert _is_seen(worn.again)
    assert "ERROR" not in worn.said
    assert "ERROR" not in hall.processes[0].log()


def test_a_recorded_suit_moves_somebody_as_the_suit_did(
    worn: Session, hall: World, display: dict[str, str]
) -> None:
    """Its panel has a row for each of 17 sensors, besides titles, devices and keys."""
    options = ["--role=trainee", "--quality=low", "--panel=1", "--person=ada"]
    window = Window(
        hall, display, *options, f"--suit-play={worn.raw}", name="played", size=(1280, 720)
    )
    window.process.await_text("recording suit.raw")
    file = hall.folder / "played.rec"
    observer = hall.client("observer", f"--record={file}", name="observer-played")
    # Without sensors there are seven lines.
    window.await_picture(lambda seen: lines_of_text(seen) >= 24, "rows of sensors")
    for _ in range(TRIES):
        _await_snapshots(observer, 4 * REST)
        if _is_seen(file):
            break
    else:
        pytest.fail("the poses are not played")
    assert observer.end() == 0, observer.log()
    window.close()
    assert "ERROR" not in window.process.log()


def lines_of_text(picture: Picture) -> int:
    """How many lines of bright text the left half of a picture has."""
    bright = (picture[:, :640].min(axis=2) > 150).sum(axis=1) > 8
    return int((bright[1:] & ~bright[:-1]).sum())


@pytest.mark.parametrize(
    ("emulator", "words"),
    [
        (["--sensors=3", "--devices=native", "--forbidden"], ["permission", ".rules", "udevadm"]),
        (["--devices=awinda"], ["MVN", "--source=mvn"]),
    ],
)
def test_what_cannot_be_used_is_said(start: Start, emulator: list[str], words: list[str]) -> None:
    bert = start("bert", emulator, [])
    bert.client.await_text(words[0])
    bert.client.await_text("joined")
    told = [line for line in bert.client.log().splitlines() if words[0] in line]
    assert all(word in told[0] for word in words)
    assert "WARN" in told[0]
    bert.quit()


def test_without_a_suit_there_is_a_hint(hall: World) -> None:
    trainee = hall.client("trainee", "--xbus=1", name="without")
    trainee.await_text("no suit on USB yet")
    assert trainee.end() == 0
    assert "ERROR" not in trainee.log()


def test_a_file_for_each_of_two_people(hall: World) -> None:
    files = ",".join(str(WALK.parent / name) for name in ("01_01.bvh", "Boxing_Toes.bvh"))
    trainee = hall.client("trainee", f"--bvh={files}", name="both")
    trainee.await_text("joined")
    await_people(trainee, {"01_01", "Boxing_Toes"})
    file = hall.folder / "both.rec"
    observer = hall.client("observer", f"--record={file}", name="observer-both")
    _await_snapshots(observer, 4 * REST)
    assert observer.end() == 0, observer.log()
    found = recorded(file)
    assert set(found) - {"ada"} == {"01_01", "Boxing_Toes"}
    assert all(turned(found[name]) > 10.0 for name in ("01_01", "Boxing_Toes"))
