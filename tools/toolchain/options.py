# SPDX-License-Identifier: MIT
"""docs/options.md: the program writes it from its own rows; `./run` reads the roles from it."""

from __future__ import annotations

import re

from .console import Failure, tail
from .godot import Godot
from .paths import ROOT

DOCUMENT = ROOT / "docs" / "options.md"
RENEW = "./run options-doc"
_ROLES = "## Roles"
_ROLE = re.compile(r"^\| `([a-z_]+)` \| (.*) \|$", re.MULTILINE)


def roles() -> dict[str, str]:
    """What the program can be started as, and what each is for."""
    text = DOCUMENT.read_text(encoding="utf-8") if DOCUMENT.exists() else ""
    return dict(_ROLE.findall(text.partition(_ROLES)[2].partition("\n## ")[0]))


def make(godot: Godot) -> str:
    """The document as the program has it now."""
    code, text = godot.call(
        ["--no-header", "--path", str(ROOT), "--", "--role=server", "--help=document"], 120
    )
    if code != 0 or not text.startswith("# Options"):
        raise Failure(f"The program does not list its options (exit {code}):\n{tail(text)}")
    return text


def write(godot: Godot) -> None:
    """Writes the document anew."""
    DOCUMENT.write_text(make(godot), encoding="utf-8")


def fault(godot: Godot) -> str:
    """Says how to renew the document if it differs from what the program has."""
    if DOCUMENT.read_text(encoding="utf-8") == make(godot):
        return ""
    return f"docs/options.md differs from the program's options: renew it with {RENEW}"
