# SPDX-License-Identifier: MIT
"""ccache for all C++ builds: what any clone has compiled once, none compiles again.

The machine's own, or Debian's in a private folder. Where neither can be had, builds take longer.
"""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import ClassVar

from .apt import SUITE
from .console import Failure, say
from .paths import ROOT, cache, make_folder
from .prefix import Prefix

LAYOUT = 1  # Raised when the way the folder is made changes.
# All builds of some hundred commits.
SIZE = "2G"


class CompilerCache(Prefix):
    """The folder with ccache in `bin/`."""

    name = f"ccache-{SUITE}-{LAYOUT}"
    packages: ClassVar[list[str]] = ["ccache", "patchelf"]
    programs: ClassVar[list[str]] = ["ccache"]
    what = "ccache"
    store = "ccache-packages"
    download_mb = 7
    unpacked_mb = 60
    absent = "There is no ccache"
    remedy = "install ccache"

    def _finish(self, work: Path) -> None:
        pass


def find() -> Path | None:
    """The ccache to compile with, fetched where the machine has none; None where it can't be."""
    installed = shutil.which("ccache")
    if installed:
        return Path(installed)
    try:
        return CompilerCache().program("ccache")
    except Failure as failure:
        say(f"[ -- ] without ccache, so builds take longer: {str(failure).splitlines()[0]}")
        return None


def environment() -> dict[str, str]:
    """An environment for CMake in which tools/compile.sh compiles through ccache."""
    program = find()
    if program is None:
        return dict(os.environ)
    own = {
        "DISMOUNT_CCACHE": str(program),
        "CCACHE_DIR": str(make_folder(cache() / "ccache")),
        "CCACHE_MAXSIZE": SIZE,
        # Paths in the clone count as relative: clones in other folders find what is there.
        "CCACHE_BASEDIR": str(ROOT),
        "CCACHE_NOHASHDIR": "1",
    }
    return {**os.environ, **own}
