# SPDX-License-Identifier: MIT
"""Suits' bus: framing and decoding speed, splits, bad lines, an hour of a stream.

Runs the native xbus_bench. Options: --file=FILE (measures with this recording of raw bytes
instead; `./run xbus-decode FILE` says what is in it).
"""

from __future__ import annotations

import json
from pathlib import Path

from bench import main
from toolchain import xbus
from toolchain.console import Failure
from toolchain.stats import Stats


def measure(arguments: list[str]) -> int:
    """Prints the stats and their goals."""
    files = [a.partition("=")[2] for a in arguments if a.startswith("--file=")]
    unknown = [a for a in arguments if a != "--json" and not a.startswith("--file=")]
    if unknown:
        raise Failure(f"There is no option '{unknown[0]}': --file=FILE, --json.", 2)
    code, lines = xbus.measure(Path(files[-1]) if files else None)
    stats = Stats("xbus", "--json" in arguments)
    for line in lines.splitlines():
        row = json.loads(line)
        stats.add(row.pop("case"), **row)
    missed = stats.finish()
    return code or missed


if __name__ == "__main__":
    main(measure)
