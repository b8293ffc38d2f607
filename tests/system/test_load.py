# SPDX-License-Identifier: MIT
"""./run load: a server, clients and a bad network, as whole processes.

How much comes how soon is for `./run load` itself to say; here it only has to be measured.
"""

from __future__ import annotations

import json

from toolchain.paths import CLIPS, OUT
from toolchain.processes import free_port

from .conftest import World
from .test_commands import run

CLIENTS = ["--trainees", "2", "--walkers", "1", "--observers", "2"]


def rows_of(*options: str) -> dict[tuple[str, str], dict]:
    done = run(
        "load",
        "--json",
        "--no-goals",
        *CLIENTS,
        "--seconds",
        "2",
        f"--port={free_port()}",
        *options,
    )
    assert done.returncode == 0, done.stderr
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    keys = {"bench", "case", "metric", "value", "unit", "goal", "holds"}
    assert all(set(row) == keys and row["bench"] == "load" for row in rows)
    return {(row["case"], row["metric"]): row for row in rows}


def check_everybody_is_well(rows: dict[tuple[str, str], dict]) -> None:
    for role in ("trainees", "walkers", "observers"):
        assert rows[role, "people known"]["value"] == 3
        assert rows[role, "snapshots of a client"]["value"] > 0.0
        assert rows[role, "age of people, p50"]["value"] > 0.0
        assert rows[role, "from sample to snapshot, p50"]["value"] > 0.0
    assert rows["sessions", "connections lost"]["value"] == 0
    assert rows["sessions", "clients at the end"]["value"] == 5
    assert rows["snapshots", "broken"]["value"] == 0
    assert rows["snapshots", "poses compared"]["value"] > 0
    assert rows["snapshots", "poses that differ between clients"]["value"] == 0
    assert rows["logs", "errors"]["value"] == 0
    assert rows["server networking", "both, CPU per tick"]["value"] > 0.0
    assert rows["server", "tick rate held"]["value"] > 0.0


def test_everybody_knows_everybody_over_a_bad_network() -> None:
    rows = rows_of("--loss", "2", "--delay", "25", "--jitter", "10", "--seed", "3")
    check_everybody_is_well(rows)
    assert 0.0 < rows["wire", "down, loss made"]["value"] < 10.0
    for way in ("down", "up"):
        assert rows["wire", f"{way}, mean of the clients"]["value"] > 0.0
    assert rows["observers", "age of people, p50"]["value"] > 20.0
    whole = json.loads((OUT / "load.json").read_text(encoding="utf-8"))
    assert len(whole["clients"]["clients"]) == 5
    assert len(whole["wire"]["clients"]) == 5
    walker = whole["server"]["after"]["status"]["walkers"][0]
    assert walker["inputs"] > 30


def test_without_a_proxy() -> None:
    rows = rows_of("--snapshot-rate", "30", "--server-options=--root=held")
    check_everybody_is_well(rows)
    assert rows["traffic", "down, mean of the clients"]["value"] > 0.0
    assert rows["observers", "snapshots of a client"]["value"] < 40.0
    assert not any(case == "proxy" for case, _ in rows)


def test_bad_options() -> None:
    for options in (["--trainees", "abc"], ["--loss", "200"], ["--trainees=0", "--observers=0"]):
        done = run("load", *options)
        assert done.returncode == 2
        assert options[0].removeprefix("--").split("=")[0] in done.stderr
        assert done.stdout == ""


def test_the_role_itself_checks_what_it_is_asked_for(world: World) -> None:
    nobody = world.client("load", "--trainees=0", "--observers=0", name="nobody")
    assert nobody.await_exit() == 2
    assert "there are no clients" in nobody.log()
    still = world.client("load", "--trainees=1", name="still")
    assert still.await_exit() == 2
    assert "--bvh=FILE" in still.log()
    world.server("--max-clients=1")
    clip = f"--bvh={CLIPS / '01_01.bvh'}"
    refused = world.client("load", "--password=none", "--trainees=1", clip, name="refused")
    assert refused.await_exit() == 3
    assert "the server refused us" in refused.log()
    waits = world.client("load", "--trainees=1", "--observers=1", clip, name="waits")
    waits.await_text("waits for room, position 1")
