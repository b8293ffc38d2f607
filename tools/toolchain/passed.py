# SPDX-License-Identifier: MIT
"""What has passed a check on this machine, by its content: shared between clones.

A mark is named by a hash over all that the check looks at. What fails is never marked.
"""

from __future__ import annotations

import hashlib
import os
import time
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from .paths import ROOT, cache, write_whole

REQUIREMENTS = ROOT / "tests" / "requirements.txt"
OLD_S = 30 * 86400.0
MOST = 20000


class Passed:
    """Marks of one kind of check."""

    def __init__(self, kind: str, *inputs: str) -> None:
        self._folder = cache() / "passed" / kind
        # A tool of another version may find more.
        self._inputs = [REQUIREMENTS.read_text(encoding="utf-8"), *inputs]

    def key(self, *parts: str | bytes) -> str:
        """A hash over the check's own inputs and those of one case."""
        return digest([*self._inputs, *parts])

    def find(self, key: str) -> str | None:
        """What was noted of a case that passed; None if it has not."""
        mark = self._folder / key
        try:
            text = mark.read_text(encoding="utf-8")
            os.utime(mark)  # What is still asked for is not old.
        except OSError:
            return None
        return text

    def add(self, key: str, note: str = "") -> None:
        """Marks a case; readers see all of the mark or nothing."""
        write_whole(self._folder / key, note)

    def prune(self) -> None:
        """Removes marks that nobody has asked for in a month, and the oldest of too many."""
        marks = [(_used(mark), mark) for mark in self._folder.glob("*")]
        marks.sort()
        for number, (used, mark) in enumerate(marks):
            if used < time.time() - OLD_S or number < len(marks) - MOST:
                with suppress(OSError):
                    mark.unlink()


def _used(mark: Path) -> float:
    try:
        return mark.stat().st_mtime
    except OSError:
        return 0.0


def digest(parts: Iterable[str | bytes]) -> str:
    """A hash over texts, and where one ends and the next begins."""
    whole = hashlib.sha256()
    for part in parts:
        data = part.encode() if isinstance(part, str) else part
        whole.update(f"{len(data)}:".encode() + data)
    return whole.hexdigest()


def contents(names: Iterable[str], root: Path = ROOT) -> str:
    """A hash over files of the repository: their names and what is in them."""
    parts: list[str | bytes] = []
    for name in sorted(names):
        parts += [name, (root / name).read_bytes()]
    return digest(parts)
