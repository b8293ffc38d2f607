# SPDX-License-Identifier: MIT
"""An emulated suit through the real libusb: delay of a sample, and what becomes of a motion.

Delay: from the moment at which the last byte of a sample is handed over by the chip (and, as a
figure without a goal, at which it lies in the chip) to the callback of the suit's thread. Where a
processor of a rented machine stands still for everybody, bytes are lost that the chip does not keep
for so long (an FTDI's keeps 5 ms of them): the longest stop is told. Samples: a clip, worn in a
suit with trackers at any angle and with norths that differ by up to 30 degrees, calibrated as
guided: how far what the suit's source gives is from the clip itself, all limbs (of the spine, which
has no tracker, what 17 trackers tell of it; how far that is from the clip's is told on its own),
with one master and with two that measure each in its own time. Motion: the same behind physics and
network at an observer, against the same clip sent directly.

Options: --seconds=20 (of each part), --sensors=15 (delay), --rate=100, --bvh=FILE,
--only=delay|samples|motion, --port=7777 (a free one by default).
"""

from __future__ import annotations

import csv
import subprocess
import tempfile
from pathlib import Path

from bench import main
from toolchain import suit
from toolchain.console import Failure, step, tail
from toolchain.godot import Godot, find
from toolchain.paths import CLIPS
from toolchain.processes import free_port
from toolchain.processor_stops import ProcessorStops
from toolchain.project import EXTENSIONS
from toolchain.stats import Stats
from toolchain.suit_session import SuitSession, compare, sample

STREAM = EXTENSIONS / "xbus" / "suit_stream"
CHIPS = ("native", "ftdi", "ftdi-fast")
P50_MS = 0.5
P99_MS = 5.0
SAMPLE_DEG = 0.05
SECOND_MASTER_DEG = 0.03
SPINE_DEG = 5.0
# The part of the clip that is judged begins here: by then everybody has begun, in either way.
BEGIN_S = 6.0


def percentile(values: list[float], fraction: float) -> float:
    """A percentile of a list."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(fraction * len(ordered)))]


def delays(chip: str, options: dict[str, str], folder: Path) -> dict[str, list[float]]:
    """Delays of all samples of a run, ms, from when they lay in the chip and were handed over."""
    trace, callbacks = folder / f"{chip}.csv", folder / f"{chip}.txt"
    seconds, rate = options["seconds"], options["rate"]
    command = [str(suit.PROGRAM), f"--devices={chip}", f"--sensors={options['sensors']}"]
    # The chip itself waits for nobody: what is measured is the program.
    command.append("--real-time")
    command += [f"--trace={trace}", "--", str(STREAM), f"--seconds={seconds}"]
    command += [f"--trace={callbacks}", f"--rate={rate}"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    if done.returncode != 0:
        raise Failure(f"Nothing came of the emulated suit:\n{tail(done.stdout + done.stderr)}")
    with trace.open(encoding="utf-8") as file:
        sent = [row for row in csv.DictReader(file) if row["device"] == "1"]
    heard = [line.split() for line in callbacks.read_text(encoding="utf-8").splitlines()]
    # Both count their samples from their first one on.
    by_count = {number + 1: row for number, row in enumerate(sent)}
    found: dict[str, list[float]] = {"chip": [], "handed over": [], "lost": []}
    last = 0
    for _, count, usec, _ in heard:
        row = by_count.get(int(count))
        if row is not None:
            found["chip"].append((int(usec) - int(row["on_chip_usec"])) / 1000.0)
            found["handed over"].append((int(usec) - int(row["handed_over_usec"])) / 1000.0)
        found["lost"] += [0.0] * max(int(count) - last - 1, 0)
        last = int(count)
    return found


def measure_delays(options: dict[str, str], stats: Stats, folder: Path) -> None:
    """Adds the stats of all kinds of chip."""
    for chip in CHIPS:
        with step(f"stream from an emulated suit ({chip})"), ProcessorStops() as stops:
            found = delays(chip, options, folder)
        case = f"{chip}, {options['sensors']} trackers at {options['rate']} Hz"
        handed = found["handed over"]
        stats.add(case, "sample to callback p50", percentile(handed, 0.5), "ms", at_most=P50_MS)
        stats.add(case, "sample to callback p99", percentile(handed, 0.99), "ms", at_most=P99_MS)
        stats.add(case, "in the chip to callback p50", percentile(found["chip"], 0.5), "ms")
        stats.add(case, "in the chip to callback p99", percentile(found["chip"], 0.99), "ms")
        stats.add(case, "samples", len(handed), "")
        stats.add(case, "samples lost", len(found["lost"]), "", at_most=0)
        if stops.longest_ms is not None:
            stats.add(case, "a processor stood still", stops.longest_ms, "ms")


def measure_samples(options: dict[str, str], stats: Stats, folder: Path) -> None:
    """Adds the stats of what a suit's source gives, before physics."""
    godot = find()
    bvh, seconds = Path(options["bvh"]), float(options["seconds"])
    means = []
    # Two of the same kind: an emulated FTDI chip hands over ten times as often, and two of them
    # take so much of two processors that the program waits for one.
    for masters, devices in ((1, "native"), (2, "two-native-masters")):
        with step(f"sample {bvh.name} in a suit ({masters} masters)"):
            # As above: a real chip is held up by nobody.
            own = [f"--devices={devices}", "--sensors=17", "--real-time"]
            found = sample(godot, bvh, own, masters, seconds, folder / devices)
        case = f"samples of a suit, masters: {masters}"
        means.append(found["mean"])
        stats.add(case, "mean error", found["mean"], "deg", at_most=SAMPLE_DEG)
        stats.add(case, "p95", found["p95"], "deg")
        stats.add(case, "spine from the clip's", found["spine_deg"], "deg", at_most=SPINE_DEG)
        stats.add(case, "samples", found["count"], "")
    more = means[1] - means[0]
    stats.add("samples of a suit", "second master", more, "deg", at_most=SECOND_MASTER_DEG)


def motion_error(godot: Godot, options: dict[str, str], folder: Path, worn: bool) -> dict:
    """How far an observer's picture of a clip is from it: sent directly, or worn in a suit."""
    bvh = Path(options["bvh"])
    seconds = float(options["seconds"])
    folder.mkdir()
    with SuitSession(folder, int(options["port"])) as session:
        if worn:
            session.start_suit(godot, bvh, ["--sensors=17", "--devices=two-native-masters"])
        else:
            session.start_bvh(bvh)
        session.record(folder / "observer.rec", BEGIN_S + seconds)
    return compare(godot, folder / "observer.rec", bvh, BEGIN_S, BEGIN_S + seconds)


def measure_motion(options: dict[str, str], stats: Stats, folder: Path) -> None:
    """Adds the stats of a motion that goes through a suit and of one that does not."""
    godot = find()
    found = {}
    for name in ("direct", "suit"):
        with step(f"follow {Path(options['bvh']).name} ({name})"):
            found[name] = motion_error(godot, options, folder / name, name == "suit")
        stats.add("motion at the observer", f"{name}: mean error", found[name]["mean"], "deg")
        stats.add("motion at the observer", f"{name}: p95", found[name]["p95"], "deg")
        stats.add("motion at the observer", f"{name}: spine", found[name]["limbs"]["Spine"], "deg")
    more = found["suit"]["mean"] - found["direct"]["mean"]
    stats.add("motion at the observer", "suit - direct", more, "deg")


PARTS = {"delay": measure_delays, "samples": measure_samples, "motion": measure_motion}


def measure(arguments: list[str]) -> int:
    """Measures and prints the stats."""
    options = {"seconds": "20", "sensors": "15", "rate": "100", "only": ""}
    options |= {"bvh": str(CLIPS / "01_01.bvh"), "port": str(free_port())}
    for argument in arguments:
        name, _, value = argument.removeprefix("--").partition("=")
        if name != "json" and name not in options:
            raise Failure(f"There is no option '{argument}': see ./run bench suit --help.", 2)
        options |= {name: value}
    if options["only"] not in ("", *PARTS):
        raise Failure(f"--only is one of {', '.join(PARTS)}, found '{options['only']}'.", 2)
    stats = Stats("suit", "json" in options)
    with tempfile.TemporaryDirectory(prefix="dismount-") as name:
        for part, add in PARTS.items():
            if options["only"] in ("", part):
                add(options, stats, Path(name))
    return stats.finish()


if __name__ == "__main__":
    main(measure)
