# SPDX-License-Identifier: MIT
"""How long each test took last time on this machine: what is long begins first."""

from __future__ import annotations

import json
from pathlib import Path

from .paths import cache, lock, write_whole


def durations_file() -> Path:
    """Where the times of tests are kept, by their names."""
    return cache() / "durations.json"


def read_durations() -> dict[str, float]:
    """How long each test took last time, s."""
    try:
        return json.loads(durations_file().read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


def keep_durations(seconds: dict[str, float]) -> None:
    """Adds the times of a run."""
    with lock(cache() / "durations.lock", "the times of tests"):
        known = {**read_durations(), **{name: round(time, 2) for name, time in seconds.items()}}
        write_whole(durations_file(), json.dumps(known, indent=0))
