# SPDX-License-Identifier: MIT
"""clang-tidy over our C++, in the units that it is compiled in: headers are most of its work."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

from .passed import Passed, contents
from .paths import ROOT
from .project import EXTENSIONS
from .tracked import tracked

# All that any source may include or be made from, besides the machine's own headers.
HEADERS = (
    ".clang-tidy",
    "gdextension/*.hpp",
    "gdextension/*.inc",
    "gdextension/bindings/generator/*.py",
    "gdextension/build_profile.json",
)
_INCLUDED = re.compile(r'^#include "(.*?)"', re.MULTILINE)


class Tidy:
    """What clang-tidy has to look at, and what it has found to be in order."""

    def __init__(self, tools: Path, engine: str) -> None:
        self._program = str(tools / "clang-tidy")
        compiler = subprocess.run(["c++", "--version"], capture_output=True, text=True, check=False)
        self.passed = Passed("clang-tidy", contents(tracked(*HEADERS)), engine, compiler.stdout)

    def units(self) -> Iterator[tuple[str, str, int]]:
        """What has not passed yet as it is: the file to check, its key, its size."""
        database = json.loads((EXTENSIONS / "compile_commands.json").read_text(encoding="utf-8"))
        own = set(tracked("gdextension/*.cpp"))
        for file, command in {entry["file"]: entry["command"] for entry in database}.items():
            sources = [name for name in _sources(Path(file)) if name in own]
            key = self.passed.key(command.replace(str(ROOT), ""), contents(sources))
            if sources and self.passed.find(key) is None:
                yield file, key, sum((ROOT / name).stat().st_size for name in sources)

    def command(self, file: str) -> list[str]:
        """How a file is checked."""
        return [self._program, "-quiet", "-p", str(EXTENSIONS), file]


def _sources(file: Path) -> list[str]:
    """The sources that a unit includes, or the source itself, from the repository's root."""
    if file.parent.name == "units":
        found = _INCLUDED.findall(file.read_text(encoding="utf-8"))
        return [f"gdextension/{name}" for name in found]
    return [str(file.relative_to(ROOT))] if file.is_relative_to(ROOT) else []
