# SPDX-License-Identifier: MIT
"""The webcam's helper as a process: what it says without its environment, and, where that was made,
what it sees. The latter needs what `./run webcam --setup` fetches, which no test does."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from toolchain import webcam
from toolchain.paths import CLIENT_BINARY, ROOT, cache

from .conftest import Process, World

# Two people are in a part of it.
AVATARS = ROOT / "docs" / "pictures" / "avatars.png"
CROP = """
import cv2, sys
part = cv2.imread(sys.argv[1])[675:900, 0:400]
cv2.imwrite(sys.argv[2], cv2.resize(part, None, fx=3, fy=3))
"""
# How far landmarks in a mirror are from the others: the mean, and the furthest, as shares of the
# square that is looked at.
MIRROR = """
import cv2, sys
sys.path.insert(0, "tools")
import numpy as np
from webcam import environment
from webcam.models import Detector, Landmarker
picture = cv2.cvtColor(cv2.imread(sys.argv[1]), cv2.COLOR_BGR2RGB)
region = Detector(environment.models(), 1).find(picture, 1)[0]
model = Landmarker(environment.models(), 1)
plain, mirrored = model.find(picture, region), model.find(picture, region, is_mirrored=True)
off = np.hypot(*(plain.image - mirrored.image)[:, :2].T) / region.size
deep = np.linalg.norm((plain.world - mirrored.world)[:, :3], axis=1)
near = np.hypot(plain.next_region.x - mirrored.next_region.x,
                plain.next_region.y - mirrored.next_region.y) / region.size
print(off.mean(), off.max(), deep.mean(), near)
"""
FOLDER_OF = """
import sys
sys.path.insert(0, "tools")
from webcam import environment
print(environment.folder())
"""
LIMIT_S = 60.0
NOT_READY = 3

needs_environment = pytest.mark.skipif(
    not webcam.is_ready(), reason="./run webcam --setup was not run on this machine"
)


@pytest.fixture(scope="module")
def people(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A picture of two people; a film of one picture is one, too."""
    picture = tmp_path_factory.mktemp("people") / "people.png"
    folder = subprocess.check_output([sys.executable, "-c", FOLDER_OF], text=True).strip()
    python = str(Path(folder) / "bin" / "python3")
    subprocess.run([python, "-c", CROP, str(AVATARS), str(picture)], check=True)
    return picture


@contextmanager
def helper(
    pictures: str | Path, *flags: str, environment: dict[str, str] | None = None
) -> Iterator[tuple[subprocess.Popen[bytes], Callable[[], dict[str, Any]]]]:
    """A helper, and what gets the next message of it."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(LIMIT_S)
        port = receiver.getsockname()[1]
        command = [sys.executable, str(webcam.FOLDER), "run", f"--pictures={pictures}"]

        def take() -> dict[str, Any]:
            while not (data := receiver.recv(65536)).startswith(b"{"):
                assert data.startswith(b"\xff\xd8")
            return dict(json.loads(data))

        with subprocess.Popen(
            [*command, f"--port={port}", *flags], env={**os.environ, **(environment or {})}
        ) as process:
            try:
                yield process, take
            finally:
                process.kill()


def await_fault(take: Callable[[], dict[str, Any]], words: str) -> None:
    """Waits until the helper says something."""
    end = time.monotonic() + LIMIT_S
    said: list[str] = []
    while time.monotonic() < end:
        said = take().get("status", {}).get("faults", [])
        if any(words in one for one in said):
            return
    raise AssertionError(f"'{words}' was not said, but {said}")


def trainee(world: World, pictures: Path, environment: dict[str, str]) -> Process:
    """A client whose motion is that of the people in a picture."""
    command = [str(CLIENT_BINARY), "--headless", "--", "--role=trainee", f"--port={world.port}"]
    named = {webcam.VARIABLE: str(webcam.FOLDER), **environment}
    return world.start("trainee", [*command, f"--source=webcam:{pictures}"], named)


@pytest.mark.parametrize(
    ("pictures", "words"),
    [("/nowhere/film.avi", "there is no film /nowhere/film.avi"), ("63", "there is no camera 63")],
)
def test_what_is_not_there_is_told_without_the_environment(
    tmp_path: Path, pictures: str, words: str
) -> None:
    nothing = {"XDG_CACHE_HOME": str(tmp_path), "DISMOUNT_USER_CACHE": str(tmp_path)}
    with helper(pictures, environment=nothing) as (process, take):
        await_fault(take, words)
        assert process.poll() is None


def test_a_missing_environment_is_an_exit_code_and_a_sentence_of_the_client(
    tmp_path: Path, world: World
) -> None:
    nothing = {"XDG_CACHE_HOME": str(tmp_path), "DISMOUNT_USER_CACHE": str(tmp_path)}
    with helper(AVATARS, environment=nothing) as (process, _take):
        assert process.wait(LIMIT_S) == NOT_READY
    world.server()
    client = trainee(world, AVATARS, nothing)
    client.await_text("not set up yet")
    assert "setup' once" in client.log()


def test_it_ends_with_its_client() -> None:
    # Not our child's parent: as if the client had ended.
    with helper("/nowhere/film.avi", "--parent=1") as (process, _take):
        assert process.wait(LIMIT_S) == 0


@needs_environment
def test_people_in_a_picture_are_seen_and_too_many_are_told(people: Path) -> None:
    with helper(people, "--people=2", "--rate=20") as (_process, take):
        seen: dict[int, dict[str, Any]] = {}
        end = time.monotonic() + LIMIT_S
        while len(seen) < 2 and time.monotonic() < end:
            message = take()
            if "world_landmarks" in message:
                seen[message["person"]] = message
        assert len(seen) == 2
        for message in seen.values():
            assert len(message["world_landmarks"]) == len(message["landmarks"]) == 33
            assert abs(message["time"] - time.time()) < 10.0
            nose, ankle = message["landmarks"][0], message["landmarks"][27]
            assert nose[1] < ankle[1]
    with helper(people, "--rate=20") as (_process, take):
        await_fault(take, "2 people are in the picture, and only one of them moves")


@needs_environment
def test_left_is_left_in_a_mirror_too(people: Path) -> None:
    folder = subprocess.check_output([sys.executable, "-c", FOLDER_OF], text=True).strip()
    command = [str(Path(folder) / "bin" / "python3"), "-c", MIRROR, str(people)]
    found = subprocess.check_output(command, text=True, cwd=ROOT, stderr=subprocess.DEVNULL)
    mean, furthest, deep_m, near = map(float, found.split())
    # Shoulders are a sixth of the square apart.
    assert 0.0 < mean < 0.03
    assert furthest < 0.1
    assert deep_m < 0.12
    assert near < 0.05


@needs_environment
def test_a_broken_film_and_a_dark_one_are_told(tmp_path: Path) -> None:
    broken = tmp_path / "broken.avi"
    broken.write_bytes(b"RIFF" + bytes(5000))
    with helper(broken) as (_process, take):
        await_fault(take, "broken or no film")
    dark = tmp_path / "dark.ppm"
    dark.write_bytes(b"P6 320 180 255\n" + bytes(320 * 180 * 3))
    with helper(dark, "--rate=5") as (_process, take):
        await_fault(take, "the picture is dark")
        await_fault(take, "nobody is in the picture")
        await_fault(take, "only 5 pictures a second")


@needs_environment
def test_who_is_in_a_film_moves_in_the_world(world: World, people: Path) -> None:
    server = world.server()
    client = trainee(world, people, {"DISMOUNT_USER_CACHE": str(cache().parent)})
    client.await_text("Webcam:  at 127.0.0.1")
    server.await_report(lambda report: len(report["people"]) == 1)
