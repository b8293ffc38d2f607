# SPDX-License-Identifier: MIT
"""Where libusb, libsodium and umockdev come from."""

from __future__ import annotations

from pathlib import Path

import pytest
from toolchain import libraries
from toolchain.console import Failure


def _release(folder: Path, text: str) -> Path:
    file = folder / "os-release"
    file.write_text(text, encoding="utf-8")
    return file


def test_the_host_s_own_release_comes_first(tmp_path: Path) -> None:
    host = _release(tmp_path, 'ID=debian\nVERSION_CODENAME=trixie\nNAME="Debian GNU/Linux"\n')
    assert libraries.suites(host)[:2] == ["trixie", "bookworm"]


def test_other_systems_get_the_oldest(tmp_path: Path) -> None:
    host = _release(tmp_path, "ID=ubuntu\nVERSION_CODENAME=noble\n")
    assert libraries.suites(host)[0] == "bookworm"
    assert libraries.suites(tmp_path / "none")[0] == "bookworm"


def test_no_mirror_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path))
    monkeypatch.setenv("DISMOUNT_DEBIAN_MIRROR", f"file://{tmp_path}/nothing")
    monkeypatch.setattr(libraries, "installed", lambda _name: False)
    with pytest.raises(Failure, match=r"libusb-1\.0-0-dev libsodium-dev.*DISMOUNT_DEBIAN_MIRROR"):
        libraries.find()
    assert not list((tmp_path / "dismount").glob("libraries-*"))


def test_what_extensions_need_is_enough(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path))
    monkeypatch.setenv("DISMOUNT_DEBIAN_MIRROR", f"file://{tmp_path}/nothing")
    monkeypatch.setattr(libraries, "installed", lambda name: name != "umockdev-1.0")
    found = libraries.find()
    assert found.libusb is None
    assert found.libsodium is None
    assert "-DDISMOUNT_UMOCKDEV=OFF" in found.options()
