# SPDX-License-Identifier: MIT
"""Builds the extensions, imports the assets, exports server and client; each only when needed."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
from pathlib import Path

from . import libraries
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

    def holds(self, value: str) -> bool:
        """Whether the step was done with exactly these inputs."""
        return self._file.exists() and self._file.read_text(encoding="utf-8") == value

    def set(self, value: str) -> None:
        """Notes that the step was done."""
        make_folder(self._file.parent)
        self._file.write_text(value, encoding="utf-8")


def prepare(export: bool) -> Godot:
    """All set-up, in order; returns the engine. What is up to date is not done again."""
    need_space(ROOT, 600, "the build")
    make_folder(BUILD)
    (BUILD / ".gdignore").touch()  # Keeps the editor from importing what we build.
    godot = find()
    link_templates(godot)
    with lock(BUILD / "lock", "building this clone"):
        build_extensions(godot)
        import_assets(godot)
        if export:
            export_all(godot)
    return godot


def _tool(command: list[str], what: str) -> None:
    done = subprocess.run(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False
    )
    if done.returncode != 0:
        raise Failure(f"{what} failed; this is the end of what it said:\n{tail(done.stdout, 30)}")


def build_extensions(godot: Godot) -> None:
    """Compiles the C++ modules with CMake and Ninja (or make)."""
    api = dump_api(godot)
    generator = "Ninja" if shutil.which("ninja") else "Unix Makefiles"
    godot_cpp = os.environ.get("GODOT_CPP_DIR", "")
    options = libraries.find().options()
    configure = f"{api} {generator} {godot_cpp} {' '.join(options)}"
    stamp = Stamp("configure")
    if not (stamp.holds(configure) and (EXTENSIONS / "CMakeCache.txt").exists()):
        with step("configure the extensions"):
            shutil.rmtree(EXTENSIONS, ignore_errors=True)
            command = ["cmake", "-S", str(ROOT / "gdextension"), "-B", str(EXTENSIONS)]
            command += ["-G", generator, f"-DGODOT_API_DIR={api}", "-DCMAKE_BUILD_TYPE=Release"]
            command += options
            command += [f"-DGODOT_CPP_DIR={godot_cpp}"] if godot_cpp else []
            _tool(command, "Configuring the extensions")
            stamp.set(configure)
    built = Stamp("build")
    sources = fingerprint(["gdextension"], configure)
    if built.holds(sources) and any((ROOT / "gdextension" / "bin").glob("*.so")):
        return
    with step("build the extensions"):
        jobs = str(os.cpu_count() or 2)
        _tool(["cmake", "--build", str(EXTENSIONS), "-j", jobs], "Building the extensions")
    built.set(fingerprint(["gdextension"], configure))


def list_extensions() -> None:
    """Names the extensions before the first editor run: it aborts with those of godot-cpp else."""
    found = sorted(ROOT.glob("gdextension/*/*.gdextension"))
    text = "".join(f"res://{path.relative_to(ROOT)}\n" for path in found)
    make_folder(ROOT / ".godot")
    (ROOT / ".godot" / "extension_list.cfg").write_text(text, encoding="utf-8")


def import_assets(godot: Godot) -> None:
    """Lets the editor import assets and register script classes."""
    stamp = Stamp("import")
    value = fingerprint(IMPORTED, godot.full_version)
    if stamp.holds(value) and (ROOT / ".godot").exists():
        return
    with step("import assets"):
        list_extensions()
        code, text = godot.call(["--path", str(ROOT), "--import"], 600)
        if code != 0 or "SCRIPT ERROR" in text:
            raise Failure(f"Importing failed (exit {code}):\n{tail(text, 30)}")
        # Importing may add .import and .uid files beside the sources.
        stamp.set(fingerprint(IMPORTED, godot.full_version))


def export_all(godot: Godot) -> None:
    """Exports the dedicated server and the client as release builds."""
    value = fingerprint(EXPORTED, godot.full_version)
    for preset, target in PRESETS.items():
        stamp = Stamp("export-" + target.stem)
        if stamp.holds(value) and target.exists():
            continue
        with step(f"export {preset}"):
            shutil.rmtree(target.parent, ignore_errors=True)
            make_folder(target.parent)
            _export(godot, preset, target)
            ship_rules(target.parent)
            stamp.set(value)


def ship_rules(folder: Path) -> None:
    """Puts the udev rules for suits and wheels into the folder of a program."""
    for rules in (UDEV_RULES, WHEEL_RULES):
        shutil.copyfile(rules, folder / rules.name)


def _export(godot: Godot, preset: str, target: Path) -> None:
    code, text = godot.call(["--path", str(ROOT), "--export-release", preset, str(target)], 300)
    if code != 0 or not target.exists() or "SCRIPT ERROR" in text:
        raise Failure(f"Exporting '{preset}' failed (exit {code}):\n{tail(text, 30)}")
