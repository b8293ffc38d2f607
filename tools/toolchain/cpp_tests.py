# SPDX-License-Identifier: MIT
"""The C++ tests: as they are, and with sanitizers."""

from __future__ import annotations

import dataclasses
import os
import re
import subprocess
import time
from pathlib import Path

from . import libraries
from .cmake import BuildFolder
from .outcome import Outcome
from .passed import Passed, contents, digest
from .paths import BUILD
from .project import EXTENSIONS
from .tracked import tracked


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


# All that these tests are made from and read.
INPUTS = (
    "gdextension/*.cpp",
    "gdextension/*.hpp",
    "gdextension/*.h",
    "gdextension/*CMakeLists.txt",
    "gdextension/*.cmake",
    "gdextension/*/corpus/*",
    "assets/sound/head/*",
    "tests/data/xbus/*",
    "tools/compile.sh",
    "tools/toolchain/cpp_tests.py",
)


def run_sanitizers(again: bool) -> Outcome:
    """Builds and runs the C++ tests with each set of sanitizers; a finding fails its test.

    Only if they have not passed on this machine with the same sources, or `again`.
    """
    outcome = Outcome()
    passed = Passed("sanitizers", _inputs())
    for build in SANITIZED:
        key = passed.key(str(build))
        note = passed.find(key)
        if note is not None and not again:
            said = f"sanitizers ({build.sanitizers}): not run, unchanged since {note}"
            print(said)
            outcome.notes.append(said)
            continue
        found = _run_sanitized(build)
        outcome.add(found)
        if found.failed == 0 and found.passed > 0:
            passed.add(key, f"{found.passed} tests passed on {time.strftime('%Y-%m-%d %H:%M')}")
    passed.prune()
    return outcome


def _run_sanitized(build: Sanitized) -> Outcome:
    folder = _build_sanitized(build)
    jobs = () if build.ctest else ("-j", str(os.cpu_count() or 2))
    return run_ctest(folder, *build.ctest, *jobs)


def _inputs() -> str:
    """A hash over the sources, the compiler, and the libraries that the tests are linked to."""
    compiler = subprocess.run(["c++", "--version"], capture_output=True, text=True, check=False)
    record = BuildFolder(EXTENSIONS, "").record()
    linked = sorted(Path(value) for name, value in record.items() if name.endswith("_LIBRARY"))
    found = [file.read_bytes() for file in linked if file.is_file()]
    return digest([contents(tracked(*INPUTS)), compiler.stdout, *found])


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
