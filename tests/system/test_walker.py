# SPDX-License-Identifier: MIT
"""Walks without a suit: by a list, and by the keys of a window."""

from __future__ import annotations

import hashlib
import math
import struct
from pathlib import Path
from typing import Any

from .conftest import CLIPS, WINDOW_LIMIT_S, World
from .pictures import Window

Report = dict[str, Any]


def place(told: Report, key: str = "position") -> tuple[float, float]:
    """Where the walker is over the ground, m; NaN where there is none."""
    rows = told.get("walkers", [])
    return (rows[0][key][0], rows[0][key][2]) if rows else (math.nan, math.nan)


def test_who_names_no_source_walks_with_a_body(world: World) -> None:
    server = world.server()
    trainee = world.client("trainee", "--name=Ada", "--walk=1.2:0:25:1000", "--fps=60")
    begin = place(server.await_report(lambda told: not math.isnan(place(told)[0])))
    told = server.await_report(lambda told: math.dist(place(told), begin) > 1.5)
    # The body goes with it, on its feet.
    assert math.dist(place(told), place(told, "hips")) < 1.0, told["walkers"]
    server.await_report(lambda told: told["people"][0]["count"] > 16 * 120)
    here = trainee.await_report(lambda seen: seen["walking"]["tick"] > 0)["walking"]
    assert here["corrections"] >= 1
    server.mark()
    assert trainee.end() == 0, trainee.log()
    server.await_line("'Ada' (", "left")
    assert "ERROR" not in trainee.log()
    assert "ERROR" not in server.log()


def _own_set(file: Path) -> str:
    """Writes a set of three clips of the shipped one; returns what reports call it."""
    shipped = (CLIPS / "walker.motionset").read_bytes()
    at, clips = 8, {}
    for _ in range(struct.unpack_from("<H", shipped, 6)[0]):
        begin, name = at, shipped[at + 1 : at + 1 + shipped[at]].decode()
        at += 1 + shipped[at] + 1
        at += 4 + 8 + 153 * int(struct.unpack_from("<I", shipped, at)[0])
        clips[name] = shipped[begin:at]
    assert at == len(shipped)
    chosen = [bytes for name, bytes in clips.items() if name.split()[0] in ("stand", "slow")]
    data = shipped[:6] + struct.pack("<H", len(chosen)) + b"".join(chosen)
    file.write_bytes(data)
    return hashlib.sha256(data).hexdigest()[:16]


def test_a_walker_s_own_gait_is_the_server_s_body_s_too(world: World) -> None:
    file = world.folder / "ada.motionset"
    own = _own_set(file)
    server = world.server()
    walk = ("--walk=1.2:0:25:1000", "--fps=60")
    ada = world.client("trainee", "--name=Ada", f"--motion-set={file}", *walk, name="ada")
    world.client("trainee", "--name=Bob", *walk, name="bob")
    told = server.await_report(
        lambda told: (
            sorted(row["motion_set"] for row in told["walkers"]) == sorted([own, "shipped"])
        )
    )
    names = {row["name"]: row["motion_set"] for row in told["walkers"]}
    assert names == {"Ada": own, "Bob": "shipped"}
    assert told["motion_sets"] == {"taken": 1, "refused": 0}
    ada.await_report(lambda seen: seen["walking"]["motion_set"] == {"id": own, "state": "TAKEN"})
    # It walks on by it, on its feet.
    ada_is = [row["name"] for row in told["walkers"]].index("Ada")
    begin = told["walkers"][ada_is]["position"]
    told = server.await_report(
        lambda told: math.dist(told["walkers"][ada_is]["position"], begin) > 1.5
    )
    row = told["walkers"][ada_is]
    assert math.dist(row["position"][::2], row["hips"][::2]) < 1.0, row
    server.await_line("'Ada' (", "walks by a motion set of 3 clips", own)
    # Another level has other walkers, of the same people.
    instructor = world.instructor()
    instructor.type("level yard")
    instructor.await_text("the world is now 'yard'")
    told = server.await_report(
        lambda told: told["level"]["name"] == "yard" and len(told["walkers"]) == 2
    )
    assert {row["name"]: row["motion_set"] for row in told["walkers"]} == names
    assert told["motion_sets"] == {"taken": 1, "refused": 0}
    assert "ERROR" not in ada.log()
    assert "ERROR" not in server.log()


def test_a_set_that_is_none_is_refused_with_a_sentence(world: World) -> None:
    world.server()
    for name, content, why in [
        ("none", None, "cannot read"),
        ("text", b"walk, walk", "this is no motion set"),
    ]:
        file = world.folder / f"{name}.motionset"
        if content is not None:
            file.write_bytes(content)
        client = world.client("trainee", f"--motion-set={file}", name=name)
        assert client.await_exit() == 2
        assert "--motion-set: " in client.log() and why in client.log()


def test_a_walker_s_legs_carry_a_worn_motion(world: World) -> None:
    server = world.server()
    fuse = (f"--bvh={CLIPS / 'Boxing_Toes.bvh'}", "--source=walker", "--fuse=legs:2")
    trainee = world.client("trainee", "--name=Cay", *fuse, "--walk=1.2:0:40:60", "--fps=60")
    begin = trainee.await_report(lambda seen: seen["legs"]["share"] == 1.0)["legs"]["position"]
    # A circle of 1.7 m: as far from its beginning as it gets.
    trainee.await_report(lambda seen: math.dist(seen["legs"]["position"], begin) > 2.5)
    told = server.await_report(lambda told: told["people"][0]["count"] > 16 * 120)
    # One person, whose body goes where its motion is; for the server nobody walks.
    assert len(told["people"]) == 1
    assert told["walkers"] == []
    assert told["people"][0]["mean_deg"] < 8.0, told["people"]
    assert told["people"][0]["distance_m"] < 0.6, told["people"]
    assert "ERROR" not in trainee.log()
    assert "ERROR" not in server.log()


def test_keys_walk_in_a_window(world: World, display: dict[str, str]) -> None:
    server = world.server()
    window = Window(world, display, "--role=trainee", "--quality=low", "--name=Bea")
    begin = place(server.await_report(lambda told: not math.isnan(place(told)[0]), WINDOW_LIMIT_S))
    window.process.await_report(lambda seen: seen["walking"].get("tick", -1) > 0, WINDOW_LIMIT_S)
    with window.holding("w"):
        server.await_report(lambda told: math.dist(place(told), begin) > 1.0, WINDOW_LIMIT_S)
    heading = window.process.fresh_report()["walking"]["heading"]
    with window.holding("Left"):
        window.process.await_report(
            lambda seen: abs(seen["walking"]["heading"] - heading) > 0.5, WINDOW_LIMIT_S
        )
    window.close()
    assert "ERROR" not in server.log()
