# SPDX-License-Identifier: MIT
"""What effects cost, how soon they are seen, how alike both renderers show them, what breaks them.

In a virtual display, drawn by the processor: making an effect, the first shot after loading, 20,000
simple particles, a table of all effects by tier and by number, mean colours (in Forward+ too where
VK_DRIVER_FILES names a Vulkan driver), 10,000 mutated files in a running session; and 20,000
particles at a client beside a server on 127.0.0.1. Options: --part=NAME (again for more: cost,
colours, mutations, session; default all), --mutations=10000, --seconds=30 (of the session),
--write (the tables into docs/effect-costs.md).
"""

from __future__ import annotations

import shutil
import sys
import time
from pathlib import Path
from typing import Any

from bench import SOFTWARE, Bench, Options, main
from toolchain.console import Failure
from toolchain.display import virtual_display
from toolchain.paths import ROOT
from toolchain.processes import ask, free_port, json_lines
from toolchain.stats import Stats

SCRIPTS = "res://tests/bench/effects/"
METHODS = {"Compatibility": "gl_compatibility", "Forward+": "forward_plus"}
PARTS = ("cost", "colours", "mutations", "session")
COST_PARTS = "making,shot,triangles,tiers,counts"
TABLES = ROOT / "docs" / "effect-costs.md"
FIELD = "bench_effects"
# Of 300 particles each.
FOUNTAINS = 67
RATE = 60.0
SETTLE_S = 25.0
# Goals of issue 17.
MAX_SHOT_MS = 50.0
MAX_MAKING_MS = 10.0
MAX_TRIANGLES_MS = 12.0
MAX_COLOUR = 10.0
MAX_HANG_MS = 1000.0
# Lines that a program may say while it is given ten thousand broken files.
MAX_LINES = 100.0


def measure(arguments: list[str]) -> int:
    """Runs the parts and prints their stats."""
    defaults = {"part": PARTS, "mutations": 10000, "seconds": 30.0, "write": False}
    options = Options(arguments, defaults)
    bench = Bench("effects", options.json)
    with virtual_display() as environment:
        if "cost" in options["part"] or "colours" in options["part"]:
            measure_drawing(bench, options, environment)
        if "mutations" in options["part"]:
            measure_mutations(bench, options["mutations"], environment)
        if "session" in options["part"]:
            measure_session(bench, options["seconds"], environment)
    return bench.finish()


def run_script(
    bench: Bench, script: str, method: str, environment: dict[str, str], option: str
) -> tuple[list[dict[str, Any]], int]:
    """What a script tells, and how many lines it and the engine say besides."""
    flags = ["--rendering-method", method, "--audio-driver", "Dummy", "--resolution", "640x360"]
    flags += ["--fixed-fps", "60", "-s", SCRIPTS + script, "--", option]
    texts = bench.run(bench.command(*flags), environment, 3000.0)
    rows = json_lines("\n".join(texts))
    return rows, sum(len(text.splitlines()) for text in texts) - len(rows)


def methods(environment: dict[str, str]) -> dict[str, str]:
    """The renderers that run here."""
    driver = Path(environment["VK_DRIVER_FILES"].split(":")[0])
    return METHODS if driver.is_file() else {"Compatibility": METHODS["Compatibility"]}


def measure_drawing(bench: Bench, options: Options, environment: dict[str, str]) -> None:
    """Costs and colours, with every renderer that there is."""
    colours: dict[str, dict[str, list[float]]] = {}
    tables: list[str] = []
    parts = COST_PARTS if "cost" in options["part"] else ""
    if "colours" in options["part"]:
        parts = f"{parts},colours" if parts else "colours"
    for name, method in methods(environment).items():
        rows, _ = run_script(bench, "effect_costs.gd", method, environment, f"--part={parts}")
        if rows[0]["name"] != method:
            raise Failure(f"{name} was asked for, {rows[0]['name']} came: no driver for it?")
        if "cost" in options["part"]:
            add_costs(bench.stats, name, rows)
            tables += [f"## {name}\n", *tier_table(rows), *count_table(rows)]
        found = [row for row in rows if row["what"] == "colour"]
        colours[name] = {row["effect"]: row["mean"] for row in found if row["pixels"] > 0}
    if "Forward+" in colours:
        for effect, mean in sorted(colours["Forward+"].items()):
            other = colours["Compatibility"].get(effect, [0.0, 0.0, 0.0])
            apart = max(abs(a - b) for a, b in zip(mean, other, strict=True))
            bench.stats.add(effect, "mean colours apart", apart, "of 255", at_most=MAX_COLOUR)
    elif "colours" in options["part"]:
        print("colours are not compared: VK_DRIVER_FILES names no Vulkan driver", file=sys.stderr)
    if options["write"] and tables:
        TABLES.write_text("\n".join([*HEAD, *tables]), encoding="utf-8")


def add_costs(stats: Stats, renderer: str, rows: list[dict[str, Any]]) -> None:
    """Adds what one renderer costs."""
    goal = MAX_MAKING_MS if renderer == "Compatibility" else None
    making = max(row["ms"] for row in rows if row["what"] == "making")
    stats.add(renderer, "making an effect, longest", making, "ms", at_most=goal)
    shot = next(row for row in rows if row["what"] == "shot")
    beyond = shot["first_ms"] - shot["median_ms"]
    stats.add(renderer, "first shot beyond median frame", beyond, "ms", at_most=MAX_SHOT_MS)
    for row in rows:
        if row["what"] == "simple":
            most = MAX_TRIANGLES_MS if row["name"] == "triangle" and goal else None
            stats.add(renderer, f"20,000 x {row['name']}, CPU", row["ms"], "ms", at_most=most)
        elif row["what"] == "tier":
            case = f"{row['effect']}, {row['tier']}, {row['particles']}"
            stats.add(renderer, f"{case}, CPU", row["ms"], "ms")


HEAD = [
    "# What effects cost",
    "",
    "Written by `./run bench effects --write`: processor time of all threads in a frame, ms, above",
    "an empty scene, drawn by the processor, 640x360, at 60 steps a second. Where a graphics card",
    "does most of it, the order still tells.",
    "",
]


def tier_table(rows: list[dict[str, Any]]) -> list[str]:
    """All effects from 8 m, going on all the time, by tier of quality."""
    found: dict[str, dict[str, str]] = {}
    for row in (one for one in rows if one["what"] == "tier"):
        text = f"{max(row['ms'], 0.0):.1f} ({row['particles']})"
        found.setdefault(row["effect"], {})[row["tier"]] = text
    lines = [
        "Every effect from 8 m, as if it went on for ever; in brackets the number of particles.",
        "",
        "| effect | low | medium | high |",
        "|---|---|---|---|",
    ]
    for effect, by_tier in sorted(found.items()):
        lines.append(f"| {effect} | {by_tier['low']} | {by_tier['medium']} | {by_tier['high']} |")
    return [*lines, ""]


def count_table(rows: list[dict[str, Any]]) -> list[str]:
    """All effects from afar, by number of particles."""
    found: dict[str, dict[int, float]] = {}
    for row in (one for one in rows if one["what"] == "count"):
        found.setdefault(row["effect"], {})[row["particles"]] = max(row["ms"], 0.0)
    counts = sorted({count for by_count in found.values() for count in by_count})
    lines = [
        "The first file of each with so many particles, from 90 m: there numbers count, not areas.",
        "",
        "| effect | " + " | ".join(f"{count:,}" for count in counts) + " |",
        "|---" * (len(counts) + 1) + "|",
    ]
    for effect, by_count in sorted(found.items()):
        cells = " | ".join(f"{by_count[count]:.1f}" for count in counts)
        lines.append(f"| {effect} | {cells} |")
    return [*lines, ""]


def measure_mutations(bench: Bench, count: int, environment: dict[str, str]) -> None:
    """Thousands of broken files in a running session."""
    method = METHODS["Compatibility"]
    rows, lines = run_script(bench, "effect_mutations.gd", method, environment, f"--count={count}")
    row = next(row for row in rows if row["what"] == "mutations")
    case = f"{row['count']} mutated files"
    add = bench.stats.add
    add(case, "accepted", row["accepted"], "")
    add(case, "crashes", 0.0, "", at_most=0.0)
    add(case, "refused, but replaced", row["replaced_wrongly"], "", at_most=0.0)
    add(case, "longest check", row["longest_ms"], "ms", at_most=MAX_HANG_MS)
    add("hostile texts", "longest reading", row["hostile_ms"], "ms", at_most=MAX_HANG_MS)
    add(case, "longest frame after one", row["frame_ms"], "ms", at_most=MAX_HANG_MS)
    add(case, "lines of the log", lines, "", at_most=MAX_LINES)


def measure_session(bench: Bench, seconds: float, environment: dict[str, str]) -> None:
    """A client that draws a field of fountains beside a server, on two cores."""
    world = ROOT / "scenes" / "world" / FIELD
    make = ["--headless", "-s", SCRIPTS + "make_field.gd", "--", FIELD, str(FOUNTAINS)]
    try:
        bench.run(bench.command(*make), limit_s=120.0)
        add_session(bench, seconds, environment)
    finally:
        shutil.rmtree(world, ignore_errors=True)


def add_session(bench: Bench, seconds: float, environment: dict[str, str]) -> None:
    """The session, after the level has been made."""
    with bench.session(environment) as (group, _):
        port = free_port()
        server = ["--headless", "--", "--role=server", f"--port={port}", f"--world={FIELD}"]
        group.start("server", bench.command(*server))
        status = group.await_status()
        drawn = [*SOFTWARE, "--resolution", "640x360", "--", "--role=observer", "--quality=high"]
        group.start("observer", bench.command(*drawn, f"--port={port}"))
        time.sleep(SETTLE_S)
        begin, before = time.monotonic(), ask(status)["ticks"]
        time.sleep(seconds)
        report = ask(status)
        missed = (time.monotonic() - begin) * RATE - (report["ticks"] - before)
        if group.exit_code("observer") is not None:
            raise Failure(f"The observer ended:\n{group.log('observer')[-2000:]}")
    case = f"{FOUNTAINS * 300} particles beside a server"
    bench.stats.add(case, "ticks missed", max(missed - 1.0, 0.0), "", at_most=1.0)
    bench.stats.add(case, "work of a tick, p99", report["recent"]["work_ms_p99"], "ms")
    frames = report["sessions"][0]["frames_per_second"]
    bench.stats.add(case, "frames of the client", frames, "/s")


if __name__ == "__main__":
    main(measure)
