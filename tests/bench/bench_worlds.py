# SPDX-License-Identifier: MIT
"""What worlds cost: draws with visible sets and without, tiers of quality, loading, ticks, throws.

Each world is flown through on a fixed path in a virtual display, drawn by the processor; in the
town random views with and without sets are compared. Then, without a window: checking, baking,
crates and throws; in sessions of exported programs on 127.0.0.1: the tick with 8 people and 200
crates, a client's start, a change of level; and Try level, clicked in the editor. Heights of the
desert are `bench terrain`, received levels `bench levels`, people on screen `bench display`.
Options: --world=NAME (again for more), --views=500, --throws=10000, --part=NAME (again for more:
views, bake, physics, session, trial; default all), --pictures=DIR (of views that differ, and of the
tiers).
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.request
from pathlib import Path
from statistics import mean
from typing import Any

from toolchain.console import Failure
from toolchain.display import virtual_display
from toolchain.godot import Godot
from toolchain.paths import CLIENT_BINARY, CLIPS, ROOT, SERVER_BINARY
from toolchain.processes import Group, free_port
from toolchain.project import prepare
from toolchain.stats import Stats
from toolchain.testing import python_tools

SCRIPTS = "res://tests/bench/worlds/"
SOFTWARE = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]
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


class Bench:
    """The options, and where results go."""

    def __init__(self, arguments: list[str]) -> None:
        given: dict[str, list[str]] = {"world": [], "part": []}
        single = {"views": "500", "throws": "10000", "pictures": ""}
        for option in arguments:
            name, _, value = option.removeprefix("--").partition("=")
            if name in given:
                given[name].append(value)
            elif name in single:
                single[name] = value
            elif option != "--json":
                known = ", ".join(f"--{key}" for key in (*given, *single, "json"))
                raise Failure(f"'{option}' is no option: {known}.", 2)
        for count in ("views", "throws"):
            if not single[count].isdigit():
                raise Failure(f"--{count} expects a number, found '{single[count]}'.", 2)
        folder = ROOT / "scenes" / "world"
        there = [
            one.name for one in sorted(folder.iterdir()) if (one / f"{one.name}.tscn").exists()
        ]
        for world in given["world"]:
            if world not in there:
                raise Failure(f"There is no world '{world}': {', '.join(there)}.", 2)
        for part in given["part"]:
            if part not in PARTS:
                raise Failure(f"There is no part '{part}': {', '.join(PARTS)}.", 2)
        self.worlds = given["world"] or there
        self.parts = given["part"] or list(PARTS)
        self.views, self.throws = int(single["views"]), int(single["throws"])
        self.pictures = single["pictures"]
        self.stats = Stats("worlds", "--json" in arguments)
        self.godot: Godot = prepare(export=True)

    def command(self, *flags: str) -> list[str]:
        """The engine on the sources."""
        return [str(self.godot.program), "--no-header", "--path", str(ROOT), *flags]

    def run(self, command: list[str], environment: dict[str, str], limit_s: float) -> str:
        """Runs a program to its end; returns what it printed."""
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=limit_s,
            check=False,
            env={**os.environ, **self.godot.environment(), **environment},
        )
        if done.returncode != 0:
            said = (done.stdout + done.stderr)[-2000:]
            raise Failure(f"{' '.join(command[-3:])} ended with {done.returncode}:\n{said}")
        return done.stdout


def measure(arguments: list[str]) -> int:
    """Runs the parts and prints their stats."""
    bench = Bench(arguments)
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
    return bench.stats.finish()


def measure_views(bench: Bench, world: str, environment: dict[str, str]) -> None:
    """Flies through a world, compares views, times the tiers."""
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        out = Path(folder) / "views.json"
        size = ["--resolution", "480x270"]
        views = bench.views if world == TOWN else bench.views // 10
        options = [f"--world={world}", f"--out={out}", f"--views={views}"]
        options += [f"--pictures={bench.pictures}", f"--tiers={FRAMES if world == TOWN else 0}"]
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
    names = (("draw calls", ""), ("primitives", "k"), ("CPU of a frame", "ms"), ("frame", "ms"))
    for column, (name, unit) in enumerate(names):
        whole = mean(row[column] for row in path["without"])
        stats.add(world, f"{name} on the path, all", whole, unit)
        if found["has_sets"]:
            part = mean(row[column] for row in path["with"])
            stats.add(world, f"{name} on the path, with sets", part, unit)
            goal = {0: MAX_DRAWS_SHARE, 1: MAX_PRIMITIVES_SHARE}.get(column) if is_town else None
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
        stats.add(world, "cells seen from roofs too", found["cells_anywhere"], "")
    tiers = found["tiers"]
    for name, frame_ms in tiers.items():
        stats.add(world, f"tier {name}", 1000.0 / frame_ms, "frames/s")
    if tiers:
        ratio = max(tiers.values()) / min(tiers.values())
        stats.add(world, "lowest tier by highest", ratio, "", at_least=MIN_TIERS)


def measure_bake(bench: Bench) -> None:
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


def measure_physics(bench: Bench) -> None:
    """Checks the town, lets crates fall in it, throws at it."""
    flags = ["--headless", "--fixed-fps", "60", "-s", SCRIPTS + "world_physics.gd"]
    options = [f"--world={TOWN}", f"--crates={CRATES}", f"--throws={bench.throws}"]
    said = bench.run(bench.command(*flags, "--", *options), {}, 3600.0)
    rows = [json.loads(line) for line in said.splitlines() if line.startswith("{")]
    found = {row["what"]: row["value"] for row in rows}
    add = bench.stats.add
    add(TOWN, "check, processor time", found["check_s"], "s", at_most=MAX_CHECK_S)
    add(TOWN, "faults that it finds", found["faults"], "", at_most=0.0)
    add(TOWN, f"{CRATES} crates that fall, tick", found["crates_falling_ms"], "ms")
    resting = found["crates_resting_ms"]
    add(TOWN, f"{CRATES} crates, tick", resting, "ms", at_most=MAX_CRATES_MS)
    for kind, speed in (("boxes", 10), ("balls", 40)):
        add(TOWN, f"{kind} of {speed} m/s thrown", found[f"{kind}_thrown"], "")
        add(TOWN, f"{kind} that went through", found[f"{kind}_through"], "", at_most=0.0)


def measure_tick(bench: Bench) -> None:
    """A server's work with people who move by clips, and crates around them."""
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        environment = {**os.environ, **bench.godot.environment()}
        with Group(Path(folder), environment) as group:
            port = free_port()
            options = [f"--port={port}", f"--world={TOWN}", f"--crates={CRATES}"]
            server = ["--headless", "-s", SCRIPTS + "crowded_server.gd", "--", *options]
            group.start("server", bench.command(*server))
            status = await_status(group)
            clips = [f"--bvh={clip}" for clip in sorted(CLIPS.glob("*.bvh"))]
            load = ["--role=load", f"--port={port}", f"--trainees={PEOPLE}", *clips]
            group.start("load", [str(CLIENT_BINARY), "--headless", "--", *load])
            end = time.monotonic() + 60.0
            while len(look(status)["people"]) < PEOPLE:
                if time.monotonic() > end:
                    raise Failure(f"The people do not join:\n{group.log('load')[-2000:]}")
                time.sleep(0.3)
            time.sleep(TICK_S)
            report = look(status)
    case = f"{TOWN}, {PEOPLE} people, {CRATES} crates"
    add = bench.stats.add
    add(case, "work of a tick, median", report["recent"]["work_ms_p50"], "ms", at_most=MAX_TICK_MS)
    add(case, "work of a tick, p99", report["recent"]["work_ms_p99"], "ms")
    add(case, "ticks", report["ticks_per_second"], "/s", at_least=59.0)


def await_status(group: Group) -> str:
    """Waits for a server; returns the address of its status."""
    mark = "status at http://127.0.0.1:"
    group.await_text("server", mark, 90.0)
    return f"http://127.0.0.1:{group.log('server').split(mark)[1].split('/')[0]}/"


def look(status: str) -> dict[str, Any]:
    """What a server reports."""
    with urllib.request.urlopen(status, timeout=60) as reply:
        report: dict[str, Any] = json.load(reply)
    return report


def measure_session(bench: Bench, environment: dict[str, str]) -> None:
    """A client's start in the town, and a change to another level while it watches."""
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        work = Path(folder)
        with Group(work, environment) as group:
            port = free_port()
            server = ["--role=server", f"--port={port}", f"--world={TOWN}"]
            group.start("server", [str(SERVER_BINARY), "--headless", "--", *server])
            status = await_status(group)
            begin = time.monotonic()
            report = work / "observer.json"
            observer = ["--role=observer", f"--port={port}", f"--report={report}"]
            group.start("observer", [str(CLIENT_BINARY), *SOFTWARE, "--", *observer])
            start_s = await_frames(report, 0, begin)
            trainee = ["--role=trainee", f"--port={port}", f"--bvh={CLIPS / '01_03.bvh'}"]
            group.start("trainee", [str(CLIENT_BINARY), "--headless", "--", *trainee])
            group.await_text("trainee", "joined", 60.0)
            time.sleep(3.0)
            orders = ["--role=instructor", f"--port={port}", f"--orders=world:{OTHER}"]
            begin = time.monotonic()
            group.start("instructor", [str(CLIENT_BINARY), "--headless", "--", *orders])
            change_s = await_level(group, report, begin)
            people = len(look(status)["people"])
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


def measure_trial(bench: Bench) -> None:
    """Try level in the editor: from the click until server, trainee and observer have the level."""
    folder = ROOT / "scenes" / "world" / YARD
    tools = python_tools()
    try:
        bench.run(bench.command("--headless", "-s", SCRIPTS + "make_yard.gd", "--", YARD), {}, 60.0)
        flags = ["--headless", "-s", "res://scripts/world/guard/level_tool.gd", "--", "bake", YARD]
        bench.run(bench.command(*flags), {}, 300.0)
        said = bench.run([str(tools / "python"), "-m", "tutorial.trial", YARD], {}, 600.0)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    found = json.loads(said.splitlines()[-1])
    bench.stats.add("editor", "Try level, all there", found["seconds"], "s", at_most=MAX_TRIAL_S)
    bench.stats.add("editor", "Try level, processor time of all", found["processor_s"], "s")


def read_report(path: Path) -> dict[str, Any]:
    """A client's report, empty while there is none."""
    try:
        report: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return report


def await_frames(report: Path, frames: int, begin: float) -> float:
    """Waits until a client has shown more frames of a world; returns the seconds since a moment."""
    while read_report(report).get("shown_frames", 0) <= frames:
        if time.monotonic() - begin > 120.0:
            raise Failure(f"The client shows nothing: {read_report(report)}")
        time.sleep(0.05)
    return time.monotonic() - begin


def await_level(group: Group, report: Path, begin: float) -> float:
    """Waits until a client shows the other level; returns the seconds since a moment."""
    group.await_text("server", f"world '{OTHER}' is there", 60.0)
    while read_report(report).get("level", {}).get("name") != OTHER:
        if time.monotonic() - begin > 120.0:
            raise Failure(f"The client does not get there: {read_report(report)}")
        time.sleep(0.05)
    return await_frames(report, int(read_report(report).get("shown_frames", 0)), begin)


if __name__ == "__main__":
    try:
        sys.exit(measure(sys.argv[1:]))
    except Failure as failure:
        print(failure, file=sys.stderr)
        sys.exit(2)
