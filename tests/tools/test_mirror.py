# SPDX-License-Identifier: MIT
"""The gate that keeps tests beside what they test."""

from __future__ import annotations

import pytest
from toolchain.mirror import check

SCRIPTS = ["scripts/net/link.gd", "scripts/net/session/session.gd", "scripts/core/log.gd"]
SCRIPTS += ["addons/kit/dock.gd"]
CLASSES = ["SuitHub"]


@pytest.mark.parametrize(
    "test",
    [
        "tests/net/test_link.gd",
        "tests/net/test_link_hostile.gd",
        "tests/net/session/test_session.gd",
        "tests/mocap/test_suit_hub_threads.gd",
        "tests/net/link_pair.gd",
        "tests/framework/test_self.gd",
        "tests/addons/kit/test_dock.gd",
    ],
)
def test_a_test_beside_its_script(test: str) -> None:
    assert check([test], SCRIPTS, CLASSES) == []


@pytest.mark.parametrize(
    "test",
    ["tests/net/test_links.gd", "tests/core/test_link.gd", "tests/net/test_session.gd"],
)
def test_a_test_of_nothing_in_particular(test: str) -> None:
    (fault,) = check([test], SCRIPTS, CLASSES)
    assert fault.startswith(f"{test}: begin its name")
