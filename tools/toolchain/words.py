# SPDX-License-Identifier: MIT
"""The gate that keeps words out which the glossary replaces (docs/glossary.md, column "not").

Only words that hardly ever mean anything else. They are found in names, comments and texts of
scripts and C++: in `_open_lobby` and `OpenLobby` as well as in `the lobby`. In comments of scripts
it also finds phrases that cannot be read at once.
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
# Phrases of comments, and what to write instead. They may go over the end of a line.
PHRASES = {
    r"\b(?:is|are|be|been) told\b": "gets a notice, is sent, is shown",
    r"\btold apart\b": "distinguished",
    r"\b(?:at|from|over|around) a place\b": "position",
    r"\b(?:heading and place|place and heading)\b": "position",
    r"\b(?:body|head|headset|hips)'s? place\b": "position",
    r"\b(?:body|hips|person|shell)'s? way\b": "path, direction",
    r"\b(?:[Ff]or|[Aa]fter) so long\b": "'Time for which ...', 'Time after which ...'",
    r"^(?:Farther|Nearer|Slower|Faster) (?:away|than|from)\b": "'Distance beyond which ...'",
    r"^(?:So|Every so|From so|In so|Over so) (?:many|long|far|much)\b": "name the quantity",
    r"^(?:Of whom|Who comes|What somebody)\b": "a subject first",
}

# Where a word is somebody else's: files (a pattern), the word, whose it is.
ALLOWED = (
    ("gdextension/xbus/device/*", "blob", "Xsens' data item RawBlob"),
    ("gdextension/xbus/tools/decode/*", "visitor", "the design pattern"),
)

_PART = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
_COMMENT = re.compile(r"^\s*##? (.*)$")
_PHRASES = {re.compile(phrase): instead for phrase, instead in PHRASES.items()}
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


def check_phrases(name: str, lines: Iterable[str]) -> Iterator[str]:
    """A line of report for each phrase of [PHRASES] in the comments of a script."""
    for number, text in _comments(lines):
        for phrase, instead in _PHRASES.items():
            for found in phrase.findall(text):
                yield f"{name}:{number}: '{found}': better {instead}"


def _comments(lines: Iterable[str]) -> Iterator[tuple[int, str]]:
    """Each comment of a script as one text, with the number of its first line."""
    begin, texts = 0, []
    for number, line in enumerate([*lines, ""], start=1):
        match = _COMMENT.match(line)
        if match:
            begin = begin if texts else number
            texts.append(match[1])
        elif texts:
            yield begin, " ".join(texts)
            texts = []


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
        if name.endswith(".gd"):
            faults += check_phrases(name, lines)
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
