"""Loops of what is all around: wind, rain, fire, rooms, night."""

import numpy as np

from .bodies import strike
from .waves import RATE, band, bump, norm, periodic_noise, put_round, rng, samples, times


def wind() -> np.ndarray:
    """Wind with gusts."""
    seconds = 10.0
    x = np.zeros(samples(seconds))
    for number, (centre, wide, gain) in enumerate(
        ((180, 1.4, 1.0), (520, 0.8, 0.5), (1300, 0.5, 0.22))
    ):
        gust = periodic_noise(seconds, lambda f: (f < 1.4) / np.maximum(f, 0.15), 101 + number)
        air = periodic_noise(
            seconds, lambda f, c=centre, w=wide: bump(f, c, w) / np.sqrt(f), 111 + number
        )
        x += gain * air * np.exp(0.55 * np.clip(gust, -2.5, 2.5))
    return x


def sand_wind() -> np.ndarray:
    """A sandstorm: wind that carries grains against everything."""
    seconds = 6.0
    air = periodic_noise(seconds, lambda f: bump(f, 320, 1.5) / np.sqrt(f), 116)
    gust = periodic_noise(seconds, lambda f: (f < 1.4) / np.maximum(f, 0.15), 117)
    hiss = periodic_noise(seconds, lambda f: bump(f, 5200, 0.9), 118)
    swell = np.exp(0.4 * np.clip(gust, -2.5, 2.5))
    return norm(air * swell + 0.35 * hiss * swell**2)


def rain() -> np.ndarray:
    """Rain on hard ground: hiss of the many, drops of the near ones."""
    seconds = 5.0
    x = 0.5 * periodic_noise(seconds, lambda f: bump(f, 4200, 1.5) + 0.2 * bump(f, 900, 1.2), 150)
    random = rng(151)
    drops = np.zeros(samples(seconds))
    for _ in range(900):
        t = times(0.02)
        # The bubble that a drop leaves rings at a few kHz.
        f = random.uniform(1800, 7500)
        drop = np.sin(2 * np.pi * f * t) * np.exp(-t * random.uniform(250, 900))
        put_round(drops, drop, random.uniform(0, seconds), random.exponential(0.5))
    return norm(norm(x) + 0.8 * norm(drops))


def rain_roof() -> np.ndarray:
    """The same rain from below a roof."""
    x = np.concatenate([rain()] * 2)
    half = len(x) // 2
    low = band(x, 90, 900, 2)[half:]
    return norm(norm(low) + 0.15 * norm(x[half:]))


def fire() -> np.ndarray:
    """A fire that roars and crackles."""
    seconds = 5.0
    x = 0.35 * periodic_noise(seconds, lambda f: bump(f, 130, 1.6) + 0.15 * bump(f, 1500, 1.5), 120)
    random = rng(121)
    y = np.zeros(len(x))
    for _ in range(140):
        body = strike(random.integers(1 << 30), 5, (900, 8000), (0.001, 0.006), 0.02, 0.0002)
        put_round(y, body, random.uniform(0, seconds), random.exponential(0.5))
    return norm(x / 4 + y)


def room() -> np.ndarray:
    """What is heard in a large quiet room: air ducts and a hum of lamps."""
    seconds = 4.0
    air = periodic_noise(seconds, lambda f: bump(f, 110, 1.3) / np.sqrt(f), 160)
    angle = 2 * np.pi * times(seconds) / seconds
    hum = sum(
        gain * np.sin(round(f * seconds) * angle)
        for f, gain in ((100, 1.0), (200, 0.4), (300, 0.3))
    )
    return norm(air + 0.25 * hum)


def crickets() -> np.ndarray:
    """A warm night: insects that chirp in bursts of a few strokes."""
    seconds = 4.0
    random = rng(170)
    x = np.zeros(samples(seconds))
    for _ in range(9):
        f = random.uniform(3900, 5200)
        gain = random.exponential(0.5)
        pause = seconds / random.integers(5, 10)
        begin = random.uniform(0, pause)
        for burst in range(int(seconds / pause)):
            for stroke in range(3):
                t = times(0.014)
                tone = np.sin(2 * np.pi * f * t) * np.sin(np.pi * t / 0.014) ** 2
                put_round(x, tone, begin + burst * pause + 0.03 * stroke, gain)
    air = periodic_noise(seconds, lambda f: bump(f, 300, 1.5) / np.sqrt(f), 171)
    return norm(norm(x) + 0.06 * air)


def birds() -> np.ndarray:
    """A town by day: a few birds, far away."""
    seconds = 6.0
    random = rng(180)
    x = np.zeros(samples(seconds))
    for _ in range(7):
        begin, base = random.uniform(0, seconds), random.uniform(2400, 4200)
        for note in range(random.integers(2, 6)):
            t = times(random.uniform(0.05, 0.13))
            sweep = base * (1 + random.uniform(-0.25, 0.35) * t / t[-1])
            tone = np.sin(2 * np.pi * np.cumsum(sweep) / RATE) * np.sin(np.pi * t / t[-1]) ** 2
            put_round(x, tone, begin + 0.16 * note, random.uniform(0.2, 0.7))
    air = periodic_noise(seconds, lambda f: bump(f, 350, 1.6) / np.sqrt(f), 181)
    return norm(norm(x) + 0.10 * air)
