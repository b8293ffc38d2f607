# SPDX-License-Identifier: MIT
"""What benchmarks share that drive whole programs: options, the engine on the sources, results.

A benchmark is `bench_NAME.py` with a function that takes the arguments and returns the exit code,
and ends with `main(measure)`. The first line of its docstring says what it measures, the others
name its options.
"""

from __future__ import annotations

import functools
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from toolchain.console import Failure, tail
from toolchain.godot import Godot
from toolchain.paths import ROOT
from toolchain.processes import Group, json_lines
from toolchain.project import prepare
from toolchain.stats import LEFT_OUT, Stats

SOFTWARE = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]
Option = str | int | float | bool | list[str] | tuple[str, ...]


class Options:
    """The options of a benchmark, by the names and types of their defaults.

    A default is a text, a number, False for an option without a value, a list for one that may be
    given again, or a tuple of all values that such a one may have.
    """

    def __init__(self, arguments: list[str], defaults: dict[str, Option]) -> None:
        self.json = "--json" in arguments
        self._values: dict[str, Any] = dict(defaults)
        again: dict[str, list[str]] = {}
        for argument in arguments:
            name, _, value = argument.removeprefix("--").partition("=")
            if name not in defaults and argument != "--json":
                known = ", ".join(f"--{one}" for one in (*defaults, "json"))
                raise Failure(f"'{argument}' is no option: {known}.", 2)
            default = defaults.get(name)
            if isinstance(default, (list, tuple)):
                if isinstance(default, tuple) and value not in default:
                    raise Failure(f"--{name} is one of {', '.join(default)}; found '{value}'.", 2)
                again.setdefault(name, []).append(value)
            elif default is not None:
                self._values[name] = _convert(name, value, default)
        self._values.update(again)

    def __getitem__(self, name: str) -> Any:
        return self._values[name]


def _convert(name: str, value: str, default: Option) -> Option:
    if isinstance(default, bool):
        return True
    try:
        return type(default)(value)
    except ValueError:
        raise Failure(f"--{name} expects a number, found '{value}'.", 2) from None


class Bench:
    """The engine, and where results go."""

    def __init__(self, name: str, as_json: bool, export: bool = False) -> None:
        self.stats = Stats(name, as_json)
        self._name = name
        self._is_exported = export
        self._left_out = 0

    @functools.cached_property
    def godot(self) -> Godot:
        """The engine, once all is built."""
        return prepare(export=self._is_exported)

    def command(self, *flags: str) -> list[str]:
        """The engine on the sources."""
        return [str(self.godot.program), "--no-header", "--path", str(ROOT), *flags]

    def environment(self, more: dict[str, str] | None = None) -> dict[str, str]:
        """What the engine is to know."""
        return {**os.environ, **self.godot.environment(), **(more or {})}

    def run(
        self,
        command: list[str],
        environment: dict[str, str] | None = None,
        limit_s: float = 600.0,
        codes: tuple[int, ...] = (0,),
    ) -> tuple[str, str]:
        """Runs a program to its end; returns what it printed: results, and all else."""
        done = subprocess.run(
            command,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=limit_s,
            check=False,
            env=self.environment(environment),
        )
        if done.returncode not in codes:
            said = tail(done.stdout + done.stderr, 20)
            raise Failure(f"{' '.join(command[-3:])} ended with {done.returncode}:\n{said}")
        return done.stdout, done.stderr

    def rows(
        self, command: list[str], environment: dict[str, str] | None = None, limit_s: float = 900.0
    ) -> list[dict[str, Any]]:
        """The objects that a program prints, a line each."""
        return json_lines(self.run(command, environment, limit_s)[0])

    @contextmanager
    def session(self, environment: dict[str, str] | None = None) -> Iterator[tuple[Group, Path]]:
        """A group of programs, and the folder of their logs, which goes with it."""
        with (
            tempfile.TemporaryDirectory(prefix="dismount-") as folder,
            Group(Path(folder), self.environment(environment)) as group,
        ):
            yield group, Path(folder)

    def leave_out(self, case: str, why: str) -> None:
        """Says that a case cannot be measured here."""
        self._left_out += 1
        print(f"{self._name}: {case} is left out: {why}", file=sys.stderr)

    def finish(self) -> int:
        """Prints the stats; returns the exit code."""
        code = self.stats.finish()
        return code if code != 0 or self._left_out == 0 else LEFT_OUT


def main(measure: Callable[[list[str]], int]) -> None:
    """Runs a benchmark as a program."""
    try:
        sys.exit(measure(sys.argv[1:]))
    except Failure as failure:
        print(failure, file=sys.stderr)
        sys.exit(failure.code)
