# SPDX-License-Identifier: MIT
"""Runs a small world in a headset of Monado's: for the tests and the benchmark of the headset."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
import time
from pathlib import Path
from types import TracebackType

from .console import Failure, tail
from .godot import Godot
from .monado import Monado
from .paths import ROOT

SCENES = "res://tests/system/hmd/"
# A busy machine looks like a runtime that stalls, which is left and entered again.
LIMIT_S = 600.0
# Without a headset's rate a processor draws frames for nobody.
_WINDOW = ["--resolution", "320x180", "--max-fps", "30"]
# Eyes' pictures of a small target, without anything else.
POSES_LIMIT_S = 180.0


class Stage:
    """The engine with tests/system/hmd/stage.tscn: a headset's display and a few boxes."""

    def __init__(self, godot: Godot, environment: dict[str, str], *flags: str) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="dismount-stage-")
        self._log = Path(self._folder.name) / "stage.log"
        with self._log.open("wb") as log:
            self.process = subprocess.Popen(
                [*_command(godot), *_WINDOW, *flags, SCENES + "stage.tscn"],
                env={**os.environ, **godot.environment(), **environment},
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
            )

    def __enter__(self) -> Stage:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _error: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        self.process.kill()
        self.process.wait()
        self._folder.cleanup()

    def log(self) -> str:
        """What it has said."""
        return self._log.read_text(encoding="utf-8", errors="replace")

    def mark(self) -> int:
        """Where the log ends now."""
        return len(self.log())

    def await_text(self, text: str, since: int = 0, limit_s: float = LIMIT_S) -> str:
        """What was said since a mark, as soon as it holds a text."""
        end = time.monotonic() + limit_s
        while text not in self.log()[since:]:
            if self.process.poll() is not None:
                raise Failure(f"The stage ended with {self.process.returncode}:\n{self._tail()}")
            if time.monotonic() > end:
                raise Failure(f"'{text}' did not come in {limit_s:g} s:\n{self._tail()}")
            time.sleep(0.05)
        return self.log()[since:]

    def _tail(self) -> str:
        return tail(self.log(), 30)


def lose_and_return(stage: Stage, monado: Monado, is_stalled: bool) -> tuple[float, float]:
    """Kills or stalls the runtime under a stage that is worn, and brings it back.

    Returns how long it took until the window went on, and from then to the headset, s.
    """
    stage.await_text("worn true", stage.mark())
    stage.await_text(", guarded", stage.mark())
    process = stage.process.pid
    mark = stage.mark()
    begin = time.monotonic()
    if is_stalled:
        monado.stall()
    else:
        monado.kill()
    # The window shows frames without the headset.
    stage.await_text("worn false", mark)
    without_s = time.monotonic() - begin
    if is_stalled:
        monado.resume()
        monado.kill()
    mark = stage.mark()
    begin = time.monotonic()
    monado.start()
    stage.await_text("worn true", mark)
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
