# SPDX-License-Identifier: MIT
"""`./run` as its users type it."""

from __future__ import annotations

import json
import os
import re
import socket
import subprocess
from pathlib import Path

from toolchain.paths import CLIPS, OUT, ROOT
from toolchain.processes import free_port


def run(*arguments: str, limit_s: float = 600.0, **environment: str) -> subprocess.CompletedProcess:
    """Calls ./run from a folder elsewhere, without a display."""
    plain = {k: v for k, v in os.environ.items() if not k.startswith("DISMOUNT_")}
    plain.pop("DISPLAY", None)
    plain.pop("WAYLAND_DISPLAY", None)
    # The engine's own folders belong to the test; ./run is to find its own.
    for name in ("XDG_DATA_HOME", "XDG_CONFIG_HOME"):
        plain.pop(name, None)
    if "DISMOUNT_USER_CACHE" in os.environ:
        plain["XDG_CACHE_HOME"] = os.environ["DISMOUNT_USER_CACHE"]
    return subprocess.run(
        [str(ROOT / "run"), *arguments],
        cwd=environment.pop("cwd", str(CLIPS)),
        env={**plain, **environment},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=limit_s,
        check=False,
    )


def test_bvh_tells_what_a_file_holds() -> None:
    done = run("bvh", "01_01.bvh")
    assert done.returncode == 0, done.stderr
    lines = dict(line.split(": ", 1) for line in done.stdout.splitlines())
    assert lines["frames"] == "2751"
    assert lines["joints"] == "31"
    assert lines["frame_time"].startswith("0.00833")
    assert lines["unit"].startswith("CMU")
    assert lines["up"].startswith("Y")


def test_bvh_refuses_a_broken_file(tmp_path: Path) -> None:
    broken = tmp_path / "broken.bvh"
    broken.write_text("HIERARCHY\nROOT Hips\n{\nOFFSET 0 zero 0\n}\n")
    done = run("bvh", "broken.bvh", cwd=str(tmp_path))
    assert done.returncode == 2
    assert "broken.bvh:4:" in done.stderr
    assert done.stdout == ""
    assert run("bvh", "missing.bvh").returncode == 2
    assert run("bvh").returncode == 2


def test_bench_runs() -> None:
    command = ["bench", "tracking", "--json", "--no-goals", "--bvh", "01_01.bvh", "--hz", "60"]
    done = run(*command, "--mode", "velocity_motor", "--root", "held", "--seconds", "3")
    assert done.returncode == 0, done.stderr
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(rows) >= 2
    keys = {"bench", "case", "metric", "value", "unit", "goal", "holds"}
    assert all(set(row) == keys and row["bench"] == "tracking" for row in rows)
    mean = next(row["value"] for row in rows if row["metric"] == "mean error")
    assert 0.01 < mean < 2.0
    assert run("bench", "nonsense").returncode == 2
    assert run("bench", "tracking", "--nonsense", "1").returncode == 2
    assert run("bench", "tracking", "--mode", "magic").returncode == 2


def test_a_bench_goes_on_at_a_bad_file(tmp_path: Path) -> None:
    """A file that is none and one of two frames are named; the third is measured."""
    whole = (ROOT / "assets" / "motion" / "01_01.bvh").read_text(encoding="utf-8")
    hierarchy, frames = whole.split("MOTION")
    rows = [line for line in frames.splitlines() if line and not line.startswith("Frame")]
    head = f"{hierarchy}MOTION\nFrames: 2\nFrame Time: 0.0083333\n"
    short = tmp_path / "short.bvh"
    short.write_text(head + "\n".join(rows[:2]) + "\n", encoding="utf-8")
    none = tmp_path / "none.bvh"
    none.write_text("no motion at all", encoding="utf-8")
    for name, options in {"tracking": ["--hz", "60", "--seconds", "2"], "gait": []}.items():
        files = [f"--bvh={path}" for path in (short, none)]
        done = run("bench", name, "--json", "--no-goals", *files, "--bvh", "01_01.bvh", *options)
        assert done.returncode == 6, done.stderr
        rows = [json.loads(line) for line in done.stdout.splitlines()]
        assert {Path(row["case"]).name for row in rows if "error" in row} == {
            "short.bvh",
            "none.bvh",
        }
        assert any("01_01.bvh" in row["case"] for row in rows if "value" in row)
        assert str(short) in done.stderr and str(none) in done.stderr


def test_a_missed_goal_is_an_exit_code() -> None:
    """With motors this weak, a fist does not do what a stiff arm would."""
    command = ["bench", "contacts", "--json", "--bvh", "01_01.bvh", "--scene", "fist"]
    command += ["--gain", "5"]
    missed = run(*command)
    rows = [json.loads(line) for line in missed.stdout.splitlines()]
    assert any(row["holds"] is False for row in rows)
    assert missed.returncode == 5
    assert run(*command, "--no-goals").returncode == 0


def test_bench_contacts_plays_its_scenes() -> None:
    command = ["bench", "contacts", "--json", "--no-goals", "--bvh", "01_01.bvh", "--body", "file"]
    done = run(*command, "--scene", "wall", "--scene", "fist", "--hz", "60", "--gain", "45")
    assert done.returncode == 0, done.stderr
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    values = {(row["case"].split(",")[0], row["metric"]): row["value"] for row in rows}
    assert all(row["bench"] == "contacts" for row in rows)
    for case in ("wall punch", "wall walk", "wall clip left", "wall clip right"):
        assert 0.0 < values[case, "arm in wall"] < 20.0
    assert 3.0 < values["swing on 10 kg", "fist"] < 5.0
    assert values["swing on 10 kg", "crate"] > values["swing on 40 kg", "crate"] > 0.1
    assert run("bench", "contacts", "--scene", "nonsense").returncode == 2
    assert run("bench", "contacts", "--set", "nonsense=1").returncode == 2


def test_bench_starts_and_drops() -> None:
    command = ["bench", "starts", "--json", "--no-goals", "--bvh", "01_01.bvh", "--root", "soft"]
    done = run(*command, "--hz", "60", "--buffer", "1")
    assert done.returncode == 0, done.stderr
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    worst = [row["value"] for row in rows if row["metric"] == "worst limb after 0.1 s"]
    assert len(worst) == 2  # Who begins, and who goes on after a pause.
    assert max(worst) < 8.0
    done = run("bench", "drops", "--json", "--no-goals", "--bvh", "01_01.bvh", "--count", "2")
    assert done.returncode == 0, done.stderr
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    through = [row["value"] for row in rows if row["metric"] == "limbs in or under the floor"]
    assert through == [0.0, 0.0]


def test_bench_scale() -> None:
    done = run(
        "bench", "scale", "--json", "--no-goals", "--people", "1", "--people", "2", "--seconds", "1"
    )
    assert done.returncode == 0, done.stderr
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    assert any(row["case"] == "2 people by 1" and row["value"] > 0.0 for row in rows)


def test_the_main_job_without_a_display() -> None:
    port = free_port()
    for product in ("observer.png", "observer.avi"):
        (OUT / product).unlink(missing_ok=True)
    done = run("--seconds", "5", DISMOUNT_PORT=str(port))
    assert done.returncode == 0, done.stderr
    for words in ("tick rate held", "tracking error, mean", "bytes/s", "sample to display"):
        assert words in done.stdout
    assert (OUT / "observer.png").stat().st_size > 20000
    film = (OUT / "observer.avi").read_bytes()
    assert film[:4] == b"RIFF"
    assert film[8:12] == b"AVI "
    # The film has sound, whose bytes may look like the head of a picture: only chunks of it count.
    heads = re.finditer(rb"00d[bc](.{4})\xff\xd8\xff", film, re.DOTALL)
    frames = [int.from_bytes(head.group(1), "little") for head in heads]
    assert len(frames) > 60
    # An empty hall is a smooth picture: it takes 24 kB.
    assert min(frames) > 40000
    assert "software rendering" in done.stdout
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("0.0.0.0", port))
    listed = subprocess.run(["ps", "ax"], capture_output=True, text=True, check=False).stdout
    assert f"--port={port}" not in listed


def test_the_main_job_with_a_port_in_use() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as occupant:
        occupant.bind(("0.0.0.0", 0))
        port = occupant.getsockname()[1]
        done = run(f"--port={port}")
    assert done.returncode == 1
    assert f"UDP port {port} is in use" in done.stderr
