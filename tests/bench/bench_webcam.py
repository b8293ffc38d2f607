# SPDX-License-Identifier: MIT
"""How well a webcam captures: our own people, filmed in our own worlds, against what is true.

Each film shows one of 4 builds, moved by one of 8 pieces of clips, in one of 3 worlds from one of
6 places of the camera; the webcam's own helper looks through it, the client's own solver makes
poses. Errors are angles: of the directions of arms and legs, of the rotations of pelvis and chest.
Then the helper runs in real time beside a server and a client on two processors. The camera's field
of view is given, how far it looks down is not. Films are kept in build/webcam.

Options: --films=24 (of 144; all are different, 8 show each clip once), --foreign (8 other pieces of
the clips, on which nothing was tuned), --seconds=20 (of the run in real time; 0: none). It needs
./run webcam --setup, and draws films for 15 minutes on two processors.
"""

from __future__ import annotations

import hashlib
import json
import os
import socket
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from statistics import mean
from typing import Any

from bench import SOFTWARE, Bench, Options, main
from toolchain import webcam
from toolchain.console import Failure, step
from toolchain.display import virtual_display
from toolchain.paths import BUILD, CLIENT_BINARY, CLIPS, ROOT, SERVER_BINARY, cache, make_folder
from toolchain.processes import free_port

FILM = "res://tests/bench/webcam/film.gd"
JUDGE = "res://tests/bench/webcam/judge.gd"
RATE = 15
SECONDS = 8
WORLDS = ("yard", "hangar", "hall")
PLACES = ("screen", "desk", "shelf", "side", "far", "low")
BUILDS = ("soldier", "civilian_woman", "civilian_man", "instructor")
# Where the person looks beside the camera at first, degrees.
TURNS = (0, 20, -25, 40, -15, 10, -35, 30)
# A clip, where it begins, s, and the share of its way over the floor that is gone.
TUNED = (
    *(("Boxing_Toes", 0.0, 1.0), ("Boxing_Toes", 12.0, 1.0), ("Boxing_Toes", 20.0, 1.0)),
    *(("01_01", 0.0, 0.3), ("01_01", 8.0, 0.5)),
    *(("01_03", 0.0, 0.3), ("01_03", 16.0, 0.4), ("01_03", 28.0, 0.4)),
)
FOREIGN = (
    *(("Boxing_Toes", 6.0, 1.0), ("Boxing_Toes", 9.0, 1.0), ("Boxing_Toes", 16.0, 1.0)),
    *(("01_01", 4.0, 0.3), ("01_01", 14.0, 0.5)),
    *(("01_03", 5.0, 0.4), ("01_03", 20.0, 0.4), ("01_03", 32.0, 1.0)),
)
# The engine's own environment has another cache folder.
USER = {"DISMOUNT_USER_CACHE": str(cache().parent)}
# Goals of issue 35.
MAX_UPPER_DEG = 12.0
MAX_LEGS_DEG = 15.0
MIN_SEEN = 0.95
MAX_DELAY_MS = 50.0
MIN_RATE = 20.0


@dataclass(frozen=True)
class Shot:
    """A film that is to be made."""

    name: str
    clip: tuple[str, float, float]
    world: str
    place: str
    build: str
    turn: int

    def arguments(self) -> list[str]:
        """What the script that films takes."""
        clip, begin, travel = self.clip
        return [
            *(f"--world={self.world}", f"--avatar={self.build}", f"--place={self.place}"),
            *(f"--clip={CLIPS / clip}.bvh", f"--from={begin}", f"--travel={travel}"),
            *(f"--turn={self.turn}", f"--rate={RATE}", f"--seconds={SECONDS}"),
        ]


def measure(arguments: list[str]) -> int:
    """Makes the films that are not there yet, looks through them, and prints how well."""
    options = Options(arguments, {"films": 24, "foreign": False, "seconds": 20.0})
    if not webcam.is_ready():
        raise Failure("The webcam's environment is not there: ./run webcam --setup makes it.")
    bench = Bench("webcam", options.json, export=options["seconds"] > 0.0)
    shots = plan(FOREIGN if options["foreign"] else TUNED)[: options["films"]]
    films = make_films(bench, shots)
    measure_poses(bench, films)
    if options["seconds"] > 0.0:
        measure_live(bench, films[0], options["seconds"])
    return bench.finish()


def plan(clips: tuple[tuple[str, float, float], ...]) -> list[Shot]:
    """All films: each clip in each world from each place."""
    shots = []
    for number in range(len(clips) * len(WORLDS) * len(PLACES)):
        clip, rest = number % len(clips), number // len(clips)
        world, turn_of = rest % len(WORLDS), rest // len(WORLDS)
        place = PLACES[(clip + 2 * world + turn_of) % len(PLACES)]
        build = BUILDS[(clip + world + turn_of) % len(BUILDS)]
        turn = TURNS[(3 * clip + world + turn_of) % len(TURNS)]
        name = f"{clips[clip][0]}-{clips[clip][1]:.0f}-{WORLDS[world]}-{place}-{build}"
        shots.append(Shot(name, clips[clip], WORLDS[world], place, build, turn))
    return shots


def make_films(bench: Bench, shots: list[Shot]) -> list[Path]:
    """The films of shots: those that are not there are made."""
    script = (ROOT / FILM.removeprefix("res://")).read_bytes()
    wanted = []
    for shot in shots:
        key = hashlib.sha256(script + " ".join(shot.arguments()).encode()).hexdigest()[:12]
        wanted.append((shot, make_folder(BUILD / "webcam") / f"{shot.name}-{key}.avi"))
    missing = [(shot, film) for shot, film in wanted if not film.with_suffix(".json").exists()]
    if missing:
        with virtual_display(keeps_shaders=True) as display:
            display["LP_NUM_THREADS"] = str(os.cpu_count() or 1)
            for number, (shot, film) in enumerate(missing):
                with step(f"film {number + 1} of {len(missing)}: {shot.name}"):
                    draw(bench, shot, film, display)
    return [film for _shot, film in wanted]


def draw(bench: Bench, shot: Shot, film: Path, display: dict[str, str]) -> None:
    """Draws one film, and writes what is true of it beside."""
    movie = ["--write-movie", str(film), "--fixed-fps", str(RATE), "-s", FILM, "--"]
    truth = film.with_suffix(".part")
    command = bench.command(*SOFTWARE, *movie, *shot.arguments(), f"--truth={truth}")
    bench.run(command, display, limit_s=900.0)
    truth.rename(film.with_suffix(".json"))


def helper(film: Path, *flags: str) -> list[str]:
    """The command of the webcam's helper for a film."""
    return [sys.executable, str(webcam.FOLDER), "run", f"--pictures={film}", *flags]


def measure_poses(bench: Bench, films: list[Path]) -> None:
    """Adds the errors of the poses in films."""
    pairs = []
    with step(f"look through {len(films)} films"):
        for film in films:
            found, _said = bench.run(helper(film, "--every-picture", "--threads=2"), USER)
            film.with_suffix(".jsonl").write_text(found, encoding="utf-8")
            pairs.append(f"{film.with_suffix('.jsonl')},{film.with_suffix('.json')}")
    rows = bench.rows(bench.command("--headless", "-s", JUDGE, "--", *pairs))
    if len(rows) != len(films):
        raise Failure(f"{len(rows)} of {len(films)} films were judged.")
    for row in rows:
        add_errors(bench, row["film"].rpartition("-")[0], [row], has_goals=False)
    add_errors(bench, "all", rows, has_goals=True)


def add_errors(bench: Bench, case: str, rows: list[dict[str, Any]], has_goals: bool) -> None:
    """Adds the errors of films, each of the same weight."""

    def average(key: str) -> float:
        return mean(row[key] for row in rows)

    def goal(value: float) -> float | None:
        return value if has_goals else None

    stats = bench.stats
    # Four parts of arms and two of the trunk.
    upper = (4.0 * average("arms") + 2.0 * average("trunk")) / 6.0
    stats.add(case, "arms and trunk", upper, "deg", at_most=goal(MAX_UPPER_DEG))
    stats.add(case, "legs", average("legs"), "deg", at_most=goal(MAX_LEGS_DEG))
    if has_goals:
        stats.add(case, "arms", average("arms"), "deg")
        stats.add(case, "trunk", average("trunk"), "deg")
        stats.add(case, "place on the floor", average("place_m"), "m")
        stats.add(case, "a pose of landmarks", average("solve_ms"), "ms")
        in_view = max(sum(row["frames"] for row in rows), 1)
        seen = sum(row["seen"] * row["frames"] for row in rows) / in_view
        stats.add(case, "seen of frames in view", seen, "share", at_least=MIN_SEEN)


def measure_live(bench: Bench, film: Path, seconds: float) -> None:
    """Runs the helper over a film in real time beside a server and a client."""
    port = free_port()
    with bench.session() as (group, _folder):
        server = [str(SERVER_BINARY), "--headless", "--", "--role=server", f"--port={port}"]
        group.start("server", server)
        group.await_text("server", "listening on UDP port", 60)
        group.start(
            "client", [str(CLIENT_BINARY), "--headless", "--", "--role=observer", f"--port={port}"]
        )
        group.await_text("client", "joined", 60)
        delays = listen(film, seconds)
    stats = bench.stats
    stats.add("live", "frame to landmarks", mean(delays), "ms", at_most=MAX_DELAY_MS)
    worst = sorted(delays)[int(0.95 * len(delays))]
    stats.add("live", "frame to landmarks, 95 %", worst, "ms")
    stats.add("live", "poses", len(delays) / seconds, "1/s", at_least=MIN_RATE)


def listen(film: Path, seconds: float) -> list[float]:
    """How old each person's landmarks are when they come, ms."""
    delays: list[float] = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(1.0)
        # A film at its own 15 pictures a second would say nothing of how many a processor manages.
        command = helper(film, f"--port={receiver.getsockname()[1]}", "--rate=30")
        with subprocess.Popen(command, stderr=subprocess.DEVNULL) as process:
            try:
                begin: float | None = None
                while begin is None or time.monotonic() < begin + seconds:
                    data = receiver.recv(65536) if process.poll() is None else b""
                    message = json.loads(data) if data[:1] == b"{" else {}
                    if "world_landmarks" in message:
                        begin = begin or time.monotonic()
                        delays.append((time.time() - message["time"]) * 1000.0)
                    elif not data:
                        raise Failure("The webcam's helper has ended.")
            finally:
                process.terminate()
    return delays


if __name__ == "__main__":
    main(measure)
