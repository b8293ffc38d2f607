# SPDX-License-Identifier: MIT
"""A copy of the project in the engine's editor, and what the editor has saved."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

from toolchain.godot import Godot
from toolchain.paths import ROOT
from tutorial.editor import Editor
from tutorial.screen import Screen

from .conftest import SOFTWARE, World

# What a virtual display without Vulkan and V-Sync says of itself, and the bindings' own project,
# which is none of this one.
KNOWN = ("VK_KHR_surface", "err != OK", "V-Sync", "Detected another project.godot")

SCRIPT_LIST = ".godot/editor/filesystem_cache10"

# Twenty frames a second are enough for a hand, and a fifth of the work.
SETTINGS = """[gd_resource type="EditorSettings" format=3]

[resource]
interface/editor/low_processor_mode_sleep_usec = 50000
interface/editor/unfocused_low_processor_mode_sleep_usec = 50000
"""


def complaints(log: str) -> list[str]:
    """What a log has of warnings and errors."""
    found = [line for line in log.splitlines() if "WARNING" in line or "ERROR" in line]
    return [line for line in found if not any(known in line for known in KNOWN)]


def call_git(folder: Path, *arguments: str) -> str:
    named = ["-c", "user.name=test", "-c", "user.email=test@localhost", "-c", "core.autocrlf=false"]
    done = subprocess.run(
        ["git", *named, *arguments], cwd=folder, capture_output=True, text=True, check=True
    )
    return done.stdout


def copy_project(folder: Path) -> None:
    """The project in a repository of its own, with what ./run has built and imported; no editor
    has opened it yet. The import's list of scripts comes with it, as users have it: without it the
    editor draws a frame for each script, which takes ten minutes on a busy machine."""
    listed = call_git(ROOT, "ls-files", "-co", "--exclude-standard", "-z")
    for name in filter(None, listed.split("\0")):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name)
    shutil.copytree(ROOT / "gdextension" / "bin", folder / "gdextension" / "bin")
    shutil.copytree(ROOT / ".godot", folder / ".godot", ignore=shutil.ignore_patterns("editor"))
    (folder / ".godot" / "editor").mkdir()
    shutil.copy2(ROOT / SCRIPT_LIST, folder / SCRIPT_LIST)
    call_git(folder, "init", "-q")
    call_git(folder, "add", "-A")
    call_git(folder, "commit", "-q", "-m", "as it is")


class EditedProject:
    """A copy of the project, and an editor that has it open at a display of its own."""

    def __init__(self, world: World, godot: Godot, display: dict[str, str], scene: str) -> None:
        self.folder = world.folder / "project"
        copy_project(self.folder)
        settings = world.folder / "CONFIG" / "godot" / "editor_settings-4.6.tres"
        settings.parent.mkdir(parents=True)
        settings.write_text(SETTINGS, encoding="utf-8")
        probe = world.folder / "probe.json"
        command = [str(godot.program), *SOFTWARE, "--single-window", "--path", str(self.folder)]
        environment = {**display, "DISMOUNT_KIT_PROBE": str(probe)}
        command += ["--editor", scene]
        self.process = world.start("editor", command, environment, reports=False)
        self.screen = Screen(display["DISPLAY"])
        self.editor = Editor(self.screen, probe, lambda: self.process.process.poll() is None)

    def level_file(self, level: str, kind: str) -> Path:
        """A file of a level."""
        return self.folder / "scenes" / "world" / level / f"{level}.{kind}"

    def changes(self) -> list[str]:
        """What git says is not as it was."""
        return call_git(self.folder, "status", "--porcelain").splitlines()

    def complaints(self) -> list[str]:
        """Warnings and errors of the editor."""
        return complaints(self.process.log())


def sections(scene: Path) -> dict[str, dict[str, str]]:
    """Nodes of a scene as the editor has saved it: their properties by their paths."""
    found: dict[str, dict[str, str]] = {}
    text = scene.read_text(encoding="utf-8")
    for match in re.finditer(r'^\[node name="([^"]+)"([^\n]*)\]\n((?:[^\[\n].*\n)*)', text, re.M):
        parent = re.search(r'parent="([^"]+)"', match.group(2))
        path = match.group(1)
        if parent is not None and parent.group(1) != ".":
            path = f"{parent.group(1)}/{path}"
        found[path] = dict(re.findall(r"^(\S+) = (.*)$", match.group(3), re.M))
    return found
