# SPDX-License-Identifier: MIT
"""Finds Godot >= 4.6 ($GODOT, PATH) or makes a private one, and gives it its export templates."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from .console import Failure, say, step, tail
from .paths import BUILD, ROOT, cache, lock, make_folder
from .prefix import Prefix

OLDEST = (4, 6)


@dataclass(frozen=True)
class Godot:
    """An engine that can be started, with templates of the same version."""

    program: Path
    version: str  # As the export templates' folder is named: "4.6.3.stable".
    full_version: str

    def environment(self, name: str = "godot-home") -> dict[str, str]:
        """An environment that keeps the editor's settings and templates out of the user's home."""
        home = make_folder(BUILD / name)
        own = {
            "XDG_DATA_HOME": str(home / "data"),
            "XDG_CONFIG_HOME": str(home / "config"),
            "XDG_CACHE_HOME": str(home / "cache"),
        }
        return {**os.environ, **own}

    def call(
        self, arguments: list[str], limit_s: float, cwd: Path = ROOT, home: str = "godot-home"
    ) -> tuple[int, str]:
        """Runs the engine headless; returns the exit code and what it printed."""
        command = [str(self.program), "--headless", *arguments]
        try:
            done = subprocess.run(
                command,
                cwd=cwd,
                env=self.environment(home),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                timeout=limit_s,
                check=False,
                text=True,
                errors="replace",
            )
        except subprocess.TimeoutExpired as late:
            text = late.stdout.decode(errors="replace") if late.stdout else ""
            return 124, text + f"\nstopped after {limit_s:.0f} s"
        return done.returncode, done.stdout


def read_version(program: Path) -> str:
    """What `godot --version` says, or an empty text where it can't be started."""
    try:
        done = subprocess.run(
            [str(program), "--version"], capture_output=True, text=True, timeout=30, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return done.stdout.strip().splitlines()[-1] if done.stdout.strip() else ""


def parse_version(text: str) -> tuple[tuple[int, ...], str]:
    """Splits "4.6.3.stable.debian" into (4, 6, 3) and the templates' name "4.6.3.stable"."""
    match = re.match(r"(\d+(?:\.\d+)+)\.([a-z]+\d*)", text)
    if match is None:
        return (), ""
    return tuple(int(part) for part in match.group(1).split(".")), match.group(0)


def installed() -> Godot | None:
    """The machine's own Godot, where it is new enough."""
    named = os.environ.get("GODOT")
    candidates = [named] if named else ["godot", "godot4"]
    for candidate in candidates:
        found = shutil.which(candidate)
        full = read_version(Path(found)) if found else ""
        numbers, version = parse_version(full)
        if numbers >= OLDEST:
            return Godot(Path(str(found)), version, full)
        if named:
            what = f"is version {full}" if numbers else "does not say a version of Godot"
            raise Failure(f"$GODOT is {named}, which {what}: set it to a Godot >= 4.6 or unset it.")
        if full:
            say(f"[ -- ] {found} is version {full}, too old: a private one is used")
    return None


def find() -> Godot:
    """The engine to use from here on; a private one is fetched where the machine has none."""
    godot = installed()
    if godot is None:
        program = Prefix().program("godot")
        full = read_version(program)
        numbers, version = parse_version(full)
        if numbers < OLDEST:
            raise Failure(
                f"The private Godot in {program.parent} does not start (it says '{full}'): delete "
                "that folder and start again, or put a Godot 4.6 in $GODOT."
            )
        godot = Godot(program, version, full)
    return godot


def link_templates(godot: Godot) -> None:
    """Puts the release template where the editor looks for it."""
    folder = make_folder(
        BUILD / "godot-home" / "data" / "godot" / "export_templates" / godot.version
    )
    for kind in ("release", "debug"):
        link = folder / f"linux_{kind}.x86_64"
        target = _template(godot, kind)
        if link.is_symlink() and link.resolve() == target.resolve():
            continue
        link.unlink(missing_ok=True)
        link.symlink_to(target)


def _template(godot: Godot, kind: str) -> Path:
    """A template of the engine's version: the user's, the system's, or the private folder's."""
    data = Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share")
    user = data / "godot" / "export_templates" / godot.version / f"linux_{kind}.x86_64"
    beside = godot.program.parent / f"godot-template-{kind}"
    system = shutil.which(f"godot-template-{kind}")
    for candidate in (user, beside, Path(system) if system else user):
        if candidate.exists():
            return candidate
    private = Prefix().program(f"godot-template-{kind}")
    _, version = parse_version(read_version(Prefix().program("godot")))
    if version == godot.version:
        return private
    raise Failure(
        f"Godot {godot.version} has no export templates: install them (Editor > Manage Export "
        "Templates, or the package godot-template-release), or unset GODOT to use a private Godot."
    )


def dump_api(godot: Godot) -> Path:
    """The folder with the engine's own description of its API, made once per engine version."""
    folder = cache() / "api" / re.sub(r"[^\w.+-]", "_", godot.full_version)
    if (folder / "gdextension_interface.h").exists():
        return folder
    with lock(cache() / "api.lock", "asking the engine for its API"), step("dump the engine's API"):
        work = folder.with_name(folder.name + ".part")
        shutil.rmtree(work, ignore_errors=True)
        make_folder(work)
        flags = ["--dump-extension-api", "--dump-gdextension-interface"]
        flags += ["--dump-gdextension-interface-json"]  # For godot-cpp, see GODOT_CPP_DIR.
        code, text = godot.call(flags, 120, cwd=work)
        if not (work / "gdextension_interface.h").exists():
            raise Failure(f"Godot could not describe its API (exit {code}):\n{tail(text)}")
        shutil.rmtree(folder, ignore_errors=True)
        work.rename(folder)
    return folder
