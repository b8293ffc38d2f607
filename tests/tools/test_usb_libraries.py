# SPDX-License-Identifier: MIT
"""Where libusb and umockdev come from."""

from __future__ import annotations

from pathlib import Path

import pytest
from toolchain import usb
from toolchain.console import Failure


def _release(folder: Path, text: str) -> Path:
    file = folder / "os-release"
    file.write_text(text, encoding="utf-8")
    return file


def test_the_host_s_own_release_comes_first(tmp_path: Path) -> None:
    host = _release(tmp_path, 'ID=debian\nVERSION_CODENAME=trixie\nNAME="Debian GNU/Linux"\n')
    assert usb.suites(host)[:2] == ["trixie", "bookworm"]


def test_other_systems_get_the_oldest(tmp_path: Path) -> None:
    host = _release(tmp_path, "ID=ubuntu\nVERSION_CODENAME=noble\n")
    assert usb.suites(host)[0] == "bookworm"
    assert usb.suites(tmp_path / "none")[0] == "bookworm"


def test_no_mirror_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("DISMOUNT_DEBIAN_MIRROR", f"file://{tmp_path}/nothing")
    monkeypatch.setattr(usb, "installed", lambda _name: False)
    with pytest.raises(Failure, match=r"libusb-1\.0-0-dev.*DISMOUNT_DEBIAN_MIRROR"):
        usb.find()
    assert not list((tmp_path / "dismount").glob("usb-*"))


def test_an_installed_libusb_is_enough(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("DISMOUNT_DEBIAN_MIRROR", f"file://{tmp_path}/nothing")
    monkeypatch.setattr(usb, "installed", lambda name: name == "libusb-1.0")
    found = usb.find()
    assert found.libusb is None
    assert "-DDISMOUNT_UMOCKDEV=OFF" in found.options()
