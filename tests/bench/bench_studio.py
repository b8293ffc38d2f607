# SPDX-License-Identifier: MIT
"""The effects studio: from a key to its picture, how long a check takes, and the second fence.

In a virtual display, drawn by the processor, in Compatibility, 1280x720. Keys are typed into the
code, and the time and frames are counted until the picture of the effect shows the change. An
endless loop is given to the process that tries effects: it has to be killed while the studio goes
on. Options: --keys=20.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from statistics import median
from typing import Any

from toolchain.console import Failure
from toolchain.display import virtual_display
from toolchain.paths import ROOT
from toolchain.project import prepare
from toolchain.stats import Stats

SCRIPT = "res://tests/bench/studio/studio_keys.gd"
# Goals of issue 17.
MAX_FRAMES = 3.0
MAX_BEYOND_MS = 40.0
MAX_CHECK_MS = 2.0
MAX_HANG_MS = 1000.0


def rows(keys: int) -> list[dict[str, Any]]:
    """What the script tells."""
    godot = prepare(export=False)
    command = [str(godot.program), "--no-header", "--path", str(ROOT)]
    command += ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]
    command += ["--resolution", "1280x720", "-s", SCRIPT, "--", f"--keys={keys}"]
    with virtual_display() as environment:
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=600.0,
            check=False,
            env={**os.environ, **godot.environment(), **environment},
        )
    found = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode != 0 or not any(row["what"] == "again" for row in found):
        raise Failure(f"The studio ended with {done.returncode}:\n{done.stderr[-2000:]}")
    return found


def measure(arguments: list[str]) -> int:
    """Types, and prints the stats."""
    keys = 20
    for option in arguments:
        name, _, value = option.removeprefix("--").partition("=")
        if name == "keys" and value.isdigit() and int(value) > 0:
            keys = int(value)
        elif option != "--json":
            raise Failure(f"'{option}' is no option: --keys=N, --json.", 2)
    found = rows(keys)
    add = (stats := Stats("studio", "--json" in arguments)).add
    typed = [row for row in found if row["what"] == "key"]
    frames = [row["frames"] for row in typed]
    beyond = [row["ms"] - row["frame_ms"] for row in typed]
    add(f"{keys} keys", "median frame", median(row["frame_ms"] for row in typed), "ms")
    add(f"{keys} keys", "key to picture, most", max(frames), "frames", at_most=MAX_FRAMES)
    add(f"{keys} keys", "key to picture, median", median(row["ms"] for row in typed), "ms")
    add(
        f"{keys} keys",
        "key to picture beyond a frame, median",
        median(beyond),
        "ms",
        at_most=MAX_BEYOND_MS,
    )
    add(f"{keys} keys", "key to picture beyond a frame, most", max(beyond), "ms")
    add(f"{keys} keys", "check, median", median(row["check_ms"] for row in typed), "ms")
    checks = {row["effect"]: row["ms"] for row in found if row["what"] == "check"}
    slowest = max(checks, key=lambda effect: checks[effect])
    add("shipped effects", "check, median", median(checks.values()), "ms", at_most=MAX_CHECK_MS)
    longest = checks[slowest]
    add(f"shipped: {slowest}", "check, longest", longest, "ms", at_most=MAX_CHECK_MS)
    loop = next(row for row in found if row["what"] == "loop")
    add("a loop, tried first", "shown", float(loop["shown"]), "", at_least=1.0)
    add("a loop, tried first", "key to picture", loop["ms"], "ms")
    endless = next(row for row in found if row["what"] == "endless")
    add("an endless loop", "process killed", float(endless["killed"]), "", at_least=1.0)
    add("an endless loop", "after", endless["ms"], "ms")
    longest = endless["longest_frame_ms"]
    add("an endless loop", "longest frame of the studio", longest, "ms", at_most=MAX_HANG_MS)
    again = next(row for row in found if row["what"] == "again")
    add("an endless loop", "process ready again", float(again["ready"]), "", at_least=1.0)
    return stats.finish()


if __name__ == "__main__":
    try:
        sys.exit(measure(sys.argv[1:]))
    except Failure as failure:
        print(failure, file=sys.stderr)
        sys.exit(2)
