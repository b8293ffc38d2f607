# SPDX-License-Identifier: MIT
"""Builds the extensions, imports the assets, exports server and client; each only when needed."""

from __future__ import annotations

import hashlib
import os
import shutil
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from . import compiler_cache, libraries
from .cmake import BuildFolder
from .console import Failure, step, tail
from .godot import Godot, dump_api, find, link_templates
from .paths import BUILD, CLIENT_BINARY, ROOT, SERVER_BINARY, lock, make_folder, need_space

EXTENSIONS = BUILD / "gdextension"
IMPORTED = ["assets", "examples", "scenes", "scripts", "tests", "addons", "gdextension/bin"]
EXPORTED = [
    "assets",
    "examples",
    "scenes",
    "scripts",
    "addons",
    "gdextension/bin",
    "gdextension/xbus/udev",
]
SETTINGS = ["project.godot", "export_presets.cfg"]
# What lets users at suits on USB; it lies beside the programs that ask for it.
UDEV_RULES = ROOT / "gdextension" / "xbus" / "udev" / "60-dismount-suits.rules"
WHEEL_RULES = ROOT / "gdextension" / "cueing" / "udev" / "60-dismount-wheels.rules"
# Targets of CMake: what the program needs, what some commands run besides, and all, with the tests.
RUN = ("extensions",)
NATIVE = ("extensions", "programs")
ALL = ("extensions", "programs", "all")
WHAT = {"extensions": "the extensions", "programs": "native programs", "all": "the C++ tests"}
PRESETS = {"Linux Dedicated Server": SERVER_BINARY, "Linux Client": CLIENT_BINARY}


def fingerprint(folders: list[str], extra: str) -> str:
    """A hash over the names and contents of the files that a step depends on."""
    digest = hashlib.sha256(extra.encode())
    files = [ROOT / name for name in SETTINGS]
    for folder in folders:
        files += sorted(path for path in (ROOT / folder).rglob("*") if path.is_file())
    files += sorted(ROOT.glob("gdextension/*/*.gdextension"))
    for file in files:
        if file.exists() and "__pycache__" not in file.parts:
            digest.update(str(file.relative_to(ROOT)).encode() + b"\0")
            digest.update(hashlib.sha256(file.read_bytes()).digest())
    return digest.hexdigest()


class Stamp:
    """Remembers that a step was done with certain inputs."""

    def __init__(self, name: str) -> None:
        self._file = BUILD / "stamps" / name

    def exists(self) -> bool:
        """Whether the step was done at all."""
        return self._file.exists()

    def holds(self, value: str) -> bool:
        """Whether the step was done with exactly these inputs."""
        return self._file.exists() and self._file.read_text(encoding="utf-8") == value

    def why(self, value: str) -> str:
        """Why the step is done again, as its name goes on; empty if it is done for the first time.

        Behind the hash of files a value has the engine's version.
        """
        if not self.exists():
            return ""
        engine = value.partition(" ")[2]
        before = self._file.read_text(encoding="utf-8").partition(" ")[2]
        return f": the engine is {engine} now" if before != engine else ": files have changed"

    def set(self, value: str) -> None:
        """Notes that the step was done."""
        make_folder(self._file.parent)
        self._file.write_text(value, encoding="utf-8")


def _value(folders: list[str], godot: Godot) -> str:
    return f"{fingerprint(folders, godot.full_version)} {godot.full_version}"


def prepare(export: bool, targets: Sequence[str] = RUN) -> Godot:
    """All set-up, in order; returns the engine. What is up to date is not done again."""
    need_space(ROOT, 600, "the build")
    make_folder(BUILD)
    (BUILD / ".gdignore").touch()  # Keeps the editor from importing what we build.
    with ThreadPoolExecutor() as pool:
        # Beside the engine: they wait for the network most of the time.
        is_new = not BuildFolder(EXTENSIONS, "").record()
        others = [pool.submit(fetch) for fetch in (libraries.find, compiler_cache.find) if is_new]
        godot = find()
        for other in others:
            other.result()
    link_templates(godot)
    with lock(BUILD / "lock", "building this clone"):
        build_extensions(godot, RUN)
        with ThreadPoolExecutor() as pool:
            # Importing and exporting leave a processor idle most of the time.
            rest = pool.submit(build_extensions, godot, targets) if targets != RUN else None
            import_assets(godot)
            if export:
                export_all(godot)
            if rest is not None:
                rest.result()
    return godot


def build_extensions(godot: Godot, targets: Sequence[str]) -> None:
    """Compiles targets of the C++ modules; those that are up to date are not looked at."""
    folder = BuildFolder(EXTENSIONS, WHAT[targets[-1]])
    record = folder.record()
    options = {
        "GODOT_API_DIR": _api_folder(godot, record),
        "GODOT_CPP_DIR": os.environ.get("GODOT_CPP_DIR", ""),
        "CMAKE_BUILD_TYPE": "Release",
        **libraries.options(record),
    }
    value = fingerprint(["gdextension"], str(options))
    stamps = {name: Stamp(f"build-{name}") for name in targets}
    missing = [name for name, stamp in stamps.items() if not stamp.holds(value)]
    if record and not missing and any((ROOT / "gdextension" / "bin").glob("*.so")):
        return
    is_new = not any(stamps[name].exists() for name in missing)
    folder.make(options, missing or targets, "" if is_new else "their sources have changed")
    for stamp in stamps.values():
        stamp.set(fingerprint(["gdextension"], str(options)))


def _api_folder(godot: Godot, record: dict[str, str]) -> str:
    """The engine's API: where the build has it from, or another folder of the same version."""
    found = dump_api(godot)
    recorded = Path(record.get("GODOT_API_DIR", ""))
    return str(recorded if recorded.name == found.name and recorded.exists() else found)


def list_extensions() -> None:
    """Names the extensions before the first editor run: it aborts with those of godot-cpp else."""
    found = sorted(ROOT.glob("gdextension/*/*.gdextension"))
    text = "".join(f"res://{path.relative_to(ROOT)}\n" for path in found)
    make_folder(ROOT / ".godot")
    (ROOT / ".godot" / "extension_list.cfg").write_text(text, encoding="utf-8")


def import_assets(godot: Godot) -> None:
    """Lets the editor import assets and register script classes."""
    stamp = Stamp("import")
    value = _value(IMPORTED, godot)
    if stamp.holds(value) and (ROOT / ".godot").exists():
        return
    with step("import assets" + stamp.why(value)):
        list_extensions()
        code, text = godot.call(["--path", str(ROOT), "--import"], 600)
        if code != 0 or "SCRIPT ERROR" in text:
            raise Failure(f"Importing failed (exit {code}):\n{tail(text, 30)}")
        # Importing may add .import and .uid files beside the sources.
        stamp.set(_value(IMPORTED, godot))


def export_all(godot: Godot) -> None:
    """Exports the dedicated server and the client as release builds."""
    value = _value(EXPORTED, godot)
    for preset, target in PRESETS.items():
        stamp = Stamp("export-" + target.stem)
        if stamp.holds(value) and target.exists():
            continue
        with step(f"export {preset}" + stamp.why(value)):
            folder = target.parent.with_name(f"{target.parent.name}-{value[:12]}")
            shutil.rmtree(folder, ignore_errors=True)
            _export(godot, preset, make_folder(folder) / target.name)
            ship_rules(folder)
            show(folder, target.parent)
            stamp.set(value)


def show(folder: Path, name: Path) -> None:
    """Lets a name stand for a folder, and removes those before it that no program runs from.

    A running program reads its files by its own folder's path: nobody meets half an export.
    """
    link = name.with_name(name.name + ".link")
    link.unlink(missing_ok=True)
    link.symlink_to(folder.name)
    if name.exists() and not name.is_symlink():
        # As exports were laid out once.
        name.rename(name.with_name(name.name + "-before"))
    link.replace(name)
    for old in name.parent.glob(f"{name.name}-*"):
        if old != folder and not _runs_from(old):
            shutil.rmtree(old, ignore_errors=True)


def _runs_from(folder: Path) -> bool:
    for program in Path("/proc").glob("[0-9]*/exe"):
        try:
            if program.readlink().is_relative_to(folder):
                return True
        except OSError:
            continue  # It has ended, or is somebody else's.
    return False


def ship_rules(folder: Path) -> None:
    """Puts the udev rules for suits and wheels into the folder of a program."""
    for rules in (UDEV_RULES, WHEEL_RULES):
        shutil.copyfile(rules, folder / rules.name)


def _export(godot: Godot, preset: str, target: Path) -> None:
    code, text = godot.call(["--path", str(ROOT), "--export-release", preset, str(target)], 300)
    if code != 0 or not target.exists() or "SCRIPT ERROR" in text:
        raise Failure(f"Exporting '{preset}' failed (exit {code}):\n{tail(text, 30)}")
