# SPDX-License-Identifier: MIT
"""How long tests took is kept, whoever else keeps times meanwhile."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from toolchain.durations import durations_file, keep_durations, read_durations


@pytest.fixture(autouse=True)
def store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path))


def test_runners_that_end_together_all_keep_their_times() -> None:
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda number: keep_durations({f"test {number}": number}), range(64)))
    assert read_durations() == {f"test {number}": number for number in range(64)}
    # Nothing is left that was half written.
    names = {file.name for file in durations_file().parent.iterdir()}
    assert names == {durations_file().name, "durations.lock"}


def test_a_broken_file_is_as_none() -> None:
    keep_durations({"test": 1.0})
    durations_file().write_text("{", encoding="utf-8")
    assert read_durations() == {}
