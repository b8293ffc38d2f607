# SPDX-License-Identifier: MIT
"""What can be said of a camera or a film without opening it; needs only Python's own library."""

from __future__ import annotations

import os
from pathlib import Path


class PictureError(Exception):
    """Why there are no pictures, as a sentence for people."""


def path_of(number: int) -> str:
    """The device of a camera."""
    return f"/dev/video{number}"


def check(what: str) -> None:
    """Says what is wrong with a camera, by its number, or a film, by its path."""
    if what.isdigit():
        _check_camera(int(what))
    elif not Path(what).is_file():
        raise PictureError(f"there is no film {what}")


def _check_camera(number: int) -> None:
    device = path_of(number)
    if not os.path.exists(device):
        others = sorted(one.name.removeprefix("video") for one in Path("/dev").glob("video*"))
        there = f"there are {', '.join(others)}" if others else "plug one in"
        raise PictureError(f"there is no camera {number}: {there}")
    try:
        os.close(os.open(device, os.O_RDWR | os.O_NONBLOCK))
    except PermissionError:
        advice = "add yourself to the group 'video' and log in again"
        raise PictureError(f"this user may not use camera {number}: {advice}") from None
    except OSError as error:
        raise PictureError(f"camera {number} cannot be opened: {error.strerror}") from None


def silence_of(number: int) -> str:
    """Why a camera that is there gives no pictures."""
    who = users(path_of(number))
    if who:
        return f"camera {number} is in use by {', '.join(who)}: end it, or choose another camera"
    return (
        f"camera {number} gives no pictures: another program may be using it, or it is only a"
        " second channel of the same camera (try the next number)"
    )


def users(device: str) -> list[str]:
    """Names of this user's other programs that have a file open."""
    names = set()
    for entry in Path("/proc").glob("[0-9]*"):
        if entry.name == str(os.getpid()):
            continue
        try:
            files = {os.readlink(one) for one in (entry / "fd").iterdir()}
            if device in files:
                names.add((entry / "comm").read_text(encoding="utf-8").strip())
        except OSError:
            continue
    return sorted(names)
