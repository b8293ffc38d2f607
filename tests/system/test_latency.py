"""The delay from sample to display: its file, its report, its picture."""

from __future__ import annotations

import csv
import time
from pathlib import Path

from .conftest import World

HEADS = ["person", "sample", "tick", "sampled_usec"]


def rows(file: Path) -> list[dict[str, str]]:
    with file.open(encoding="utf-8") as handle:
        return list(csv.DictReader(handle))


def test_every_sample_is_in_the_file_while_the_session_runs(world: World, tmp_path: Path) -> None:
    file = tmp_path / "latency.csv"
    world.server()
    world.trainee().await_text("joined")
    observer = world.client("observer", f"--latency-csv={file}", "--fps=60")
    observer.await_text("joined")
    end = time.monotonic() + 120.0
    while not file.exists() or len(rows(file)) < 100:
        assert time.monotonic() < end, f"too few lines come in:\n{observer.log()}"
        time.sleep(0.2)
    observer.kill()  # What is on the disk stays.
    found = rows(file)
    assert list(found[0])[:4] == HEADS
    samples = [int(row["sample"]) for row in found]
    assert len(set(samples)) == len(samples)
    for row in found[:-1]:
        total = (int(row["displayed_usec"]) - int(row["sampled_usec"])) / 1000.0
        assert abs(total - float(row["total_ms"])) < 0.01
        # A starved observer shows what is old; a wrong clock would be off by years.
        assert -5.0 < total < 60000.0


def test_a_file_that_cannot_be_written_is_named(world: World) -> None:
    observer = world.client("observer", "--latency-csv=/nowhere/latency.csv")
    assert observer.await_exit() == 1
    assert "/nowhere/latency.csv" in observer.log()
