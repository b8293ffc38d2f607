# SPDX-License-Identifier: MIT
"""What the parts of the benchmark `displays` share.

A part is a module of this folder, found by its name: `stereo.py` is the part `stereo`. It has:

    PART = "stereo"                      # the name, for --part=stereo
    def measure(bench: Bench) -> None    # adds its rows by bench.stats.add(case, metric, ...)

A part runs what it needs by `bench.script()` (a GDScript of this folder, whose lines that begin
with `{` are its findings) or `bench.run()`, and raises `toolchain.console.Failure` where it cannot
measure. A goal is `at_most=` or `at_least=` of `stats.add`. What this machine has not, such as a
GPU or a headset's runtime, is told by `bench.leave_out(case, why)`: the others are measured, and
the benchmark ends with 6. `if __name__ == "__main__"` is not needed.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from typing import Any

from toolchain.console import Failure, tail
from toolchain.godot import Godot
from toolchain.paths import ROOT
from toolchain.stats import LEFT_OUT, Stats

SCRIPTS = "res://tests/bench/displays/"
SOFTWARE = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]


class Bench:
    """The engine, and where results go."""

    def __init__(self, godot: Godot, as_json: bool) -> None:
        self.godot = godot
        self.stats = Stats("displays", as_json)
        self.left_out = 0

    def command(self, *flags: str) -> list[str]:
        """The engine on the sources."""
        return [str(self.godot.program), "--no-header", "--path", str(ROOT), *flags]

    def run(self, command: list[str], environment: dict[str, str], limit_s: float) -> str:
        """Runs a program to its end; returns what it printed."""
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=limit_s,
            check=False,
            env={**os.environ, **self.godot.environment(), **environment},
        )
        if done.returncode != 0:
            said = tail(done.stdout + done.stderr, 20)
            raise Failure(f"{' '.join(command[-3:])} ended with {done.returncode}:\n{said}")
        return done.stdout

    def script(
        self, name: str, options: list[str], environment: dict[str, str], size: str = "640x360"
    ) -> list[dict[str, Any]]:
        """Runs a script of this folder in a window; returns what it found."""
        flags = [*SOFTWARE, "--resolution", size, "-s", SCRIPTS + name, "--", *options]
        said = self.run(self.command(*flags), environment, 900.0)
        return [json.loads(line) for line in said.splitlines() if line.startswith("{")]

    def leave_out(self, case: str, why: str) -> None:
        """Says that a case cannot be measured here."""
        self.left_out += 1
        print(f"displays: {case} is left out: {why}", file=sys.stderr)

    def finish(self) -> int:
        """Prints the stats; returns the exit code."""
        code = self.stats.finish()
        return code if code != 0 or self.left_out == 0 else LEFT_OUT
