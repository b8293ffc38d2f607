# SPDX-License-Identifier: MIT
"""What the engine warns of in our scripts when a designer starts the project from the editor."""

from __future__ import annotations

from .console import tail
from .godot import Godot
from .paths import ROOT

LOADER = ROOT / "tools" / "toolchain" / "load_scripts.gd"


def find(godot: Godot, scripts: list[str]) -> str:
    """The engine's warnings and errors of these scripts, paths in the project; nothing if none."""
    paths = [f"res://{name}" for name in scripts]
    # Only with its debugger does the engine look for warnings.
    arguments = ["--debug", "--path", str(ROOT), "-s", str(LOADER), "--", *paths]
    code, text = godot.call(arguments, 300)
    if "WARNING: " in text or "ERROR: " in text:
        return text
    if code != 0 or f"{len(scripts)} scripts loaded" not in text:
        return f"not all {len(scripts)} scripts could be loaded (exit {code}):\n{tail(text)}"
    return ""
