# SPDX-License-Identifier: MIT
"""The gate that keeps includes one way: which folder of gdextension/*/src may include which.

`includes.txt` says the order, in the words of `arrows.txt`. Besides, neither folders nor files
may include one another in a ring. What lies outside of a module's src/ is not looked at: bindings
may use everything.
"""

from __future__ import annotations

import re
import sys
from collections import defaultdict
from collections.abc import Mapping
from pathlib import Path, PurePosixPath

from .arrows import Order, Use, find_rings
from .paths import ROOT

ORDER = Path(__file__).with_name("includes.txt")

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.MULTILINE)


def folder_of(path: str) -> str:
    """The module of a file and its folder below src/: "ragdoll_motor/gait"."""
    _, module, _, *folders = PurePosixPath(path).parts[:-1]
    return "/".join([module, *folders])


def _resolve(path: str, name: str, files: Mapping[str, str]) -> str:
    """Which of our files an include means: beside its user, in its module, then in any other."""
    module = PurePosixPath(path).parts[1]
    modules = sorted({PurePosixPath(file).parts[1] for file in files} - {module})
    places = [PurePosixPath(path).parent, *(f"gdextension/{at}/src" for at in [module, *modules])]
    found = (f"{place}/{name}" for place in places)
    return next((file for file in found if file in files), "")


def find_uses(files: Mapping[str, str]) -> list[Use]:
    """Who includes whom, of files given as path and text."""
    uses: set[Use] = set()
    for path, text in files.items():
        names = (_resolve(path, name, files) for name in _INCLUDE.findall(text))
        uses.update(Use(path, used) for used in names if used and used != path)
    return sorted(uses, key=lambda use: (use.user, use.used))


def check(files: Mapping[str, str], order: Order) -> list[str]:
    """Everything that breaks the order, a line each."""
    faults = list(order.unknown(folder_of(path) for path in files))
    between_files: dict[str, set[str]] = defaultdict(set)
    between_folders: dict[str, set[str]] = defaultdict(set)
    for use in find_uses(files):
        left, right = folder_of(use.user), folder_of(use.used)
        between_files[use.user].add(use.used)
        if left != right:
            between_folders[left].add(right)
        if why := order.fault(left, right):
            faults.append(f"{use.user} includes {use.used}: {why}")
    faults += [f"folders in a ring: {', '.join(ring)}" for ring in find_rings(between_folders)]
    faults += [f"files in a ring: {', '.join(ring)}" for ring in find_rings(between_files)]
    return faults


def read_files(root: Path) -> dict[str, str]:
    """The sources of every module's core below a folder."""
    found = [
        path for kind in ("cpp", "hpp") for path in root.glob(f"gdextension/*/src/**/*.{kind}")
    ]
    return {
        path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
        for path in sorted(found)
        if path.relative_to(root).parts[1] != "bindings"  # Generated.
    }


def main() -> int:
    """Checks the repository; the exit status says whether it is in order."""
    text = ORDER.read_text(encoding="utf-8")
    faults = check(read_files(ROOT), Order.parse(text))
    if text not in (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8"):
        faults.append(f"ARCHITECTURE.md does not show {ORDER.relative_to(ROOT)} as it is")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
