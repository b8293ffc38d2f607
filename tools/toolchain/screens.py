# SPDX-License-Identifier: MIT
"""Several monitors where there is none: a virtual display, cut into logical monitors by xrandr.

xrandr comes from the machine, or from a private folder that only tests and benchmarks make.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import ClassVar

from .apt import SUITE
from .console import Failure
from .display import virtual_display
from .prefix import Prefix

LAYOUT = 1  # Raised when the way the folder is made changes.
# Pixels per millimetre of a usual monitor.
PER_MM = 3.78


class ScreenPrefix(Prefix):
    """The folder: xrandr in `bin/`."""

    name = f"screens-{SUITE}-{LAYOUT}"
    packages: ClassVar[list[str]] = ["x11-xserver-utils", "patchelf"]
    programs: ClassVar[list[str]] = ["xrandr"]
    what = "xrandr"
    download_mb = 10
    unpacked_mb = 60
    absent = "Tests of several monitors need xrandr"
    remedy = "install x11-xserver-utils"

    def _finish(self, work: Path) -> None:
        """There is no Xvfb among these programs."""


def xrandr() -> str:
    """The program, from wherever it is."""
    return shutil.which("xrandr") or str(ScreenPrefix().program("xrandr"))


@contextmanager
def monitors(
    widths: list[int], height: int, keeps_shaders: bool = False
) -> Iterator[dict[str, str]]:
    """A virtual display of monitors beside one another, named m0, m1, ...; yields the environment
    for its clients."""
    program = xrandr()
    with virtual_display(f"{sum(widths)}x{height}x24", keeps_shaders) as environment:
        left = 0
        for number, width in enumerate(widths):
            millimetres = round(width / PER_MM), round(height / PER_MM)
            place = f"{width}/{millimetres[0]}x{height}/{millimetres[1]}+{left}+0"
            output = "screen" if number == 0 else "none"
            done = subprocess.run(
                [program, "--setmonitor", f"m{number}", place, output],
                env={**os.environ, **environment},
                capture_output=True,
                text=True,
                check=False,
            )
            if done.returncode != 0:
                raise Failure(f"xrandr cannot make monitors: {done.stderr.strip()}")
            left += width
        path = f"{os.path.dirname(program)}{os.pathsep}{os.environ.get('PATH', '')}"
        yield {**environment, "PATH": path}
