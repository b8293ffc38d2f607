# SPDX-License-Identifier: MIT
"""A wearer without a suit in a session: how old the own body is that the headset shows.

A server, a trainee in Monado's headset and a warm-up of the same, in which shaders are compiled and
kept. The processor draws: what counts is the age in frames, not in ms.
"""

from __future__ import annotations

import json
import math
import time
from typing import Any

from bench import Bench
from toolchain.console import Failure, tail
from toolchain.display import virtual_display
from toolchain.monado import Monado
from toolchain.paths import cache, make_folder
from toolchain.processes import free_port

PART = "session"
# Goal of issue 18: from the sample of the own hand to the frame that shows it.
MAX_FRAMES = 1.0
WARM_UP_S = 170
SECONDS = 60


def measure(bench: Bench) -> None:
    """The own body in the headset."""
    with virtual_display() as display, Monado(display) as monado:
        shaders = str(make_folder(cache() / "xr-shaders"))
        environment = {**monado.environment(), "MESA_SHADER_CACHE_DIR": shaders}
        wear(bench, monado, environment, WARM_UP_S)
        report = wear(bench, monado, environment, SECONDS)
    frames = report["frame_times"]
    frame_ms = sum(frames[part]["p50_ms"] for part in ("waiting", "scene", "drawing"))
    own = report["own_latency"]
    if own["count"] < 20:
        bench.leave_out("own hand in the headset", f"only {own['count']} frames showed it")
        return
    case = "own body in the headset"
    bench.stats.add(case, "age, p50", own["p50_ms"] / frame_ms, "frames", at_most=MAX_FRAMES)
    bench.stats.add(case, "age, p50", own["p50_ms"], "ms")
    bench.stats.add(case, "frame", frame_ms, "ms")


def wear(bench: Bench, monado: Monado, environment: dict[str, str], seconds: int) -> dict[str, Any]:
    """Moves a wearer in a session for a time; what the client reports."""
    port = f"--port={free_port()}"
    with bench.session(environment) as (group, folder):
        file = folder / "trainee.json"
        server = ["--headless", "--", port, "--role=server", "--world=hall"]
        group.start("server", bench.command(*server))
        options = ["--role=trainee", "--display=hmd", "--mirror=none", "--quality=low"]
        options += [f"--duration={seconds}", f"--report={file}"]
        window = ["--audio-driver", "Dummy", "--resolution", "320x180"]
        group.start("trainee", bench.command(*window, "--", port, *options))
        begin = time.monotonic()
        while group.exit_code("trainee") is None and time.monotonic() < begin + 3 * seconds + 60:
            move(monado, time.monotonic() - begin)
            time.sleep(0.02)
        if not file.exists():
            raise Failure(f"The wearer's client left no stats:\n{tail(group.log('trainee'))}")
        return dict(json.loads(file.read_text(encoding="utf-8")))


def move(monado: Monado, at_s: float) -> None:
    """The wearer looks around and waves."""
    yaw = 0.4 * math.sin(0.7 * at_s)
    wearer = monado.wearer
    wearer.position = (0.2 * math.sin(0.5 * at_s), 1.62, 0.0)
    wearer.rotation = (0.0, math.sin(yaw / 2), 0.0, math.cos(yaw / 2))
    wearer.left.position = (wearer.position[0] - 0.25, 1.1 + 0.3 * math.sin(2.0 * at_s), -0.35)
    wearer.right.position = (wearer.position[0] + 0.25, 1.2 + 0.2 * math.cos(2.0 * at_s), -0.4)
    monado.send()
