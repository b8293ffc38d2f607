# SPDX-License-Identifier: MIT
"""The gate that keeps tests beside what they test: `tests/` has the folders, names of `scripts/`.

`tests/net/test_server_link_hostile.gd` begins with `scripts/net/server_link.gd`. A class of C++ may
stand for a script, in any folder.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable
from pathlib import PurePosixPath

from .tracked import tracked

# What tests are made with, and what runs whole scenes and programs.
APART = ("tests/framework/", "tests/bench/", "tests/system/", "tests/examples/")


def check(tests: Iterable[str], scripts: Iterable[str], classes: Iterable[str]) -> list[str]:
    """A line for each test that begins with the name of no script beside it and of no class."""
    beside: dict[str, list[str]] = {}
    for script in scripts:
        path = PurePosixPath(script)
        folder = "tests" / path.parent.relative_to("scripts" if path.parts[0] == "scripts" else "")
        beside.setdefault(str(folder), []).append(path.stem)
    bound = [re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower() for name in classes]
    faults = []
    for test in tests:
        path = PurePosixPath(test)
        if test.startswith(APART) or not path.name.startswith("test_"):
            continue
        stem = path.stem.removeprefix("test_")
        known = beside.get(str(path.parent), []) + bound
        if not any(stem == name or stem.startswith(name + "_") for name in known):
            folder = str(path.parent).replace("tests", "scripts", 1)
            faults.append(f"{test}: begin its name with that of a script in {folder} or of a class")
    return faults


def main() -> int:
    """Checks the repository; returns 1 if a test is named otherwise."""
    classes = [PurePosixPath(name).stem for name in tracked("gdextension/*/doc_classes/*.xml")]
    faults = check(tracked("tests/*.gd"), tracked("scripts/*.gd", "addons/*.gd"), classes)
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
