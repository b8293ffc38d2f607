# SPDX-License-Identifier: MIT
"""Suits at the kernel's own USB: its drivers ftdi_sio and xsens_mt, usbfs, a cable that is pulled.

An emulated suit is plugged into vhci_hcd in a virtual machine with Debian's kernel. ./test --kernel
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from toolchain.kernel import KernelMachine

TRACE = Path(__file__).parents[2] / "build" / "kernel" / "console.log"
LIMIT_S = 240.0


@pytest.fixture(scope="module")
def console() -> str:
    """What the machine's console has shown."""
    return KernelMachine().run(LIMIT_S)


@pytest.fixture(scope="module")
def results(console: str) -> dict[str, str]:
    """The results by their names."""
    found = dict(re.findall(r"RESULT ([^:\n]+): ([^\r\n]*)", console))
    assert found.get("finished") == "yes", f"the machine did not come to an end: see {TRACE}"
    return found


def _stats(output: str) -> dict[str, Any]:
    """The stats in the last line but one of suit_stream's output."""
    stats: dict[str, Any] = json.loads(output.split("|")[-2])
    return stats


KINDS = pytest.mark.parametrize(("kind", "driver"), [("ftdi", "ftdi_sio"), ("native", "xsens_mt")])


@KINDS
def test_the_kernel_s_driver_is_detached_and_given_back(
    results: dict[str, str], kind: str, driver: str
) -> None:
    assert results[f"{kind} driver before"] == driver
    assert results[f"{kind} driver meanwhile"] == "usbfs"
    assert results[f"{kind} driver after"] == driver


@KINDS
def test_all_samples_arrive(results: dict[str, str], kind: str, driver: str) -> None:
    del driver
    stats = _stats(results[f"{kind} output"])
    assert stats["frames"] > 50
    (device,) = stats["devices"]
    assert device["trackers"]
    for tracker in device["trackers"]:
        assert tracker["received"] > 50
        assert tracker["lost"] == 0


@KINDS
def test_a_pulled_cable_is_noticed(results: dict[str, str], kind: str, driver: str) -> None:
    del driver
    output = results[f"{kind} output of the unplugged"]
    assert "was unplugged" in output
    assert _stats(output)["frames"] > 0
    assert results[f"{kind} driver of the unplugged"] == "gone"


def test_the_chip_sees_what_it_sees_of_the_kernel_s_driver(console: str) -> None:
    """Our requests to the FTDI chip begin as ftdi_sio's own do, and end so."""
    requests = re.findall(r"LOG control (\w\w \w\w \w{4})", console)
    probe = ["c0 0a 0000", "40 09 0010", "c0 90 0000"]
    assert requests[: len(probe)] == probe
    ours = requests[len(probe) :]
    assert ours[0] == "40 00 0000"
    assert "40 03 4006" in ours
    assert "40 01 0303" in ours
    end = ours.index("40 01 0300")
    assert ours[end - 1] == "40 02 0000"
