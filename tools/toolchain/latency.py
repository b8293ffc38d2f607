# SPDX-License-Identifier: MIT
"""`./run latency`: measures the delay from sample to display on this machine, and draws it."""

from __future__ import annotations

import csv
import json
import os
import subprocess
import tempfile
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

from .console import Failure, step, tail
from .display import virtual_display
from .godot import Godot
from .nearest import options_in, suggest, unknown_option
from .paths import CLIENT_BINARY, CLIPS, OUT, ROOT, SERVER_BINARY, make_folder
from .processes import Group, require_port
from .project import prepare

PLOT = "res://scripts/display/latency/latency_plot.gd"
SOFTWARE = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]
CSV = "latency.csv"
PICTURE = "latency.png"
SMOOTHING = ("none", "linear", "hermite", "extrapolate_lerp", "error_offset", "adaptive_low_delay")

# What an observer's window can show the world in, where there is no headset and no second monitor.
DISPLAYS = (
    "window",
    "side-by-side",
    "side-by-side-full",
    "top-bottom",
    "top-bottom-full",
    "anaglyph",
    "rows",
    "columns",
    "checkerboard",
    "windows",
    "left",
    "right",
    "wall",
)
# Small enough that the processor draws 15 frames a second.
WINDOW = "320x180"
# One screen straight ahead, of the window's shape.
LAYOUT = """[station]
eye = 0 1.65 0
[screen front]
bottom-left = {left} 1.2 -1
bottom-right = {right} 1.2 -1
top-left = {left} 2.1 -1
position = 0 0
size = {width} {height}
"""

HELP = """./run latency [options]

Measures the delay from sample to display on this machine, stage by stage: a server, a trainee who
moves by a file, and an observer of a fixed frame rate. Prints a table; leaves out/latency.csv and
out/latency.png. docs/latency.md says what the stages are.

  --seconds=S           length of the measurement, 3 to 3600 (20)
  --rate=N              samples a second of the trainee, 1 to 240 (60)
  --fps=N               frames a second of the clients, 1 to 1000 (60)
  --smoothing=NAME      the observer's method for the motion between updates: none, linear, hermite,
                        extrapolate_lerp, error_offset, adaptive_low_delay (the default)
  --bvh=FILE            the motion (assets/motion/01_01.bvh)
  --display=NAME        the observer has a window, drawn by the processor on a virtual display, that
                        shows the world in this way: window, wall (one screen), side-by-side,
                        anaglyph, ... (none: no window)
  --port=NUMBER         UDP port of the session, 1 to 65535 (7777)
"""


@dataclass(frozen=True)
class Window:
    """An observer's window on a virtual display: how it shows the world, its size in pixels."""

    display: str = "window"
    size: str = WINDOW

    def engine(self, fps: int) -> list[str]:
        """Options of the engine; fps 0: as many frames as can be drawn."""
        limit = ["--max-fps", str(fps)] if fps else []
        return [*SOFTWARE, "--resolution", self.size, "--disable-vsync", *limit]

    def options(self, folder: Path) -> list[str]:
        """Options of the client; a wall's layout is written into the folder."""
        if self.display != "wall":
            return [f"--display={self.display}"]
        width, height = (int(part) for part in self.size.split("x"))
        half = 0.45 * width / height
        text = LAYOUT.format(left=-half, right=half, width=width, height=height)
        layout = folder / "wall.cfg"
        layout.write_text(text, encoding="utf-8")
        return ["--display=wall", f"--layout={layout}"]


class Settings:
    """Options of `./run latency`."""

    def __init__(self, arguments: list[str]) -> None:
        values = {
            "port": os.environ.get("DISMOUNT_PORT", "7777"),
            "bvh": str(CLIPS / "01_01.bvh"),
            "seconds": "20",
            "rate": "60",
            "fps": "60",
            "smoothing": "",
            "display": "",
        }
        for argument in arguments:
            name, _, value = argument.removeprefix("--").partition("=")
            if name not in values or not value:
                raise Failure(unknown_option("./run latency", argument, options_in(HELP)), 2)
            values[name] = value
        self.port = _whole(values, "port", 1, 65535)
        self.rate = _whole(values, "rate", 1, 240)
        self.fps = _whole(values, "fps", 1, 1000)
        self.seconds = _whole(values, "seconds", 3, 3600)
        self.bvh = values["bvh"]
        self.smoothing = values["smoothing"]
        self.window = Window(values["display"]) if values["display"] else None
        if values["display"] not in ("", *DISPLAYS):
            hint = suggest(values["display"], DISPLAYS) or f": {', '.join(DISPLAYS)}."
            raise Failure(f"There is no display '{values['display']}'{hint}", 2)
        if self.smoothing not in ("", *SMOOTHING):
            hint = suggest(self.smoothing, SMOOTHING) or f": {', '.join(SMOOTHING)}."
            raise Failure(f"There is no smoothing '{self.smoothing}'{hint}", 2)
        if not Path(self.bvh).is_file():
            raise Failure(f"There is no motion file {self.bvh}: name one with --bvh=FILE.", 2)


def _whole(values: dict[str, str], name: str, least: int, most: int) -> int:
    value = values[name]
    if not value.isdigit() or not least <= int(value) <= most:
        raise Failure(f"--{name} is between {least} and {most}, found '{value}'.", 2)
    return int(value)


def main(arguments: list[str]) -> int:
    """Runs a session, prints a table and leaves a CSV file and a picture in out/."""
    settings = Settings(arguments)
    make_folder(OUT)
    (OUT / ".gdignore").touch()  # The editor is not to import our pictures.
    godot = prepare(export=True)
    with step(f"run server, trainee and observer for {settings.seconds} s"):
        run_session(settings, OUT / CSV)
    with step("draw the delays"):
        stats = draw(godot, OUT / CSV, OUT / PICTURE)
    print_table(stats)
    print(f"\nfile     {OUT / CSV}\npicture  {OUT / PICTURE}")
    return 0


def run_session(settings: Settings, csv_file: Path) -> dict[str, dict]:
    """A server, a trainee and an observer of fixed frame rate on loopback; the clients' reports."""
    options = [f"--smoothing={settings.smoothing}"] if settings.smoothing else []
    trainee = [f"--bvh={settings.bvh}", f"--rate={settings.rate}"]
    return observe(
        settings.port, settings.seconds, settings.fps, csv_file, settings.window, trainee, options
    )


def observe(
    port: int,
    seconds: int,
    fps: int,
    csv_file: Path,
    window: Window | None,
    trainee: list[str],
    observer: list[str],
    world: str = "",
) -> dict[str, dict]:
    """Runs a session whose observer has a window, or none; returns the clients' reports."""
    require_port(port)
    csv_file.unlink(missing_ok=True)
    common = [f"--port={port}"]
    with ExitStack() as stack:
        screen = stack.enter_context(virtual_display()) if window else {}
        work = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="dismount-")))
        group = stack.enter_context(Group(work, screen))
        server = [str(SERVER_BINARY), "--headless", "--", "--role=server", *common]
        server += [f"--world={world}"] if world else []
        group.start("server", server)
        group.await_text("server", "listening on UDP port", 30)
        rate = [f"--fps={fps}"] if window is None else []
        options = ["--role=trainee", *trainee, *common, *rate]
        options.append(f"--report={work / 'trainee.json'}")
        group.start("trainee", [str(CLIENT_BINARY), "--headless", "--", *options])
        group.await_text("trainee", "joined", 30)
        options = [
            "--role=observer",
            *common,
            *rate,
            *observer,
            f"--duration={seconds}",
            f"--latency-csv={csv_file}",
            f"--report={work / 'observer.json'}",
            *(window.options(work) if window else []),
        ]
        engine = window.engine(fps) if window else ["--headless"]
        group.start("observer", [str(CLIENT_BINARY), *engine, "--", *options])
        group.await_exit("observer", seconds + 60)
        for name in ("server", "trainee"):
            if group.exit_code(name) is not None:
                raise Failure(f"The {name} ended too early:\n{tail(group.log(name))}")
        if not (work / "observer.json").exists():
            raise Failure(f"The observer left no stats:\n{tail(group.log('observer'))}")
        return {name: _report(work, name) for name in ("trainee", "observer")}


def read_delays(csv_file: Path, warm_up_s: float) -> tuple[list[float], float]:
    """From arrival to display of each sample after a warm-up, ms, and frames a second."""
    with csv_file.open(encoding="utf-8", newline="") as text:
        rows = [row for row in csv.DictReader(text) if row["displayed_usec"]]
    begin = int(rows[0]["displayed_usec"]) + warm_up_s * 1e6 if rows else 0.0
    kept = [row for row in rows if int(row["displayed_usec"]) > begin]
    shown = sorted({int(row["displayed_usec"]) for row in kept})
    if len(shown) < 2:
        raise Failure("The observer drew too few frames to measure them: give more --seconds.")
    delays = [(int(row["displayed_usec"]) - int(row["arrival_usec"])) / 1000.0 for row in kept]
    return delays, (len(shown) - 1) / ((shown[-1] - shown[0]) / 1e6)


def _report(work: Path, name: str) -> dict:
    file = work / f"{name}.json"
    if not file.exists():
        raise Failure(f"The {name} left no stats: the session was too short.")
    return json.loads(file.read_text(encoding="utf-8"))


def draw(godot: Godot, csv: Path, picture: Path) -> dict[str, dict]:
    """Draws the delays of a file; returns their stats by stage."""
    picture.unlink(missing_ok=True)
    with virtual_display() as environment:
        done = subprocess.run(
            [str(godot.program), "--no-header", *SOFTWARE, "--path", str(ROOT)]
            + ["-s", PLOT, "--", str(csv), str(picture)],
            env={**godot.environment(), **environment},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )
    found = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode != 0 or not picture.is_file() or not found:
        raise Failure(f"The picture could not be drawn:\n{tail(done.stdout + done.stderr)}")
    return json.loads(found[0])


def print_table(stats: dict[str, dict]) -> None:
    """Prints the stages and the total."""
    columns = ("mean", "sd", "p50", "p95", "p99")
    print(f"\n{'ms':<12}" + "".join(f"{name:>8}" for name in columns) + f"{'count':>9}")
    stages = [name for name in stats if name != "total"]
    for name in [*stages, "total"]:
        row = stats[name]
        values = "".join(f"{row[column + '_ms']:8.1f}" for column in columns)
        print(f"{name:<12}{values if row['count'] else '       -' * 5}{row['count']:>9.0f}")
