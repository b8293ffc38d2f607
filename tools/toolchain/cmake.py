# SPDX-License-Identifier: MIT
"""Folders that CMake builds in: what works is kept until something better stands.

CMake's own record of a folder (CMakeCache.txt) says what it was configured with. Only where that
has changed is it configured anew, in place: what stays the same is not compiled again. A folder
that can't go on, as it was moved or its compiler is gone, stays aside until its successor is built.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from . import compiler_cache
from .console import Failure, step, tail
from .paths import ROOT

SOURCE = ROOT / "gdextension"
# Entries of the record that are programs a build goes on with.
PROGRAMS = ("CMAKE_MAKE_PROGRAM", "CMAKE_CXX_COMPILER", "_Python3_EXECUTABLE")
WHY = {
    "GODOT_API_DIR": "the engine's API is another",
    "DISMOUNT_SUIT_EMULATOR": "there is a suit emulator now",
}


class BuildFolder:
    """A folder to build in; `what` is built there, as steps name it."""

    def __init__(self, folder: Path, what: str, source: Path = SOURCE) -> None:
        self.folder = folder
        self.what = what
        self._source = source

    def record(self) -> dict[str, str]:
        """What the folder was configured with; empty if it was not."""
        file = self.folder / "CMakeCache.txt"
        if not file.exists():
            return {}
        text = file.read_text(encoding="utf-8", errors="replace")
        return dict(re.findall(r"^([\w-]+):\w+=(.*)$", text, re.MULTILINE))

    def make(self, options: dict[str, str], targets: Sequence[str], why: str) -> None:
        """Configures the folder if it has to be, and builds targets; `why` is for the second."""
        environment = compiler_cache.environment()
        with self._kept() as end:
            if self._configure(options, end, environment):
                why = ""  # That was said.
            command = ["cmake", "--build", str(self.folder), "-j", str(os.cpu_count() or 2)]
            with step(f"build {self.what}{f': {why}' if why else ''}"):
                run([*command, "--target", *targets], f"Building {self.what}", environment)

    def _end(self) -> str:
        """Why the folder can't go on; empty if it can, or if there is none."""
        record = self.record()
        if not record:
            return ""
        places = (record.get("CMAKE_HOME_DIRECTORY"), record.get("CMAKE_CACHEFILE_DIR"))
        if places != (str(self._source), str(self.folder)):
            return "the clone was moved"
        gone = [record[name] for name in PROGRAMS if not shutil.which(record.get(name, "cmake"))]
        return f"{gone[0]} is gone" if gone else ""

    @contextmanager
    def _kept(self) -> Iterator[str]:
        """Puts a folder that can't go on aside, and back if its successor does not stand; says
        why it can't."""
        end = self._end()
        aside = self.folder.with_name(self.folder.name + ".before")
        if aside.exists():
            # Somebody was stopped in between.
            shutil.rmtree(self.folder, ignore_errors=True)
            aside.rename(self.folder)
            end = self._end()
        if not end:
            yield ""
            return
        self.folder.rename(aside)
        try:
            yield end
        except BaseException:
            shutil.rmtree(self.folder, ignore_errors=True)
            aside.rename(self.folder)
            raise
        shutil.rmtree(aside, ignore_errors=True)

    def _configure(self, options: dict[str, str], end: str, environment: dict[str, str]) -> bool:
        record = self.record()
        changed = [name for name, value in options.items() if record.get(name) != value]
        stands = any((self.folder / name).exists() for name in ("build.ninja", "Makefile"))
        if stands and not changed:
            return False
        reason = end
        if stands:
            reason = "; ".join(dict.fromkeys(_why(name) for name in changed))
        command = ["cmake", "-S", str(self._source), "-B", str(self.folder)]
        if "CMAKE_GENERATOR" not in record:
            command += ["-G", "Ninja" if shutil.which("ninja") else "Unix Makefiles"]
        # Where libraries were found before says nothing of where they are now.
        command += [f"-UDISMOUNT_*_{kind}" for kind in ("LIBRARY", "INCLUDE", "CONFIG")]
        command += [f"-D{name}={value}" for name, value in options.items()]
        with step(f"configure {self.what}{f': {reason}' if reason else ''}"):
            run(command, f"Configuring {self.what}", environment)
        return True


def _why(option: str) -> str:
    if option.startswith("DISMOUNT_") and option.endswith(("_ROOT", "_UMOCKDEV")):
        return "libraries are elsewhere"
    return WHY.get(option, f"{option} has changed")


def run(command: list[str], what: str, environment: dict[str, str] | None = None) -> None:
    """Runs a tool; a failure says the first of its errors and the end of what it said."""
    done = subprocess.run(
        command,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    if done.returncode != 0:
        lines = done.stdout.splitlines()
        errors = [f"    {line}" for line in lines if re.search(r"\berror\b", line, re.IGNORECASE)]
        raise Failure(
            f"{what} failed; its first errors, and the end of what it said:\n"
            + "\n".join([*errors[:10], tail(done.stdout, 20)])
        )
