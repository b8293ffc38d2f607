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
    assert found.options()["DISMOUNT_UMOCKDEV"] == "OFF"


def _record(root: Path) -> dict[str, str]:
    """What CMake found in a private folder."""
    (root / "include").mkdir(parents=True)
    library = root / "libusb-1.0.so"
    library.touch()
    found = libraries.Libraries(root, root, root, root, has_umockdev=True).options()
    found["DISMOUNT_LIBUSB_LIBRARY"] = str(library)
    found["DISMOUNT_LIBUSB_INCLUDE"] = str(root / "include")
    return found


@pytest.fixture
def everywhere(monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    """A machine that has all libraries installed; the options that this makes."""
    monkeypatch.setattr(libraries, "installed", lambda _name: True)
    return libraries.Libraries(None, None, None, None, has_umockdev=True).options()


def test_a_library_that_is_installed_later_changes_nothing(
    tmp_path: Path, everywhere: dict[str, str]
) -> None:
    assert libraries.options({}) == everywhere
    record = _record(tmp_path / "root" / "usr")
    assert libraries.options(record) == {name: record[name] for name in everywhere}


def test_a_library_that_is_gone_is_looked_for(tmp_path: Path, everywhere: dict[str, str]) -> None:
    record = _record(tmp_path / "root" / "usr")
    Path(record["DISMOUNT_LIBUSB_LIBRARY"]).unlink()
    assert libraries.options(record) == everywhere


def test_a_private_folder_of_another_kind_is_left(
    tmp_path: Path, everywhere: dict[str, str]
) -> None:
    record = _record(tmp_path / "libraries-bookworm-1" / "root" / "usr")
    assert libraries.options(record) == everywhere


def test_what_was_built_without_an_emulator_looks_for_one(
    tmp_path: Path, everywhere: dict[str, str]
) -> None:
    record = {**_record(tmp_path / "root" / "usr"), "DISMOUNT_UMOCKDEV": "OFF"}
    assert libraries.options(record) == everywhere
