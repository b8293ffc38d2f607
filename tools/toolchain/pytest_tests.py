# SPDX-License-Identifier: MIT
"""What is written for pytest: the tools' own tests, bindings, whole processes."""

from __future__ import annotations

import os
import subprocess
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from .godot import Godot
from .paths import BUILD, ROOT, cache
from .project import EXTENSIONS
from .suites import Result

TESTS = ("tests", "gdextension/bindings/tests")
# What failed last time, and nothing where nothing did.
AGAIN = ("--last-failed", "--last-failed-no-failures=none")
SLOWEST = 25


@dataclass
class PytestSuite:
    """Tests that pytest runs."""

    godot: Godot
    tools: Path
    text: str = ""
    chosen: tuple[str, ...] = TESTS
    name: str = "system"

    def run(self) -> Result:
        """Runs all; as they wait for one another, by one worker more than there are processors."""
        # Workers take seconds to start, which a few tests are not worth.
        is_whole = self.chosen == TESTS and not self.text
        workers = ["-n", str((os.cpu_count() or 2) + 1)] if is_whole else []
        return self._run([*workers, f"--durations={SLOWEST}"])

    def run_again(self, failed: Iterable[str]) -> Result:
        """Runs what failed last."""
        del failed  # pytest has kept it.
        return self._run([*AGAIN])

    def _run(self, options: list[str]) -> Result:
        environment = {
            **self.godot.environment(),
            "DISMOUNT_GODOT": str(self.godot.program),
            "DISMOUNT_BUILD": str(EXTENSIONS),
            "DISMOUNT_USER_CACHE": str(cache().parent),
            "PYTHONPATH": str(ROOT / "tools"),
            "PYTHONDONTWRITEBYTECODE": "1",
        }
        report = BUILD / "pytest.xml"
        report.unlink(missing_ok=True)
        command = [str(self.tools / "pytest"), "-p", "toolchain.schedule"]
        command += ["-o", f"cache_dir={BUILD / 'pytest-cache'}", f"--junitxml={report}"]
        command += [*self.chosen, *(["-k", self.text] if self.text else []), *options]
        code = subprocess.run(command, cwd=ROOT, env=environment, check=False).returncode
        if not report.exists():
            return Result(faults=[f"pytest did not finish (exit {code})"])
        result = read_report(report)
        if code not in (0, 1, 5) and not result.failed:
            result.faults.append(f"pytest ended with {code}")
        return result


def read_report(report: Path) -> Result:
    """What a report in JUnit's format says."""
    result = Result()
    for case in ElementTree.parse(report).getroot().iter("testcase"):
        name = f"{case.get('classname')}::{case.get('name')}"
        faults = [*case.findall("failure"), *case.findall("error")]
        if faults:
            said = "\n".join(fault.text or fault.get("message") or "" for fault in faults)
            # A test and its end can fail both.
            result.failed[name] = f"{result.failed.get(name, '')}{said}"
        elif case.find("skipped") is not None:
            result.skipped += 1
        else:
            result.passed.add(name)
    result.passed -= set(result.failed)
    return result
