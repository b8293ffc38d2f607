# SPDX-License-Identifier: MIT
"""Processor time of a process and its threads, as Linux counts it."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path


def parse_stat(line: str) -> tuple[str, float]:
    """Name and processor time (s) of a thread, from /proc/PID/task/TID/stat."""
    # The name is in brackets and may itself hold any.
    begin, end = line.index("("), line.rindex(")")
    fields = line[end + 2 :].split()
    return line[begin + 1 : end], (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def thread_seconds(process: int) -> dict[int, tuple[str, float]]:
    """Name and processor time (s) of each thread; the main one has the process' own number."""
    found: dict[int, tuple[str, float]] = {}
    for task in Path(f"/proc/{process}/task").glob("*"):
        # A thread may end while we read.
        with contextlib.suppress(OSError, ValueError, IndexError):
            name, seconds = parse_stat((task / "stat").read_text(encoding="utf-8"))
            # ns, where the kernel has them; the other counts in hundredths of a second.
            with contextlib.suppress(OSError, ValueError, IndexError):
                seconds = int((task / "schedstat").read_text(encoding="ascii").split()[0]) / 1e9
            found[int(task.name)] = (name, seconds)
    return found
