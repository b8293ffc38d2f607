# SPDX-License-Identifier: MIT
"""What the benchmarks say of a machine whose processors stand still."""

from __future__ import annotations

import os
import time

import pytest
from toolchain.processor_stops import ProcessorStops


def test_who_watches_says_how_long_and_leaves_others_where_they_were() -> None:
    before = os.sched_getaffinity(0), os.sched_getscheduler(0)
    with ProcessorStops() as stops:
        time.sleep(0.1)
    assert (os.sched_getaffinity(0), os.sched_getscheduler(0)) == before
    assert stops.longest_ms is None or 0.0 <= stops.longest_ms < 10_000.0


def test_who_may_not_run_first_knows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_arguments: object) -> None:
        raise PermissionError

    monkeypatch.setattr(os, "sched_setscheduler", refuse)
    with ProcessorStops() as stops:
        time.sleep(0.01)
    assert stops.longest_ms is None
