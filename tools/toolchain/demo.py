# SPDX-License-Identifier: MIT
"""The main job: an exported server, a trainee who moves by a real clip, and an observer."""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
import time
from pathlib import Path

from .console import Failure, say, step
from .display import real_display, virtual_display
from .nearest import options_in, unknown_option
from .paths import CLIENT_BINARY, CLIPS, OUT, SERVER_BINARY, make_folder
from .processes import Group, require_port
from .project import prepare

FILM_S = 5.0
FILM_FPS = 24
CLIP = CLIPS / "01_01.bvh"
# Where our clip begins, s: so the crates fall 2.3 s, or 4.3 s, after the trainee has joined.
CLIP_FROM_S = 4.0
CLIP_FROM_IN_WINDOWS_S = 2.0
# Where the film begins after that, s: then the body is there.
FILM_AFTER_S = 0.5
CAMERA = "--camera=60,10,3.5"
# When the physics world is seen, s of the film, or of the observer's window.
PHYSICS_IN_FILM = "--physics-at=1.2,3.6"
PHYSICS_IN_WINDOW = "--physics-at=3,9"
SOFTWARE = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]
SMALL = ["--resolution", "640x360"]
FILM_SIZE = ["--resolution", "960x540"]
# Parts of the names by which OpenGL calls what draws without a graphics card.
SOFTWARE_RENDERERS = ("llvmpipe", "softpipe", "swrast", "swiftshader")
SLOW = """
The observer's frames were drawn by the processor (software rendering), so they are few, and each
sample waits for the next one: that is most of the time from sample to display. A graphics card
draws 60 frames a second and more. ./run latency measures the delays without drawing."""

HELP = """Options of ./run demo, and of ./run without a command
  --port=NUMBER             UDP port of the session, 1 to 65535 (7777)
  --bvh=FILE                the trainee's motion (assets/motion/01_01.bvh)
  --seconds=S               length of the session without a display, 3 to 3600 (12)
"""


class Settings:
    """Options of `./run` without a command."""

    def __init__(self, arguments: list[str]) -> None:
        values = {
            "port": os.environ.get("DISMOUNT_PORT", "7777"),
            "bvh": os.environ.get("DISMOUNT_BVH", str(CLIP)),
            "seconds": "12",
        }
        for argument in arguments:
            name, _, value = argument.removeprefix("--").partition("=")
            if name not in values or not value:
                raise Failure(unknown_option("./run", argument, options_in(HELP)), 2)
            values[name] = value
        if not values["port"].isdigit() or not 0 < int(values["port"]) < 65536:
            raise Failure(f"A port is a number from 1 to 65535, found '{values['port']}'.", 2)
        try:
            self.seconds = float(values["seconds"])
        except ValueError:
            raise Failure(f"--seconds expects a number, found '{values['seconds']}'.", 2) from None
        if not 3.0 <= self.seconds <= 3600.0:
            raise Failure("--seconds is between 3 and 3600.", 2)
        self.port = int(values["port"])
        self.bvh = values["bvh"]
        if not Path(self.bvh).is_file():
            raise Failure(f"There is no motion file {self.bvh}: name one with --bvh=FILE.", 2)


def main(arguments: list[str]) -> int:
    """Shows Dismount: in windows, or by a picture, a film and stats."""
    settings = Settings(arguments)
    require_port(settings.port)
    prepare(export=True)
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        work = Path(folder)
        if real_display():
            stats = _show(settings, work)
        else:
            with virtual_display() as environment:
                stats = _measure(settings, work, environment)
    print_table(stats)
    if not real_display():
        print(f"\npicture  {OUT / 'observer.png'}\nfilm     {OUT / 'observer.avi'}")
    return 0


def _command(binary: Path, role: str, settings: Settings, work: Path, *more: str) -> list[str]:
    flags = [] if role != "server" else ["--headless"]
    report = f"--report={work / role}.json"
    options = [f"--role={role}", f"--port={settings.port}", report, *more]
    return [str(binary), *flags, "--", *options]


def _start_server(group: Group, settings: Settings, work: Path, *more: str) -> None:
    require_port(settings.port)
    group.start("server", _command(SERVER_BINARY, "server", settings, work, *more))
    group.await_text("server", "listening on UDP port", 30)


def _trainee(settings: Settings, work: Path, from_s: float) -> list[str]:
    """The command of the trainee; our own clip begins where something is about to happen."""
    begin = from_s if Path(settings.bvh) == CLIP else 0.0
    options = (f"--bvh={settings.bvh}", f"--bvh-from={begin}")
    return _command(CLIENT_BINARY, "trainee", settings, work, *options)


def _show(settings: Settings, work: Path) -> dict[str, dict]:
    with Group(work, {}) as group:
        _start_server(group, settings, work)
        group.start("trainee", _trainee(settings, work, CLIP_FROM_IN_WINDOWS_S))
        group.await_text("trainee", "joined", 60)
        options = (CAMERA, PHYSICS_IN_WINDOW)
        group.start("observer", _command(CLIENT_BINARY, "observer", settings, work, *options))
        say(f"Running on UDP port {settings.port}. Close a window, or press Ctrl+C, to end.")
        with contextlib.suppress(KeyboardInterrupt):
            group.await_any_exit(["trainee", "observer", "server"])
        return _read_reports(work)


def _measure(settings: Settings, work: Path, environment: dict[str, str]) -> dict[str, dict]:
    make_folder(OUT)
    (OUT / ".gdignore").touch()  # The editor is not to import our pictures.
    recording = work / "session.dismount"
    watch = step(f"run server, trainee and observer for {settings.seconds:.0f} s")
    with Group(work, environment) as group, watch:
        _start_server(group, settings, work, f"--record={recording}")
        begin = time.monotonic()
        # On two cores without a GPU a second window would slow down everything.
        trainee = _trainee(settings, work, CLIP_FROM_S)
        group.start("trainee", [trainee[0], "--headless", *trainee[1:]])
        # In the new world, where its body is made.
        group.await_text("trainee", "is there after", 60)
        film_from = time.monotonic() - begin + FILM_AFTER_S
        observer = _command(
            CLIENT_BINARY,
            "observer",
            settings,
            work,
            f"--duration={settings.seconds}",
        )
        group.start("observer", [observer[0], *SOFTWARE, *SMALL, *observer[1:]])
        group.await_exit("observer", settings.seconds + 60)
        for name in ("server", "trainee"):
            if group.exit_code(name) is not None:
                raise Failure(f"The {name} ended too early:\n{group.log(name)[-2000:]}")
        stats = _read_reports(work)
    # Nothing else runs: the film has all processors.
    drawing = {**environment, "LP_NUM_THREADS": str(os.cpu_count() or 1)}
    with Group(work, drawing) as group, step("film what the observer saw"):
        _film(group, recording, film_from)
    for product in ("observer.png", "observer.avi"):
        if not (OUT / product).is_file():
            raise Failure(f"No {product} was made:\n{group.log('film')[-2000:]}")
    return stats


def _film(group: Group, recording: Path, from_s: float) -> None:
    """Renders the beginning of the session anew: in real time software rendering would stutter."""
    (OUT / "observer.png").unlink(missing_ok=True)
    (OUT / "observer.avi").unlink(missing_ok=True)
    film = ["--write-movie", str(OUT / "observer.avi"), "--fixed-fps", str(FILM_FPS)]
    options = ["--role=replay", f"--file={recording}", f"--duration={FILM_S}"]
    options += [f"--from={from_s:.2f}", CAMERA, PHYSICS_IN_FILM]
    # A processor draws it: one tier lower takes half the time.
    options.append("--quality=medium")
    options.append(f"--screenshot={OUT / 'observer.png'}")
    group.start("film", [str(CLIENT_BINARY), *SOFTWARE, *FILM_SIZE, *film, "--", *options])
    group.await_exit("film", 480)


def _read_reports(work: Path) -> dict[str, dict]:
    reports: dict[str, dict] = {}
    for role in ("server", "trainee", "observer"):
        file = work / f"{role}.json"
        if not file.exists():
            raise Failure(f"The {role} left no stats: the session was too short.")
        reports[role] = json.loads(file.read_text(encoding="utf-8"))
    return reports


def print_table(stats: dict[str, dict]) -> None:
    """Prints what was measured."""
    server, trainee, observer = (stats[role] for role in ("server", "trainee", "observer"))
    person = server["people"][0] if server["people"] else {"mean_deg": 0.0, "p95_deg": 0.0}
    rows = [
        ("server tick rate held", f"{server['ticks_per_second']:.1f} /s"),
        ("tracking error, mean", f"{person['mean_deg']:.2f} deg"),
        ("tracking error, p95", f"{person['p95_deg']:.2f} deg"),
        ("trainee, up", f"{trainee['sent_bytes_per_second']:.0f} bytes/s"),
        ("observer, down", f"{observer['received_bytes_per_second']:.0f} bytes/s"),
        ("observer, up", f"{observer['sent_bytes_per_second']:.0f} bytes/s"),
        ("observer, frames", f"{observer['frames_per_second']:.1f} /s"),
        ("sample to display, mean", f"{observer['latency_ms_mean']:.1f} ms"),
        ("sample to display, p95", f"{observer['latency_ms_p95']:.1f} ms"),
    ]
    print()
    for name, value in rows:
        print(f"{name:<26}{value:>16}")
    if any(word in observer["renderer"].lower() for word in SOFTWARE_RENDERERS):
        print(SLOW)
