# SPDX-License-Identifier: MIT
"""`python3 tools/webcam setup|run|check`: what stands behind `--source=webcam`.

setup                     makes the environment of its own, once
check                     exits with 0 where that is done
run --port=N              sends the landmarks of people to UDP port N of this machine; without
                          a port each is a line on standard output
  --pictures=WHAT         the number of a camera, or a film (0)
  --people=N              most people that are followed, 1 to 4 (1)
  --parent=PID            ends with this process
  --threads=N             processors that the models may use (1)
  --rate=HZ               pictures a second of a film (its own)
    --every-picture         a film once, as fast as it goes, with its own times
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

# As a folder that is run it has no package around it.
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from webcam import device, environment, sender


def main(arguments: list[str]) -> int:
    """Does one of the three."""
    parser = argparse.ArgumentParser(prog="webcam", add_help=True)
    parser.add_argument("what", choices=("setup", "check", "run"))
    parser.add_argument("--pictures", default="0")
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--people", type=int, default=1, choices=range(1, 5))
    parser.add_argument("--parent", type=int, default=0)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--rate", type=float, default=0.0)
    parser.add_argument("--every-picture", action="store_true")
    given = parser.parse_args(arguments)
    if given.what == "check":
        return 0 if environment.is_ready() else 1
    if given.what == "setup":
        return _set_up()
    if not given.every_picture and not sender.say_until(
        lambda: _fault(given.pictures), given.port, given.parent
    ):
        return 0
    if not environment.is_ready():
        return 3
    if Path(sys.prefix).resolve() != environment.folder().resolve():
        own = str(environment.python())
        os.execv(own, [own, str(Path(__file__).parent), *arguments])
    return _run(given)


def _fault(pictures: str) -> str:
    try:
        device.check(pictures)
    except device.PictureError as error:
        return str(error)
    return ""


def _set_up() -> int:
    if environment.is_ready():
        print(f"The webcam is ready already, in {environment.folder()}.")
        return 0
    try:
        environment.make(lambda text: print(text, flush=True))
    except environment.SetupError as error:
        print(f"The webcam cannot be set up: {error}.", file=sys.stderr)
        return 1
    return 0


def _run(given: argparse.Namespace) -> int:
    try:
        from webcam import helper  # Needs the environment.
    except ImportError as error:
        print(f"The webcam's environment is broken: {error}. Set it up anew.", file=sys.stderr)
        return 4
    return helper.run(given)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
