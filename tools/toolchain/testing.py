# SPDX-License-Identifier: MIT
"""`./test`: lint and format gates, C++, GDScript and whole-process tests; counts at the end."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .console import Failure, say, step, tail
from .cpp_tests import run_ctest, run_sanitizers
from .godot import Godot, find
from .godot_cpp import checkout, run_godot_cpp
from .lint import run_lint
from .outcome import Outcome
from .paths import BUILD, ROOT, cache, lock, make_folder, user_path
from .project import ALL, EXTENSIONS, prepare

HELP = """./test [PART ...] [options]   sets up everything, then runs every test (or some parts)

  parts       lint      format and lint gates: gdformat, gdlint, clang-format, clang-tidy, ruff,
                        shellcheck
              cpp       C++ unit tests (ctest)
              sanitizers  the same with address and undefined-behaviour sanitizers, and those of
                        several threads with the thread sanitizer; unless it is named, only if
                        the C++ has changed since they passed on this machine
              gdscript  GDScript tests in headless Godot
              system    whole-process tests in pytest, with exported server and clients
  options     --filter=TEXT   only GDScript and system tests whose name has TEXT
              --kernel        only the test with the kernel's own USB drivers, in a virtual machine
                              (a minute; the first time it fetches a kernel and QEMU, 130 MB)
              --godot-cpp=DIR  only this: builds all extensions on a checkout of godot-cpp and loads
                              them (three minutes the first time)
"""

REQUIREMENTS = ROOT / "tests" / "requirements.txt"
TOOLS_FAULT = "The test tools can't be had: check the network, or PIP_INDEX_URL."
# A test that hangs is ended by the runner itself; a busy machine takes five times as long.
GDSCRIPT_LIMIT_S = 3600


def main(arguments: list[str]) -> int:
    """Runs the tests; returns 0 if all passed."""
    if "--help" in arguments or "-h" in arguments:
        print(HELP, end="")
        return 0
    text = next((a.partition("=")[2] for a in arguments if a.startswith("--filter=")), "")
    named = next((a.partition("=")[2] for a in arguments if a.startswith("--godot-cpp=")), "")
    if named:
        return _report(run_godot_cpp(find(), checkout(user_path(named))))
    kernel = "--kernel" in arguments
    parts: dict[str, Callable[[Godot, Path], Outcome]] = {
        "lint": run_lint,
        "cpp": lambda _godot, _tools: run_ctest(EXTENSIONS),
        "sanitizers": lambda _godot, _tools: run_sanitizers(again="sanitizers" in chosen),
        "gdscript": lambda godot, _tools: run_gdscript(godot, text),
        "system": lambda godot, tools: run_pytest(godot, tools, text),
        "kernel": lambda godot, tools: run_pytest(godot, tools, text, ["tests/kernel"]),
    }
    chosen = [argument for argument in arguments if not argument.startswith("--")]
    chosen += ["kernel"] if kernel else []
    unknown = [name for name in chosen if name not in parts]
    options = [a for a in arguments if a.startswith("--") and a != "--kernel"]
    unknown += [option for option in options if not option.startswith("--filter=")]
    if unknown:
        raise Failure(f"There is no '{unknown[0]}': see ./test --help.", 2)
    tools = python_tools()
    godot = prepare(True, ALL)
    total = Outcome()
    for name in chosen or [name for name in parts if name != "kernel"]:
        total.add(_run_part(name, parts[name], godot, tools))
    return _report(total)


def _report(total: Outcome) -> int:
    for note in total.notes:
        print(note)
    print(f"\n{total.passed} passed, {total.failed} failed", flush=True)
    return 0 if total.failed == 0 and total.passed > 0 else 1


def _run_part(
    name: str, part: Callable[[Godot, Path], Outcome], godot: Godot, tools: Path
) -> Outcome:
    say(f"\n=== {name}")
    begin = time.monotonic()
    outcome = part(godot, tools)
    seconds = time.monotonic() - begin
    say(f"=== {name}: {outcome.passed} passed, {outcome.failed} failed ({seconds:.0f} s)")
    return outcome


def python_tools() -> Path:
    """A virtual environment with the test tools, made once for all clones; returns its bin/."""
    wanted = REQUIREMENTS.read_text(encoding="utf-8")
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    # Clones with other requirements have tools of their own, and may run at the same time.
    key = hashlib.sha256(wanted.encode()).hexdigest()[:8]
    folder = cache() / f"test-tools-{version}-{key}"
    stamp = folder / "requirements.txt"
    make_folder(cache())
    with lock(cache() / "test-tools.lock", "setting up the test tools"):
        if stamp.exists() and stamp.read_text(encoding="utf-8") == wanted:
            return folder / "bin"
        with step("install the test tools from PyPI"):
            shutil.rmtree(folder, ignore_errors=True)
            _call([sys.executable, "-m", "venv", str(folder)])
            pip = [str(folder / "bin" / "pip"), "install", "-q", "--disable-pip-version-check"]
            _call([*pip, "-r", str(REQUIREMENTS)])
            stamp.write_text(wanted, encoding="utf-8")
    return folder / "bin"


def _call(command: list[str]) -> None:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failure(TOOLS_FAULT + "\n" + tail(done.stderr or done.stdout, 5))


def run_gdscript(godot: Godot, text: str) -> Outcome:
    """Runs the GDScript tests, side by side; a hang ends after a while, and is named."""
    # Frames come as fast as they can: nobody watches, and a simulated minute takes seconds.
    arguments = ["--fixed-fps", "60", "--path", str(ROOT)]
    arguments += ["-s", "res://tests/framework/test_runner.gd", "--"]
    arguments += [f"--filter={text}"] if text else []
    runners = os.cpu_count() or 2
    with tempfile.TemporaryDirectory() as claims, ThreadPoolExecutor(runners) as pool:
        command = [*arguments, f"--claims={claims}"]
        outcome = Outcome()
        for one in pool.map(lambda number: _run_gdscript(godot, command, number), range(runners)):
            outcome.add(one)
    return outcome if outcome.passed + outcome.failed > 0 else Outcome(0, 1)


def _run_gdscript(godot: Godot, command: list[str], number: int) -> Outcome:
    # Each has its own user://.
    home = f"test-home-{number}"
    code, output = godot.call(command, GDSCRIPT_LIMIT_S, home=home)
    print(output)
    match = re.search(r"^(\d+) passed, (\d+) failed", output, re.M)
    if match is None:
        return Outcome(0, 1, [f"gdscript: the runner did not finish (exit {code})"])
    passed, failed = int(match.group(1)), int(match.group(2))
    # Who is left without a file says so and fails.
    if code != 0 and failed == 0 and passed > 0:
        failed = 1
    leaks = find_leaks(output)
    return Outcome(passed, failed + len(leaks), [f"gdscript: {leak}" for leak in leaks])


def find_leaks(output: str) -> list[str]:
    """What the engine says at its end of what nobody has freed; --verbose has it name each."""
    return re.findall(
        r"^(?:WARNING|ERROR): (.*(?:leaked|in use|in use exist) at exit.*)", output, re.M
    )


SYSTEM_TESTS = ["tests", "gdextension/bindings/tests", "--ignore=tests/kernel"]


def run_pytest(godot: Godot, tools: Path, text: str, chosen: list[str] | None = None) -> Outcome:
    """Runs what is written for pytest: the tools' own tests, bindings, whole processes."""
    report = BUILD / "pytest.xml"
    report.unlink(missing_ok=True)
    command = [str(tools / "pytest"), f"--junitxml={report}", "-p", "no:cacheprovider"]
    # Most of their time processes wait for one another. A file's tests stay together.
    command += ["-n", str((os.cpu_count() or 2) + 1), "--dist", "loadfile"]
    command += SYSTEM_TESTS if chosen is None else chosen
    command += ["-k", text] if text else []
    environment = {
        **godot.environment(),
        "DISMOUNT_GODOT": str(godot.program),
        "DISMOUNT_BUILD": str(EXTENSIONS),
        "DISMOUNT_USER_CACHE": str(cache().parent),
        "PYTHONPATH": str(ROOT / "tools"),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    code = subprocess.run(command, cwd=ROOT, env=environment, check=False).returncode
    if not report.exists():
        return Outcome(0, 1, [f"system: pytest did not finish (exit {code})"])
    suite = ElementTree.parse(report).getroot()[0]
    failed = int(suite.get("failures", 0)) + int(suite.get("errors", 0))
    skipped = int(suite.get("skipped", 0))
    passed = int(suite.get("tests", 0)) - failed - skipped
    if code not in (0, 1, 5) and failed == 0:
        failed = 1
    notes = [f"system: {skipped} skipped"] if skipped else []
    return Outcome(passed, failed, notes)
