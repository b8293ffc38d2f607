# SPDX-License-Identifier: MIT
"""How long this machine's processors stand still for everybody, as those of a rented one do."""

from __future__ import annotations

import multiprocessing
import os
import time
from multiprocessing.connection import Connection
from types import TracebackType

_PERIOD_S = 0.002
# Above the programs that are measured, which run at 20.
_PRIORITY = 60


class ProcessorStops:
    """A process on each processor that no other program can hold up, and yet is late at times.

    `with ProcessorStops() as stops: ...`, then `stops.longest_ms`: the longest stop, ms; None where
    this user may not run before everybody else.
    """

    def __init__(self) -> None:
        self.longest_ms: float | None = None
        self._watches: list[tuple[multiprocessing.Process, Connection]] = []

    def __enter__(self) -> ProcessorStops:
        for number in sorted(os.sched_getaffinity(0)):
            ours, theirs = multiprocessing.Pipe()
            process = multiprocessing.Process(target=_watch, args=(number, theirs), daemon=True)
            process.start()
            theirs.close()
            self._watches.append((process, ours))
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        for process, pipe in self._watches:
            try:
                pipe.send(None)
                self.longest_ms = max(self.longest_ms or 0.0, pipe.recv())
            except (EOFError, OSError):
                pass  # It could not run first, and has ended.
            process.join()


def _watch(number: int, pipe: Connection) -> None:
    try:
        os.sched_setaffinity(0, {number})
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(_PRIORITY))
    except OSError:
        return
    longest = 0.0
    while not pipe.poll():
        begin = time.monotonic()
        time.sleep(_PERIOD_S)
        longest = max(longest, time.monotonic() - begin - _PERIOD_S)
    pipe.send(1e3 * longest)
