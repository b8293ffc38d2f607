# SPDX-License-Identifier: MIT
"""Walls: a CAVE, three monitors and two projectors against one wide picture of the same world."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from bench import Bench
from toolchain.screens import monitors

from displays import run_script

PART = "walls"
# Goals of issue 18.
MAX_MEAN = 0.3
MAX_LIGHT = 2.0
WIDTHS = [480, 480, 480]
HEIGHT = 400
# Off the middle: no wall is seen straight.
EYE = "0.15 1.65 0.1"
WARPS = ("0.02 0.03  0.97 0.0  1.0 0.98  0.0 0.95", "0.0 0.02  0.98 0.04  0.96 1.0  0.03 0.97")


def corners(bottom_left: str, bottom_right: str, top_left: str) -> str:
    """Lines of a screen's corners."""
    return f"bottom-left = {bottom_left}\nbottom-right = {bottom_right}\ntop-left = {top_left}\n"


def cave() -> str:
    """Walls of 2.4 m by 2 m at three sides."""
    sides = {
        "left": corners("-1.2 0.7 1.2", "-1.2 0.7 -1.2", "-1.2 2.7 1.2"),
        "front": corners("-1.2 0.7 -1.2", "1.2 0.7 -1.2", "-1.2 2.7 -1.2"),
        "right": corners("1.2 0.7 -1.2", "1.2 0.7 1.2", "1.2 2.7 -1.2"),
    }
    text = f"[station]\neye = {EYE}\n"
    for number, (name, lines) in enumerate(sides.items()):
        text += f"[screen {name}]\n{lines}monitor = m{number}\n"
    return text


def row() -> str:
    """Three screens of 1.2 m by 1 m in a row, on monitors by number."""
    text = f"[station]\neye = {EYE}\n"
    for number in range(3):
        left = -1.8 + 1.2 * number
        place = (f"{left} 1 -1.5", f"{left + 1.2} 1 -1.5", f"{left} 2 -1.5")
        text += f"[screen s{number}]\n{corners(*place)}monitor = {number}\n"
    return text


def seam() -> str:
    """Two projectors of 2 m by 1.25 m that overlap by 0.5 m, both out of square."""
    text = f"[station]\neye = {EYE}\n"
    for number, left in enumerate((-1.75, -0.25)):
        place = (f"{left} 1 -2", f"{left + 2.0} 1 -2", f"{left} 2.25 -2")
        edge = "right" if number == 0 else "left"
        text += f"[screen p{number}]\n{corners(*place)}position = {number * 720} 0\n"
        text += f"size = 640 400\nwarp = {WARPS[number]}\nblend-{edge} = 0.25\n"
    return text


def compare(bench: Bench, case: str, layout: str, environment: dict[str, str]) -> dict[str, Any]:
    """What a case finds."""
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        file = Path(folder) / f"{case}.cfg"
        file.write_text(layout, encoding="utf-8")
        options = [f"--case={case}", f"--layout={file}"]
        return run_script(bench, "wall_pictures.gd", options, environment)[-1]


def measure(bench: Bench) -> None:
    """Compares pictures of walls."""
    add = bench.stats.add
    with monitors(WIDTHS, HEIGHT) as environment:
        found = compare(bench, "cave", cave(), environment)
        add("a CAVE, stitched", "mean difference", found["mean"], "/255", at_most=MAX_MEAN)
        add("a CAVE, stitched", "of the wide picture", found["covered"], "", at_least=0.99)
        found = compare(bench, "monitors", row(), environment)
        add("three monitors", "seen by the engine", found["screens"], "", at_least=3)
        add("three monitors", "mean difference", found["mean"], "/255", at_most=MAX_MEAN)
        found = compare(bench, "seam", seam(), environment)
        case = "two projectors, warped and blended"
        add(case, "mean difference, overlap", found["seam"], "/255 of light", at_most=MAX_LIGHT)
        add(case, "mean difference, beside", found["beside"], "/255 of light", at_most=MAX_LIGHT)
        add(case, "largest difference, overlap", found["most"], "/255 of light")
        found = compare(bench, "white", seam(), environment)
        most = found["most"]
        add(case, "largest, of all white", most, "/255 of light", at_most=MAX_LIGHT)
