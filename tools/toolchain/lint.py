# SPDX-License-Identifier: MIT
"""The format and lint gates: every tool over every file of the repository that it is for.

What has passed before as it is now is not looked at again: see passed.py.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from . import options, script_warnings
from .godot import Godot
from .outcome import Outcome
from .passed import Passed, contents
from .paths import ROOT
from .project import IMPORTED, fingerprint
from .tidy import Tidy
from .tracked import tracked

FORMAT_HINT = "format it with the same tool and flags as in tools/toolchain/lint.py"
# Bytes of files that a tool is started with at once: starting is dear, and so is a processor that
# waits for another one at the end.
BATCH = 200_000


@dataclass
class Job:
    """A part of a gate; what it finds, or nothing."""

    gate: str
    run: Callable[[], str]
    work: float  # About how long it takes, in processor seconds: the longest come first.
    passed: Passed | None = None
    keys: list[str] = field(default_factory=list)


def quick_gates(tools: Path) -> Iterator[tuple[str, list[str]]]:
    """Each gate that looks at everything, in a second or two: its name and command."""
    shell = ["run", "test", ".ci/run", *tracked("*.sh", "tools/assets/build_avatar")]
    yield "ruff check", [str(tools / "ruff"), "check", "--no-cache", "."]
    yield "ruff format", [str(tools / "ruff"), "format", "--no-cache", "--check", "."]
    yield "arrows", [sys.executable, "-m", "toolchain.arrows"]
    yield "method order", [sys.executable, "-m", "toolchain.method_order"]
    yield "includes", [sys.executable, "-m", "toolchain.includes"]
    yield "bound", [sys.executable, "-m", "toolchain.bound"]
    yield "mirror", [sys.executable, "-m", "toolchain.mirror"]
    yield "words", [sys.executable, "-m", "toolchain.words"]
    yield "shellcheck", [str(tools / "shellcheck"), "-x", *shell]


def file_gates(tools: Path) -> Iterator[tuple[str, list[str], str, list[str], float]]:
    """Each gate that looks at files one by one: name, command, configuration, files, and about how
    many processor seconds it needs for a megabyte."""
    gd = [name for name in tracked("*.gd") if "/fixtures/" not in name]
    cpp = tracked("gdextension/*.cpp", "gdextension/*.hpp", "gdextension/*.h")
    form = [str(tools / "clang-format"), "--dry-run", "--Werror"]
    yield "gdformat", [str(tools / "gdformat"), "--check"], "gdlintrc", gd, 5.0
    yield "gdlint", [str(tools / "gdlint")], "gdlintrc", gd, 4.5
    yield "clang-format", form, ".clang-format", cpp, 1.0


def file_jobs(tools: Path) -> Iterator[Job]:
    """Jobs for files that have not passed yet as they are, in batches."""
    for name, command, configuration, files, cost in file_gates(tools):
        passed = Passed(name.replace(" ", "-"), contents([configuration]), *command[1:])
        batch: list[str] = []
        keys: list[str] = []
        size = 0
        for file in files:
            data = (ROOT / file).read_bytes()
            key = passed.key(file, data)
            if passed.find(key) is not None:
                continue
            batch.append(file)
            keys.append(key)
            size += len(data)
            if size > BATCH:
                yield Job(name, _runs([*command, *batch]), size * cost / 1e6, passed, keys)
                batch, keys, size = [], [], 0
        if batch:
            yield Job(name, _runs([*command, *batch]), size * cost / 1e6, passed, keys)


def engine_jobs(godot: Godot) -> Iterator[Job]:
    """What the engine says of the project."""
    folders = [name for name in IMPORTED if name != "tests"]
    everything = fingerprint([*folders, "tools", "docs"], godot.full_version)
    scripts = tracked("scripts/*.gd", "addons/*.gd", "examples/*.gd", "tools/*.gd")
    gates: dict[str, Callable[[], str]] = {
        "options": lambda: options.fault(godot),
        "script warnings": lambda: script_warnings.find(godot, scripts),
    }
    for name, run in gates.items():
        passed = Passed(name.replace(" ", "-"))
        key = passed.key(everything)
        if passed.find(key) is None:
            yield Job(name, run, 20.0, passed, [key])


def tidy_jobs(godot: Godot, tools: Path) -> Iterator[Job]:
    """clang-tidy over what has not passed yet."""
    tidy = Tidy(tools, godot.full_version)
    for file, key, size in tidy.units():
        yield Job("clang-tidy", _runs(tidy.command(file)), 1.0 + size / 4e4, tidy.passed, [key])


def run_lint(godot: Godot, tools: Path) -> Outcome:
    """Runs every gate; each counts as a test."""
    jobs = [Job(name, _runs(command), 0.5) for name, command in quick_gates(tools)]
    jobs += [*file_jobs(tools), *engine_jobs(godot), *tidy_jobs(godot, tools)]
    found = run_jobs(jobs)
    outcome = Outcome()
    names = [name for name, *_ in [*file_gates(tools), *quick_gates(tools)]]
    for name in [*names, "options", "script warnings", "clang-tidy"]:
        _count(outcome, name, found.get(name, ""))
        Passed(name.replace(" ", "-")).prune()
    return outcome


def run_jobs(jobs: Iterable[Job]) -> dict[str, str]:
    """Runs jobs on all processors; returns what each gate has found, and marks what passed."""

    def run(job: Job) -> str:
        found = job.run()
        if not found and job.passed is not None:
            for key in job.keys:
                job.passed.add(key)
        return found

    ordered = sorted(jobs, key=lambda job: -job.work)
    found: dict[str, str] = {}
    with ThreadPoolExecutor(os.cpu_count() or 2) as pool:
        for job, text in zip(ordered, pool.map(run, ordered), strict=True):
            found[job.gate] = found.get(job.gate, "") + text
    return found


def _runs(command: list[str]) -> Callable[[], str]:
    """Runs a tool; it has found nothing if all is well."""

    def run() -> str:
        done = subprocess.run(
            command,
            cwd=ROOT,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
        )
        return "" if done.returncode == 0 else done.stdout or "it failed"

    return run


def _count(outcome: Outcome, name: str, found: str) -> None:
    if found == "":
        outcome.passed += 1
        print(f"ok   {name}")
    else:
        outcome.failed += 1
        print(f"FAIL {name}: {FORMAT_HINT if 'format' in name else 'see below'}")
        print(found[-6000:])
