# SPDX-License-Identifier: MIT
"""The headset: pictures of both eyes against commanded poses, and a runtime that is lost.

Monado with its remote driver and a null compositor of 320x240 per eye, drawn by the processor.
Missed frames are simulated: there is no graphics card here that could hold 90 Hz, see
hmd_rate_bench.gd. HMD_LOSSES=N kills and stalls the runtime N times each (default 20).
"""

from __future__ import annotations

import os

from bench import Bench
from toolchain.apt import AptError
from toolchain.console import Failure
from toolchain.display import virtual_display
from toolchain.headset import Stage, compare_eyes, lose_and_return
from toolchain.monado import Monado

from displays import SCRIPTS, add_rows

PART = "hmd"


def measure(bench: Bench) -> None:
    """Adds all rows."""
    _simulate_rate(bench)
    losses = int(os.environ.get("HMD_LOSSES", "20"))
    with virtual_display() as screen:
        try:
            monado = Monado(screen)
        except (AptError, Failure) as failure:
            bench.leave_out("headset", str(failure))
            return
        with monado:
            _compare(bench, monado)
        for name in ("killed", "stalled"):
            with Monado(screen) as again:
                _lose(bench, again, name, losses)


def _compare(bench: Bench, monado: Monado) -> None:
    found = compare_eyes(bench.godot, monado)
    add = bench.stats.add
    add("both eyes", "worst distance from the commanded pose", found["error_px"], "px", at_most=0.5)
    add("both eyes", "camera follows a command", found["lag_frames"], "frames", at_most=1)
    withheld = found["withheld_px"]
    add("both eyes", "negative control: a pose withheld", withheld, "px", at_least=0.5)


def _lose(bench: Bench, monado: Monado, name: str, count: int) -> None:
    windows = returns = 0
    slowest_window_s = slowest_return_s = 0.0
    with Stage(bench.godot, monado.environment()) as stage:
        for _ in range(count):
            window_s, return_s = lose_and_return(stage, monado, name == "stalled")
            windows += 1
            returns += 1
            slowest_window_s = max(slowest_window_s, window_s)
            slowest_return_s = max(slowest_return_s, return_s)
    add = bench.stats.add
    add(f"runtime {name}", f"working windows of {count}", windows, "", at_least=count)
    add(f"runtime {name}", f"back in the headset of {count}", returns, "", at_least=count)
    add(f"runtime {name}", "slowest until the window goes on", slowest_window_s, "s")
    add(f"runtime {name}", "slowest from the runtime's return", slowest_return_s, "s")


def _simulate_rate(bench: Bench) -> None:
    add_rows(bench, bench.rows(bench.command("--headless", "-s", SCRIPTS + "hmd_rate_bench.gd")))
