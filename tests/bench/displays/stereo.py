# SPDX-License-Identifier: MIT
"""Stereo without a headset: by how much both eyes see a target apart, on the panel of a display."""

from __future__ import annotations

from bench import Bench
from toolchain.display import virtual_display

from displays import run_script

PART = "stereo"
MODES = ("side-by-side", "anaglyph", "rows", "columns")
# Places of the window on its panel: the second is a row further, the third a column.
ORIGINS = ((40, 20), (40, 21), (41, 21))
# A goal of issue 18.
MAX_PX = 0.1


def measure(bench: Bench) -> None:
    """Compares disparities with what they should be, also after the window has moved."""
    with virtual_display() as environment:
        found = []
        for mode in MODES:
            places = ORIGINS if mode in ("rows", "columns") else ORIGINS[:1]
            origins = ",".join(f"{x}:{y}" for x, y in places)
            options = [f"--modes={mode}", f"--origins={origins}"]
            found += run_script(bench, "stereo_targets.gd", options, environment)
    for mode in MODES:
        for place in dict.fromkeys(row["at"] for row in found if row["mode"] == mode):
            rows = [row for row in found if row["mode"] == mode and row["at"] == place]
            worst = max(abs(row["got"] - row["wanted"]) for row in rows)
            case = f"{mode}, window at {place}"
            bench.stats.add(case, "error of disparity, worst depth", worst, "px", at_most=MAX_PX)
