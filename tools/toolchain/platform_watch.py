# SPDX-License-Identifier: MIT
"""`./run platform-watch`: a motion platform that is not there, to see what one would be sent.

It reads the datagrams of docs/motion-platform.md and knows nothing of the C++ that writes them.
"""

from __future__ import annotations

import json
import math
import select
import socket
import struct
import sys
import time
import zlib
from dataclasses import asdict, dataclass
from typing import TextIO

from .console import Failure
from .paths import user_path

HELP = """./run platform-watch [--port=4123] [--seconds=S] [--csv=FILE] [--json]

Shows what a motion platform on this machine would be sent by --platform=127.0.0.1:4123, ten lines a
second: how far it takes part, its position and attitude, what is felt in the seat. At the end, or
after Ctrl+C: how many datagrams came, were lost or broken, their rate, the greatest values.

  --port=4123           UDP port to listen on, at 127.0.0.1
  --seconds=S           end after this time; by default it goes on
  --csv=FILE            write every datagram to this file
  --json                one JSON object for each datagram instead of lines for people
"""
LOCAL = "127.0.0.1"
CUE = struct.Struct("<4sHHIIQ4f3f3f3f3ffII")
OUTSIM = struct.Struct("<I12f3i")
OUTSIM_WITH_ID = struct.Struct("<I12f4i")
FLAGS = ("paused", "teleported", "stale")
PERIOD_S = 0.1


@dataclass
class Cue:
    """Our own datagram."""

    sequence: int
    tick: int
    time_s: float
    flags: list[str]
    gain: float
    orientation: tuple[float, ...]
    specific_force: tuple[float, ...]
    rates: tuple[float, ...]
    position: tuple[float, ...]
    attitude: tuple[float, ...]


@dataclass
class OutSim:
    """OutSim's packet; X is to the right, Y ahead, Z up."""

    time_s: float
    rates: tuple[float, ...]
    heading: float
    pitch: float
    roll: float
    acceleration: tuple[float, ...]
    velocity: tuple[float, ...]
    position: tuple[float, ...]
    id: int | None


def decode(data: bytes) -> Cue | OutSim:
    """What a datagram holds; ValueError says why it is none."""
    if len(data) == CUE.size and data[:4] == b"DSMC":
        return _decode_cue(data)
    if len(data) == OUTSIM.size:
        return _decode_outsim(OUTSIM.unpack(data), None)
    if len(data) == OUTSIM_WITH_ID.size:
        values = OUTSIM_WITH_ID.unpack(data)
        return _decode_outsim(values[:-1], values[-1])
    raise ValueError(f"{len(data)} bytes are no datagram for a platform")


def _decode_cue(data: bytes) -> Cue:
    _magic, version, bits, sequence, tick, time_usec, *rest = CUE.unpack(data)
    if version != 1:
        raise ValueError(f"version {version}, not 1")
    if zlib.crc32(data[:-4]) != rest[-1]:
        raise ValueError("its CRC is wrong")
    names = [name for bit, name in enumerate(FLAGS) if bits >> bit & 1]
    parts = [tuple(rest[begin : begin + 3]) for begin in (4, 7, 10, 13)]
    return Cue(sequence, tick, time_usec / 1e6, names, rest[16], tuple(rest[:4]), *parts)


def _decode_outsim(values: tuple, number: int | None) -> OutSim:
    angles = values[4:7]
    metres = tuple(value / 65536.0 for value in values[13:16])
    rates, acceleration, velocity = values[1:4], values[7:10], values[10:13]
    return OutSim(values[0] / 1e3, rates, *angles, acceleration, velocity, metres, number)


class Watch:
    """Counts datagrams and keeps the greatest values."""

    def __init__(self) -> None:
        self.count = 0
        self.broken = 0
        self.lost = 0
        self.newest: Cue | OutSim | None = None
        self.greatest: dict[str, float] = {}
        self._begin = 0.0
        self._end = 0.0

    def take(self, data: bytes) -> Cue | OutSim | None:
        """The datagram, or None where it is broken."""
        try:
            found = decode(data)
        except ValueError:
            self.broken += 1
            return None
        before = self.newest
        if isinstance(found, Cue) and isinstance(before, Cue):
            # A sender that begins anew counts anew.
            self.lost += max(found.sequence - before.sequence - 1, 0)
        self._end = time.monotonic()
        self._begin = self._begin or self._end
        self.count += 1
        self.newest = found
        values = {"mm": 0.0, "deg": 0.0}
        if isinstance(found, Cue):
            values["mm"] = 1e3 * max(abs(metres) for metres in found.position)
            values["deg"] = math.degrees(max(abs(angle) for angle in found.attitude))
        for unit, value in values.items():
            self.greatest[unit] = max(self.greatest.get(unit, 0.0), value)
        return found

    def summary(self) -> str:
        """What came in all."""
        seconds = self._end - self._begin
        rate = (self.count - 1) / seconds if seconds > 0.0 else 0.0
        line = (
            f"{self.count} datagrams, {rate:.1f} a second, {self.lost} lost, {self.broken} broken"
        )
        if isinstance(self.newest, Cue):
            line += f"; at most {self.greatest['mm']:.1f} mm and {self.greatest['deg']:.2f} deg"
        return line


def describe(found: Cue | OutSim) -> str:
    """A line for people."""
    if isinstance(found, OutSim):
        pushed = " ".join(f"{value:7.2f}" for value in found.acceleration)
        angles = (found.heading, found.pitch, found.roll)
        turned = " ".join(f"{math.degrees(angle):7.2f}" for angle in angles)
        return f"OutSim {found.time_s:9.2f} s   m/s2 {pushed}   heading pitch roll {turned} deg"
    moved = " ".join(f"{1e3 * metres:7.1f}" for metres in found.position)
    turned = " ".join(f"{math.degrees(angle):6.2f}" for angle in found.attitude)
    pushed = " ".join(f"{value:6.2f}" for value in found.specific_force)
    state = " ".join(found.flags)
    return (
        f"{found.time_s:8.2f} s  gain {found.gain:4.2f}   x y z {moved} mm"
        f"   pitch yaw roll {turned} deg   felt {pushed} m/s2  {state}"
    )


def main(arguments: list[str]) -> int:
    """Runs the command; its options are --name=value."""
    given = dict(argument.removeprefix("--").partition("=")[::2] for argument in arguments)
    try:
        port, seconds = int(given.get("port") or 4123), float(given.get("seconds") or math.inf)
    except ValueError as error:
        raise Failure(
            f"./run platform-watch: --port and --seconds are numbers: {error}", 2
        ) from None
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    with receiver:
        try:
            receiver.bind((LOCAL, port))
        except (OSError, OverflowError) as error:
            raise Failure(f"UDP port {port} cannot be listened on: {error}") from None
        print(f"listening on UDP port {receiver.getsockname()[1]}", file=sys.stderr, flush=True)
        watch = Watch()
        try:
            if given.get("csv"):
                with user_path(given["csv"]).open("w", encoding="utf-8") as file:
                    _watch(receiver, watch, seconds, file, "json" in given)
            else:
                _watch(receiver, watch, seconds, None, "json" in given)
        except KeyboardInterrupt:
            pass
        print(watch.summary(), file=sys.stderr)
    return 0


def _watch(
    receiver: socket.socket, watch: Watch, seconds: float, file: TextIO | None, as_json: bool
) -> None:
    end = time.monotonic() + seconds
    shown_s = 0.0
    while time.monotonic() < end:
        if not select.select([receiver], [], [], PERIOD_S)[0]:
            continue
        found = watch.take(receiver.recv(2048))
        if found is None:
            continue
        if file is not None:
            _write_row(file, found, watch.count == 1)
        if as_json:
            print(json.dumps(asdict(found)), flush=True)
        elif time.monotonic() - shown_s >= PERIOD_S:
            shown_s = time.monotonic()
            print(describe(found), flush=True)


def _write_row(file: TextIO, found: Cue | OutSim, is_first: bool) -> None:
    names: list[str] = []
    values: list[str] = []
    for name, value in asdict(found).items():
        if isinstance(value, tuple):
            names += [f"{name}_{axis}" for axis in "xyzw"[: len(value)]]
            values += [repr(part) for part in value]
        else:
            names.append(name)
            values.append(" ".join(value) if isinstance(value, list) else str(value))
    if is_first:
        file.write(",".join(names) + "\n")
    file.write(",".join(values) + "\n")
