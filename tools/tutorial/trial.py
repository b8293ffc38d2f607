# SPDX-License-Identifier: MIT
"""Measures Try level: the seconds from a click in the editor until all three programs are there.

    python -m tutorial.trial LEVEL     (with the test tools' Python, PYTHONPATH=tools)

The editor has the level open in a virtual display, drawn by the processor. Prints a line of JSON;
what the programs say goes to standard error.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
import tempfile
from pathlib import Path

from toolchain.display import virtual_display
from toolchain.godot import find
from toolchain.paths import ROOT
from toolchain.processes import Program, await_that

from .editor import Editor
from .screen import Screen
from .steps import Tutorial

SIZE = "1280x800x24"
SOFTWARE = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]
LIMIT_S = 240.0
END_S = 20.0


def find_all(mark: str) -> list[Path]:
    """Folders in /proc of the programs that have this in their environment."""
    found = []
    for entry in Path("/proc").glob("[0-9]*/environ"):
        # Others' cannot be read; one that has just ended has none.
        with contextlib.suppress(OSError):
            if mark.encode() in entry.read_bytes().split(b"\0"):
                found.append(entry.parent)
    return found


def spent_s(mark: str) -> float:
    """Processor time that these programs have taken together, s."""
    ticks = 0
    for entry in find_all(mark):
        with contextlib.suppress(OSError):
            fields = (entry / "stat").read_text().rpartition(")")[2].split()
            ticks += int(fields[11]) + int(fields[12])
    return ticks / os.sysconf("SC_CLK_TCK")


def end_all(mark: str) -> None:
    """Ends these programs, and waits until they have gone."""

    def are_gone() -> bool:
        found = find_all(mark)
        for entry in found:
            with contextlib.suppress(ProcessLookupError):
                os.kill(int(entry.name), signal.SIGKILL)
        return not found

    await_that(are_gone, "the end of all programs", END_S, look_s=0.1)


def measure(level: str) -> dict[str, float]:
    """The seconds for a level, and the processor time of the editor and the three programs."""
    scene = f"scenes/world/{level}/{level}.tscn"
    command = [str(find().program), *SOFTWARE, "--single-window", "--path", str(ROOT)]
    command += ["--editor", f"res://{scene}"]
    with virtual_display(SIZE) as display, tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        log, probe = folder / "log", folder / "probe.json"
        homes = {f"XDG_{kind}_HOME": f"{name}/{kind}" for kind in ("DATA", "CONFIG", "CACHE")}
        environment = {**os.environ, **display, **homes, "DISMOUNT_KIT_PROBE": str(probe)}
        program = Program(command, log, environment)
        mark = f"DISMOUNT_KIT_PROBE={probe}"
        screen = Screen(display["DISPLAY"])
        try:
            editor = Editor(screen, probe, lambda: program.process.poll() is None)
            editor.await_start()
            editor.await_state(lambda s: s["scene"]["path"].endswith(scene), "the level")
            before = spent_s(mark)
            seconds = Tutorial(editor).start_trial(
                lambda: Tutorial.is_on_level(program.log(), level), LIMIT_S
            )
            return {"seconds": seconds, "processor_s": spent_s(mark) - before}
        finally:
            sys.stderr.write(program.log())
            screen.close()
            program.kill()
            end_all(mark)


if __name__ == "__main__":
    print(json.dumps(measure(sys.argv[1])))
