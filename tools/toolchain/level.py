# SPDX-License-Identifier: MIT
"""`./run level VERB`: what is done with levels without the editor.

A verb is a row of VERBS here and of the script's own. `run` is given the verb's arguments.
"""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from dataclasses import dataclass

from .console import Failure
from .nearest import suggest
from .paths import ROOT, user_path
from .project import prepare

SCRIPT = "res://scripts/world/guard/level_tool.gd"
HELP = """./run level VERB ...

Works on levels without the editor.

"""


@dataclass(frozen=True)
class Verb:
    """One thing that can be done: how it is called, what it is for, and who does it."""

    usage: str
    about: str
    run: Callable[[list[str]], int]


def _call(arguments: list[str]) -> int:
    """Has the project's script do it; standard output is the script's alone."""
    godot = prepare(export=False)
    command = [str(godot.program), "--headless", "--no-header", "--path", str(ROOT)]
    return subprocess.run(
        [*command, "-s", SCRIPT, "--", *arguments],
        env=godot.environment(),
        stdin=subprocess.DEVNULL,
        check=False,
    ).returncode


def _pack(arguments: list[str]) -> int:
    words, options = _sort(arguments, ("--out",))
    if len(words) != 1:
        raise Failure(f"usage: {VERBS['pack'].usage}", 2)
    # A name of ours stays a name; a folder of the user's becomes a whole path.
    level = str(user_path(words[0])) if user_path(words[0]).is_dir() else words[0]
    return _call(["pack", level, f"--out={user_path(options.get('--out', 'levels'))}"])


def _verify(arguments: list[str]) -> int:
    words, _ = _sort(arguments, ())
    if len(words) != 1:
        raise Failure(f"usage: {VERBS['verify'].usage}", 2)
    return _call(["verify", str(user_path(words[0]))])


def _bake(arguments: list[str]) -> int:
    words, _ = _sort(arguments, ())
    if len(words) != 1:
        raise Failure(f"usage: {VERBS['bake'].usage}", 2)
    return _call(["bake", words[0]])


def _check(arguments: list[str]) -> int:
    words, _ = _sort(arguments, ())
    if len(words) != 1:
        raise Failure(f"usage: {VERBS['check'].usage}", 2)
    return _call(["check", words[0]])


VERBS = {
    "bake": Verb(
        "./run level bake NAME",
        "works out the light of a level of ours and what can be seen from where, and keeps it in\n"
        "NAME.bake beside the scene",
        _bake,
    ),
    "check": Verb(
        "./run level check NAME",
        "looks for what is wrong in a level of ours: spawn points and props in walls, places that\n"
        "nobody can walk to, what is not solid, light that is not baked; says how to set it right",
        _check,
    ),
    "pack": Verb(
        "./run level pack NAME [--out=DIR]",
        "makes a folder of a level that a server can offer (--levels=DIR) to clients that lack\n"
        "it, or says with file and line what in it may not be sent. NAME: a level of ours, or a\n"
        "folder that holds a scene of its name. DIR: where the folder goes (./levels)",
        _pack,
    ),
    "verify": Verb(
        "./run level verify FOLDER",
        "says whether a folder that was made by pack is whole and may be used",
        _verify,
    ),
}


def help_text() -> str:
    """What `./run level --help` prints."""
    parts = [HELP]
    for verb in VERBS.values():
        about = verb.about.replace("\n", "\n      ")
        parts.append(f"  {verb.usage}\n      {about}\n")
    parts.append("\nExit codes: 0 done, 1 the level is not fit, 2 the call is wrong.\n")
    return "".join(parts)


def main(arguments: list[str]) -> int:
    """Does one verb and returns its exit code."""
    if not arguments or arguments[0] not in VERBS:
        named = arguments[0] if arguments else ""
        hint = suggest(named, VERBS) or f": {', '.join(VERBS)}."
        raise Failure(f"There is no './run level {named}'{hint}", 2)
    return VERBS[arguments[0]].run(arguments[1:])


def _sort(arguments: list[str], known: tuple[str, ...]) -> tuple[list[str], dict[str, str]]:
    """Words, and options by name."""
    words = [one for one in arguments if not one.startswith("--")]
    options: dict[str, str] = {}
    for one in arguments:
        if one.startswith("--"):
            name, _, value = one.partition("=")
            if name not in known or not value:
                raise Failure(f"There is no option {one} here: see ./run level --help.", 2)
            options[name] = value
    return words, options
