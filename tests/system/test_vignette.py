# SPDX-License-Identifier: MIT
"""What both eyes see of the vignette while a headset's wearer is moved and turned, at Monado's."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator

import pytest
from toolchain.godot import Godot
from toolchain.headset import POSES_LIMIT_S, SCENES
from toolchain.monado import Monado, Wearer
from toolchain.paths import ROOT

pytestmark = pytest.mark.serial


@pytest.fixture(scope="module")
def monado(display: dict[str, str]) -> Iterator[Monado]:
    with Monado(display) as runtime:
        yield runtime


def test_the_vignette_darkens_the_rim_of_both_eyes(godot: Godot, monado: Monado) -> None:
    monado.wearer = Wearer()
    monado.send()
    command = [str(godot.program), "--no-header", "--path", str(ROOT), "--audio-driver", "Dummy"]
    done = subprocess.run(
        [*command, "--resolution", "64x64", SCENES + "vignette.tscn"],
        env={**os.environ, **godot.environment(), **monado.environment()},
        capture_output=True,
        text=True,
        timeout=POSES_LIMIT_S,
        check=False,
    )
    lines = [line for line in done.stdout.splitlines() if line.startswith("JSON ")]
    assert lines, done.stdout + done.stderr
    found = json.loads(lines[0].removeprefix("JSON "))
    for eye in range(2):
        still, walking, turning = (found[name][eye] for name in ("still", "walking", "turning"))
        assert still["rim"] > 0.95 * still["centre"], found
        for moved in (walking, turning):
            assert moved["rim"] < 0.75 * still["rim"], found
            assert moved["centre"] > 0.98 * still["centre"], found
        # After a step the whole picture is dark for a moment.
        assert found["step"][eye]["centre"] < 0.3 * still["centre"], found
