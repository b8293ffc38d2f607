# SPDX-License-Identifier: MIT
"""Where things lie: the repository, what is built in it, and the cache that all clones share."""

from __future__ import annotations

import errno
import fcntl
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from .console import Failure, say

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
OUT = ROOT / "out"
SERVER_BINARY = BUILD / "export" / "server" / "dismount-server.x86_64"
CLIENT_BINARY = BUILD / "export" / "client" / "dismount.x86_64"
CLIPS = ROOT / "assets" / "motion"


def cache() -> Path:
    """The user's cache folder for downloads and the private Godot."""
    # Tests have an XDG_CACHE_HOME for the engine: nothing is to be fetched a second time into it.
    named = os.environ.get("DISMOUNT_USER_CACHE") or os.environ.get("XDG_CACHE_HOME")
    base = named or str(Path.home() / ".cache")
    return Path(base) / "dismount"


def user_path(text: str) -> Path:
    """A path as the user typed it: relative to where `./run` was called, not to the repository."""
    return Path(os.environ.get("DISMOUNT_CWD", os.getcwd())) / Path(text).expanduser()


def make_folder(folder: Path) -> Path:
    """Makes a folder and its parents."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Failure(f"Cannot make the folder {folder}: {error.strerror}.") from error
    return folder


def write_whole(file: Path, text: str) -> None:
    """Writes a file of which readers see all or nothing, whoever else writes it meanwhile."""
    make_folder(file.parent)
    with tempfile.NamedTemporaryFile(
        "w", encoding="utf-8", dir=file.parent, prefix=f".{file.name}.", delete=False
    ) as part:
        part.write(text)
    Path(part.name).replace(file)


def need_space(folder: Path, megabytes: int, what: str) -> None:
    """Gives up early, and clearly, where the disk is too full for what comes next."""
    free = shutil.disk_usage(make_folder(folder)).free // 2**20
    if free < megabytes:
        raise Failure(
            f"The disk is too full for {what}: {folder} has {free} MB free and needs "
            f"{megabytes} MB. Free some space, or set XDG_CACHE_HOME to a larger disk."
        )


def explain(error: OSError) -> Failure:
    """Turns an operating system error into a sentence with the remedy."""
    where = f" ({error.filename})" if error.filename else ""
    if error.errno == errno.ENOSPC:
        return Failure(f"The disk is full{where}: free some space and start again.")
    if error.errno in (errno.EACCES, errno.EPERM, errno.EROFS):
        return Failure(f"No permission{where}: make the folder writable for you and start again.")
    return Failure(f"The system refused{where}: {error.strerror}.")


@contextmanager
def lock(file: Path, what: str) -> Iterator[None]:
    """Holds a lock between processes, so that two set-ups at once do not disturb one another."""
    make_folder(file.parent)
    with open(file, "w", encoding="utf-8") as handle:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say(f"[ .. ] waiting for another process that is at {what}")
            fcntl.flock(handle, fcntl.LOCK_EX)
        yield
