# SPDX-License-Identifier: MIT
"""The commands of `./run`."""

from __future__ import annotations

import ast
import itertools
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from . import demo, jolt, latency, load, suit, xbus
from .console import Failure, say
from .display import real_display
from .godot import Godot
from .paths import CLIENT_BINARY, CLIPS, ROOT, SERVER_BINARY, user_path
from .project import prepare

HELP = """Dismount: people in motion-capture suits move through physics.

  ./run                     set up everything; start an exported server, a trainee who moves by a
                            recorded clip, and an observer. With a display: in windows, until one
                            is closed. Without: for 20 s; a picture and a film are left in out/

Roles
  ./run server  [options]   the exported dedicated server alone
  ./run trainee [options]   a client with a body. Its motion (key M: the panel for suits):
      --bvh=FILE[,FILE]     motion files, a person each (without any of these: a clip of ours)
      --xbus                a wired Xsens suit on USB (docs/suits.md)
      --mvn[=PORT]          Xsens MVN's network stream on UDP 9763: every person in it
      --tracker=NAME        a body tracker of another Godot plugin
      --suit-play=FILE      a recording of a suit or of MVN, in a loop
      --suit-record=FILE    keeps every byte of suit and MVN for that
      --person=NAME --calibrate=KIND   who wears the suit; t_pose, n_pose, t_to_n, full, quick
  ./run observer [options]  a client that watches
  ./run instructor [options]  a client that watches and decides who takes part
  ./run replay --file=FILE  shows what a client recorded with --record=FILE

Motion capture without a suit
  ./run suit-emulator [-- COMMAND]  a suit on USB that is not there, for the program behind --
                            (./run suit-emulator --help, docs/suit-emulator.md)
  ./run mvn-sender --bvh FILE  plays a motion file as MVN's network stream: --host --port --rate
                            --types --characters --name --seconds --loss (docs/mvn.md)
  ./run xbus-decode FILE    what a recording of a suit's bus holds: messages, devices, rates, loss;
                            --json prints everything, decoded (docs/xbus.md)
  ./run bvh FILE            what a motion file holds: joints, frames, duration, unit, up axis
                            (--unit=m|cm|mm|inch|cmu|METRES and --up=y|z override the guess)

Measuring
  ./run latency             measures the delay from sample to display on this machine, stage by
                            stage, and draws it (--seconds, --rate, --fps, --smoothing, --bvh)
  ./run load                puts many clients on a server over a bad network (docs/load.md):
                            --trainees=8 --observers=24 --loss=2 --delay=25 --jitter=10
                            --seconds --rate --snapshot-rate --seed --json --server-options
  ./run bench               lists the benchmarks
  ./run bench NAME [--json] [options]   runs one

Development
  ./run editor              the Godot editor with this project
  ./run export              exports server and client to build/export/
  ./run --help              this text; ./run server --help lists the roles' options

Options of the roles are given as --name=value, or by the environment: DISMOUNT_PORT=7778 is
--port=7778. For ./run itself: --port, --bvh, --seconds (of the session without a display).

The environment also knows GODOT (an engine >= 4.6 to use), GODOT_CPP_DIR (build against a checkout
of godot-cpp), DISMOUNT_DEBIAN_MIRROR (where to fetch Godot), XDG_CACHE_HOME, and
DISMOUNT_DISPLAY=virtual (do as if there was no display).

Keys in a window: 1 mesh world, 2 static world, 3 physics world, L delays; a trainee's: M suits and
calibration. Drag and wheel move the camera.
"""

FLAGS = ("--help", "--xbus", "--panel", "--dtls", "--waiting-room")
SESSION_FILES = ("ban-file", "dtls-certificate", "dtls-key")
SUIT_FILES = ("suit-record", "suit-play")
OUTPUT_FILES = ("record", "report", "screenshot", "latency-csv")
FILES = ("bvh", "file", *SUIT_FILES, *OUTPUT_FILES, *SESSION_FILES)
SOURCES = ("bvh", "xbus", "mvn", "tracker", "suit-play")


def main(arguments: list[str]) -> int:
    """Runs one command and returns its exit code."""
    if arguments and arguments[0] in ("--help", "-h", "help"):
        print(HELP, end="")
        return 0
    commands: dict[str, Callable[[list[str]], int]] = {
        "server": _server,
        "trainee": lambda rest: _client("trainee", rest),
        "observer": lambda rest: _client("observer", rest),
        "instructor": lambda rest: _client("instructor", rest),
        "replay": lambda rest: _client("replay", rest),
        "editor": _editor,
        "export": _export,
        "bvh": _bvh,
        "mvn-sender": _mvn_sender,
        "xbus-decode": xbus.decode,
        "bench": _bench,
        "latency": lambda rest: latency.main(normalise(rest)),
        "load": lambda rest: load.main(normalise(rest)),
        "suit-emulator": suit.main,
    }
    if not arguments or arguments[0].startswith("-"):
        return demo.main(normalise(arguments))
    if arguments[0] not in commands:
        raise Failure(f"There is no command '{arguments[0]}': see ./run --help.", 2)
    return commands[arguments[0]](arguments[1:])


def normalise(arguments: list[str]) -> list[str]:
    """Options as --name=value, also where they were given as --name value; files as full paths."""
    result: list[str] = []
    rest = [argument for argument in arguments if argument != "--"]
    while rest:
        option = rest.pop(0)
        takes_next = rest and not rest[0].startswith("--") and option not in FLAGS
        if option.startswith("--") and "=" not in option and takes_next:
            option = f"{option}={rest.pop(0)}"
        name, _, value = option.removeprefix("--").partition("=")
        if name in FILES and value:
            option = f"--{name}={_user_files(value)}"
        result.append(option)
    return result


def _user_files(value: str) -> str:
    """A path, or several with commas between, as full ones."""
    if user_path(value).exists():
        return str(user_path(value))
    return ",".join(str(user_path(part)) for part in value.split(","))


def _run(command: list[str]) -> int:
    """Runs a program in the foreground and ends it when we end."""
    with subprocess.Popen(command) as process:
        try:
            return process.wait()
        except BaseException:
            process.terminate()
            try:
                process.wait(5)
            except subprocess.TimeoutExpired:
                process.kill()
            raise


def _server(arguments: list[str]) -> int:
    prepare(export=True)
    return _run([str(SERVER_BINARY), "--headless", "--", "--role=server", *normalise(arguments)])


def _client(role: str, arguments: list[str]) -> int:
    options = normalise(arguments)
    if role == "trainee" and not _names_source(options):
        options.append(f"--bvh={CLIPS / '01_01.bvh'}")
    prepare(export=True)
    command = [str(CLIENT_BINARY)]
    if not real_display():
        say("There is no display: the client runs without a window.")
        command.append("--headless")
    return _run([*command, "--", f"--role={role}", *options])


def _names_source(options: list[str]) -> bool:
    """Whether options or environment say where a trainee's motion comes from."""
    named = [option.partition("=")[0] for option in options]
    variables = [f"DISMOUNT_{name.upper().replace('-', '_')}" for name in SOURCES]
    return any(f"--{name}" in named for name in SOURCES) or any(map(os.environ.get, variables))


def _editor(_arguments: list[str]) -> int:
    godot = prepare(export=False)
    if not real_display():
        raise Failure("The editor needs a display: start it in a desktop session.")
    return _run([str(godot.program), "--editor", "--path", str(ROOT)])


def _export(_arguments: list[str]) -> int:
    prepare(export=True)
    print(SERVER_BINARY)
    print(CLIENT_BINARY)
    return 0


def _script(godot: Godot, flags: list[str], script: str, arguments: list[str]) -> int:
    """Runs a script of the project headless; standard output is the script's alone."""
    command = [str(godot.program), "--headless", "--no-header", "--path", str(ROOT), *flags]
    command += ["-s", script, "--", *arguments]
    return subprocess.run(
        command, env=godot.environment(), stdin=subprocess.DEVNULL, check=False
    ).returncode


def _bvh(arguments: list[str]) -> int:
    files = [argument for argument in arguments if not argument.startswith("-")]
    if len(files) != 1:
        raise Failure("usage: ./run bvh FILE [--unit=U] [--up=y|z]", 2)
    options = [argument for argument in arguments if argument.startswith("-")]
    godot = prepare(export=False)
    return _script(
        godot, [], "res://scripts/mocap/bvh/bvh_info.gd", [str(user_path(files[0])), *options]
    )


def _mvn_sender(arguments: list[str]) -> int:
    options = normalise(arguments)
    if "-h" in options:
        options = ["--help"]
    godot = prepare(export=False)
    return _script(godot, [], "res://scripts/mocap/mvn/mvn_sender.gd", options)


def benchmarks() -> dict[str, tuple[Path, str]]:
    """Script and first line of documentation of each benchmark, by name."""
    found: dict[str, tuple[Path, str]] = {}
    for script in sorted((ROOT / "tests" / "bench").glob("bench_*.gd")):
        lines = script.read_text(encoding="utf-8").splitlines()
        if lines and lines[0].startswith("extends SceneTree"):
            about = next((line[3:] for line in lines if line.startswith("## ")), "")
            found[script.stem.removeprefix("bench_")] = (script, about)
    for script in sorted((ROOT / "tests" / "bench").glob("bench_*.py")):
        about = _docstring(script).partition("\n")[0]
        found[script.stem.removeprefix("bench_")] = (script, about)
    return dict(sorted(found.items()))


def _docstring(script: Path) -> str:
    return ast.get_docstring(ast.parse(script.read_text(encoding="utf-8"))) or ""


def _bench_python(script: Path, options: list[str]) -> int:
    """Runs a benchmark that drives whole processes: standard output is the script's alone."""
    if "--help" in options or "-h" in options:
        print(_docstring(script))
        return 0
    prepare(export=True)
    path = {"PYTHONPATH": str(ROOT / "tools"), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, str(script), *normalise(options)]
    return subprocess.run(
        command, env={**os.environ, **path}, stdin=subprocess.DEVNULL, check=False
    ).returncode


def _bench(arguments: list[str]) -> int:
    known = benchmarks()
    if not arguments or arguments[0] in ("--help", "-h"):
        for name, (_, about) in known.items():
            print(f"{name:<12} {about}")
        return 0
    name, *options = arguments
    if name not in known:
        raise Failure(f"There is no benchmark '{name}': {', '.join(known)}.", 2)
    if known[name][0].suffix == ".py":
        return _bench_python(known[name][0], options)
    if "--help" in options or "-h" in options:
        source = known[name][0].read_text(encoding="utf-8").splitlines()
        about = itertools.dropwhile(lambda line: not line.startswith("##"), source)
        head = itertools.takewhile(lambda line: line.startswith("##"), about)
        print("\n".join(line[2:].strip() for line in head))
        return 0
    godot = prepare(export=False)
    relative = known[name][0].relative_to(ROOT)
    rate = next((o.split("=")[1] for o in normalise(options) if o.startswith("--hz=")), "60")
    flags = ["--fixed-fps", rate] if rate.isdigit() and rate != "0" else []
    options = normalise(options)
    if name == "raw_jolt" and not any(o.startswith(("--program=", "--absent=")) for o in options):
        options += jolt.options(godot)
    return _script(godot, flags, f"res://{relative}", options)
