# SPDX-License-Identifier: MIT
"""Stats of benchmarks in Python, printed as tests/bench/bench_report.gd prints them."""

from __future__ import annotations

import json

# What a program exits with where a goal is missed.
GOALS_MISSED = 5
# And where something, such as a file, could not be measured.
LEFT_OUT = 6
HEADS = ("case", "metric", "value", "unit", "goal", "holds")


class Stats:
    """A table for people, or a JSON object a line for programs."""

    def __init__(self, bench: str, as_json: bool) -> None:
        self._bench = bench
        self._json = as_json
        self._rows: list[tuple[str, ...]] = [HEADS]
        self._missed = 0

    def add(
        self,
        case: str,
        metric: str,
        value: float,
        unit: str,
        at_most: float | None = None,
        at_least: float | None = None,
    ) -> None:
        """Adds a figure and the goal it has, if it has one."""
        goal = at_most if at_most is not None else at_least
        holds = None
        if at_most is not None:
            holds = value <= at_most
        elif at_least is not None:
            holds = value >= at_least
        self._missed += holds is False
        if self._json:
            row = {"bench": self._bench, "case": case, "metric": metric, "value": value}
            print(json.dumps({**row, "unit": unit, "goal": goal, "holds": holds}), flush=True)
            return
        sign = "<= " if at_most is not None else ">= "
        goal_text = "" if goal is None else f"{sign}{goal:g}"
        holds_text = "" if holds is None else ("yes" if holds else "NO")
        self._rows.append((case, metric, f"{value:.3f}", unit, goal_text, holds_text))

    def finish(self) -> int:
        """Prints the table, if it is not JSON that is wanted; returns the exit code."""
        if not self._json:
            self._print_table()
        return GOALS_MISSED if self._missed else 0

    def _print_table(self) -> None:
        widths = [max(len(row[column]) for row in self._rows) for column in range(len(HEADS))]
        for row in self._rows:
            cells = (cell.ljust(width + 2) for cell, width in zip(row, widths, strict=True))
            print("".join(cells).rstrip())
