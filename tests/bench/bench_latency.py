# SPDX-License-Identifier: MIT
"""From a sample to its display on loopback, through exported programs in real time.

A server of 60 ticks/s, a trainee who moves by a clip, and an observer whose frames come at a
fixed rate; stages as in docs/latency.md. The own body is what the trainee sees in local feedback.
Options: --seconds=20, --rate=60 (samples per second), --fps=60 (of the displays),
--smoothing=METHOD (of the observer), --bvh=FILE, --port=7777 (a free one by default).
"""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path

from toolchain.console import Failure
from toolchain.latency import Settings, run_session
from toolchain.processes import free_port
from toolchain.stats import Stats

MAX_MS = 20.0
MAX_SD_MS = 6.0
THESIS_MS = 50.7


def measure(arguments: list[str]) -> int:
    """Runs a session and prints its stats."""
    as_json = "--json" in arguments
    options = [argument for argument in arguments if argument != "--json"]
    if not any(option.startswith("--port=") for option in options):
        options.append(f"--port={free_port()}")
    settings = Settings(options)
    with tempfile.TemporaryDirectory(prefix="dismount-") as folder:
        reports = run_session(settings, Path(folder) / "latency.csv")
    stats = Stats("latency", as_json)
    delays = reports["observer"]["latency"]
    total = delays.pop("total")
    case = "sample to display"
    stats.add(case, "mean", total["mean_ms"], "ms", at_most=MAX_MS)
    stats.add(case, "sd", total["sd_ms"], "ms", at_most=MAX_SD_MS)
    for name in ("p50", "p95", "p99"):
        stats.add(case, name, total[name + "_ms"], "ms")
    stats.add(case, "samples", total["count"], "", at_least=0.9 * settings.rate * settings.seconds)
    stats.add(case, "thesis over ours", THESIS_MS / max(total["mean_ms"], 0.001), "")
    for stage, row in delays.items():
        if row["count"]:
            stats.add(stage, "mean", row["mean_ms"], "ms")
            stats.add(stage, "p99", row["p99_ms"], "ms")
    own = reports["trainee"].get("own_latency", {"count": 0})
    if own["count"]:
        frame_ms = 1000.0 / settings.fps
        stats.add("own body", "mean", own["mean_ms"], "ms", at_most=frame_ms)
        stats.add("own body", "p95", own["p95_ms"], "ms")
    else:
        print("The trainee did not show the own body.", file=sys.stderr)
    stats.finish()
    return 0


if __name__ == "__main__":
    try:
        sys.exit(measure(sys.argv[1:]))
    except Failure as failure:
        print(failure, file=sys.stderr)
        sys.exit(2)
    except (KeyError, json.JSONDecodeError) as broken:
        print(f"A report lacks what is needed: {broken}", file=sys.stderr)
        sys.exit(1)
