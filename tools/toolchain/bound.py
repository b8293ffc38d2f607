# SPDX-License-Identifier: MIT
"""The gate that keeps dead methods out of the bindings: what our C++ classes bind is named by some
script, scene, resource or Python file; what is not, and is for users, stands in bound.txt with its
reason.

A property's setter and getter count as named where the property is. Of constants one of a class is
enough: an enum is bound whole.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable

from .paths import ROOT
from .tracked import tracked

# At most so many members are named by tests alone: a test goes through what users use.
ONLY_TESTED_LIMIT = 44
KEPT = ROOT / "tools" / "toolchain" / "bound.txt"
_METHOD = re.compile(r'D_METHOD\(\s*"(\w+)"[^;]*?&(\w+)::')
_PROPERTY = re.compile(
    r'ADD_PROPERTY\(\s*PropertyInfo\([^"]*"(\w+)".*?\)\s*,\s*"(\w*)",\s*"(\w+)"\);', re.DOTALL
)
_CONSTANT = re.compile(r"BIND_(?:ENUM_)?CONSTANT\((\w+)\)")


def find_unnamed(sources: Iterable[str], named: set[str]) -> list[str]:
    """What C++ sources bind and nobody names, as Class.member."""
    unnamed = []
    for source in sources:
        properties = _PROPERTY.findall(source)
        methods = _METHOD.findall(source)
        alive = set(named)
        for name, setter, getter in properties:
            if named & {name, setter, getter}:
                alive |= {name, setter, getter}
        owner = methods[0][1] if methods else "?"
        unnamed += [f"{owner}.{name}" for name, *_ in properties if name not in alive]
        accessors = {accessor for _, *pair in properties for accessor in pair}
        unnamed += [
            f"{of}.{name}" for name, of in methods if name not in alive and name not in accessors
        ]
        constants = _CONSTANT.findall(source)
        if constants and not named & set(constants):
            unnamed += [f"{owner}.{name}" for name in constants]
    return unnamed


def check(found: Iterable[str], kept: Iterable[str]) -> list[str]:
    """A line for each member that nobody names, and for each that is kept for no reason."""
    unnamed = list(found)
    reasons: dict[str, str] = {}
    for line in kept:
        if line.strip() and not line.startswith("#"):
            member, _, reason = line.strip().partition(" ")
            reasons[member] = reason.strip()
    faults = [
        f"{member}: no script names it; unbind it, or give a reason in bound.txt"
        for member in unnamed
        if member not in reasons
    ]
    faults += [f"bound.txt: {member}: give a reason" for member in reasons if not reasons[member]]
    stale = sorted(set(reasons) - set(unnamed))
    return faults + [f"bound.txt: {member} is named or is not bound: remove it" for member in stale]


def names_in(*folders: str) -> set[str]:
    """Every word of the scripts, scenes, resources and Python files of some folders."""
    named: set[str] = set()
    for name in tracked(*(f"{d}/*.{end}" for d in folders for end in ("gd", "tscn", "tres", "py"))):
        named |= set(re.findall(r"\w+", (ROOT / name).read_text(encoding="utf-8")))
    return named


def main() -> int:
    """Checks the repository; returns 1 if something is bound for nobody."""
    of_users = names_in("scripts", "scenes", "addons", "examples")
    sources = [(ROOT / name).read_text() for name in tracked("gdextension/*/binding/*.cpp")]
    unnamed = find_unnamed(sources, of_users | names_in("tests"))
    faults = check(unnamed, KEPT.read_text().splitlines())
    only_tested = sorted(set(find_unnamed(sources, of_users)) - set(unnamed))
    if len(only_tested) > ONLY_TESTED_LIMIT:
        faults.append(
            f"{len(only_tested)} members are named by tests alone, {ONLY_TESTED_LIMIT} may be: "
            + ", ".join(only_tested)
        )
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
