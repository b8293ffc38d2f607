# SPDX-License-Identifier: MIT
"""`./run latency`: measures the delay from sample to display on this machine, and draws it."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
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
  --port=NUMBER         UDP port of the session, 1 to 65535 (7777)
"""


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


def run_session(settings: Settings, csv: Path) -> dict[str, dict]:
    """A server, a trainee and an observer of fixed frame rate on loopback; the clients' reports."""
    require_port(settings.port)
    csv.unlink(missing_ok=True)
    common = [f"--port={settings.port}"]
    with (
        tempfile.TemporaryDirectory(prefix="dismount-") as folder,
        Group(Path(folder), {}) as group,
    ):
        server = [str(SERVER_BINARY), "--headless", "--", "--role=server", *common]
        group.start("server", server)
        group.await_text("server", "listening on UDP port", 30)
        work = Path(folder)
        common.append(f"--fps={settings.fps}")
        options = ["--role=trainee", f"--bvh={settings.bvh}", f"--rate={settings.rate}", *common]
        options.append(f"--report={work / 'trainee.json'}")
        group.start("trainee", [str(CLIENT_BINARY), "--headless", "--", *options])
        group.await_text("trainee", "joined", 30)
        options = [
            "--role=observer",
            *common,
            f"--duration={settings.seconds}",
            f"--latency-csv={csv}",
            f"--report={work / 'observer.json'}",
        ]
        options += [f"--smoothing={settings.smoothing}"] if settings.smoothing else []
        group.start("observer", [str(CLIENT_BINARY), "--headless", "--", *options])
        group.await_exit("observer", settings.seconds + 60)
        for name in ("server", "trainee"):
            if group.exit_code(name) is not None:
                raise Failure(f"The {name} ended too early:\n{tail(group.log(name))}")
        return {name: _report(work, name) for name in ("trainee", "observer")}


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
