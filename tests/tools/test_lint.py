# SPDX-License-Identifier: MIT
"""Gates look at what has changed, and what fails is looked at again."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from toolchain import lint, passed, tidy


class Repository:
    """A folder whose files a gate looks at: none may have the word "bad"."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.root.mkdir()
        self.write("rules", "no bad word")

    def write(self, name: str, text: str) -> None:
        (self.root / name).write_text(text, encoding="utf-8")

    def gates(self, _tools: Path) -> Iterator[tuple[str, list[str], str, list[str], float]]:
        files = sorted(path.name for path in self.root.glob("*.txt"))
        look = ["sh", "-c", 'echo "$@" >>looked; ! grep bad "$@"', "-"]
        yield "words", look, "rules", files, 1.0

    def look(self) -> tuple[str, list[str]]:
        """What the gate finds, and the files that it looks at."""
        seen = self.root / "looked"
        seen.write_text("", encoding="utf-8")
        found = lint.run_jobs(lint.file_jobs(Path()))
        return found.get("words", ""), sorted(seen.read_text(encoding="utf-8").split())


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Repository:
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path / "cache"))
    made = Repository(tmp_path / "clone")
    monkeypatch.setattr(lint, "ROOT", made.root)
    monkeypatch.setattr(lint, "file_gates", made.gates)
    monkeypatch.setattr(lint, "contents", lambda names: passed.contents(names, made.root))
    monkeypatch.setattr(lint, "BATCH", 1)
    return made


def test_a_file_that_passed_is_looked_at_when_it_changes(repository: Repository) -> None:
    repository.write("a.txt", "good")
    repository.write("b.txt", "good")
    assert repository.look() == ("", ["a.txt", "b.txt"])
    assert repository.look() == ("", [])
    repository.write("b.txt", "better")
    assert repository.look() == ("", ["b.txt"])
    repository.write("rules", "other rules")
    assert repository.look() == ("", ["a.txt", "b.txt"])


def test_a_file_that_failed_fails_again(repository: Repository) -> None:
    repository.write("a.txt", "good")
    repository.write("b.txt", "bad")
    for files in (["a.txt", "b.txt"], ["b.txt"], ["b.txt"]):
        assert repository.look() == ("bad\n", files)
    repository.write("b.txt", "good")
    assert repository.look() == ("", ["b.txt"])


def test_a_batch_passes_as_a_whole(repository: Repository, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lint, "BATCH", 1000)
    repository.write("a.txt", "good")
    repository.write("b.txt", "bad")
    found, files = repository.look()
    assert "bad" in found
    assert repository.look() == (found, files)
    assert files == ["a.txt", "b.txt"]


class Units:
    """Sources that are compiled in two units, and a header."""

    def __init__(self, root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.root = root
        units = root / "build" / "units"
        units.mkdir(parents=True)
        (root / "gdextension").mkdir()
        for name in ("a.cpp", "b.cpp", "c.cpp", "h.hpp"):
            self.write(name, "")
        entries = []
        for unit, sources in {"ab.cpp": "ab", "c.cpp": "c"}.items():
            lines = [f'#include "{source}.cpp" // A reason.\n' for source in sources]
            (units / unit).write_text("".join(lines), encoding="utf-8")
            command = f"c++ -c {units / unit}"
            entries.append({"file": str(units / unit), "command": command})
        database = root / "build" / "compile_commands.json"
        database.write_text(json.dumps(entries), encoding="utf-8")
        monkeypatch.setattr(tidy, "ROOT", root)
        monkeypatch.setattr(tidy, "EXTENSIONS", root / "build")
        monkeypatch.setattr(tidy, "tracked", self._tracked)
        monkeypatch.setattr(tidy, "contents", lambda names: passed.contents(names, root))

    def write(self, name: str, text: str) -> None:
        (self.root / "gdextension" / name).write_text(text, encoding="utf-8")

    def _tracked(self, *patterns: str) -> list[str]:
        suffixes = [pattern.rpartition("*")[2] for pattern in patterns]
        files = (self.root / "gdextension").iterdir()
        return [f"gdextension/{file.name}" for file in files if file.suffix in suffixes]

    def left(self) -> list[str]:
        """Marks all units; returns those that were not marked."""
        found = tidy.Tidy(Path(), "engine")
        names = []
        for file, key, _size in found.units():
            names.append(Path(file).name)
            found.passed.add(key)
        return names


def test_a_unit_is_tidied_when_a_source_or_any_header_changes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path / "cache"))
    units = Units(tmp_path / "clone", monkeypatch)
    assert units.left() == ["ab.cpp", "c.cpp"]
    assert units.left() == []
    units.write("b.cpp", "int changed;")
    assert units.left() == ["ab.cpp"]
    units.write("h.hpp", "int changed;")
    assert units.left() == ["ab.cpp", "c.cpp"]
    # Another clone has the same marks.
    assert Units(tmp_path / "other", monkeypatch).left() == []
