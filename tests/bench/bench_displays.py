# SPDX-License-Identifier: MIT
"""Displays: stereo, walls, headsets, pacing; what is shown against what should be seen.

Each part is a module of tests/bench/displays, see its __init__.py; all run in virtual displays,
drawn by the processor, where they don't say otherwise. Options: --part=NAME (again for more;
default all).
"""

from __future__ import annotations

import importlib
import sys
from types import ModuleType

from displays import Bench
from toolchain.console import Failure
from toolchain.paths import ROOT
from toolchain.project import prepare

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
    chosen: list[str] = []
    for option in arguments:
        name, _, value = option.removeprefix("--").partition("=")
        if name == "part":
            if value not in parts:
                raise Failure(f"There is no part '{value}': {', '.join(parts)}.", 2)
            chosen.append(value)
        elif option != "--json":
            raise Failure(f"'{option}' is no option: --part=NAME, --json.", 2)
    bench = Bench(prepare(export=False), "--json" in arguments)
    for part in chosen or parts:
        parts[part].measure(bench)
    return bench.finish()


if __name__ == "__main__":
    try:
        sys.exit(measure(sys.argv[1:]))
    except Failure as failure:
        print(failure, file=sys.stderr)
        sys.exit(2)
