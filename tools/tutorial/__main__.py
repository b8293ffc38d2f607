# SPDX-License-Identifier: MIT
"""Makes the pictures of docs/tutorial.md. The level that it builds goes again."""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from pathlib import Path

from toolchain.display import virtual_display
from toolchain.godot import find
from toolchain.paths import ROOT
from toolchain.processes import Program

from .editor import Editor
from .screen import Screen
from .steps import LEVEL, Tutorial

PICTURES = ROOT / "docs" / "pictures" / "tutorial"
TO_JPEG = "res://tools/tutorial/to_jpeg.gd"
SIZE = "1280x800x24"
SOFTWARE = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]


def make_small(pictures: Path) -> None:
    """Has the engine make JPEGs of the pictures, a tenth of the size."""
    code, said = find().call(["--path", str(ROOT), "-s", TO_JPEG, "--", str(pictures)], 120.0)
    if code != 0:
        raise SystemExit(said)


def main() -> int:
    """Makes them."""
    pictures = Path(sys.argv[1]) if len(sys.argv) > 1 else PICTURES
    level = ROOT / "scenes" / "world" / LEVEL
    if level.exists():
        print(f"{level} is there: rename or remove it first", file=sys.stderr)
        return 2
    command = [str(find().program), *SOFTWARE, "--single-window", "--path", str(ROOT), "--editor"]
    with virtual_display(SIZE) as display, tempfile.TemporaryDirectory() as folder:
        probe = Path(folder) / "probe.json"
        homes = {f"XDG_{kind}_HOME": f"{folder}/{kind}" for kind in ("DATA", "CONFIG", "CACHE")}
        environment = {**os.environ, **display, **homes, "DISMOUNT_KIT_PROBE": str(probe)}
        log = Path(folder) / "log"
        program = Program(command, log, environment)
        screen = Screen(display["DISPLAY"])
        try:
            editor = Editor(screen, probe, lambda: program.process.poll() is None)
            editor.await_start()
            tutorial = Tutorial(editor, pictures)
            tutorial.run()
            seconds = tutorial.start_trial(lambda: Tutorial.is_on_level(program.log()), 240.0)
            print(f"Try level: {seconds:.1f} s")
            tutorial.end_trial()
            make_small(pictures)
        finally:
            screen.close()
            program.kill()
            shutil.rmtree(level, ignore_errors=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
