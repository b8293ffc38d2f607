# SPDX-License-Identifier: MIT
"""The format and lint gates: every tool over every file of the repository that it is for."""

from __future__ import annotations

import functools
import hashlib
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from . import options, script_warnings
from .godot import Godot
from .outcome import Outcome
from .paths import BUILD, ROOT
from .project import EXTENSIONS

FORMAT_HINT = "format it with the same tool and flags as in tools/toolchain/lint.py"


def tracked(*patterns: str) -> list[str]:
    """Files of the repository, also new ones, but not ignored ones."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *patterns]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return sorted({name for name in done.stdout.split("\n") if name and (ROOT / name).exists()})


def gates(tools: Path) -> Iterator[tuple[str, list[str]]]:
    """Each gate's name and command."""
    gd = [name for name in tracked("*.gd") if "/fixtures/" not in name]
    cpp = tracked("gdextension/*.cpp", "gdextension/*.hpp", "gdextension/*.h", "tests/bench/*.?pp")
    shell = ["run", "test", ".ci/run", *tracked("*.sh", "tools/assets/build_avatar")]
    yield "gdformat", [str(tools / "gdformat"), "--check", *gd]
    yield "gdlint", [str(tools / "gdlint"), *gd]
    yield "clang-format", [str(tools / "clang-format"), "--dry-run", "--Werror", *cpp]
    yield "ruff check", [str(tools / "ruff"), "check", "--no-cache", "."]
    yield "ruff format", [str(tools / "ruff"), "format", "--no-cache", "--check", "."]
    yield "arrows", [sys.executable, "-m", "toolchain.arrows"]
    yield "mirror", [sys.executable, "-m", "toolchain.mirror"]
    yield "words", [sys.executable, "-m", "toolchain.words"]
    yield "shellcheck", [str(tools / "shellcheck"), "-x", *shell]


def changed_sources() -> list[str]:
    """C++ sources that clang-tidy has not passed yet in their present form."""
    database = EXTENSIONS / "compile_commands.json"
    if not database.exists():
        return []
    known = {entry["file"] for entry in json.loads(database.read_text(encoding="utf-8"))}
    own = tracked("gdextension/*.cpp")
    return [name for name in own if str(ROOT / name) in known and not _passed(name).exists()]


def _passed(name: str) -> Path:
    """A mark that a source passed clang-tidy, by its contents and those of all headers."""
    key = hashlib.sha256(_headers().encode() + (ROOT / name).read_bytes()).hexdigest()
    return BUILD / "stamps" / "tidy" / key


@functools.cache
def _headers() -> str:
    names = tracked(".clang-tidy", "gdextension/*.hpp")
    hashes = [hashlib.sha256((ROOT / name).read_bytes()).hexdigest() for name in names]
    return "\n".join([*names, *hashes])


def tidy(tools: Path) -> str:
    """Runs clang-tidy on what has changed, on all processors; returns what it found."""

    def check(source: str) -> str:
        found = _run_gate([str(tools / "clang-tidy"), "-quiet", "-p", str(EXTENSIONS), source])
        if not found:
            mark = _passed(source)
            mark.parent.mkdir(parents=True, exist_ok=True)
            mark.touch()
        return found

    with ThreadPoolExecutor(os.cpu_count() or 2) as pool:
        return "".join(pool.map(check, changed_sources()))


def run_lint(godot: Godot, tools: Path) -> Outcome:
    """Runs every gate; each counts as a test."""
    outcome = Outcome()
    all_gates = list(gates(tools))
    with ThreadPoolExecutor(os.cpu_count() or 2) as pool:
        found = pool.map(_run_gate, [command for _, command in all_gates])
        for (name, _), text in zip(all_gates, found, strict=True):
            _count(outcome, name, text)
    _count(outcome, "options", options.fault(godot))
    scripts = tracked("scripts/*.gd", "addons/*.gd", "examples/*.gd", "tools/*.gd")
    _count(outcome, "script warnings", script_warnings.find(godot, scripts))
    _count(outcome, "clang-tidy", tidy(tools))
    return outcome


def _run_gate(command: list[str]) -> str:
    """What a gate found; nothing if all is well."""
    done = subprocess.run(
        command,
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    return "" if done.returncode == 0 else done.stdout or "it failed"


def _count(outcome: Outcome, name: str, found: str) -> None:
    if found == "":
        outcome.passed += 1
        print(f"ok   {name}")
    else:
        outcome.failed += 1
        print(f"FAIL {name}: {FORMAT_HINT if 'format' in name else 'see below'}")
        print(found[-6000:])
