# SPDX-License-Identifier: MIT
"""The commands of `./run`."""

from __future__ import annotations

import ast
import functools
import itertools
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from . import demo, jolt, latency, load, options, package, suit, xbus
from .console import Failure, say
from .display import real_display
from .godot import Godot
from .paths import CLIENT_BINARY, CLIPS, ROOT, SERVER_BINARY, user_path
from .project import prepare

HELP = """Dismount: people in motion-capture suits move through physics.

  ./run                     set up everything; start an exported server, a trainee who moves by a
                            recorded clip, and an observer. With a display: in windows, until one
                            is closed. Without: for 20 s; a picture and a film are left in out/

Roles (./run ROLE --help lists the options of one; all are in docs/options.md)
{roles}

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
  ./run package NAME...     writes build/addons/NAME/ for other Godot projects: ragdoll_motor,
                            xbus, threaded_peer (docs/packages)
  ./run options-doc         writes docs/options.md anew from the rows of all options
  ./run --help              this text

Options of the roles are given as --name=value, or by the environment: DISMOUNT_PORT=7778 is
--port=7778. For ./run itself: --port, --bvh, --seconds (of the session without a display).

The environment also knows GODOT (an engine >= 4.6 to use), GODOT_CPP_DIR (build against a checkout
of godot-cpp), DISMOUNT_DEBIAN_MIRROR (where to fetch Godot), XDG_CACHE_HOME, and
DISMOUNT_DISPLAY=virtual (do as if there was no display).

Keys in a window: 1 mesh world, 2 static world, 3 physics world, L delays; a trainee's: M suits and
calibration. Drag and wheel move the camera.
"""

FLAGS = ("--help",)
FILES = ("bvh", "file", "report")
# What a trainee moves by who names no source of motion.
CLIP = CLIPS / "01_01.bvh"


def main(arguments: list[str]) -> int:
    """Runs one command and returns its exit code."""
    if arguments and arguments[0] in ("--help", "-h", "help"):
        print(HELP.format(roles=_describe_roles()), end="")
        return 0
    commands: dict[str, Callable[[list[str]], int]] = {
        **{role: functools.partial(_role, role) for role in options.roles()},
        "editor": _editor,
        "export": _export,
        "bvh": _bvh,
        "mvn-sender": _mvn_sender,
        "xbus-decode": xbus.decode,
        "bench": _bench,
        "latency": lambda rest: latency.main(normalise(rest)),
        "load": lambda rest: load.main(normalise(rest)),
        "package": package.main,
        "suit-emulator": suit.main,
        "options-doc": _options_doc,
    }
    if not arguments or arguments[0].startswith("-"):
        return demo.main(normalise(arguments))
    if arguments[0] not in commands:
        raise Failure(f"There is no command '{arguments[0]}': see ./run --help.", 2)
    return commands[arguments[0]](arguments[1:])


def normalise(arguments: list[str]) -> list[str]:
    """Options of commands that are no role as --name=value, also where they were given as
    --name value; files as full paths."""
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


def _run(command: list[str], more: dict[str, str] | None = None) -> int:
    """Runs a program in the foreground and ends it when we end."""
    with subprocess.Popen(command, env={**os.environ, **(more or {})}) as process:
        try:
            return process.wait()
        except BaseException:
            process.terminate()
            try:
                process.wait(5)
            except subprocess.TimeoutExpired:
                process.kill()
            raise


def _describe_roles() -> str:
    """The roles that are commands of ours as they are: "load" needs a server and a network."""
    rows = [row for row in options.roles().items() if row[0] != "load"]
    return "\n".join(f"  {'./run ' + role:<26}{meaning}" for role, meaning in rows)


def _role(role: str, arguments: list[str]) -> int:
    """Starts the program as a role. It knows its options itself, and where relative files are."""
    prepare(export=True)
    environment = {"PWD": str(user_path(""))}
    environment["DISMOUNT_DEFAULT_BVH"] = os.environ.get("DISMOUNT_DEFAULT_BVH") or str(CLIP)
    command = [str(SERVER_BINARY if role == "server" else CLIENT_BINARY), "--no-header"]
    wants_help = "--help" in arguments or "-h" in arguments
    if wants_help or role == "server" or not real_display():
        command.append("--headless")
    if wants_help:
        return _run([*command, "--", f"--role={role}", "--help"])
    if role != "server" and not real_display():
        say("There is no display: the client runs without a window.")
    given = [argument for argument in arguments if argument != "--"]
    return _run([*command, "--", f"--role={role}", *given], environment)


def _options_doc(_arguments: list[str]) -> int:
    options.write(prepare(export=False))
    print(options.DOCUMENT)
    return 0


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
    given = [argument for argument in arguments if argument.startswith("-")]
    godot = prepare(export=False)
    return _script(
        godot, [], "res://scripts/mocap/bvh/bvh_info.gd", [str(user_path(files[0])), *given]
    )


def _mvn_sender(arguments: list[str]) -> int:
    given = normalise(arguments)
    if "-h" in given:
        given = ["--help"]
    godot = prepare(export=False)
    return _script(godot, [], "res://scripts/mocap/mvn/mvn_sender.gd", given)


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


def _bench_python(script: Path, given: list[str]) -> int:
    """Runs a benchmark that drives whole processes: standard output is the script's alone."""
    if "--help" in given or "-h" in given:
        print(_docstring(script))
        return 0
    prepare(export=True)
    path = {"PYTHONPATH": str(ROOT / "tools"), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, str(script), *normalise(given)]
    return subprocess.run(
        command, env={**os.environ, **path}, stdin=subprocess.DEVNULL, check=False
    ).returncode


def _bench(arguments: list[str]) -> int:
    known = benchmarks()
    if not arguments or arguments[0] in ("--help", "-h"):
        for name, (_, about) in known.items():
            print(f"{name:<12} {about}")
        return 0
    name, *given = arguments
    if name not in known:
        raise Failure(f"There is no benchmark '{name}': {', '.join(known)}.", 2)
    if known[name][0].suffix == ".py":
        return _bench_python(known[name][0], given)
    if "--help" in given or "-h" in given:
        source = known[name][0].read_text(encoding="utf-8").splitlines()
        about = itertools.dropwhile(lambda line: not line.startswith("##"), source)
        head = itertools.takewhile(lambda line: line.startswith("##"), about)
        print("\n".join(line[2:].strip() for line in head))
        return 0
    godot = prepare(export=False)
    relative = known[name][0].relative_to(ROOT)
    rate = next((o.split("=")[1] for o in normalise(given) if o.startswith("--hz=")), "60")
    flags = ["--fixed-fps", rate] if rate.isdigit() and rate != "0" else []
    given = normalise(given)
    if name == "raw_jolt" and not any(o.startswith(("--program=", "--absent=")) for o in given):
        given += jolt.options(godot)
    return _script(godot, flags, f"res://{relative}", given)
