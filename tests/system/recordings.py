# SPDX-License-Identifier: MIT
"""What recordings of sessions hold, also while they are being written."""

from __future__ import annotations

import functools
import json
import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

from toolchain.paths import ROOT
from toolchain.processes import await_that

LIMIT_S = 120.0
LOOK_S = 0.1


@functools.cache
def _reader() -> subprocess.Popen[str]:
    """One engine for all that is asked: recording_reader.gd. It ends with us."""
    script = "res://tests/system/recording_reader.gd"
    command = [os.environ["DISMOUNT_GODOT"], "--headless", "--no-header", "--path", str(ROOT)]
    return subprocess.Popen(
        [*command, "-s", script],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def forget(recording: Path) -> None:
    """What a recording has had so far counts no more: another test begins."""
    _ask(f"forget {recording}")


def read(recording: Path) -> dict[str, Any]:
    """Levels, entities and people of a recording, as far as it goes."""
    return _ask(str(recording))


def _ask(line: str) -> dict[str, Any]:
    reader = _reader()
    assert reader.stdin is not None
    assert reader.stdout is not None
    reader.stdin.write(f"{line}\n")
    reader.stdin.flush()
    said = ""
    for answer in reader.stdout:
        if answer.startswith("{"):
            assert "ERROR" not in said, said
            found: dict[str, Any] = json.loads(answer)
            return found
        said += answer
    raise AssertionError(f"the reader of recordings has ended:\n{said}")


def comes(recording: Path, holds: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """Waits until a recording that is being written holds something."""
    found: dict[str, Any] = {}

    def look() -> bool:
        nonlocal found
        found = read(recording)
        return holds(found)

    await_that(look, "what is looked for", LIMIT_S, lambda: str(found), LOOK_S)
    return found


def recorded(recording: Path) -> dict[str, list[dict]]:
    """Who is in an observer's recording and how they move."""
    people: dict[str, list[dict]] = read(recording)["people"]
    return people


def turned(entries: list[dict]) -> float:
    """How far all limbs of a recorded person have turned altogether, degrees on average."""
    return sum(entry["turned_deg"] for entry in entries)
