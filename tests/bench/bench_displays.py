# SPDX-License-Identifier: MIT
"""Displays: stereo, walls, headsets, pacing; what is shown against what should be seen.

Each part is a module of tests/bench/displays, see its __init__.py; all run in virtual displays,
drawn by the processor, where they don't say otherwise. Options: --part=NAME (again for more;
default all).
"""

from __future__ import annotations

import importlib
from types import ModuleType

from bench import Bench, Options, main
from toolchain.paths import ROOT

PARTS = ROOT / "tests" / "bench" / "displays"


def find_parts() -> dict[str, ModuleType]:
    """The parts there are, by name."""
    found = {}
    for path in sorted(PARTS.glob("[a-z]*.py")):
        module = importlib.import_module(f"displays.{path.stem}")
        if hasattr(module, "PART"):
            found[str(module.PART)] = module
    return found


def measure(arguments: list[str]) -> int:
    """Runs the parts and prints their stats."""
    parts = find_parts()
    options = Options(arguments, {"part": tuple(parts)})
    bench = Bench("displays", options.json)
    for part in options["part"]:
        parts[part].measure(bench)
    return bench.finish()


if __name__ == "__main__":
    main(measure)
