# SPDX-License-Identifier: MIT
"""What the parts of the benchmark `displays` share.

A part is a module of this folder, found by its name: `stereo.py` is the part `stereo`. It has:

    PART = "stereo"                      # the name, for --part=stereo
    def measure(bench: Bench) -> None    # adds its rows by bench.stats.add(case, metric, ...)

A part runs what it needs by `run_script()` (a GDScript of this folder, whose lines that begin with
`{` are its findings) or `bench.run()`, and raises `toolchain.console.Failure` where it cannot
measure. A goal is `at_most=` or `at_least=` of `stats.add`. What this machine has not, such as a
GPU or a headset's runtime, is told by `bench.leave_out(case, why)`: the others are measured, and
the benchmark ends with 6.
"""

from __future__ import annotations

from typing import Any

from bench import SOFTWARE, Bench

SCRIPTS = "res://tests/bench/displays/"


def run_script(
    bench: Bench, name: str, options: list[str], environment: dict[str, str]
) -> list[dict[str, Any]]:
    """Runs a script of this folder in a window; returns what it found."""
    flags = [*SOFTWARE, "--resolution", "640x360", "-s", SCRIPTS + name, "--", *options]
    return bench.rows(bench.command(*flags), environment)


def add_rows(bench: Bench, rows: list[dict[str, Any]]) -> None:
    """Adds the rows that a script of this folder has printed, with their goals."""
    for row in rows:
        figure = (row["case"], row["metric"], row["value"], row["unit"])
        bench.stats.add(*figure, at_most=row.get("goal"))
