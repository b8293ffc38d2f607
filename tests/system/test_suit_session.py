# SPDX-License-Identifier: MIT
"""Somebody in an (emulated) suit, from the first calibration to a recording that is played."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from toolchain.suit_session import compare

from .conftest import WINDOW_LIMIT_S, World
from .pictures import Picture, read_png
from .suits import (
    WALK,
    Suit,
    await_people,
    engine,
    needs_emulator,
    profiles_in,
    recorded,
    suits_of,
    take_over,
    turned,
)

pytestmark = needs_emulator

# Two masters, trackers at any angle, norths that differ by up to 30 degrees.
TWO = ["--sensors=17", "--devices=two-masters", "--heading=30"]
MASTERS = ("00130500", "00130501")
ARMS_AND_TRUNK = ["LeftUpperArm", "LeftLowerArm", "RightUpperArm", "RightLowerArm", "Hips", "Chest"]


class Past(NamedTuple):
    """What an earlier session has left."""

    folder: Path
    said: str
    # When the clip began, s after the suit was opened.
    clip_s: float = 0.0


@pytest.fixture(scope="module")
def calibrated(tmp_path_factory: pytest.TempPathFactory) -> Past:
    """Ada has been calibrated, guided by the texts on the screen."""
    world = World(tmp_path_factory.mktemp("calibration"))
    try:
        world.server()
        with suits_of(world) as start:
            ada = start("ada", TWO, ["--person=ada", "--calibrate=full"])
            said = ada.await_calibrated("full")
            ada.quit()
    finally:
        world.close()
    return Past(world.folder, said)


@pytest.fixture(scope="module")
def played(calibrated: Past, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Past]:
    """Ada has worn the suit again; what the suit said is recorded."""
    world = World(tmp_path_factory.mktemp("session"))
    take_over(calibrated.folder / "DATA", world)
    try:
        server = world.server()
        with suits_of(world) as start:
            options = ["--person=ada", f"--suit-record={world.folder / 'suit.raw'}"]
            ada = start("ada", TWO, options)
            clip_s = _play(world, ada)
            ada.quit()
        assert "ERROR" not in server.log()
    finally:
        world.close()
    yield Past(world.folder, ada.client.log(), clip_s)


def _play(world: World, ada: Suit) -> float:
    """What happens in that session: an instructor's calibration, motion, and a pulled plug."""
    ada.client.await_text("was plugged in")
    begin = time.monotonic()
    ada.client.await_text("joined")
    _await_masters(ada, 1)
    orders = "--orders=calibrate-quick:ada"
    instructor = world.client("instructor", orders, "--name=Ida", "--duration=20")
    instructor.await_text("ada: calibrating")
    ada.client.await_text(": limbs are off by about")
    ada.command("clip")
    clip_s = time.monotonic() - begin
    _observe(world, "moving", 8)
    ada.command("hold")
    time.sleep(1)
    ada.command("unplug")
    ada.client.await_text("was unplugged")
    time.sleep(1)
    await_people(ada.client, {"ada"})
    ada.command("plug")
    _await_masters(ada, 2)
    ada.command("clip")
    time.sleep(1)
    _observe(world, "again", 6)
    return clip_s


def _await_masters(ada: Suit, count: int) -> None:
    for master in MASTERS:
        ada.client.await_text(f"Xbus Master {master} measures", count=count)


def _observe(world: World, name: str, seconds: int) -> None:
    observer = world.client("observer", f"--record={world.folder / name}", name=name)
    # Of a busy machine's ticks as many.
    observer.await_report(lambda seen: seen["snapshots"] > 60 * seconds)
    assert observer.end() == 0, observer.log()


def _check_moves_as_the_clip(recording: Path) -> None:
    # Lower quartiles: on a busy machine the world is too slow at times, and bodies lag behind. A
    # limb that is mixed up with another is far off at nearly all times; `./run bench suit` measures
    # how well it follows.
    found = compare(engine(), recording, WALK, 0.0, 1e9, slack_s=0.5)["quartiles"]
    measured = [error for bone, error in found.items() if bone != "Spine"]
    assert sum(measured) / len(measured) < 12.0, found
    assert all(found[bone] < 15.0 for bone in ARMS_AND_TRUNK), found


def test_a_guided_calibration_is_good_and_kept(calibrated: Past) -> None:
    assert "not calibrated" not in calibrated.said
    off = re.search(r"limbs are off by about (\d+)°", calibrated.said)
    assert off is not None and int(off[1]) <= 4, calibrated.said
    (file,) = profiles_in(calibrated.folder / "DATA")
    kept = json.loads(file.read_text(encoding="utf-8"))
    assert kept["name"] == "ada"
    assert file.stem == "ada"


def test_the_next_session_needs_no_calibration(played: Past) -> None:
    assert "ada: as kept in" in played.said
    before = played.said.split("was asked")[0]
    assert "calibrating (full)" not in before


def test_an_observer_sees_the_wearer_move_as_the_wearer_does(played: Past) -> None:
    _check_moves_as_the_clip(played.folder / "moving")


def test_an_instructor_lets_the_wearer_be_calibrated(played: Past) -> None:
    assert "calibrating (quick reset)" in played.said
    assert ": limbs are off by about" in played.said
    instructor = (played.folder / "instructor.log").read_text(encoding="utf-8")
    assert "ada: calibrating" in instructor
    assert "ada: calibrated, " in instructor


def test_a_pulled_plug_ends_nothing(played: Past) -> None:
    assert played.said.count("was unplugged") == 2
    # Everybody is as before: the same trackers on the same limbs, calibrated.
    _check_moves_as_the_clip(played.folder / "again")
    (entries,) = recorded(played.folder / "again").values()
    assert turned(entries) > 10.0
    assert "ERROR" not in played.said


def test_a_recorded_suit_moves_somebody_as_the_suit_did(world: World, played: Past) -> None:
    take_over(played.folder / "DATA", world)
    world.server()
    options = [f"--suit-play={played.folder / 'suit.raw'}", "--person=ada"]
    client = world.client("trainee", *options)
    client.await_text("recording suit.raw")
    # It stands first, as the wearer did.
    time.sleep(played.clip_s + 0.5)
    _observe(world, "played", 5)
    _check_moves_as_the_clip(world.folder / "played")
    assert "ERROR" not in client.log()


@pytest.mark.parametrize(
    ("emulator", "words"),
    [
        (["--sensors=3", "--devices=native", "--forbidden"], ["permission", ".rules", "udevadm"]),
        (["--devices=awinda"], ["MVN", "--mvn"]),
    ],
)
def test_what_cannot_be_used_is_said(world: World, emulator: list[str], words: list[str]) -> None:
    world.server()
    with suits_of(world) as start:
        ada = start("ada", emulator, [])
        ada.client.await_text(words[0])
        ada.client.await_text("joined")
        told = [line for line in ada.client.log().splitlines() if words[0] in line]
        assert all(word in told[0] for word in words)
        assert "WARN" in told[0]
        ada.quit()


def test_without_a_suit_there_is_a_hint(world: World) -> None:
    world.server()
    trainee = world.client("trainee", "--xbus=1")
    trainee.await_text("no suit on USB yet")
    assert trainee.end() == 0
    assert "ERROR" not in trainee.log()


def test_a_file_for_each_of_two_people(world: World) -> None:
    world.server()
    files = ",".join(str(WALK.parent / name) for name in ("01_01.bvh", "Boxing_Toes.bvh"))
    trainee = world.client("trainee", f"--bvh={files}", "--name=both")
    trainee.await_text("joined")
    await_people(trainee, {"01_01", "Boxing_Toes"})
    _observe(world, "both", 4)
    found = recorded(world.folder / "both")
    assert set(found) == {"01_01", "Boxing_Toes"}
    assert all(turned(entries) > 10.0 for entries in found.values())


def test_the_panel_shows_the_sensors(
    world: World, calibrated: Past, display: dict[str, str]
) -> None:
    """A row for each of 17 sensors, besides titles, devices and keys."""
    take_over(calibrated.folder / "DATA", world)
    world.server()
    target = world.folder / "panel.png"
    options = ["--panel=1", "--person=ada", f"--screenshot={target}"]
    with suits_of(world) as start:
        ada = start("ada", TWO, options, display=display)
        _await_masters(ada, 1)
        frames = ada.client.fresh_report()["shown_frames"]
        ada.client.await_report(lambda seen: seen["shown_frames"] > frames + 8, WINDOW_LIMIT_S)
        ada.quit()
        assert "ERROR" not in ada.client.log()
    # Without sensors there are seven lines.
    assert lines_of_text(read_png(target)) >= 24


def lines_of_text(picture: Picture) -> int:
    """How many lines of bright text the left half of a picture has."""
    bright = (picture[:, :640].min(axis=2) > 150).sum(axis=1) > 8
    return int((bright[1:] & ~bright[:-1]).sum())
