# SPDX-License-Identifier: MIT
"""The generated files: collected in memory, then written where they changed."""

from __future__ import annotations

from pathlib import Path

_NOTICE = "// Generated from the engine's API dump by gdextension/bindings/generator.\n"


class Output:
    """Files to write, by their path below the output folder."""

    def __init__(self) -> None:
        self.files: dict[str, str] = {}

    def add(self, path: str, lines: list[str], notice: bool = True) -> None:
        """Adds a file."""
        self.files[path] = (_NOTICE if notice else "") + "\n".join(lines).rstrip("\n") + "\n"

    def add_header(self, path: str, lines: list[str]) -> None:
        """Adds a header below include/godot_cpp/."""
        self.add(f"include/godot_cpp/{path}", ["#pragma once", "", *lines])

    def write(self, folder: Path) -> None:
        """Writes what changed (so that little is compiled again) and removes what is stale."""
        for path, text in self.files.items():
            file = folder / path
            if file.exists() and file.read_text(encoding="utf-8") == text:
                continue
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        for file in folder.rglob("*"):
            if file.is_file() and str(file.relative_to(folder)) not in self.files:
                file.unlink()
