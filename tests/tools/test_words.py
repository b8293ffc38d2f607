# SPDX-License-Identifier: MIT
"""The gate that keeps words out which the glossary replaces."""

from __future__ import annotations

import pytest
from toolchain.paths import ROOT
from toolchain.words import ALLOWED, INSTEAD, PREFIXES, check, check_phrases


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("## Who waits in the lobby.", "lobby"),
        ("var _open_lobbies: int = 0", "lobbies"),
        ("class PendingVisitor:", "Visitor"),
        ("const MAX_BLOBS: int = 3", "BLOBS"),
        ("int figures_of_a_run = 0;", "figures"),
    ],
)
def test_a_word_that_the_glossary_replaces(line: str, found: str) -> None:
    (fault,) = check("scripts/net/link.gd", ["extends Node", line])
    assert fault.startswith(f"scripts/net/link.gd:2: {found}: the glossary has ")


@pytest.mark.parametrize("line", ["const MOST_PEERS: int = 3", "constexpr int _LEAST_RATE = 3;"])
def test_the_beginning_of_a_constant(line: str) -> None:
    (fault,) = check("gdextension/wire/src/a.hpp", [line])
    assert "the glossary has M" in fault


@pytest.mark.parametrize(
    "line",
    ["its figure, trailing commas, blobby", "AT_MOST, AT_LEAST", "the most_recent one", ""],
)
def test_other_words(line: str) -> None:
    assert list(check("scripts/net/link.gd", [line])) == []


@pytest.mark.parametrize(
    ("lines", "found"),
    [
        (["## Both ends are told."], "are told"),
        (["## Both ends are", "## told."], "are told"),
        (["\t# Bursts at a place."], "at a place"),
        (["## So long it waits, s."], "So long"),
    ],
)
def test_a_phrase_in_a_comment(lines: list[str], found: str) -> None:
    (fault,) = check_phrases("scripts/net/link.gd", ["extends Node", *lines])
    assert fault.startswith(f"scripts/net/link.gd:2: '{found}': better ")


@pytest.mark.parametrize("line", ['_say("you are told")', "## It waits so long.", "##", ""])
def test_phrases_count_in_comments_alone(line: str) -> None:
    assert list(check_phrases("scripts/net/link.gd", [line])) == []


def test_a_word_of_somebody_else() -> None:
    assert list(check("gdextension/xbus/device/items.cpp", ["RawBlob"])) == []
    assert len(list(check("gdextension/wire/src/items.cpp", ["RawBlob"]))) == 1


def test_the_glossary_has_all_of_them() -> None:
    table = (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8").splitlines()
    rows = [line.split("|") for line in table if line.count("|") == 4]
    replaced = {word.strip() for row in rows for word in row[3].split(",")}
    assert set(INSTEAD) <= replaced


def test_the_lists_fit_each_other() -> None:
    assert all(word in INSTEAD for _, word, _ in ALLOWED)
    assert not set(INSTEAD) & {prefix.lower() for prefix in PREFIXES}
