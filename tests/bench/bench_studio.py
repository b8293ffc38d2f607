# SPDX-License-Identifier: MIT
"""The effects studio: from a key to its picture, how long a check takes, and the second fence.

In a virtual display, drawn by the processor, in Compatibility, 1280x720. Keys are typed into the
code, and the time and frames are counted until the picture of the effect shows the change. An
endless loop is given to the process that tries effects: it has to be killed while the studio goes
on. Options: --keys=20.
"""

from __future__ import annotations

from statistics import median

from bench import SOFTWARE, Bench, Options, main
from toolchain.display import virtual_display

SCRIPT = "res://tests/bench/studio/studio_keys.gd"
# Goals of issue 17.
MAX_FRAMES = 3.0
MAX_BEYOND_MS = 40.0
MAX_CHECK_MS = 2.0
MAX_HANG_MS = 1000.0


def measure(arguments: list[str]) -> int:
    """Types, and prints the stats."""
    options = Options(arguments, {"keys": 20})
    keys = options["keys"]
    bench = Bench("studio", options.json)
    flags = [*SOFTWARE, "--resolution", "1280x720", "-s", SCRIPT, "--", f"--keys={keys}"]
    with virtual_display() as environment:
        found = bench.rows(bench.command(*flags), environment, 600.0)
    add = bench.stats.add
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
    return bench.finish()


if __name__ == "__main__":
    main(measure)
