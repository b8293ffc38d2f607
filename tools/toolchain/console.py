# SPDX-License-Identifier: MIT
"""Progress on screen, and the one way to give up: one sentence with the remedy."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager


class Failure(Exception):
    """What can't be had, in one sentence that says what to do about it."""

    def __init__(self, message: str, code: int = 1) -> None:
        super().__init__(message)
        self.code = code


def say(text: str) -> None:
    """Prints a line of progress to standard error: standard output is for results."""
    print(text, file=sys.stderr, flush=True)


@contextmanager
def step(name: str) -> Iterator[None]:
    """Shows a step of the set-up while it runs, and how long it took."""
    begin = time.monotonic()
    say(f"[ .. ] {name}")
    yield
    say(f"[ ok ] {name} ({time.monotonic() - begin:.1f} s)")


def tail(text: str, lines: int = 15) -> str:
    """The last lines of a tool's output, indented, for a message about its failure."""
    return "\n".join("    " + line for line in text.rstrip().splitlines()[-lines:])
