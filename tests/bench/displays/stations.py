# SPDX-License-Identifier: MIT
"""Stations: two displays, each a process; what they tell one another has 20 ms of jitter."""

from __future__ import annotations

import json
from bisect import bisect_right
from typing import Any

from bench import Bench
from toolchain.console import Failure, tail
from toolchain.processes import free_port
from toolchain.udp_proxy import ProxyProcess

from displays import SCRIPTS

PART = "stations"
# A goal of issue 18: a snapshot is a tick.
MAX_APART = 1.0
JITTER_MS = 20.0
SECONDS = 12
# So long the first words and what one display waits for the other may take.
SETTLED_US = 4e6
CASES = {"as fast": (60, 60, 0), "slow, 40 ms behind": (60, 25, 40)}


def play(bench: Bench, first_fps: int, second_fps: int, behind_ms: int) -> list[dict[str, Any]]:
    """Runs two displays; what each has shown."""
    port = free_port()
    # The proxy draws delays of 10 ms more or less: 20 ms from the quickest to the slowest.
    half = JITTER_MS / 2.0
    with ProxyProcess(port, (1.0, half, half, 3)) as proxy, bench.session() as (group, _):
        commands = {
            "first": ["--leads", f"--port={port}", f"--fps={first_fps}"],
            "second": [f"--port={proxy.port}", f"--fps={second_fps}", f"--behind={behind_ms}"],
        }
        flags = ["--headless", "-s", SCRIPTS + "station_display.gd", "--"]
        for name, options in commands.items():
            group.start(name, bench.command(*flags, *options, f"--seconds={SECONDS}"))
        for name in commands:
            group.await_exit(name, 120.0)
        said = [group.log(name) for name in commands]
    found = []
    for text in said:
        lines = [line for line in text.splitlines() if line.startswith("{")]
        if not lines:
            raise Failure(f"A display of the station said nothing:\n{tail(text)}")
        found.append(json.loads(lines[-1]))
    return found


def apart(first: dict[str, Any], second: dict[str, Any]) -> list[float]:
    """By how many ticks two displays differ at each frame of the second; what the first shows
    between two of its frames is on its way from one to the other."""
    moments, ticks = first["moments"], first["ticks"]
    found = []
    for moment, tick in zip(second["moments"], second["ticks"], strict=True):
        at = bisect_right(moments, moment)
        if 0 < at < len(moments) and moment > moments[0] + SETTLED_US:
            share = (moment - moments[at - 1]) / (moments[at] - moments[at - 1])
            found.append(abs(tick - ticks[at - 1] - share * (ticks[at] - ticks[at - 1])))
    return found


def measure(bench: Bench) -> None:
    """Two displays of one station."""
    for case, (first_fps, second_fps, behind_ms) in CASES.items():
        first, second = play(bench, first_fps, second_fps, behind_ms)
        found = apart(first, second)
        if not found:
            raise Failure("The displays of the station have not run at the same time.")
        name = f"two displays, the second {case}"
        bench.stats.add(name, "most apart", max(found), "snapshots", at_most=MAX_APART)
        bench.stats.add(name, "frames compared", len(found), "")
        bench.stats.add(name, "the first waits", first["report"]["wait_ticks"], "ticks")
