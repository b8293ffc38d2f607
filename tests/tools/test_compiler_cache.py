# SPDX-License-Identifier: MIT
"""ccache is taken where it is, and missed nowhere."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from toolchain import compiler_cache
from toolchain.paths import ROOT

COMPILE = ROOT / "tools" / "compile.sh"


@pytest.fixture
def alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A machine without ccache and without packages."""
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path))
    monkeypatch.setenv("DISMOUNT_DEBIAN_MIRROR", f"file://{tmp_path}/nothing")
    monkeypatch.setattr(compiler_cache.shutil, "which", lambda _name: None)
    return tmp_path


def _recorder(folder: Path) -> Path:
    program = folder / "ccache"
    program.write_text('#!/bin/sh\necho "cached: $*"\n', encoding="utf-8")
    program.chmod(0o755)
    return program


def test_without_ccache_builds_go_on(alone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert compiler_cache.find() is None
    assert "without ccache" in capsys.readouterr().err
    assert "DISMOUNT_CCACHE" not in compiler_cache.environment()
    assert not list(alone.glob("dismount/ccache-*"))


def test_the_machines_own_is_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path))
    monkeypatch.setenv("PATH", str(_recorder(tmp_path).parent), prepend=os.pathsep)
    given = compiler_cache.environment()
    assert given["DISMOUNT_CCACHE"] == str(tmp_path / "ccache")
    assert given["CCACHE_DIR"] == str(tmp_path / "dismount" / "ccache")
    assert given["CCACHE_BASEDIR"] == str(ROOT)


def test_compilers_are_started_through_it_or_as_they_are(tmp_path: Path) -> None:
    command = [str(COMPILE), "echo", "a b", "c"]
    plain = {"PATH": os.environ["PATH"]}
    cached = {**plain, "DISMOUNT_CCACHE": str(_recorder(tmp_path))}
    found = [
        subprocess.run(command, env=given, capture_output=True, text=True, check=True).stdout
        for given in (plain, cached)
    ]
    assert found == ["a b c\n", "cached: echo a b c\n"]
