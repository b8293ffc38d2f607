# SPDX-License-Identifier: MIT
"""The commands of `./run`."""

from __future__ import annotations

import functools
import itertools
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

from . import (
    demo,
    help_texts,
    latency,
    level,
    load,
    options,
    package,
    platform_watch,
    studio,
    suit,
    wall,
    webcam,
    xbus,
)
from .console import Failure, say
from .display import real_display
from .godot import Godot
from .nearest import check_options, suggest
from .paths import CLIENT_BINARY, ROOT, SERVER_BINARY, user_path
from .project import NATIVE, prepare
from .stats import GOALS_MISSED, LEFT_OUT

FLAGS = ("--no-goals",)
FILES = ("bvh", "file", "report")
# Whose options are all in their help; the roles' are checked by the program itself.
CHECKED = ("bvh", "editor", "export", "motion-set", "options-doc", "package", "suit-emulator")
CHECKED += ("motion-sender", "platform-watch", "xbus-decode")


def main(arguments: list[str]) -> int:
    """Runs one command and returns its exit code. What needs no set-up, tools/help.sh answers."""
    commands: dict[str, Callable[[list[str]], int]] = {
        **{role: functools.partial(_role, role) for role in options.roles()},
        "demo": lambda rest: demo.main(normalise(rest)),
        "editor": _editor,
        "export": _export,
        "bvh": _bvh,
        "motion-sender": _sender,
        "motion-set": _motion_set,
        "xbus-decode": xbus.decode,
        "bench": _bench,
        "latency": lambda rest: latency.main(normalise(rest)),
        "load": lambda rest: load.main(normalise(rest)),
        "level": level.main,
        "package": package.main,
        "platform-watch": lambda rest: platform_watch.main(normalise(rest)),
        "studio": studio.main,
        "suit-emulator": suit.main,
        "wall": wall.main,
        "webcam": webcam.main,
        "options-doc": _options_doc,
    }
    if not arguments and real_display():
        _role("start", [])
    if not arguments or arguments[0].startswith("-"):
        return demo.main(normalise(arguments))
    if arguments[0] not in commands:
        # tools/help.sh names the nearest.
        raise Failure(f"There is no command '{arguments[0]}': see ./run --help.", 2)
    if arguments[0] in CHECKED and arguments[:2] != ["motion-set", "record"]:
        own = itertools.takewhile(lambda argument: argument != "--", arguments[1:])
        check_options(f"./run {arguments[0]}", own, help_texts.read(arguments[0]))
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


def _role(role: str, arguments: list[str]) -> NoReturn:
    """Starts the program as a role. It knows its options itself, and where relative files are."""
    if not CLIENT_BINARY.exists():
        # Before minutes of set-up.
        check_options(f"./run {role}", arguments, help_texts.read(role))
    prepare(export=True)
    webcam.prepare(arguments)
    environment = {"PWD": str(user_path("")), webcam.VARIABLE: str(webcam.FOLDER)}
    environment["DISMOUNT_RUN"] = str(ROOT / "run")
    command = [str(SERVER_BINARY if role == "server" else CLIENT_BINARY), "--no-header"]
    if role == "server" or not real_display():
        command.append("--headless")
    if role == "start" and not real_display():
        raise Failure("The start screen needs a display: ./run --help lists what does not.")
    if role != "server" and not real_display():
        say("There is no display: the client runs without a window.")
    given = [argument for argument in arguments if argument != "--"]
    # In our place: signals are the program's.
    sys.stdout.flush()
    sys.stderr.flush()
    os.execve(command[0], [*command, "--", f"--role={role}", *given], {**os.environ, **environment})


def _options_doc(_arguments: list[str]) -> int:
    options.write(prepare(False, NATIVE))
    print(options.DOCUMENT)
    print(help_texts.FOLDER)
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


def _motion_set(arguments: list[str]) -> int:
    """Makes motion sets, and says what is in one."""
    if arguments[:1] == ["record"]:
        _record(arguments[1:])
    words = [argument for argument in arguments if not argument.startswith("-")]
    options_given = normalise([argument for argument in arguments if argument.startswith("-")])
    files = [str(user_path(word)) for word in words[1:]]
    return _script(
        prepare(export=False), [], help_texts.MOTION_SET_TOOL, [*words[:1], *files, *options_given]
    )


def _record(arguments: list[str]) -> NoReturn:
    """Records a motion set from a wearer. The script knows its options itself, as a role does."""
    if not arguments or arguments[0].startswith("-"):
        raise Failure("usage: ./run motion-set record OUT --source=KIND[:ADDRESS] [options]", 2)
    godot = prepare(export=False)
    webcam.prepare(arguments[1:])
    # Not the engine's own environment: calibrations are in the user's folder.
    environment = {"PWD": str(user_path("")), webcam.VARIABLE: str(webcam.FOLDER)}
    command = [str(godot.program), "--no-header", "--path", str(ROOT)]
    if not real_display():
        command.append("--headless")
    command += ["-s", help_texts.MOTION_SET_RECORD, "--", *arguments]
    sys.stdout.flush()
    sys.stderr.flush()
    # In our place: signals are the program's.
    os.execve(command[0], command, {**os.environ, **environment})


def _sender(arguments: list[str]) -> int:
    """Runs the program that sends motion."""
    given = normalise(arguments)
    return _script(prepare(export=False), [], help_texts.MOTION_SENDER, given)


def benchmarks() -> dict[str, Path]:
    """The script of each benchmark, by name."""
    found: dict[str, Path] = {}
    for script in (ROOT / "tests" / "bench").glob("bench_*"):
        text = script.read_text(encoding="utf-8")
        if script.suffix == ".py" or (
            script.suffix == ".gd" and text.startswith("extends Bench\n")
        ):
            found[script.stem.removeprefix("bench_")] = script
    return dict(sorted(found.items()))


def _bench_python(script: Path, given: list[str]) -> int:
    """Runs a benchmark that drives whole processes: standard output is the script's alone."""
    prepare(True, NATIVE)
    path = {"PYTHONPATH": str(ROOT / "tools"), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, str(script), *normalise(given)]
    return subprocess.run(
        command, env={**os.environ, **path}, stdin=subprocess.DEVNULL, check=False
    ).returncode


def _bench(arguments: list[str]) -> int:
    """Runs a benchmark; a missed goal is exit code 5, unless --no-goals says otherwise, and 6 says
    that something could not be measured."""
    known = benchmarks()
    name, *given = arguments
    if name not in known:
        hint = suggest(name, known) or f": {', '.join(known)}."
        raise Failure(f"There is no benchmark '{name}'{hint}", 2)
    code = _run_benchmark(known[name], [one for one in given if one != "--no-goals"])
    if code == GOALS_MISSED:
        say('A goal is missed: see the column "holds".')
        return 0 if "--no-goals" in given else GOALS_MISSED
    if code == LEFT_OUT:
        say('Not everything could be measured: see "not measured" above.')
    return code


def _run_benchmark(script: Path, given: list[str]) -> int:
    if script.suffix == ".py":
        return _bench_python(script, given)
    godot = prepare(False, NATIVE)
    given = normalise(given)
    rate = next((o.split("=")[1] for o in given if o.startswith("--hz=")), "60")
    flags = ["--fixed-fps", rate] if rate.isdigit() and rate != "0" else []
    return _script(godot, flags, f"res://{script.relative_to(ROOT)}", given)
