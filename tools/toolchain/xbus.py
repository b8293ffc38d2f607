# SPDX-License-Identifier: MIT
"""Native programs around the bus of motion-capture suits: the decoder and its benchmark."""

from __future__ import annotations

import subprocess
from pathlib import Path

from .paths import ROOT, user_path
from .project import EXTENSIONS, NATIVE, prepare

PROGRAMS = EXTENSIONS / "xbus"


def decode(arguments: list[str]) -> int:
    """Runs xbus_decode; standard output is its alone."""
    prepare(False, NATIVE)
    paths = [a if a.startswith("-") else str(user_path(a)) for a in arguments]
    return subprocess.run([str(PROGRAMS / "xbus_decode"), *paths], check=False).returncode


def measure(file: Path | None) -> tuple[int, str]:
    """Runs the native benchmark; returns its exit code and its lines of stats."""
    command = [str(PROGRAMS / "xbus_bench"), str(ROOT / "tests" / "data" / "xbus")]
    command += [str(file)] if file else []
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    return done.returncode, done.stdout
