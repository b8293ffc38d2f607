# SPDX-License-Identifier: MIT
"""What `./run --help` and `./run COMMAND --help` print; `./run options-doc` writes the files.

The shell prints these files, so help needs neither a build nor Python. Roles' texts come from the
program's own rows, the others from here and from the commands.
"""

from __future__ import annotations

import subprocess
from pathlib import Path

from . import demo, latency, level, load, package, platform_watch, studio, suit, wall, webcam
from .console import Failure, tail
from .godot import Godot
from .paths import CLIPS, ROOT
from .project import EXTENSIONS

FOLDER = ROOT / "tools" / "help"
# Plays motion files in place of suits and other programs.
MOTION_SENDER = "res://scripts/emulation/motion_sender.gd"
# Makes motion sets for walkers.
MOTION_SET_TOOL = "res://scripts/mocap/matching/motion_set_tool.gd"
MOTION_SET_RECORD = "res://scripts/client/suit/motion_set_record.gd"
MAIN_FILE = ROOT / "tools" / "help.txt"
# How the program marks where the text of a role begins: OptionsHelp.all_roles().
_ROLE_MARK = "=== "

MAIN = """Dismount: people in motion-capture suits move through physics.

  ./run                     sets up everything, and opens the start screen. Without a display it
                            does what ./run demo does
  ./run demo                an exported server, a trainee who moves by a recorded clip, and an
                            observer. With a display: in windows, until one is closed. Without:
                            for 12 s; a picture and a film are left in out/

Roles (./run ROLE --help lists the options of one; all are in docs/options.md)
{roles}

Displays
  ./run wall --layout=FILE  a session on several screens: monitors, projectors, a CAVE

Motion capture without a suit
  ./run suit-emulator [-- COMMAND]  a suit on USB that is not there, for the program behind --
  ./run motion-sender       plays a motion file as MVN's stream, VMC, SlimeVR, a webcam and others
  ./run xbus-decode FILE    what a recording of a suit's bus holds
  ./run bvh FILE            what a motion file holds
  ./run motion-set show FILE  what walkers move by; build and record make sets
  ./run webcam --setup      what a webcam as a suit needs; --source=webcam does it by itself

Vehicles
  ./run platform-watch      shows what a motion platform would be sent

Levels
  ./run level pack NAME     makes a folder of a level that a server can offer its clients

Effects
  ./run studio [NAME]       the studio for particle effects: text and picture side by side

Measuring
  ./run latency             the delay from sample to display on this machine, stage by stage
  ./run load                many clients on one server, over a bad network
  ./run bench [NAME]        lists the benchmarks, or runs one

Development
  ./run editor              the Godot editor with this project
  ./run export              exports server and client to build/export/
  ./run package NAME...     an archive of server or client that runs elsewhere; addons
  ./run options-doc         writes docs/options.md and the texts of --help anew

  ./run COMMAND --help      the options of a command, with what they can be
  ./run --version

Motion files of ours: {clips}

{demo}
The environment also knows GODOT (an engine >= 4.6 to use), GODOT_CPP_DIR (build against a checkout
of godot-cpp), DISMOUNT_DEBIAN_MIRROR (where to fetch Godot), XDG_CACHE_HOME, and
DISMOUNT_DISPLAY=virtual (do as if there was no display).

Keys in a window: 1 mesh world, 2 static world, 3 physics world, Tab next person, V from where to
look, N names, F1 all keys, F11 full screen, Esc menu; a trainee's: M suits and calibration.
"""

BENCH = """./run bench                           lists the benchmarks
./run bench NAME [--json] [options]   runs one
./run bench NAME --help               says what it measures, and its options

  --json                one JSON object a line: bench, case, metric, value, unit, goal, holds
  --no-goals            exit code 0 also where a goal is missed

Exit codes: 0 done, 1 failed, 2 wrong options, 5 a goal is missed, 6 something could not be measured
(a file that is none, or too short); the rest was.

"""
BVH = """./run bvh FILE [--unit=U] [--up=AXIS]

Says what a motion file (BVH) holds: joints, frames, duration, unit, up axis, size of the person.

  --unit=U              unit of its lengths: m, cm, mm, inch, cmu, dm, foot or a number of metres
                        (guessed)
  --up=AXIS             its up axis: y, z, x, -y (Y points down), -z or -x (guessed)

Exit codes: 0 done, 2 the call is wrong, the file cannot be read or it shows no person.
"""
MOTION_SET = """./run motion-set VERB ...

What walkers move by: a set of recorded clips, of which the moments are played that fit.

  build TABLE OUT       makes a set of the motion files (BVH) that a table names, a line for each
                        clip: FILE STANCE FROM_S TO_S NAME; stances are stand, crouch, prone,
                        ladder, vault, a TO_S of 0 is the file's end
  show FILE             prints clips, stances, seconds, speeds (heights of the hips a second),
                        directions and for how long feet stand
  record OUT            leads somebody in a suit through a few minutes of standing, walking, turning
                        and running, and makes a set of it; in words on the terminal, and in a
                        window where there is a display (S leaves a phase out, Escape ends it). All
                        of it is kept as motion files in OUT-recording, with the table for build

  --source=KIND         whose motion is recorded; also --bvh, --xbus, --fuse, --person, --calibrate
                        and all others about suits, as of ./run trainee
  --skip=PHASE,...      phases that are left out: stand, walk, slow-walk, fast-walk, starts,
                        turn-left, turn-right, curve-left, curve-right, back, left, right, run,
                        crouch, crouched-walk

  --clips=FOLDER        where the motion files are (the folder of the table)
  --unit=U              unit of their lengths, as of ./run bvh (guessed)

Ours is made by: ./run motion-set build tools/assets/motion_set/walker.txt
assets/motion/walker.motionset --clips=FOLDER --unit=cmu; tools/assets/motion_set says where its
clips are from.

Exit codes: 0 done, 2 the call is wrong, a file is, or nothing was recorded that makes a set.
"""
EDITOR = """./run editor

Builds the extensions, imports the assets and opens the project in the Godot editor. It needs a
display.
"""
EXPORT = """./run export

Exports the dedicated server and the client to build/export/, and prints where the programs are.
They run on this machine; ./run package server and ./run package client make archives for others.
"""
OPTIONS_DOC = """./run options-doc

Writes docs/options.md and the texts of --help (tools/help) anew, from the rows of all options.
./test lint fails where they differ.
"""


def make(godot: Godot) -> dict[Path, str]:
    """Each file, and what it is to hold."""
    roles, shown = _roles(godot)
    texts = {
        **roles,
        "latency": latency.HELP,
        "load": load.HELP,
        "bench": BENCH,
        "bvh": BVH,
        "demo": "./run demo [options]\n\n" + demo.HELP,
        "editor": EDITOR,
        "export": EXPORT,
        "motion-set": MOTION_SET,
        "options-doc": OPTIONS_DOC,
        "level": level.help_text(),
        "package": package.help_text(),
        "platform-watch": platform_watch.HELP,
        "studio": studio.HELP,
        "suit-emulator": suit.HELP,
        "wall": wall.HELP,
        "webcam": webcam.HELP,
        "motion-sender": _sender(godot),
        "xbus-decode": _xbus_decode(),
    }
    files = {FOLDER / f"{name}.txt": text for name, text in texts.items()}
    clips = ", ".join(f"assets/motion/{clip.name}" for clip in sorted(CLIPS.glob("*.bvh")))
    files[MAIN_FILE] = MAIN.format(roles=shown, clips=clips, demo=demo.HELP)
    return files


def read(command: str) -> str:
    """The text of a command as it lies there; empty if there is none yet."""
    file = FOLDER / f"{command}.txt"
    return file.read_text(encoding="utf-8") if file.exists() else ""


def _roles(godot: Godot) -> tuple[dict[str, str], str]:
    """The text of each role, and lines for all of them. "load" is a command of another kind."""
    arguments = ["--no-header", "--path", str(ROOT), "--", "--role=server", "--help=roles"]
    code, text = godot.call(arguments, 120)
    if code != 0 or not text.startswith(_ROLE_MARK):
        raise Failure(f"The program does not describe its roles (exit {code}):\n{tail(text)}")
    texts: dict[str, str] = {}
    lines: list[str] = []
    for part in text.removeprefix(_ROLE_MARK).split(f"\n{_ROLE_MARK}"):
        role, _, described = part.partition("\n")
        if role == "load":
            continue
        meaning = described.partition("\n")[0].partition(": ")[2]
        texts[role] = f"./run {role} [options]\n\n{described.strip()}\n"
        lines.append(f"  {'./run ' + role:<26}{meaning}")
    return texts, "\n".join(lines)


def _sender(godot: Godot) -> str:
    """The help of the program that plays motion files in place of somebody's suit."""
    arguments = ["--no-header", "--path", str(ROOT), "-s", MOTION_SENDER]
    code, text = godot.call([*arguments, "--", "--help"], 120)
    if code != 0 or not text.startswith("usage"):
        raise Failure(f"motion-sender prints no help (exit {code}):\n{tail(text)}")
    return text.removeprefix("usage: ")


def _xbus_decode() -> str:
    program = EXTENSIONS / "xbus" / "xbus_decode"
    done = subprocess.run([str(program), "--help"], capture_output=True, text=True, check=False)
    if not done.stdout:
        raise Failure(f"{program} prints no help: {tail(done.stderr)}")
    return "./run " + done.stdout
