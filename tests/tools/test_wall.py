# SPDX-License-Identifier: MIT
"""What ./run wall makes of a layout and its options."""

from __future__ import annotations

from pathlib import Path

import pytest
from toolchain import wall
from toolchain.console import Failure

LAYOUT = Path("/station/cave.cfg")
SCREENS = ["left", "front", "right"]


def test_one_client_shows_all_screens() -> None:
    found = {"clients": "one", "screens": SCREENS}
    given = ["--layout=cave.cfg", "--host=10.0.0.5", "--port=8000"]
    commands = wall.clients(found, LAYOUT, "observer", "", given)
    options = ["--role=observer", "--display=wall", f"--layout={LAYOUT}"]
    assert commands == {"": [*options, "--host=10.0.0.5", "--port=8000"]}


def test_each_screen_has_a_client_and_only_the_first_is_the_trainee() -> None:
    found = {"clients": "each", "screens": SCREENS}
    given = ["--role=trainee", "--host=10.0.0.5", "--bvh=walk.bvh"]
    commands = wall.clients(found, LAYOUT, "trainee", "", given)
    assert list(commands) == SCREENS
    assert "--role=trainee" in commands["left"] and "--bvh=walk.bvh" in commands["left"]
    assert "--role=observer" in commands["front"] and "--screens=front" in commands["front"]
    assert "--host=10.0.0.5" in commands["right"] and "--bvh=walk.bvh" not in commands["right"]


def test_some_screens_only() -> None:
    found = {"clients": "each", "screens": SCREENS}
    assert list(wall.clients(found, LAYOUT, "observer", "right", [])) == ["right"]
    with pytest.raises(Failure, match="no screen 'roof'"):
        wall.clients(found, LAYOUT, "observer", "roof", [])


@pytest.mark.parametrize("options", [[], ["--layout="], ["--layout=/nowhere.cfg"]])
def test_without_a_layout_it_asks_for_one(options: list[str]) -> None:
    with pytest.raises(Failure, match="--layout=FILE"):
        wall.main(options)
