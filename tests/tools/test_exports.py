# SPDX-License-Identifier: MIT
"""Exports come whole, and stay under the programs that run from them."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from toolchain import project
from toolchain.console import Failure
from toolchain.godot import Godot

SLEEP = Path(shutil.which("sleep") or "")


class Exports:
    """Programs that are exported to a folder, each with a file beside it."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.program = folder / "server" / "program"
        self.text = ""
        self._monkeypatch = monkeypatch
        monkeypatch.setattr(project, "PRESETS", {"Server": self.program})
        monkeypatch.setattr(project, "BUILD", folder)
        monkeypatch.setattr(project, "_export", self._export)

    def _export(self, _godot: Godot, _preset: str, target: Path) -> None:
        shutil.copy(SLEEP, target)
        if not self.text:
            raise Failure("it is only half there")
        target.with_name("pack").write_text(self.text, encoding="utf-8")

    def make(self, text: str) -> None:
        self.text = text
        self._monkeypatch.setattr(project, "fingerprint", lambda *_: f"{text or 'half':x<12}")
        project.export_all(Godot(Path("godot"), "4.6", "4.6"))

    def pack(self) -> str:
        return self.program.with_name("pack").read_text(encoding="utf-8")

    def folders(self) -> list[str]:
        return sorted(path.name for path in self.program.parents[1].glob("server*"))


@pytest.fixture
def exports(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Exports:
    return Exports(tmp_path, monkeypatch)


def test_a_new_export_takes_the_place_of_the_old_one(exports: Exports) -> None:
    exports.make("one")
    exports.make("two")
    assert exports.pack() == "two"
    assert exports.folders() == ["server", "server-twoxxxxxxxxx"]


def test_an_export_that_fails_leaves_the_old_one(exports: Exports) -> None:
    exports.make("one")
    with pytest.raises(Failure, match="half there"):
        exports.make("")
    assert exports.pack() == "one"
    exports.make("two")
    assert exports.folders() == ["server", "server-twoxxxxxxxxx"]


def test_a_program_that_runs_keeps_its_files(exports: Exports) -> None:
    exports.make("one")
    with subprocess.Popen([str(exports.program), "600"]) as process:
        try:
            own = Path(f"/proc/{process.pid}/exe").readlink().with_name("pack")
            exports.make("two")
            assert exports.pack() == "two"
            assert own.read_text(encoding="utf-8") == "one"
        finally:
            process.kill()
    exports.make("three")
    assert exports.folders() == ["server", "server-threexxxxxxx"]


def test_a_folder_as_it_was_once_gives_way(exports: Exports) -> None:
    exports.program.parent.mkdir()
    exports.program.write_text("old", encoding="utf-8")
    exports.make("one")
    assert exports.pack() == "one"
    assert exports.folders() == ["server", "server-onexxxxxxxxx"]
