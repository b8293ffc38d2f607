# SPDX-License-Identifier: MIT
"""The headset: what eyes see of commanded poses, and a runtime that is lost, at Monado's.

How soon a window goes on and the headset is back, and how many frames a pose takes, is measured by
`./run bench displays`.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest
from toolchain.godot import Godot
from toolchain.headset import Stage, compare_eyes, lose_and_return
from toolchain.monado import Hand, Monado

pytestmark = pytest.mark.serial


@pytest.fixture(scope="module")
def monado(display: dict[str, str]) -> Iterator[Monado]:
    with Monado(display) as runtime:
        yield runtime


def test_both_eyes_see_what_the_head_looks_at(godot: Godot, monado: Monado) -> None:
    found = compare_eyes(godot, monado)
    assert found["size"] == [320, 240]
    assert found["error_px"] <= 0.5, found
    # Without the pose that it is compared with, the same comparison fails.
    assert found["withheld_px"] > 5.0, found


@pytest.mark.parametrize(
    ("other", "flags", "text"),
    [
        ({"VK_DRIVER_FILES": os.devnull}, [], "a headset needs Vulkan"),
        ({}, ["--headless"], "start without --headless"),
        ({"XR_RUNTIME_JSON": "/none.json"}, [], "is not there: install an OpenXR runtime"),
    ],
)
def test_without_a_screen_or_a_runtime_the_program_says_so(
    godot: Godot,
    monado: Monado,
    other: dict[str, str],
    flags: list[str],
    text: str,
) -> None:
    with Stage(godot, {**monado.environment(), **other}, *flags) as stage:
        stage.await_said(text)
        stage.await_said("worn false")


def test_a_runtime_that_does_not_answer_leaves_a_window(
    godot: Godot,
    monado: Monado,
) -> None:
    monado.stall()
    with Stage(godot, monado.environment()) as stage:
        stage.await_said("does not answer within")
        stage.await_said("worn false")
    monado.resume()


@pytest.fixture(scope="module")
def stage(godot: Godot, monado: Monado) -> Iterator[Stage]:
    """A window that began without a runtime."""
    monado.kill()
    with Stage(godot, monado.environment()) as started:
        started.await_text("worn false")
        yield started


def test_a_headset_that_comes_later_is_entered(stage: Stage, monado: Monado) -> None:
    process = stage.process.pid
    assert "No headset: the OpenXR runtime of" in stage.log()
    assert "does not run: start it" in stage.log()
    stage.mark()
    monado.start()
    said = stage.await_said("worn true")
    assert "The headset is back: going into it." in said
    assert "TOLD The headset shows the world" in said
    assert stage.process.pid == process


def test_buttons_and_hands_reach_the_program(stage: Stage, monado: Monado) -> None:
    stage.mark()
    stage.await_said("worn true")
    monado.wearer.right.trigger = 1.0
    monado.wearer.right.pressed = {"trigger_click", "a_click"}
    monado.wearer.left.pressed = {"system_click"}
    monado.wearer.position = (0.25, 1.75, -0.5)
    monado.wearer.right.position = (0.5, 1.25, -0.75)
    monado.send()
    for action in ("trigger_click 1", "ax_button 1", "menu_button 0"):
        stage.await_said(f"PRESSED {action}")
    stage.await_said("HEAD (0.25, 1.75, -0.5)")
    stage.await_said("HAND (0.5, 1.25, -0.75)")
    # A ray from the hand presses what it points at; the menu is at arm's length.
    monado.wearer.right = Hand(position=(0.0, 1.5, -0.2), trigger=0.0)
    monado.send()
    stage.await_said("HAND (0.0, 1.5, -0.2)")
    stage.mark()
    monado.wearer.right.trigger = 1.0
    monado.send()
    stage.await_said("TRIGGER 1.0")
    monado.wearer.right.trigger = 0.0
    monado.send()
    stage.await_said("MENU pressed")


def test_a_killed_and_a_stalled_runtime_leave_a_window(stage: Stage, monado: Monado) -> None:
    begin = stage.mark()
    for is_stalled in (False, True):
        lose_and_return(stage, monado, is_stalled)
    said = stage.log(begin)
    assert "The headset's runtime has ended: the window goes on." in said
    assert "The headset's runtime stalled: the window goes on." in said
    told = [line for line in said.splitlines() if line.startswith("TOLD The headset")]
    # A machine that is busy enough looks like a runtime that stalls: it is left and found again.
    ways = [line.startswith("TOLD The headset is back") for line in told if "shows" not in line]
    assert sum(ways) >= 2
    assert ways == [number % 2 == 1 for number in range(len(ways))], told
