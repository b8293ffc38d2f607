# SPDX-License-Identifier: MIT
"""Runs the test extension in the editor build and in an exported release build.

Needs DISMOUNT_GODOT (path of the engine), DISMOUNT_BUILD (CMake's build folder) and, for the
export, the engine's templates below XDG_DATA_HOME.
"""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

PROJECT = Path(__file__).with_name("project")
TIMEOUT_S = 120


def required(variable: str) -> Path:
    value = os.environ.get(variable)
    if not value:
        pytest.fail(f"Set {variable}: see the head of {Path(__file__).name}.")
    path = Path(value).resolve()
    if not path.exists():
        pytest.fail(f"{variable} is {path}, which does not exist.")
    return path


@pytest.fixture
def godot() -> Path:
    return required("DISMOUNT_GODOT")


def library(name: str) -> Path:
    folder = required("DISMOUNT_BUILD") / "bindings_test"
    found = sorted(folder.glob(f"lib{name}.linux.*.so"))
    if not found:
        pytest.fail(f"There is no lib{name}.linux.*.so in {folder}: build it with CMake first.")
    return found[0]


def run(command: list, **options) -> subprocess.CompletedProcess:
    """Runs a command; a hang is a failure, with what was printed until then."""
    try:
        return subprocess.run(
            [str(part) for part in command],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            timeout=TIMEOUT_S,
            check=False,
            **options,
        )
    except subprocess.TimeoutExpired as error:
        output = (error.stdout or b"").decode(errors="replace")
        pytest.fail(f"No end after {TIMEOUT_S} s: {command}\n{output[-4000:]}")


def make_project(folder: Path, built: Path) -> Path:
    """A copy of the test project with a library in it, under the name that the project loads."""
    project = folder / "project"
    shutil.copytree(PROJECT, project, ignore=shutil.ignore_patterns(".godot", "bin", "out"))
    (project / "bin").mkdir()
    target = re.sub(r"^lib\w+?\.", "libbindings_test.", built.name)
    shutil.copy(built, project / "bin" / target)
    # An editor that has to discover an extension by itself aborts at its end.
    (project / ".godot").mkdir()
    listing = project / ".godot" / "extension_list.cfg"
    listing.write_text("res://bindings_test.gdextension\n", encoding="utf-8")
    return project


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return make_project(tmp_path, library("bindings_test"))


def imported(godot: Path, project: Path) -> str:
    result = run([godot, "--headless", "--path", project, "--import"])
    assert result.returncode == 0, result.stdout[-4000:]
    return result.stdout


def assert_all_passed(result: subprocess.CompletedProcess) -> None:
    failures = [line for line in result.stdout.splitlines() if line.startswith("FAIL")]
    assert not failures, "\n".join(failures)
    counts = re.findall(r"^(\d+) passed, (\d+) failed$", result.stdout, re.MULTILINE)
    assert counts, f"No summary in the output:\n{result.stdout[-4000:]}"
    passed, failed = map(int, counts[-1])
    assert passed > 100
    assert failed == 0
    assert len(re.findall(r"^ok ", result.stdout, re.MULTILINE)) == passed
    assert result.returncode == 0
    assert "SCRIPT ERROR" not in result.stdout
    assert "leaked at exit" not in result.stdout


def test_editor_build(godot: Path, project: Path) -> None:
    imported(godot, project)
    assert_all_passed(run([godot, "--headless", "--path", project]))


def test_exported_release_build(godot: Path, project: Path) -> None:
    data = required("XDG_DATA_HOME")
    templates = sorted(data.glob("godot/export_templates/*/linux_release.*"))
    if not templates:
        pytest.fail(f"No export templates in {data}/godot/export_templates.")
    imported(godot, project)
    game = project / "out" / "game"
    game.parent.mkdir()
    result = run([godot, "--headless", "--path", project, "--export-release", "Linux", game])
    assert result.returncode == 0, result.stdout[-4000:]
    assert game.exists(), result.stdout[-4000:]
    assert_all_passed(run([game, "--headless"], cwd=game.parent))


def test_editor_reads_documentation(godot: Path, project: Path) -> None:
    assert "doc file" not in imported(godot, project)
    text = library("bindings_test").read_bytes()
    assert "a backslash \\ and ümläuts survive".encode() in text


def test_editor_complains_of_damaged_documentation(godot: Path, project: Path) -> None:
    """Shows that the editor does read what is in the extension."""
    built = next((project / "bin").glob("*.so"))
    text = built.read_bytes()
    assert text.count(b"<methods>") == 1
    built.write_bytes(text.replace(b"<methods>", b"<nothing>"))
    assert "Invalid tag in doc file: nothing" in imported(godot, project)


def test_other_engine_is_refused(godot: Path, tmp_path: Path) -> None:
    """Bindings that expect what this engine lacks say so, and nothing of them is loaded."""
    project = make_project(tmp_path, library("bindings_test_wrong_hash"))
    imported(godot, project)
    result = run([godot, "--headless", "--path", project])
    assert "it expects Node.get_child as in Another Engine v0.0" in result.stdout
    assert "it expects Node.no_such_method as in Another Engine v0.0" in result.stdout
    assert re.search(r"does not fit Godot Engine v4\.\d", result.stdout), result.stdout[:4000]
    assert "FAIL extension is loaded" in result.stdout
    assert result.returncode == 1, "The game ends by itself, and is not ended by a crash."
    assert "handle_crash" not in result.stdout
