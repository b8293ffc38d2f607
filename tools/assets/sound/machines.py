"""Loops of what runs: engines by revolutions, tracks by speed, drives, tyres, scrapes."""

import numpy as np

from .blasts import friedlander
from .bodies import grains, strike
from .waves import (
    RATE,
    bump,
    circular,
    norm,
    periodic_noise,
    put_round,
    rng,
    samples,
    times,
)

# Pipe and block of an engine: frequencies, widths (Hz) and strengths of the exhaust's resonances.
PIPE = ((46, 12, 0.6), (97, 16, 0.8), (168, 22, 0.5), (290, 40, 0.35))
# Length of a link, m.
LINK_M = 0.16


def firings(rpm: float, cylinders: int, seconds: float, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """When a four-stroke engine fires and knocks, as pulses: a loop of whole cycles."""
    cycle = 120.0 / rpm
    cycles = max(1, round(seconds / cycle))
    count = round(cycles * cycle * RATE)
    random = rng(seed)
    fires, knocks = np.zeros(count), np.zeros(count)
    # No two cylinders are alike.
    gain = 1 + 0.10 * random.standard_normal(cylinders)
    shift = 0.009 * random.standard_normal(cylinders)
    for number in range(cycles):
        for one in range(cylinders):
            at = (number + (one + shift[one]) / cylinders) * cycle * RATE
            at = (at + 0.0001 * RATE * random.standard_normal()) % count
            first = int(at)
            share = at - first
            fires[first % count] += gain[one] * (1 + 0.06 * random.standard_normal()) * (1 - share)
            fires[(first + 1) % count] += gain[one] * share
            knocks[first % count] += gain[one] * random.uniform(0.4, 1.0)
    return fires, knocks


def engine(rpm: float, cylinders: int, seed: int) -> np.ndarray:
    """A diesel's exhaust, intake and whine, without what its block does under load."""
    fires, _ = firings(rpm, cylinders, 2.0, seed)
    count = len(fires)
    exhaust = circular(fires, friedlander(0.0045 * (1100 / rpm) ** 0.4, 0.05))
    t = times(0.25)
    pipe = sum(
        gain * np.exp(-t * 2 * np.pi * width) * np.sin(2 * np.pi * f * t) for f, width, gain in PIPE
    )
    pipe[0] += 1.2
    exhaust = norm(circular(exhaust, pipe))
    flow = periodic_noise(
        count / RATE, lambda f: bump(f, 420, 1.6) + 0.4 * bump(f, 2200, 1.0), seed + 1
    )
    gate = norm(circular(np.abs(fires), np.hanning(samples(0.02))))
    turns = rpm / 60 * count / RATE
    angle = 2 * np.pi * np.arange(count) / count
    whine = np.sin(round(turns * 17.3) * angle) + 0.5 * np.sin(round(turns * 31.0) * angle)
    x = exhaust + 0.05 * flow * (0.35 + gate) + 0.010 * whine * (rpm / 1500)
    return np.tanh(1.2 * norm(x))


def engine_load(rpm: float, cylinders: int, seed: int) -> np.ndarray:
    """What comes with the load: the block rattles and the exhaust roars."""
    fires, knocks = firings(rpm, cylinders, 2.0, seed)
    count = len(fires)
    rattle = norm(circular(knocks, strike(71, 30, (550, 4800), (0.004, 0.018), 0.05, 0.0003, 0.35)))
    roar = periodic_noise(
        count / RATE, lambda f: bump(f, 260, 1.2) + 0.3 * bump(f, 1500, 1.2), seed + 2
    )
    gate = norm(circular(np.abs(fires), np.hanning(samples(0.012))))
    return np.tanh(1.1 * norm(rattle + 0.16 * roar * (0.2 + gate)))


def motor(speed: float) -> np.ndarray:
    """An electric drive at a share of its full speed: hum, its overtones, and a little noise."""
    seconds = 2.0
    angle = 2 * np.pi * times(seconds) / seconds
    base = round(60 * speed * 4 * seconds)
    x = sum(
        gain * np.sin(round(base * ratio) * angle)
        for ratio, gain in ((1, 1.0), (2, 0.5), (6, 0.35), (12, 0.2), (18.5, 0.08))
    )
    hiss = periodic_noise(seconds, lambda f: bump(f, 900, 1.4), 76)
    return norm(x + 0.12 * hiss)


def turret() -> np.ndarray:
    """A hydraulic drive turns the turret: pump, ring gear, oil."""
    seconds = 2.0
    angle = 2 * np.pi * times(seconds) / seconds
    # Whole numbers of turns, so that the loop closes.
    x = sum(
        gain * np.sin(round(f * seconds) * angle + 0.6 * np.sin(round(7 * seconds) * angle))
        for f, gain in ((118, 0.8), (236, 0.6), (472, 0.5), (708, 0.3), (1180, 0.16))
    )
    teeth = np.zeros(samples(seconds))
    for tooth in range(52):
        hit = strike(77 + tooth % 4, 9, (500, 3200), (0.004, 0.02), 0.05, 0.001)
        put_round(teeth, hit, tooth * seconds / 52)
    oil = periodic_noise(seconds, lambda f: bump(f, 1700, 0.9), 78)
    return norm(norm(x) + 0.25 * norm(teeth) + 0.05 * oil)


def tracks(speed: float) -> np.ndarray:
    """Links over road wheels and sprocket at a speed, m/s; pins that squeal now and then."""
    seconds = round(3.0 * speed / LINK_M) * LINK_M / speed
    count = round(seconds * RATE)
    random = rng(80)
    x = np.zeros(count)
    period = LINK_M / speed
    for link in range(round(seconds / period)):
        at = (link + 0.06 * random.standard_normal()) * period % seconds
        hit = strike(81 + link % 5, 26, (260, 6500), (0.008, 0.10), 0.22, 0.0006, 0.4)
        put_round(x, hit, at, random.uniform(0.35, 1.0))
        low = strike(90 + link % 3, 8, (70, 420), (0.02, 0.12), 0.2, 0.004)
        put_round(x, low, at + 0.4 * period, 0.55 * random.uniform(0.5, 1))
    rumble = periodic_noise(count / RATE, lambda f: bump(f, 70, 1.2) + 0.25 * bump(f, 400, 1.5), 82)
    return norm(norm(x) + 0.10 * norm(squeal(count)) + 0.10 * rumble)


def squeal(count: int) -> np.ndarray:
    """Dry pins: tones that wander, now and then."""
    angle = 2 * np.pi * np.arange(count) / count
    seconds = count / RATE
    x = np.zeros(count)
    for base, often in ((610, 2), (935, 3), (1480, 1)):
        phase = round(base * seconds) * angle
        phase = phase + 3 * np.sin(often * angle) + 1.5 * np.sin(5 * often * angle)
        swell = np.clip(np.sin(often * angle + base), 0, 1) ** 3
        x += swell * (np.sin(phase) + 0.5 * np.sin(2 * phase) + 0.25 * np.sin(3 * phase))
    return x


def tyres() -> np.ndarray:
    """Tyres roll over the ground at 8 m/s: lugs, air, small stones."""
    seconds = 2.4
    x = periodic_noise(seconds, lambda f: bump(f, 160, 1.1) + 0.3 * bump(f, 900, 1.3), 130)
    angle = 2 * np.pi * times(seconds) / seconds
    x *= 1 + 0.25 * np.sin(round(46 * seconds) * angle)
    stones = np.zeros(len(x))
    random = rng(131)
    for _ in range(60):
        hit = strike(random.integers(1 << 30), 5, (900, 6000), (0.003, 0.012), 0.03, 0.0004)
        put_round(stones, hit, random.uniform(0, seconds), random.exponential(0.3))
    return norm(x / 4 + 0.35 * stones)


# Of each material: the modes that ring while something is drawn over it (Hz), how many, their time
# (s), what the rubbing itself sounds like (centre, Hz; width, octaves), and the shares of both.
SCRAPES = {
    "metal": ((420, 7200), 26, (0.02, 0.22), 2600, 1.6, 0.8, 0.3),
    "wood": ((160, 1900), 12, (0.008, 0.05), 900, 1.4, 0.6, 0.5),
    "concrete": ((500, 4200), 12, (0.004, 0.02), 2100, 1.7, 0.4, 0.7),
    "cloth": ((90, 400), 4, (0.004, 0.02), 1500, 1.8, 0.1, 0.9),
    "rubber": ((280, 900), 6, (0.02, 0.09), 700, 1.0, 0.7, 0.4),
}


def scrape(kind: str) -> np.ndarray:
    """Something is drawn over a material at 1 m/s: it sticks and slips at many places."""
    seconds = 1.6
    random = rng(140 + len(kind))
    if kind == "sand":
        loose = grains(141, seconds, 4200, 700, 9000, 1e9, 0.8)
        hush = periodic_noise(seconds, lambda f: bump(f, 2400, 1.5), 142)
        # The grains are not periodic, but none of them is longer than 4 ms.
        return norm(norm(loose) * np.hanning(len(loose)) ** 0.1 + 0.25 * hush)
    span, modes, lasts, centre, octaves, ring, rub = SCRAPES[kind]
    slips = np.zeros(samples(seconds))
    for _ in range(round(210 * seconds)):
        slips[random.integers(len(slips))] += random.exponential(1.0)
    body = strike(143 + len(kind), modes, span, lasts, 0.3, 0.0006, 0.35)
    tone = norm(circular(slips, body))
    hush = periodic_noise(seconds, lambda f: bump(f, centre, octaves), 144)
    rough = norm(circular(np.abs(slips), np.hanning(samples(0.03))))
    return norm(ring * tone + 0.22 * rub * hush * (0.4 + rough))
