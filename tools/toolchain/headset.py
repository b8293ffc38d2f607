# SPDX-License-Identifier: MIT
"""Runs a small world in a headset of Monado's: for the tests and the benchmark of the headset."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
import time
from pathlib import Path

from .console import Failure, tail
from .godot import Godot
from .monado import Monado
from .paths import ROOT
from .processes import Program

SCENES = "res://tests/system/hmd/"
# A busy machine looks like a runtime that stalls, which is left and entered again.
LIMIT_S = 600.0
# Without a headset's rate a processor draws frames for nobody.
_WINDOW = ["--resolution", "320x180", "--max-fps", "30"]
# Eyes' pictures of a small target, without anything else.
POSES_LIMIT_S = 180.0


class Stage(Program):
    """The engine with tests/system/hmd/stage.tscn: a headset's display and a few boxes."""

    def __init__(self, godot: Godot, environment: dict[str, str], *flags: str) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="dismount-stage-")
        command = [*_command(godot), *_WINDOW, *flags, SCENES + "stage.tscn"]
        whole = {**os.environ, **godot.environment(), **environment}
        super().__init__(command, Path(self._folder.name) / "stage.log", whole)

    def kill(self, limit_s: float = 0.0) -> None:
        """Ends it, and removes its folder."""
        super().kill(limit_s)
        self._folder.cleanup()

    def await_said(self, text: str) -> str:
        """What it has said since the mark, as soon as it holds a text."""
        self.await_text(text, LIMIT_S)
        return self.log()


def lose_and_return(stage: Stage, monado: Monado, is_stalled: bool) -> tuple[float, float]:
    """Kills or stalls the runtime under a stage that is worn, and brings it back.

    Returns how long it took until the window went on, and from then to the headset, s.
    """
    for text in ("worn true", ", guarded"):
        stage.mark()
        stage.await_said(text)
    process = stage.process.pid
    stage.mark()
    begin = time.monotonic()
    if is_stalled:
        monado.stall()
    else:
        monado.kill()
    # The window shows frames without the headset.
    stage.await_said("worn false")
    without_s = time.monotonic() - begin
    if is_stalled:
        monado.resume()
        monado.kill()
    stage.mark()
    begin = time.monotonic()
    monado.start()
    stage.await_said("worn true")
    if stage.process.pid != process:
        raise Failure("The stage is another process than before.")
    return without_s, time.monotonic() - begin


def compare_eyes(godot: Godot, monado: Monado) -> dict:
    """Both eyes' pictures of a target against commanded poses: see tests/system/hmd/eyes.gd."""
    monado.hand_over()
    done = subprocess.run(
        [*_command(godot), "--resolution", "64x64", SCENES + "eyes.tscn"],
        env={
            **os.environ,
            **godot.environment(),
            **monado.environment(),
            "REMOTE_PORT": str(monado.port),
        },
        capture_output=True,
        text=True,
        timeout=POSES_LIMIT_S,
        check=False,
    )
    for line in done.stdout.splitlines():
        if line.startswith("JSON "):
            found = json.loads(line.removeprefix("JSON "))
            if "fault" in found:
                raise Failure(f"The headset does not open: {found['fault']}")
            return found
    raise Failure("The eyes' pictures were not compared:\n" + tail(done.stdout + done.stderr, 30))


def _command(godot: Godot) -> list[str]:
    return [str(godot.program), "--no-header", "--path", str(ROOT), "--audio-driver", "Dummy"]
