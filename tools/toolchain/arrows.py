# SPDX-License-Identifier: MIT
"""The gate that keeps the order of folders: who in scripts/ and scenes/ may use whom.

`arrows.txt` says the order. A file uses another if it names its class in code (comments and texts
do not count), or its path in a string or as a scene's resource. No script may use itself by way of
others: who reads or changes one of such a circle must know all of them.
"""

from __future__ import annotations

import re
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from .paths import ROOT

ORDER = Path(__file__).with_name("arrows.txt")
FEATURES = "features"
# Levels put together what features offer: they may have vehicles, which know the world.
LEVELS = "levels"
OWN = "."

_TOKEN = re.compile(
    r"""(?P<comment>\#[^\n]*)
      | (?P<text>[&^$]?(?:\"\"\".*?\"\"\"|'''.*?'''|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'))
      | (?P<name>[A-Za-z_]\w*)""",
    re.VERBOSE | re.DOTALL,
)
_PATH = re.compile(r"res://((?:scripts|scenes)/[^\s\"':]+\.(?:gd|tscn|tres))\b")


class OrderError(ValueError):
    """What is wrong with the text of the order itself."""


@dataclass(frozen=True)
class Use:
    """One file that uses another."""

    user: str
    used: str


@dataclass
class Order:
    """The order of folders: for each group ("features", or a feature) the tier of each name."""

    tiers: dict[str, dict[str, int]] = field(default_factory=dict)
    only: dict[str, set[str]] = field(default_factory=dict)

    @classmethod
    def parse(cls, text: str) -> Order:
        """Reads lines such as `net: messages < session < .` and `only net/transport: core`."""
        order = cls()
        for number, line in enumerate(text.splitlines(), 1):
            line = line.split("#", 1)[0].strip()
            if not line:
                continue
            head, colon, tail = (part.strip() for part in line.partition(":"))
            if not colon or not head or not tail:
                raise OrderError(f"line {number}: expected 'NAME: ...', found '{line}'")
            if head.startswith("only "):
                order.only[head.removeprefix("only ").strip()] = set(tail.split())
            elif head in order.tiers:
                raise OrderError(f"line {number}: '{head}' has an order already")
            else:
                order.tiers[head] = _parse_tiers(tail, number)
        if FEATURES not in order.tiers:
            raise OrderError(f"there is no line '{FEATURES}: ...'")
        for group in order.tiers.keys() - {FEATURES} - order.tiers[FEATURES].keys():
            raise OrderError(f"'{group}' has an order, but is no feature")
        return order

    def fault(self, user: str, used: str) -> str:
        """Why files in one folder ("net/session") may not use those in another, or nothing."""
        if user == used:
            return ""
        allowed = self.only.get(user)
        if allowed is not None and used not in allowed and _feature(used) not in allowed:
            return f"{user} may use {' '.join(sorted(allowed))} only"
        group, left, right = FEATURES, _feature(user), _feature(used)
        if left == right:
            group, left, right = left, _inner(user), _inner(used)
        tiers = self.tiers.get(group)
        if tiers is None:
            return ""
        for name in (left, right):
            if name not in tiers:
                return f"'{name}' is not in the line '{group}:'"
        if tiers[left] > tiers[right]:
            return ""
        apart = "beside" if tiers[left] == tiers[right] else "before"
        return f"{left} comes {apart} {right} in the line '{group}:'"

    def unknown(self, folders: Iterable[str]) -> Iterator[str]:
        """What folders have no rank though they need one."""
        seen = sorted(set(folders))
        nested = {_feature(folder) for folder in seen if "/" in folder}
        for feature in sorted({_feature(folder) for folder in seen}):
            if feature not in self.tiers[FEATURES]:
                yield f"{feature}: it is not in the line '{FEATURES}:'"
        for folder in seen:
            feature = _feature(folder)
            if feature in nested and _inner(folder) not in self.tiers.get(feature, {}):
                yield f"{folder}: '{_inner(folder)}' is not in a line '{feature}:'"


def _parse_tiers(text: str, number: int) -> dict[str, int]:
    tiers: dict[str, int] = {}
    for tier, names in enumerate(text.split("<")):
        if not names.split():
            raise OrderError(f"line {number}: nothing stands between two arrows")
        for name in names.split():
            if name in tiers:
                raise OrderError(f"line {number}: '{name}' stands there twice")
            tiers[name] = tier
    return tiers


def _feature(folder: str) -> str:
    return folder.split("/", 1)[0]


def _inner(folder: str) -> str:
    return folder.split("/", 1)[1] if "/" in folder else OWN


def folder_of(path: str) -> str:
    """The folder below scripts/ or scenes/ that a file counts as: scenes do as their feature."""
    parts = PurePosixPath(path).parts
    if parts[:2] == ("scenes", "world") and parts[-1] == f"{parts[2]}.tscn":
        return LEVELS
    if parts[0] == "scenes":
        return parts[1]
    return "/".join(parts[1:-1])


def read_tokens(text: str) -> tuple[set[str], set[str]]:
    """The names in a script's code, and the paths of ours in its texts."""
    names: set[str] = set()
    paths: set[str] = set()
    for token in _TOKEN.finditer(text):
        if token["name"]:
            names.add(token["name"])
        elif token["text"]:
            paths.update(_PATH.findall(token["text"]))
    return names, paths


def find_class(text: str) -> str:
    """The name that a script gives its class, or nothing."""
    found = re.search(r"^(?:@\w+\s+)?class_name\s+(\w+)", text, re.MULTILINE)
    return found[1] if found else ""


def find_uses(files: Mapping[str, str]) -> list[Use]:
    """Who uses whom, of files given as path and text."""
    classes = {find_class(text): path for path, text in files.items() if path.endswith(".gd")}
    uses: set[Use] = set()
    for path, text in files.items():
        if path.endswith(".gd"):
            names, paths = read_tokens(text)
            used = {classes[name] for name in names & classes.keys()} | paths
        else:
            used = set(_PATH.findall(text))
        uses.update(Use(path, other) for other in used - {path})
    return sorted(uses, key=lambda use: (use.user, use.used))


def find_cycles(uses: Iterable[Use]) -> list[list[str]]:
    """Folders that use one another in a ring, each ring once."""
    arrows: dict[str, set[str]] = defaultdict(set)
    for use in uses:
        left, right = folder_of(use.user), folder_of(use.used)
        if left != right and "scenes" not in (use.user[:6], use.used[:6]):
            arrows[left].add(right)
    return find_rings(arrows)


def find_rings(arrows: Mapping[str, Iterable[str]]) -> list[list[str]]:
    """What leads back to itself by arrows from name to names, each ring once."""
    reached = {name: _reach(arrows, name) for name in list(arrows)}
    rings = {
        tuple(sorted(b for b in reached[a] if a in reached.get(b, ())))
        for a in reached
        if a in reached[a]
    }
    return [list(ring) for ring in sorted(rings)]


def _reach(arrows: Mapping[str, Iterable[str]], start: str) -> set[str]:
    seen: set[str] = set()
    waiting = list(arrows.get(start, ()))
    while waiting:
        folder = waiting.pop()
        if folder not in seen:
            seen.add(folder)
            waiting.extend(arrows.get(folder, ()))
    return seen


def find_circles(uses: Iterable[Use]) -> list[list[str]]:
    """Scripts that use one another in a circle: of each knot the shortest circle, in its order."""
    arrows: dict[str, set[str]] = defaultdict(set)
    for use in uses:
        if use.user.endswith(".gd") and use.used.endswith(".gd"):
            arrows[use.user].add(use.used)
    reached = {path: _reach(arrows, path) for path in list(arrows)}
    circles: list[list[str]] = []
    known: set[str] = set()
    for path in sorted(reached):
        if path not in reached[path] or path in known:
            continue
        knot = sorted(other for other in reached[path] if path in reached.get(other, ()))
        known.update(knot)
        circles.append(min((_way_back(arrows, start) for start in knot), key=len))
    return circles


def _way_back(arrows: Mapping[str, set[str]], start: str) -> list[str]:
    """The shortest way from a script in a circle to the one that uses it again."""
    ways = [[start]]
    seen: set[str] = set()
    for way in ways:
        for other in sorted(arrows.get(way[-1], ())):
            if other == start:
                return way
            if other not in seen:
                seen.add(other)
                ways.append([*way, other])
    raise ValueError(f"{start} is in no circle")


def check(files: Mapping[str, str], order: Order) -> list[str]:
    """Everything that breaks the order, a line each."""
    faults = list(order.unknown(folder_of(path) for path in files if path.endswith(".gd")))
    uses = find_uses(files)
    for use in uses:
        left, right = folder_of(use.user), folder_of(use.used)
        if use.used not in files:
            faults.append(f"{use.user} names {use.used}, which is not there")
        elif _is_scene_of(left, use.user, right) or _is_scene_of(right, use.used, left):
            continue
        elif why := order.fault(left, right):
            faults.append(f"{use.user} uses {use.used}: {why}")
    faults += [f"folders in a ring: {', '.join(ring)}" for ring in find_cycles(uses)]
    for circle in find_circles(uses):
        faults.append(f"scripts in a circle: {' -> '.join([*circle, circle[0]])}")
    return faults


def _is_scene_of(feature: str, path: str, other: str) -> bool:
    """Whether a path is a feature's scene, and the other folder lies in that feature."""
    return path.startswith("scenes/") and _feature(other) == feature


def read_files(root: Path) -> dict[str, str]:
    """The scripts and scenes below a folder."""
    found = [path for kind in ("gd", "tscn", "tres") for path in root.glob(f"s*/**/*.{kind}")]
    names = {path.relative_to(root).as_posix(): path for path in found}
    return {
        name: path.read_text(encoding="utf-8")
        for name, path in sorted(names.items())
        if name.startswith(("scripts/", "scenes/"))
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
