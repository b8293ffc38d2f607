# SPDX-License-Identifier: MIT
"""The same motion leads to the same state: in every process, on any number of threads, as ever.

tests/data/determinism.json keeps the fingerprints of each engine version.
"""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest
from toolchain.paths import ROOT

GOLDEN = ROOT / "tests" / "data" / "determinism.json"
OPTIONS = ["--people=3", "--seconds=3"]
LIMIT_S = 120.0


def engine(arguments: list[str], processors: set[int]) -> str:
    """Runs the engine headless on some processors; returns what it printed."""
    done = subprocess.run(
        [os.environ["DISMOUNT_GODOT"], "--headless", *arguments],
        cwd=ROOT,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=LIMIT_S,
        check=False,
        preexec_fn=lambda: os.sched_setaffinity(0, processors),  # Decides how many threads it has.
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def fingerprint(root: str, processors: set[int]) -> int:
    script = "res://tests/bench/bench_determinism.gd"
    options = [*OPTIONS, f"--root={root}", "--json"]
    output = engine(["--path", str(ROOT), "-s", script, "--", *options], processors)
    rows = [json.loads(line) for line in output.splitlines() if line.startswith("{")]
    return next(int(row["value"]) for row in rows if row["metric"] == "fingerprint")


@pytest.mark.parametrize("root", ["soft", "inertial", "grounded"])
def test_the_same_motion_leads_to_the_same_state_as_ever(root: str) -> None:
    here = os.sched_getaffinity(0)
    found = fingerprint(root, here)
    alone = fingerprint(root, {min(here)})
    assert found == alone, "the state depends on the number of threads"
    version = engine(["--version"], here).strip().split(".debian")[0]
    golden = json.loads(GOLDEN.read_text(encoding="utf-8"))
    if version not in golden:
        pytest.skip(f"{GOLDEN.name} has no fingerprint of Godot {version}")
    assert found == golden[version][root], (
        f"the simulation gives {found} where it used to give {golden[version][root]}. If the "
        f"change is meant, write the new number into {Path(GOLDEN).relative_to(ROOT)} under "
        f"'{version}', '{root}', and say in the commit what changed the motion."
    )
