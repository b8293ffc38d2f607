# SPDX-License-Identifier: MIT
"""What worlds cost: draws with visible sets and without, tiers of quality, loading, ticks, throws.

Each world is flown through on a fixed path in a virtual display, drawn by the processor; in the
town random views with and without sets are compared. Then, without a window: checking, baking,
crates and throws; in sessions of exported programs on 127.0.0.1: the tick with 8 people and 200
crates, a client's start, a change of level; and Try level, clicked in the editor. Heights of the
desert are `bench terrain`, received levels `bench levels`, people on screen `bench display`.
Options: --world=NAME (again for more), --views=500, --throws=10000, --part=NAME (again for more:
views, bake, physics, session, trial; default all).
"""

from __future__ import annotations

import json
import re
import shutil
import sys
import tempfile
import time
from pathlib import Path
from statistics import mean
from typing import Any

from bench import SOFTWARE, Bench, Options, main
from toolchain.display import virtual_display
from toolchain.paths import CLIENT_BINARY, CLIPS, ROOT, SERVER_BINARY
from toolchain.processes import Group, ask, free_port
from toolchain.stats import Stats
from toolchain.testing import python_tools

SCRIPTS = "res://tests/bench/worlds/"
PARTS = ("views", "bake", "physics", "session", "trial")
# The world that has goals, and to which a session changes.
TOWN = "town"
OTHER = "hangar"
# A level of the kit that is made for the trial and goes again.
YARD = "bench_yard"
# Goals of issue 15.
MAX_DRAWS_SHARE = 0.5
MAX_PRIMITIVES_SHARE = 0.65
MAX_DRAWS = 150.0
MIN_TIERS = 2.5
MAX_CELLS = 0.25
MAX_TICK_MS = 0.6 * 1000.0 / 60.0
MAX_START_S = 15.0
MAX_CHANGE_S = 10.0
MAX_TRIAL_S = 10.0
MAX_CHECK_S = 2.0
MAX_BAKE_S = 60.0
MAX_LOAD_MS = 1500.0
MAX_CRATES_MS = 1.0
PEOPLE = 8
CRATES = 200
TICK_S = 20.0
FRAMES = 12


class WorldBench(Bench):
    """With its options."""

    def __init__(self, arguments: list[str]) -> None:
        folder = ROOT / "scenes" / "world"
        there = [
            one.name for one in sorted(folder.iterdir()) if (one / f"{one.name}.tscn").exists()
        ]
        defaults = {
            "world": tuple(there),
            "part": PARTS,
            "views": 500,
            "throws": 10000,
        }
        self.options = Options(arguments, defaults)
        super().__init__("worlds", self.options.json, export=True)
        self.worlds, self.parts = self.options["world"], self.options["part"]


def measure(arguments: list[str]) -> int:
    """Runs the parts and prints their stats."""
    bench = WorldBench(arguments)
    if "views" in bench.parts:
        with virtual_display() as environment:
            for world in bench.worlds:
                measure_views(bench, world, environment)
    if TOWN in bench.worlds:
        if "bake" in bench.parts:
            measure_bake(bench)
        if "physics" in bench.parts:
            measure_physics(bench)
        if "session" in bench.parts:
            measure_tick(bench)
            with virtual_display() as environment:
                measure_session(bench, environment)
    if "trial" in bench.parts:
        measure_trial(bench)
    return bench.finish()


def measure_views(bench: WorldBench, world: str, environment: dict[str, str]) -> None:
    """Flies through a world, compares views, times the tiers."""
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        out = Path(folder) / "views.json"
        size = ["--resolution", "480x270"]
        views = bench.options["views"] if world == TOWN else bench.options["views"] // 10
        options = [f"--world={world}", f"--out={out}", f"--views={views}"]
        options.append(f"--tiers={FRAMES if world == TOWN else 0}")
        flags = [*SOFTWARE, *size, "-s", SCRIPTS + "world_views.gd", "--", *options]
        bench.run(bench.command(*flags), environment, 3600.0)
        found: dict[str, Any] = json.loads(out.read_text(encoding="utf-8"))
    add_views(bench.stats, world, found)


def add_views(stats: Stats, world: str, found: dict[str, Any]) -> None:
    """Adds what was seen of a world."""
    is_town = world == TOWN
    most_load = MAX_LOAD_MS if is_town else None
    stats.add(world, "load, processor time", found["load_ms"], "ms", at_most=most_load)
    path = found["path"]
    names = (("draw calls", ""), ("primitives", "k"))
    for column, (name, unit) in enumerate(names):
        whole = mean(row[column] for row in path["without"])
        stats.add(world, f"{name} on the path, all", whole, unit)
        if found["has_sets"]:
            part = mean(row[column] for row in path["with"])
            stats.add(world, f"{name} on the path, with sets", part, unit)
            goal = (MAX_DRAWS_SHARE, MAX_PRIMITIVES_SHARE)[column] if is_town else None
            stats.add(world, f"{name} with sets by all", part / whole, "", at_most=goal)
    if found["has_sets"] and found["views"]["count"]:
        views = found["views"]
        for wrong in views["wrong"]:
            print(f"{world}: hidden wrongly: {wrong}", file=sys.stderr)
        stats.add(world, "random views", views["count"], "")
        stats.add(world, "random views that differ", len(views["wrong"]), "", at_most=0.0)
        goal = MAX_DRAWS if is_town else None
        stats.add(world, "most draw calls of a view", views["most_draws"], "", at_most=goal)
        stats.add(
            world,
            "cells seen from streets and ground floors",
            found["cells"],
            "",
            at_most=MAX_CELLS if is_town else None,
        )
    tiers = found["tiers"]
    if tiers:
        ratio = max(tiers.values()) / min(tiers.values())
        stats.add(world, "lowest tier by highest", ratio, "", at_least=MIN_TIERS)


def measure_bake(bench: WorldBench) -> None:
    """Bakes the town, and keeps nothing of it."""
    flags = ["--headless", "-s", "res://scripts/world/guard/level_tool.gd", "--", "bake", TOWN]
    bake = ROOT / "scenes" / "world" / TOWN / f"{TOWN}.bake"
    before = bake.read_bytes()
    try:
        begin = time.monotonic()
        bench.run(bench.command(*flags), {}, 1800.0)
        seconds = time.monotonic() - begin
    finally:
        bake.write_bytes(before)
    bench.stats.add(TOWN, "bake", seconds, "s", at_most=MAX_BAKE_S)


def measure_physics(bench: WorldBench) -> None:
    """Checks the town, lets crates fall in it, throws at it."""
    flags = ["--headless", "--fixed-fps", "60", "-s", SCRIPTS + "world_physics.gd"]
    options = [f"--world={TOWN}", f"--crates={CRATES}", f"--throws={bench.options['throws']}"]
    rows = bench.rows(bench.command(*flags, "--", *options), limit_s=3600.0)
    found = {row["what"]: row["value"] for row in rows}
    add = bench.stats.add
    add(TOWN, "check, processor time", found["check_s"], "s", at_most=MAX_CHECK_S)
    add(TOWN, "faults that it finds", found["faults"], "", at_most=0.0)
    resting = found["crates_resting_ms"]
    add(TOWN, f"{CRATES} crates, tick", resting, "ms", at_most=MAX_CRATES_MS)
    for kind, speed in (("boxes", 10), ("balls", 40)):
        add(TOWN, f"{kind} of {speed} m/s thrown", found[f"{kind}_thrown"], "")
        add(TOWN, f"{kind} that went through", found[f"{kind}_through"], "", at_most=0.0)


def measure_tick(bench: WorldBench) -> None:
    """A server's work with people who move by clips, and crates around them."""
    with bench.session() as (group, _):
        port = free_port()
        options = [f"--port={port}", f"--world={TOWN}", f"--crates={CRATES}"]
        server = ["--headless", "-s", SCRIPTS + "crowded_server.gd", "--", *options]
        group.start("server", bench.command(*server))
        status = group.await_status()
        clips = [f"--bvh={clip}" for clip in sorted(CLIPS.glob("*.bvh"))]
        load = ["--role=load", f"--port={port}", f"--trainees={PEOPLE}", *clips]
        group.start("load", [str(CLIENT_BINARY), "--headless", "--", *load])
        group.await_that("load", lambda: len(ask(status)["people"]) >= PEOPLE, "all people", 60.0)
        time.sleep(TICK_S)
        report = ask(status)
    case = f"{TOWN}, {PEOPLE} people, {CRATES} crates"
    add = bench.stats.add
    add(case, "work of a tick, median", report["recent"]["work_ms_p50"], "ms", at_most=MAX_TICK_MS)
    add(case, "work of a tick, p99", report["recent"]["work_ms_p99"], "ms")
    add(case, "ticks", report["ticks_per_second"], "/s", at_least=59.0)


def measure_session(bench: WorldBench, environment: dict[str, str]) -> None:
    """A client's start in the town, and a change to another level while it watches."""
    with bench.session(environment) as (group, work):
        port = free_port()
        server = ["--role=server", f"--port={port}", f"--world={TOWN}"]
        group.start("server", [str(SERVER_BINARY), "--headless", "--", *server])
        status = group.await_status()
        begin = time.monotonic()
        report = work / "observer.json"
        observer = ["--role=observer", f"--port={port}", f"--report={report}"]
        group.start("observer", [str(CLIENT_BINARY), *SOFTWARE, "--", *observer])
        start_s = await_frames(group, report, 0, begin)
        trainee = ["--role=trainee", f"--port={port}", f"--bvh={CLIPS / '01_03.bvh'}"]
        group.start("trainee", [str(CLIENT_BINARY), "--headless", "--", *trainee])
        group.await_text("trainee", "joined", 60.0)
        time.sleep(3.0)
        orders = ["--role=instructor", f"--port={port}", f"--orders=world:{OTHER}"]
        begin = time.monotonic()
        group.start("instructor", [str(CLIENT_BINARY), "--headless", "--", *orders])
        change_s = await_level(group, report, begin)
        people = len(ask(status)["people"])
        ended = [name for name in ("observer", "trainee") if group.exit_code(name) is not None]
        log = group.log("server")
    add = bench.stats.add
    add("session", f"client start to {TOWN} on screen", start_s, "s", at_most=MAX_START_S)
    add("session", f"change to {OTHER}, seen", change_s, "s", at_most=MAX_CHANGE_S)
    dropped = len(ended) + (1 - people)
    add("session", "clients dropped by the change", dropped, "", at_most=0.0)
    ticks = re.findall(r"\(([0-9.]+) ms of a tick at most\)", log)
    if ticks:
        add("session", "most of a tick for the change", float(ticks[-1]), "ms")


def measure_trial(bench: WorldBench) -> None:
    """Try level in the editor: from the click until server, trainee and observer have the level."""
    folder = ROOT / "scenes" / "world" / YARD
    tools = python_tools()
    try:
        bench.run(bench.command("--headless", "-s", SCRIPTS + "make_yard.gd", "--", YARD), {}, 60.0)
        flags = ["--headless", "-s", "res://scripts/world/guard/level_tool.gd", "--", "bake", YARD]
        bench.run(bench.command(*flags), {}, 300.0)
        said = bench.run([str(tools / "python"), "-m", "tutorial.trial", YARD])[0]
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    found = json.loads(said.splitlines()[-1])
    bench.stats.add("editor", "Try level, all there", found["seconds"], "s", at_most=MAX_TRIAL_S)
    bench.stats.add("editor", "Try level, processor time of all", found["processor_s"], "s")


def read_report(path: Path) -> dict[str, Any]:
    """A client's report."""
    report: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return report


def await_frames(group: Group, report: Path, frames: int, begin: float) -> float:
    """Waits until a client has shown more frames of a world; returns the seconds since a moment."""
    group.await_that(
        "observer", lambda: read_report(report).get("shown_frames", 0) > frames, "a frame"
    )
    return time.monotonic() - begin


def await_level(group: Group, report: Path, begin: float) -> float:
    """Waits until a client shows the other level; returns the seconds since a moment."""
    group.await_text("server", f"world '{OTHER}' is there", 60.0)
    group.await_that(
        "observer", lambda: read_report(report)["level"]["name"] == OTHER, f"the level {OTHER}"
    )
    return await_frames(group, report, int(read_report(report).get("shown_frames", 0)), begin)


if __name__ == "__main__":
    main(measure)
