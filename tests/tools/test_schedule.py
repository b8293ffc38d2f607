# SPDX-License-Identifier: MIT
"""Which worker runs which test: those of a shared file together, serial ones one at a time."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

HEAD = """
import os, pathlib, time
import pytest

FOLDER = pathlib.Path(os.environ["NOTES"])


def note(name):
    begin = time.monotonic()
    time.sleep(0.05)
    worker = os.environ.get("PYTEST_XDIST_WORKER", "alone")
    (FOLDER / name).write_text(f"{worker} {begin} {time.monotonic()}")


"""
SHARED = """
@pytest.fixture(scope="module")
def server():
    note(f"server-{os.environ.get('PYTEST_XDIST_WORKER')}")


@pytest.mark.parametrize("number", range(6))
def test_shared(server, number):
    note(f"shared-{number}")
"""
WINDOWS = """
pytestmark = pytest.mark.serial


@pytest.mark.parametrize("number", range(4))
def test_window(number):
    note(f"window-@@-{number}")
"""
PLAIN = """
@pytest.mark.parametrize("number", range(12))
def test_plain(number):
    note(f"plain-{number}")
"""


@pytest.fixture
def notes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, tuple[str, float, float]]:
    """Runs tests of all kinds with two workers; the worker, begin and end of each."""
    folder = tmp_path / "notes"
    folder.mkdir()
    cache = tmp_path / "user" / "dismount"
    cache.mkdir(parents=True)
    # What is long begins first.
    (cache / "durations.json").write_text(json.dumps({"test_plain.py::test_plain[11]": 60.0}))
    monkeypatch.setenv("NOTES", str(folder))
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(cache.parent))
    (tmp_path / "test_shared.py").write_text(HEAD + SHARED)
    (tmp_path / "test_first_windows.py").write_text(HEAD + WINDOWS.replace("@@", "a"))
    (tmp_path / "test_other_windows.py").write_text(HEAD + WINDOWS.replace("@@", "b"))
    (tmp_path / "test_plain.py").write_text(HEAD + PLAIN)
    command = [sys.executable, "-m", "pytest", "-p", "toolchain.schedule", "-q", "-n", "2"]
    command += ["-p", "no:cacheprovider", "--rootdir", str(tmp_path), "-W", "error", "."]
    plain = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    done = subprocess.run(
        command, cwd=tmp_path, env=plain, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    durations = json.loads((cache / "durations.json").read_text())
    assert len(durations) == 26
    assert durations["test_plain.py::test_plain[11]"] < 60.0
    found = {}
    for file in folder.iterdir():
        worker, begin, end = file.read_text().split()
        found[file.name] = (worker, float(begin), float(end))
    return found


def test_every_test_runs_where_it_may(notes: dict[str, tuple[str, float, float]]) -> None:
    assert len(notes) == 6 + 8 + 12 + 1, "all ran, and the shared server was started once"
    assert len({notes[f"shared-{number}"][0] for number in range(6)}) == 1
    windows = [row for name, row in notes.items() if name.startswith("window")]
    assert len({row[0] for row in windows}) == 1
    assert len({row[0] for row in notes.values()}) == 2
    plain = [row for name, row in notes.items() if name.startswith("plain")]
    longest = notes["plain-11"]
    own = [row for row in plain if row[0] == longest[0]]
    assert longest[1] == min(row[1] for row in own)
