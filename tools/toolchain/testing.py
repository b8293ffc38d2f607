# SPDX-License-Identifier: MIT
"""`./test`: lint and format gates, C++, GDScript and whole-process tests; counts at the end."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .console import Failure, say, step, tail
from .cpp_tests import run_ctest, run_sanitizers
from .flaky import Ledger
from .gdscript_tests import GDScriptSuite
from .godot import Godot, find
from .godot_cpp import checkout, run_godot_cpp
from .lint import run_lint
from .outcome import Outcome
from .paths import ROOT, cache, lock, make_folder, user_path
from .project import ALL, EXTENSIONS, prepare
from .pytest_tests import PytestSuite
from .suites import Suite, run_suites

HELP = """./test [PART ...] [options]   sets up everything, then runs every test (or some parts)

  parts       lint      format and lint gates: gdformat, gdlint, clang-format, clang-tidy, ruff,
                        shellcheck
              cpp       C++ unit tests (ctest)
              sanitizers  the same with address and undefined-behaviour sanitizers, and those of
                        several threads with the thread sanitizer; unless it is named, only if
                        the C++ has changed since they passed on this machine
              gdscript  GDScript tests in headless Godot
              system    whole-process tests in pytest, with exported server and clients
  options     --filter=TEXT   only tests whose name has TEXT; without a part: cpp, gdscript, system
              --godot-cpp=DIR  only this: builds all extensions on a checkout of godot-cpp and loads
                              them (three minutes the first time)
"""

# Without a part that is named.
WHOLE = ("lint", "cpp", "sanitizers", "gdscript", "system")
FILTERED = ("cpp", "gdscript", "system")
REQUIREMENTS = ROOT / "tests" / "requirements.txt"
TOOLS_FAULT = "The test tools can't be had: check the network, or PIP_INDEX_URL."


def main(arguments: list[str]) -> int:
    """Runs the tests; returns 0 if all passed."""
    if "--help" in arguments or "-h" in arguments:
        print(HELP, end="")
        return 0
    text = next((a.partition("=")[2] for a in arguments if a.startswith("--filter=")), "")
    named = next((a.partition("=")[2] for a in arguments if a.startswith("--godot-cpp=")), "")
    if named:
        return _report(run_godot_cpp(find(), checkout(user_path(named))))
    chosen = [argument for argument in arguments if not argument.startswith("--")]
    unknown = [name for name in chosen if name not in WHOLE]
    options = [a for a in arguments if a.startswith("--")]
    unknown += [option for option in options if not option.startswith("--filter=")]
    if unknown:
        raise Failure(f"There is no '{unknown[0]}': see ./test --help.", 2)
    with ThreadPoolExecutor() as pool:
        # Meanwhile: it waits for the network most of the time.
        fetched = pool.submit(python_tools)
        godot = prepare(True, ALL)
        tools = fetched.result()
    names = chosen or (FILTERED if text else WHOLE)
    parts: dict[str, Callable[[], Outcome]] = {
        "lint": lambda: run_lint(godot, tools),
        "cpp": lambda: run_ctest(EXTENSIONS, *(("-R", text) if text else ())),
        "sanitizers": lambda: run_sanitizers(again="sanitizers" in chosen),
    }
    total = Outcome()
    for name, part in parts.items():
        if name in names:
            total.add(_run_part(name, part))
    suites = _suites(names, text, godot, tools)
    # A part of the tests tells nothing of how often a test is flaky.
    is_whole = "system" in names and not text
    if suites:
        total.add(run_suites(suites, Ledger(cache()) if is_whole else None))
    return _report(total)


def _suites(names: Sequence[str], text: str, godot: Godot, tools: Path) -> list[Suite]:
    processors = os.cpu_count() or 2
    suites: list[Suite] = []
    if "gdscript" in names:
        # Some tests wait for the clock: one more than there are processors, where all are free.
        runners = processors if "system" in names else processors + 1
        suites.append(GDScriptSuite(godot, text, runners))
    if "system" in names:
        suites.append(PytestSuite(godot, tools, text))
    return suites


def _report(total: Outcome) -> int:
    for note in total.notes:
        print(note)
    print(f"\n{total.passed} passed, {total.failed} failed", flush=True)
    return 0 if total.failed == 0 and total.passed > 0 else 1


def _run_part(name: str, part: Callable[[], Outcome]) -> Outcome:
    say(f"\n=== {name}")
    begin = time.monotonic()
    outcome = part()
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
