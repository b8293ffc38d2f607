# SPDX-License-Identifier: MIT
"""The C++ tests: as they are, and with sanitizers."""

from __future__ import annotations

import dataclasses
import os
import re
import subprocess
from pathlib import Path

from . import libraries
from .cmake import BuildFolder
from .outcome import Outcome
from .paths import BUILD
from .project import EXTENSIONS


def run_ctest(folder: Path, *options: str) -> Outcome:
    """Runs the C++ unit tests of a build folder."""
    command = ["ctest", "--test-dir", str(folder), "--output-on-failure"]
    done = subprocess.run([*command, *options], stdout=subprocess.PIPE, text=True, check=False)
    print(done.stdout)
    match = re.search(r"(\d+)% tests passed, (\d+) tests? failed out of (\d+)", done.stdout)
    if match is None:
        if "-R" in options:
            return Outcome()
        return Outcome(0, 1, [f"{folder.name}: ctest ran no test"])
    failed, count = int(match.group(2)), int(match.group(3))
    return Outcome(count - failed, failed)


@dataclasses.dataclass(frozen=True)
class Sanitized:
    """A build of the engine-free C++ with sanitizers, and which of its tests are run."""

    folder: str
    sanitizers: str
    has_usb: bool  # With the test of the USB hub at an emulated suit.
    target: str
    ctest: tuple[str, ...] = ()


SANITIZED = [
    Sanitized("sanitized-memory", "address,undefined", False, "core_tests"),
    # One at a time: an emulated suit keeps real time.
    Sanitized("sanitized-threads", "thread", True, "thread_tests", ("-L", "threads")),
]


def run_sanitizers() -> Outcome:
    """Builds and runs the C++ tests with each set of sanitizers; a finding fails its test."""
    outcome = Outcome()
    for build in SANITIZED:
        folder = _build_sanitized(build)
        jobs = () if build.ctest else ("-j", str(os.cpu_count() or 2))
        outcome.add(run_ctest(folder, *build.ctest, *jobs))
    return outcome


def _build_sanitized(build: Sanitized) -> Path:
    folder = BuildFolder(BUILD / build.folder, f"the C++ tests with -fsanitize={build.sanitizers}")
    # umockdev is not of our making: what its threads do would be findings.
    emulator = EXTENSIONS / "xbus" / "suit_emulator"
    options = {
        **libraries.options(BuildFolder(EXTENSIONS, "").record()),
        "DISMOUNT_UMOCKDEV": "OFF",
        "DISMOUNT_SUIT_EMULATOR": str(emulator) if emulator.exists() else "",
        "DISMOUNT_SANITIZE": build.sanitizers,
        "DISMOUNT_EXTENSIONS": "OFF",
        "DISMOUNT_USB": "ON" if build.has_usb else "OFF",
    }
    folder.make(options, [build.target], "")
    return folder.folder
