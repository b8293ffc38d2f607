# SPDX-License-Identifier: MIT
"""The udev rules that let users at suits: whom they match, and where users find them."""

from __future__ import annotations

import re
from fnmatch import fnmatchcase
from pathlib import Path

import pytest
from toolchain import project
from toolchain.godot import Godot
from toolchain.paths import ROOT

USB = ROOT / "gdextension" / "xbus" / "src" / "usb"
KEY = re.compile(r'(?P<key>[A-Z_]+(?:\{\w+\})?)(?P<operator>==|!=|\+=|=)"(?P<value>[^"]*)"')
ENGINE = Godot(Path("godot"), "4.6.3.stable", "4.6.3.stable")


def _known_devices() -> list[tuple[str, str]]:
    text = (USB / "known_devices.hpp").read_text(encoding="utf-8")
    vendors = dict(re.findall(r"(VENDOR_\w+) = 0x([0-9A-F]{4});", text))
    rows = re.findall(r"\{ (VENDOR_\w+), 0x([0-9A-F]{4}), DeviceLink", text)
    return [(vendors[vendor].lower(), product.lower()) for vendor, product in rows]


def _is_let_in(vendor: str, product: str, kind: str = "usb_device", action: str = "add") -> bool:
    """What udev would make of a device: its keys, as far as our rules use them."""
    facts = {"ACTION": action, "SUBSYSTEM": "usb", "ENV{DEVTYPE}": kind}
    facts |= {"ATTR{idVendor}": vendor, "ATTR{idProduct}": product}
    tags: list[str] = []
    for line in project.UDEV_RULES.read_text(encoding="utf-8").splitlines():
        keys = [match.groupdict() for match in KEY.finditer(line)]
        if line.startswith(("#", "LABEL")) or not keys:
            continue
        matches = [key for key in keys if key["operator"] in ("==", "!=")]
        if not all(
            fnmatchcase(facts[key["key"]], key["value"]) == (key["operator"] == "==")
            for key in matches
        ):
            continue
        if any(key["key"] == "GOTO" for key in keys):
            break
        tags += [key["value"] for key in keys if key["key"] == "TAG"]
    return "uaccess" in tags


def test_every_known_device_is_let_in() -> None:
    devices = _known_devices()
    assert len(devices) > 20
    assert [device for device in devices if not _is_let_in(*device)] == []


def test_unknown_devices_of_xsens_are_let_in_too() -> None:
    assert _is_let_in("2639", "0abc")


@pytest.mark.parametrize("product", ["6001", "d387", "d390", "d378"])
def test_other_serial_chips_are_left_alone(product: str) -> None:
    assert not _is_let_in("0403", product)


def test_nothing_but_devices_that_come_is_touched() -> None:
    assert not _is_let_in("2639", "0003", kind="usb_interface")
    assert not _is_let_in("2639", "0003", action="remove")


def test_the_message_names_the_file() -> None:
    assert f"copy {project.UDEV_RULES.name} to" in (USB / "port.cpp").read_text(encoding="utf-8")


def test_programs_are_exported_with_the_rules(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    targets = {"Server": tmp_path / "server" / "s", "Client": tmp_path / "client" / "c"}
    monkeypatch.setattr(project, "PRESETS", targets)
    monkeypatch.setattr(project, "BUILD", tmp_path)
    monkeypatch.setattr(project, "_export", lambda _godot, _preset, target: target.touch())
    project.export_all(ENGINE)
    for target in targets.values():
        shipped = target.parent / "60-dismount-suits.rules"
        assert shipped.read_bytes() == project.UDEV_RULES.read_bytes()


def test_wheels_are_let_in_as_the_program_says() -> None:
    rules = ROOT / "gdextension" / "cueing" / "udev" / "60-dismount-wheels.rules"
    lines = [line for line in rules.read_text(encoding="utf-8").splitlines() if line[:1] not in "#"]
    [lets_in] = [line for line in lines if "uaccess" in line]
    pairs = re.findall(r'([\w{}/]+)(==|!=|\+=|=)"([^"]*)"', lets_in)
    found = {(key, operator): value for key, operator, value in pairs}
    assert found["ENV{ID_INPUT_JOYSTICK}", "=="] == "1"
    assert found["ATTRS{capabilities/ff}", "!="] == "0"
    assert (found["GROUP", "="], found["MODE", "="]) == ("input", "0660")
    source = ROOT / "gdextension" / "cueing" / "src" / "evdev" / "force_device.cpp"
    assert rules.name in source.read_text(encoding="utf-8")
    assert "docs/motion-platform.md" in source.read_text(encoding="utf-8")
    assert rules.name in (ROOT / "docs" / "motion-platform.md").read_text(encoding="utf-8")
