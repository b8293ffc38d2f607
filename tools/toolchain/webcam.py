# SPDX-License-Identifier: MIT
"""`./run webcam`: the Python environment of the webcam's helper, made once."""

from __future__ import annotations

import itertools
import subprocess
import sys
from collections.abc import Iterable

from .console import Failure, say
from .nearest import check_options
from .paths import ROOT

FOLDER = ROOT / "tools" / "webcam"
# Names the helper's folder to the program.
VARIABLE = "DISMOUNT_WEBCAM"

HELP = """./run webcam --setup

A webcam as a suit (--source=webcam) needs OpenCV, LiteRT and the pose models of MediaPipe, in a
Python environment of their own in the user's cache folder: 140 MB are fetched from PyPI, 320 MB
kept. `./run trainee --source=webcam` makes it at first use; nothing else needs it.

  --setup                   makes it now; where it is there, says so
"""


def main(arguments: list[str]) -> int:
    """Makes the environment."""
    check_options("./run webcam", arguments, HELP)
    if arguments != ["--setup"]:
        raise Failure("usage: ./run webcam --setup", 2)
    return set_up()


def set_up() -> int:
    """Makes the environment, where it is not there; its own words say how it goes."""
    return subprocess.run([sys.executable, str(FOLDER), "setup"], check=False).returncode


def is_ready() -> bool:
    """Whether the environment was made."""
    done = subprocess.run([sys.executable, str(FOLDER), "check"], check=False)
    return done.returncode == 0


def prepare(arguments: Iterable[str]) -> None:
    """Makes the environment before a client that is to use a camera. Where that fails the client
    starts all the same, and tells its wearer."""
    given = list(arguments)
    texts = [one.removeprefix("--source=") for one in given if one.startswith("--source=")]
    texts += [after for one, after in itertools.pairwise(given) if one == "--source"]
    names = [name for text in texts for name in text.split(",")]
    wanted = [name for name in names if name == "webcam" or name.startswith("webcam:")]
    if all(name.startswith("webcam:udp:") for name in wanted) or is_ready():
        return
    if set_up() != 0:
        say("The client starts without the webcam.")
