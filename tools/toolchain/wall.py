# SPDX-License-Identifier: MIT
"""`./run wall`: a whole station of several screens, from its layout file."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from .console import Failure, say, tail
from .display import real_display
from .godot import Godot
from .paths import CLIENT_BINARY, ROOT, user_path
from .processes import Group
from .project import prepare

HELP = """./run wall --layout=FILE [options]

Shows a session on several screens: monitors around a seat, projectors, the walls of a CAVE. FILE
says where the screens are in metres, where the viewer's eyes are, and how each screen is warped and
blended; it is checked first. One client shows all screens, or each has one of its own, where the
layout says "clients = each"; all end together. It needs a display.

  --layout=FILE         layout of the station, see docs/displays.md
  --screens=NAME,...    only these of its screens: others are on another machine (all)
  --role=ROLE           observer or trainee (observer)

All other options are those of the role, such as --host and --port: see ./run observer --help. With
a client for each screen, those of a trainee are the first one's; the others observe.

Exit codes: 0 done, 1 there is no display, 2 the layout or an option is wrong, otherwise a client's.
"""
CHECK = "res://scripts/display/wall/wall_info.gd"
ROLES = ("observer", "trainee")
# Options of a client that also one of the other screens has.
SHARED = ("host", "port", "quality", "duration", "key", "certificate")


def main(arguments: list[str]) -> int:
    """Starts the clients of a station and waits until one of them has ended."""
    given = [argument for argument in arguments if argument != "--"]
    values = dict(one.removeprefix("--").partition("=")[::2] for one in given if "=" in one)
    if not values.get("layout"):
        raise Failure(
            "Which station? Name its layout with --layout=FILE: see ./run wall --help.", 2
        )
    role = values.get("role", ROLES[0])
    if role not in ROLES:
        raise Failure(f"--role is observer or trainee, found '{role}'.", 2)
    layout = user_path(values["layout"])
    if not layout.is_file():
        raise Failure(f"There is no layout {layout}: name one with --layout=FILE.", 2)
    found = check(prepare(export=True), layout, values.get("screens", ""))
    if not real_display():
        raise Failure("A wall needs a display: start it in a desktop session.")
    commands = clients(found, layout, role, values.get("screens", ""), given)
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        return run(commands, Path(folder))


def check(godot: Godot, layout: Path, screens: str = "") -> dict:
    """What a layout holds; a Failure says what is wrong with it, or with its screens that are to be
    on this machine."""
    command = [str(godot.program), "--headless", "--no-header", "--path", str(ROOT)]
    done = subprocess.run(
        [*command, "-s", CHECK, "--", str(layout), *([screens] if screens else [])],
        env={**os.environ, **godot.environment()},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode == 2:
        raise Failure(done.stderr.strip(), 2)
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode != 0 or not lines:
        raise Failure(f"The layout could not be checked:\n{tail(done.stdout + done.stderr)}")
    return dict(json.loads(lines[-1]))


def clients(
    found: dict, layout: Path, role: str, screens: str, given: list[str]
) -> dict[str, list[str]]:
    """The options of each client, by the name of its screen; one client of all has the name ""."""
    rest = [one for one in given if not one.startswith(("--layout=", "--screens=", "--role="))]
    own = ["--display=wall", f"--layout={layout}"]
    if found["clients"] == "one":
        some = [f"--screens={screens}"] if screens else []
        return {"": [f"--role={role}", *own, *some, *rest]}
    commands: dict[str, list[str]] = {}
    for name in found["screens"]:
        if screens and name not in [one.strip() for one in screens.split(",")]:
            continue
        is_first = name == found["screens"][0]
        options = rest if is_first or role == "observer" else [one for one in rest if _shared(one)]
        commands[name] = [f"--role={role if is_first else 'observer'}", *own, f"--screens={name}"]
        commands[name] += options
    if not commands:
        known = ", ".join(found["screens"])
        raise Failure(f"The layout has no screen '{screens}': it has {known}.", 2)
    return commands


def _shared(option: str) -> bool:
    return option.removeprefix("--").partition("=")[0] in SHARED


def run(commands: dict[str, list[str]], folder: Path) -> int:
    """Runs clients until one of them has ended; the others end with it. Returns its exit code."""
    environment = {"PWD": str(user_path(""))}
    # Options may come by the environment here as for any other client.
    environment |= {k: v for k, v in os.environ.items() if k.startswith("DISMOUNT_")}
    names = [f"screen {name}".strip() for name in commands]
    with Group(folder, environment) as group:
        for name, options in zip(names, commands.values(), strict=True):
            group.start(name, [str(CLIENT_BINARY), "--no-header", "--", *options])
        say(f"{len(names)} client(s) of the station run. Close a window, or press Ctrl+C, to end.")
        try:
            group.await_any_exit(names)
        except KeyboardInterrupt:
            return 0
        for name in names:
            code = group.exit_code(name)
            if code is not None:
                print(group.log(name), end="", file=sys.stderr)
                return code
    return 0
