# SPDX-License-Identifier: MIT
"""The tests that failed and then passed alone, over the last runs on this machine.

Such a test lost a race: it is a defect of the first rank, but not of the change that is being
tested. One that loses often enough fails the run.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

from .paths import lock, make_folder

# A test that is flaky so often in so many runs fails the run.
TOO_OFTEN = 3
RUNS = 20
HEADS = ("run", "date", "commit", "load", "test", "log")


@dataclass(frozen=True)
class Sighting:
    """A test that failed and then passed alone."""

    test: str
    said: str


@dataclass(frozen=True)
class Flaky:
    """A test that was flaky in this run, and how often it was so in the last ones and this one."""

    test: str
    count: int
    said: str
    log: Path

    def is_too_often(self) -> bool:
        """Whether it fails the run."""
        return self.count >= TOO_OFTEN

    def describe(self) -> str:
        """A line for the end of a run."""
        verdict = "fails the run" if self.is_too_often() else f"of {TOO_OFTEN} that fail a run"
        return f"FLAKY {self.test}: {self.count} in the last {RUNS} runs ({verdict}); {self.log}"


class Ledger:
    """The runs and what was flaky in each: flaky.csv, and a folder with what was said."""

    def __init__(self, folder: Path) -> None:
        self.file = folder / "flaky.csv"
        self._logs = folder / "flaky"
        self._lock = folder / "flaky.lock"

    def rows(self) -> list[dict[str, str]]:
        """What has been noted; a run without anything flaky has a row without a test."""
        if not self.file.exists():
            return []
        with self.file.open(encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        return [row for row in rows if (row["run"] or "").isdigit()]

    def note(self, sightings: list[Sighting], date: str, commit: str, load: str) -> list[Flaky]:
        """Adds a run; returns what was flaky in it."""
        make_folder(self._logs)
        with lock(self._lock, "noting flaky tests"):
            rows = self.rows()
            run = 1 + max((int(row["run"]) for row in rows), default=0)
            own = dict(zip(HEADS, (str(run), date, commit, load, "", ""), strict=True))
            found: list[Flaky] = []
            for number, sighting in enumerate(sightings):
                log = self._logs / f"{run}-{number}.log"
                log.write_text(f"{sighting.test}\n\n{sighting.said}\n", encoding="utf-8")
                rows.append({**own, "test": sighting.test, "log": str(log)})
                recent = [row for row in rows if int(row["run"]) > run - RUNS]
                count = sum(row["test"] == sighting.test for row in recent)
                found.append(Flaky(sighting.test, count, sighting.said, log))
            self._write(rows if sightings else [*rows, own])
        return found

    def _write(self, rows: list[dict[str, str]]) -> None:
        part = self.file.with_suffix(".part")
        with part.open("w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, HEADS)
            writer.writeheader()
            writer.writerows({head: row[head] for head in HEADS} for row in rows)
        part.rename(self.file)
