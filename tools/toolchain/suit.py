# SPDX-License-Identifier: MIT
"""`./run suit-emulator`: a suit that is not there, for tests and for people without one."""

from __future__ import annotations

import os
import signal
import subprocess
from pathlib import Path

from .console import Failure, say, tail
from .godot import Godot
from .paths import BUILD, CLIPS, ROOT, make_folder, user_path
from .project import EXTENSIONS, NATIVE, prepare

HELP = """./run suit-emulator [options] [-- COMMAND ...]

A person in a wired Xsens suit, who calibrates and then moves by a BVH file, on USB devices that
only the COMMAND finds (by umockdev; it ends with the command). Without a command: prints the
environment that a program in another terminal needs. docs/suit-emulator.md has more.

  ./run suit-emulator -- ./run trainee --xbus --calibrate=full

  --bvh=FILE            the motion (default: a walk)
  --devices=LIST        ftdi (an Xbus Master on an FTDI chip), ftdi-fast (with large packets),
                        native (on bulk endpoints), two-masters, two-native-masters, mti,
                        mti-ftdi (one tracker alone), awinda
  --sensors=N           how many trackers (default 17: the whole body)
  --limbs=A,B,...       where they sit: pelvis, sternum, head, left_shoulder, left_upper_arm, ...
  --aligned             trackers sit along the limbs' axes; otherwise at any angle (--seed=N)
  --heading=DEGREES     how far their norths differ at most (30)
  --noise=DEGREES --drift=DEGREES   of each sample, of the heading in a minute
  --mountings=FILE      lines of "w x y z degrees": how each tracker sits, and its north
  --swap=A:B            trackers that were put on each other's limb
  --hold                stands in a T-pose until the command 'go', instead of until the suit
                        measures
  --baud=N --instant    speed of the serial line (460800), or one that takes no time
  --corrupt=P --drop=P  probability that a byte is changed or lost
  --unplug-at=S --plug-at=S   seconds after the start
  --errors=MM:CC,...    messages that are answered with an error, in hexadecimal
  --answer-delay=MS     notices requests so much later   --master-id=HEX  of an unknown kind
  --real-time           waits for no processor: for measuring delays alone
  --error-every=N --mute --bus-power=off --battery=0..255 --dead=K --lie=K:BYTES
  --first-counter=N --forbidden --seconds=S
  --trace=FILE          when each sample was taken, on the chip, handed over (us, CLOCK_MONOTONIC)
  --log=FILE            what the host asked for: control requests, messages, drivers
  --commands=PIPE       where commands are read, besides the standard input: unplug, plug, hold, go,
                        calibrate, clip, motion S, corrupt P, drop P, error CC, mute, speak, freeze,
                        thaw, stall, battery N, quit
"""

PROGRAM = EXTENSIONS / "xbus" / "suit_emulator"
FILES = ("bvh", "mountings", "trace", "log", "commands")
# The mounts along the bus, from the middle outwards.
ORDER = ["pelvis", "sternum", "head"]
ORDER += ["left_shoulder", "left_upper_arm", "left_forearm", "left_hand"]
ORDER += ["right_shoulder", "right_upper_arm", "right_forearm", "right_hand"]
ORDER += ["left_thigh", "left_shank", "left_foot", "right_thigh", "right_shank", "right_foot"]
# Where trackers matter most, the most important mount first.
MOUNTS = ["pelvis", "left_shank", "right_shank", "left_forearm", "right_forearm", "sternum"]
MOUNTS += ["left_thigh", "right_thigh", "left_upper_arm", "right_upper_arm", "head"]
MOUNTS += ["left_foot", "right_foot", "left_hand", "right_hand", "left_shoulder", "right_shoulder"]


def main(arguments: list[str]) -> int:
    """Runs the emulator; returns the exit code of its command."""
    own = arguments[: arguments.index("--")] if "--" in arguments else arguments
    command = arguments[len(own) :]
    godot = prepare(False, NATIVE)
    return run(godot, own, command)


def run(godot: Godot, options: list[str], command: list[str]) -> int:
    """Starts the emulator in the foreground, in the folder that the user is in."""
    if not PROGRAM.exists():
        raise Failure("There is no suit emulator: it needs umockdev (Debian: libumockdev-dev).")
    process = subprocess.Popen(
        [str(PROGRAM), *complete(godot, options), *command],
        cwd=os.environ.get("DISMOUNT_CWD", os.getcwd()),
    )
    try:
        return process.wait()
    except BaseException:
        process.send_signal(signal.SIGTERM)
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
        raise


def complete(godot: Godot, options: list[str]) -> list[str]:
    """The program's options: full paths, limbs, and the motion stream of the BVH file where none is
    given."""
    values: dict[str, str | None] = {}
    for option in options:
        if not option.startswith("--"):
            raise Failure(f"'{option}' is no option: a command comes behind '--'.", 2)
        name, equals, value = option.removeprefix("--").partition("=")
        values[name] = value if equals else None
    for name in FILES:
        if values.get(name):
            values[name] = str(user_path(str(values[name])))
    bvh = values.pop("bvh", None) or str(CLIPS / "01_01.bvh")
    if "stream" not in values:
        values["stream"] = str(motion_stream(godot, Path(bvh)))
    values.setdefault("sensors", str(len(ORDER)))
    number = str(values["sensors"])
    if "limbs" not in values and number.isdigit() and 0 < int(number) <= len(MOUNTS):
        worn = MOUNTS[: int(number)]
        values["limbs"] = ",".join(mount for mount in ORDER if mount in worn)
    return [f"--{name}" if value is None else f"--{name}={value}" for name, value in values.items()]


def motion_stream(godot: Godot, bvh: Path) -> Path:
    """The motion of the wearer, as the emulator reads it."""
    if not bvh.exists():
        raise Failure(f"There is no file {bvh}.", 2)
    stream = make_folder(BUILD / "suit") / f"{bvh.stem}.{os.getpid()}.motion"
    arguments = ["--path", str(ROOT), "-s", "res://scripts/emulation/write_suit_motion.gd"]
    code, text = godot.call([*arguments, "--", f"--bvh={bvh}", f"--out={stream}"], 120)
    if code != 0 or not stream.exists():
        raise Failure(f"{bvh} gives no motion for a suit:\n{tail(text, 3)}", 2)
    final = stream.with_name(f"{bvh.stem}.motion")
    stream.replace(final)
    say(f"[ -- ] the wearer moves by {bvh.name}")
    return final
