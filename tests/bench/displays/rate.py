# SPDX-License-Identifier: MIT
"""Ten minutes in the town at the rate of Monado's headset, on a machine with a graphics card.

A server, a trainee who moves by a clip, and a wearer who looks around and waves; each eye's picture
is as large as a headset's, and Monado puts both together on the same card. The first minute, in
which shaders are compiled, is apart. Without a card the part is left out, and `hmd` simulates it.
RATE_SECONDS=N measures for N seconds instead.
"""

from __future__ import annotations

import json
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from bench import Bench
from toolchain.apt import AptError
from toolchain.console import Failure, tail
from toolchain.demo import SOFTWARE_RENDERERS
from toolchain.display import real_display, virtual_display
from toolchain.monado import Monado
from toolchain.paths import CLIPS
from toolchain.processes import Group, free_port

from displays.session import move

PART = "rate"
RATE_HZ = 90
SECONDS = 600.0
WARM_UP_S = 60.0
START_LIMIT_S = 180.0
# A goal of issue 18, %.
MAX_MISSED = 1.0
BY_PROCESSOR = ("VK_DRIVER_FILES", "LIBGL_ALWAYS_SOFTWARE")


def measure(bench: Bench) -> None:
    """Adds the share of frames that the headset's refreshes missed."""
    if not has_card():
        bench.leave_out("rate on a card", "there is no graphics card; see part hmd")
        return
    with card_display() as screen:
        try:
            monado = Monado(screen, RATE_HZ)
        except (AptError, Failure) as failure:
            bench.leave_out("rate on a card", str(failure))
            return
        with monado, bench.session(monado.environment()) as (group, folder):
            session = Session(group, monado, folder / "wearer.json")
            session.begin(bench)
            begin = session.move_for(WARM_UP_S)
            end = session.move_for(float(os.environ.get("RATE_SECONDS", SECONDS)))
    card = str(end["renderer"])
    if any(name in card.lower() for name in SOFTWARE_RENDERERS):
        bench.leave_out("rate on a card", f"{card} draws, which is the processor")
        return
    if end["display"]["frames"] == begin["display"]["frames"]:
        bench.leave_out("rate on a card", f"{card} has shown no frame in the time")
        return
    add_times(bench, f"town, headset, {card}", begin, end)


def has_card() -> bool:
    """Whether this machine has a graphics card at all."""
    return any(Path("/dev/dri").glob("renderD*")) or Path("/dev/nvidia0").exists()


@contextmanager
def card_display() -> Iterator[dict[str, str]]:
    """The machine's own display, else a virtual one, without what has the processor draw there."""
    if real_display():
        yield {}
        return
    with virtual_display() as screen:
        yield {name: text for name, text in screen.items() if name not in BY_PROCESSOR}


def add_times(bench: Bench, case: str, begin: dict[str, Any], end: dict[str, Any]) -> None:
    """Adds the rows of what was between two reports."""
    add = bench.stats.add
    before, after = begin["display"], end["display"]
    frames = after["frames"] - before["frames"]
    missed = after["missed"] - before["missed"]
    add(case, "measured", end["seconds"] - begin["seconds"], "s")
    add(case, "rate of the headset", after["rate_hz"], "Hz")
    width, height = after["eye_size"]
    add(case, "width of an eye's picture", width, "px")
    add(case, "height of an eye's picture", height, "px")
    share = missed / max(1, frames + missed)
    add(case, "refreshes without a new frame", 100.0 * share, "%", at_most=MAX_MISSED)
    add(case, "of the warm-up", 100.0 * before["missed_share"], "%")
    add(case, "step of quality at the end, 0 is the best", after["quality_step"], "")
    add(case, "a picture's time on the card, of the last one", after["card_ms"], "ms")
    for part, times in end["frame_times"].items():
        add(case, f"{part}, p50", times["p50_ms"], "ms")
    add(case, "own body, age, p50", end["own_latency"]["p50_ms"], "ms")


class Session:
    """Somebody with a headset, in a session with somebody who walks."""

    def __init__(self, group: Group, monado: Monado, report: Path) -> None:
        self._group = group
        self._monado = monado
        self._report = report
        self._begun_s = time.monotonic()

    def begin(self, bench: Bench) -> None:
        """Starts all, and waits until the headset shows the world."""
        port = f"--port={free_port()}"
        plain = bench.command("--headless", "--audio-driver", "Dummy", "--", port)
        self._group.start("server", [*plain, "--role=server", "--world=town"])
        clip = f"--bvh={CLIPS / '01_01.bvh'}"
        self._group.start("walker", [*plain, "--role=trainee", clip])
        window = ["--audio-driver", "Dummy", "--resolution", "640x360"]
        command = bench.command(*window, "--", port)
        options = ["--role=trainee", "--display=hmd", "--quality=high", "--mirror=none"]
        self._group.start("wearer", [*command, *options, f"--report={self._report}"])

        def is_shown() -> bool:
            self.move_for(1.0)
            return self.report()["display"].get("frames", 0) > 0

        self._group.await_that("wearer", is_shown, "a picture in the headset", START_LIMIT_S)

    def move_for(self, seconds: float) -> dict[str, Any]:
        """Looks around and waves for a time; what the client reports then."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self._group.exit_code("wearer") is not None:
                raise Failure(f"The wearer's client ended:\n{tail(self._group.log('wearer'))}")
            move(self._monado, time.monotonic() - self._begun_s)
            time.sleep(0.01)
        return self.report() if self._report.exists() else {}

    def report(self) -> dict[str, Any]:
        """The client's last report."""
        return dict(json.loads(self._report.read_text(encoding="utf-8")))
