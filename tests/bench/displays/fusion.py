# SPDX-License-Identifier: MIT
"""The wearer's body in a headset: a suit that drifts, and a body of headset and hands alone.

In simulated time: a heading that is 30 deg wrong while standing, 10 minutes at 3 deg/min, what is
seen of the correction, the way from the seen hand to the controller, the cost of a sample
(fusion_bench.gd); what headset and hands alone make of recorded people (xr_body_bench.gd). Both
run alone, too, with options for clip, seed, drift, noise, sizes and rate:

    godot --headless --path . -s tests/bench/displays/fusion_bench.gd -- --bvh=FILE --drift=6
"""

from __future__ import annotations

from bench import Bench
from toolchain.processes import json_lines
from toolchain.stats import GOALS_MISSED

from displays import SCRIPTS, add_rows

PART = "fusion"
PROGRAMS = ("fusion_bench.gd", "xr_body_bench.gd")


def measure(bench: Bench) -> None:
    """Adds the figures of all clips."""
    for program in PROGRAMS:
        command = bench.command("--headless", "-s", SCRIPTS + program, "--", "--json")
        # A goal that is missed is a result: it is judged again here.
        add_rows(bench, json_lines(bench.run(command, None, 1800.0, (0, GOALS_MISSED))[0]))
