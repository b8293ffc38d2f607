# SPDX-License-Identifier: MIT
"""`./test --godot-cpp=DIR`: builds every module on a checkout of godot-cpp and loads it."""

from __future__ import annotations

import re
import shutil
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from . import libraries
from .cmake import BuildFolder
from .console import Failure
from .godot import Godot, dump_api
from .outcome import Outcome
from .paths import BUILD, ROOT, make_folder

FOLDER = BUILD / "godot-cpp"
# The engine loads extensions of a project: here one that has nothing else.
PROJECT = FOLDER / "project"
CHECK = """extends SceneTree


func _initialize() -> void:
	for name: String in OS.get_cmdline_user_args():
		var object: Object = ClassDB.instantiate(name) if ClassDB.can_instantiate(name) else null
		print("class %s %s" % [name, "is there" if ClassDB.class_exists(name) else "is missing"])
		if object != null and not object is RefCounted:
			object.free()
	quit()
"""
LOAD_LIMIT_S = 60


def checkout(folder: Path) -> Path:
    """The folder, if it is a checkout of godot-cpp."""
    if not (folder / "binding_generator.py").exists():
        raise Failure(
            f"{folder} is no checkout of godot-cpp: name one, such as that of "
            "`git clone https://github.com/godotengine/godot-cpp`.",
            2,
        )
    return folder.resolve()


def run_godot_cpp(godot: Godot, folder: Path) -> Outcome:
    """Builds all modules on the checkout, then counts our classes that the engine has of them."""
    fault = _build(godot, folder)
    if fault:
        print(fault, flush=True)
        return Outcome(0, 1, [f"godot-cpp: the extensions do not build on {folder}"])
    return _load(godot)


def documented_classes() -> list[str]:
    """The classes of all extensions, by their pages."""
    pages = sorted(ROOT.glob("gdextension/*/doc_classes/*.xml"))
    return [str(ElementTree.parse(page).getroot().get("name")) for page in pages]


def _build(godot: Godot, folder: Path) -> str:
    """Returns why it failed, or an empty text."""
    build = BuildFolder(FOLDER, f"the extensions on {folder}")
    options = {
        "GODOT_API_DIR": str(dump_api(godot)),
        "GODOT_CPP_DIR": str(folder),
        "DISMOUNT_BIN_DIR": f"{PROJECT}/gdextension/bin",
        "CMAKE_BUILD_TYPE": "Release",
        **libraries.options(build.record()),
    }
    try:
        build.make(options, ["all"], "")
    except Failure as failure:
        return str(failure)
    return ""


def _load(godot: Godot) -> Outcome:
    names = []
    for file in sorted(ROOT.glob("gdextension/*/*.gdextension")):
        name = file.relative_to(ROOT)
        shutil.copyfile(file, make_folder(PROJECT / name.parent) / name.name)
        names.append(f"res://{name}\n")
    (make_folder(PROJECT / ".godot") / "extension_list.cfg").write_text(
        "".join(names), encoding="utf-8"
    )
    (PROJECT / "project.godot").write_text("config_version=5\n", encoding="utf-8")
    (PROJECT / "check.gd").write_text(CHECK, encoding="utf-8")
    classes = documented_classes()
    command = ["--path", str(PROJECT), "-s", "res://check.gd", "--", *classes]
    code, output = godot.call(command, LOAD_LIMIT_S)
    there = re.findall(r"^class (\w+) is there", output, re.M)
    missing = sorted(set(classes) - set(there))
    print(f"{len(there)} of {len(classes)} classes load, built on godot-cpp", flush=True)
    if code != 0 or missing or "ERROR" in output:
        print(output, flush=True)
        notes = [f"godot-cpp: {name} does not load" for name in missing]
        return Outcome(len(there), max(len(missing), 1), notes)
    return Outcome(len(there), 0)
