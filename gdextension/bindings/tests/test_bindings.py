# SPDX-License-Identifier: MIT
"""The bindings inside the engine: the test project in the editor build and as an exported release.

Needs DISMOUNT_GODOT (the engine), DISMOUNT_BUILD (the CMake build folder) and, in XDG_DATA_HOME,
export templates.
"""

import json
import os
import platform
import re
import shutil
import struct
import subprocess
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parent
LIMIT_S = 180
CHECKS = 169

GODOT = os.environ.get("DISMOUNT_GODOT", "")
BUILD = Path(os.environ.get("DISMOUNT_BUILD", ""))
ARCHITECTURE = {"x86_64": "x86_64", "aarch64": "arm64"}.get(platform.machine(), "")
LIBRARY = f"libbinding_probe.linux.{ARCHITECTURE}.so"
BUILT = BUILD / "bindings" / "tests" / "extension" / LIBRARY

pytestmark = pytest.mark.skipif(
    not GODOT or not BUILT.exists(), reason="needs DISMOUNT_GODOT and DISMOUNT_BUILD"
)


def run(command: list[str], folder: Path) -> tuple[int, str]:
    """Exit code and output of a program that may not hang."""
    done = subprocess.run(
        command,
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=LIMIT_S,
        check=False,
    )
    return done.returncode, done.stdout


def copy_project(target: Path, library: bytes, is_listed: bool = True) -> None:
    """The project with a library; where it is not listed, the editor has to find it."""
    shutil.copytree(TESTS / "project", target, ignore=shutil.ignore_patterns(".godot", "bin"))
    (target / "bin").mkdir()
    (target / "bin" / LIBRARY).write_bytes(library)
    if is_listed:
        (target / ".godot").mkdir()
        (target / ".godot" / "extension_list.cfg").write_text("res://binding_probe.gdextension\n")


@pytest.fixture(scope="module")
def project(tmp_path_factory) -> Path:
    """The imported project."""
    folder = tmp_path_factory.mktemp("bindings") / "project"
    copy_project(folder, BUILT.read_bytes())
    code, text = run([GODOT, "--headless", "--path", str(folder), "--import"], folder)
    assert code == 0, text
    assert "SCRIPT ERROR" not in text and "doc_tools" not in text, text
    return folder


def assert_all_passed(code: int, text: str) -> None:
    """Every check ran, and passed."""
    assert not re.search("^FAIL", text, re.M), text
    assert re.search(rf"^{CHECKS} passed, 0 failed$", text, re.M), text
    assert len(re.findall(r"^ok ", text, re.M)) == CHECKS
    assert "leaked" not in text and "ERROR: Failed to retrieve" not in text, text
    assert code == 0, text


def test_editor_build(project):
    assert_all_passed(*run([GODOT, "--headless", "--path", str(project)], project))


@pytest.mark.skipif(not (BUILD / "bindings/generated").exists(), reason="built with godot-cpp")
@pytest.mark.parametrize("flags", [["--import"], ["--editor", "--quit"]])
def test_the_first_run_of_an_editor_without_a_window(tmp_path, flags):
    # It quits before it has described our classes, see shut_down() in godot.cpp.
    folder = tmp_path / "project"
    copy_project(folder, BUILT.read_bytes(), is_listed=False)
    code, text = run([GODOT, "--headless", "--path", str(folder), *flags], folder)
    assert code == 0, text
    assert "SCRIPT ERROR" not in text, text
    listed = (folder / ".godot" / "extension_list.cfg").read_text()
    assert listed == "res://binding_probe.gdextension\n"
    assert_all_passed(*run([GODOT, "--headless", "--path", str(folder)], folder))


def test_exported_release_build(project):
    (project / "out").mkdir()
    command = [
        GODOT,
        "--headless",
        "--path",
        str(project),
        "--export-release",
        "Linux",
        "out/probe",
    ]
    code, text = run(command, project)
    assert code == 0, text
    assert_all_passed(*run([str(project / "out" / "probe"), "--headless"], project / "out"))


@pytest.mark.skipif(not (BUILD / "bindings/generated").exists(), reason="built with godot-cpp")
def test_class_documentation_reaches_the_editor(tmp_path):
    # No script can read the editor's help, but the editor complains of what it can't read.
    library = BUILT.read_bytes()
    text = 'This text has "quotes", a \\ and a ✓.'.encode()
    assert library.count(text) == 1
    start = b'<class name="ValueProbe"'
    assert library.count(start) == 1
    copy_project(tmp_path / "project", library.replace(start, start.replace(b"class", b"xlass")))
    _code, text = run(
        [GODOT, "--headless", "--path", str(tmp_path / "project"), "--import"], tmp_path
    )
    assert "doc_tools.cpp" in text, text


def unique_method(build: Path) -> tuple[str, int]:
    """A method whose hash nothing else in the bindings has."""
    source = (build / "bindings/generated/src/classes/physics_server3d.cpp").read_text()
    text = "".join(path.read_text() for path in (build / "bindings/generated/src").rglob("*.cpp"))
    for name, value in re.findall(r'\{ "(\w+)", (\d+), nullptr \}', source):
        if len(re.findall(rf", {value}, nullptr", text)) == 1:
            return name, int(value)
    raise AssertionError("no method has a hash of its own")


@pytest.mark.skipif(not (BUILD / "bindings/generated").exists(), reason="built with godot-cpp")
def test_a_wrong_method_hash_is_named(tmp_path):
    name, value = unique_method(BUILD)
    library = BUILT.read_bytes()
    assert library.count(struct.pack("<q", value)) == 1
    broken = library.replace(struct.pack("<q", value), struct.pack("<q", value + 1))
    copy_project(tmp_path / "project", broken)
    # Without its classes, the project has nothing that would end it.
    command = [GODOT, "--headless", "--path", str(tmp_path / "project"), "--quit-after", "60"]
    _code, text = run(command, tmp_path)
    assert f"PhysicsServer3D.{name} (hash {value + 1})" in text, text
    assert re.search(r"The engine, Godot.* v?4\.\d", text), text
    assert "binding_probe: 8 classes" not in text, text


def test_an_unknown_class_stops_the_configuration(tmp_path):
    cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8")
    api = re.search(r"^GODOT_API_DIR:\w+=(.*)$", cache, re.M)
    profile = tmp_path / "profile.json"
    profile.write_text(json.dumps({"enabled_classes": ["Node", "NoSuchClass"]}), encoding="utf-8")
    command = ["cmake", "-S", str(TESTS.parent.parent), "-B", str(tmp_path / "build")]
    command += [f"-DGODOT_API_DIR={api.group(1)}", f"-DDISMOUNT_BUILD_PROFILE={profile}"]
    code, text = run(command, tmp_path)
    assert code != 0
    assert '"NoSuchClass"' in text, text
