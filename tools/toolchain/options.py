# SPDX-License-Identifier: MIT
"""docs/options.md and the texts of --help: the program writes them from its own rows.

`./run` reads the roles from the document.
"""

from __future__ import annotations

import re
from pathlib import Path

from . import help_texts
from .console import Failure, tail
from .godot import Godot
from .paths import ROOT, make_folder

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


def files(godot: Godot) -> dict[Path, str]:
    """All that is made from the rows: each file, and what it is to hold."""
    return {DOCUMENT: make(godot), **help_texts.make(godot)}


def write(godot: Godot) -> None:
    """Writes the document and the texts of --help anew."""
    wanted = files(godot)
    for file in help_texts.FOLDER.glob("*.txt"):
        if file not in wanted:
            file.unlink()
    for file, text in wanted.items():
        make_folder(file.parent)
        file.write_text(text, encoding="utf-8")


def fault(godot: Godot) -> str:
    """Says how to renew what differs from the options that the program and the commands have."""
    wanted = files(godot)
    there = {*help_texts.FOLDER.glob("*.txt"), *wanted}
    stale = [
        str(file.relative_to(ROOT))
        for file in sorted(there)
        if not file.exists() or file.read_text(encoding="utf-8") != wanted.get(file)
    ]
    if not stale:
        return ""
    return f"{', '.join(stale)} differ from the options that there are: renew them with {RENEW}"
