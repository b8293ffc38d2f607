# SPDX-License-Identifier: MIT
"""The gate that keeps words out which the glossary replaces (docs/glossary.md, column "not").

Only words that hardly ever mean anything else. They are found in names, comments and texts of
scripts and C++: in `_open_lobby` and `OpenLobby` as well as in `the lobby`.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator
from pathlib import PurePosixPath

from .paths import ROOT
from .tracked import tracked

# A word in the singular, and what the glossary has instead.
INSTEAD = {
    "blob": "encoded person",
    "figures": "stats",
    "goodbye": "reason, disconnect",
    "greeting": "handshake, join request",
    "guest": "pending peer",
    "lobby": "pending peers",
    "trail": "history, delta",
    "visitor": "pending peer",
}
# Beginnings of constants.
PREFIXES = {"MOST": "MAX_", "LONGEST": "MAX_", "LEAST": "MIN_", "SHORTEST": "MIN_"}

# Where a word is somebody else's: files (a pattern), the word, whose it is.
ALLOWED = (
    ("gdextension/xbus/device/*", "blob", "Xsens' data item RawBlob"),
    ("gdextension/xbus/tools/decode/*", "visitor", "the design pattern"),
)

_PART = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
_PREFIX = re.compile(rf"\b_?({'|'.join(PREFIXES)})_\w")


def check(name: str, lines: Iterable[str]) -> Iterator[str]:
    """A line of report for each word of a file that the glossary has another for."""
    path = PurePosixPath(name)
    allowed = {word for files, word, _ in ALLOWED if path.match(files)}
    for number, line in enumerate(lines, start=1):
        for part in _PART.findall(line):
            word = _singular(part.lower())
            if word in INSTEAD and word not in allowed:
                yield f"{name}:{number}: {part}: the glossary has {INSTEAD[word]}"
        for prefix in _PREFIX.findall(line):
            yield f"{name}:{number}: {prefix}_: the glossary has {PREFIXES[prefix]}"


def _singular(word: str) -> str:
    if word in INSTEAD:
        return word
    return word[:-3] + "y" if word.endswith("ies") else word.removesuffix("s")


def main() -> int:
    """Checks the repository; returns 1 if a word is found."""
    names = tracked("scripts/*.gd", "gdextension/*.cpp", "gdextension/*.hpp")
    faults = []
    for name in names:
        lines = (ROOT / name).read_text(encoding="utf-8").split("\n")
        faults += check(name, lines)
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
