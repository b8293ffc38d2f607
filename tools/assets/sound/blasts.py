"""Guns, bursts and bullets: blast waves, shock waves, and what open ground gives back."""

import numpy as np
from scipy.signal import fftconvolve

from .bodies import impact, strike
from .waves import (
    RATE,
    attack,
    band,
    decay,
    noise,
    norm,
    put,
    rng,
    samples,
    saturate,
    silence,
    through_air,
    times,
)


def friedlander(positive: float, length: float = 0.0) -> np.ndarray:
    """A blast wave whose positive phase lasts so long, s (Friedlander 1946)."""
    t = np.arange(samples(length or 12 * positive)) / RATE
    return (1 - t / positive) * np.exp(-t / positive)


def n_wave(duration: float) -> np.ndarray:
    """A bullet's shock wave: rise, fall, rise (Whitham 1952); 0.2-0.3 ms for rifles."""
    x = silence(duration + 0.001)
    count = samples(duration)
    x[4 : 4 + count] = np.linspace(1, -1, count)
    return x


def outdoors(
    seconds: float, seed: int, bright: float, first: float = 0.03, density: float = 90.0
) -> np.ndarray:
    """What open ground with a few surfaces gives back: echoes, then noise that loses its highs."""
    random = rng(seed)
    x = silence(seconds)
    t = times(seconds)
    bands = ((60, 250, 1.0), (250, 900, 0.72), (900, 3000, 0.45), (3000, 9000, 0.22 * bright))
    for low, high, time in bands:
        part = band(random.standard_normal(len(x)), low, high)
        x += part / part.std() * 10 ** (-3 * t / (seconds * time)) * (low / 60) ** -0.25
    x *= np.clip((t - first) / 0.08, 0, 1)
    x /= np.abs(x).max()
    at = first
    while at < 0.6 * seconds:
        at += random.exponential(1 / (density * (0.2 + at)))
        echo = random.choice([-1, 1]) * 0.7 * 10 ** (-3 * at / (seconds * 0.8))
        put(x, np.array([echo]), at)
    return x / np.sqrt(np.sum(x**2))


def shot(
    seed: int, positive: float, gas: float, tail: float, bright: float, drive: float
) -> np.ndarray:
    """A muzzle: blast, its echo from the ground, gas, and the tail of the place."""
    random = rng(seed)
    x = silence(tail + 0.3)
    blast = friedlander(positive)
    put(x, blast, 0.002)
    put(x, blast, 0.0078 + random.uniform(0, 0.001), 0.55)
    hiss = band(random.standard_normal(samples(0.25)), 150, 9000)
    put(x, attack(norm(hiss) * decay(0.25, gas), 0.0015), 0.0025, 0.75)
    low = band(random.standard_normal(samples(0.4)), 45, 180)
    put(x, attack(norm(low) * decay(0.4, 0.35), 0.004), 0.003, 0.6)
    x = saturate(x, drive)
    wet = fftconvolve(x, outdoors(tail, seed + 50, bright))[: len(x)]
    return x + 0.30 * norm(wet)


def far_off(x: np.ndarray, seed: int, tail: float, metres: float, direct: float) -> np.ndarray:
    """The same from afar: more of the place than of the source, without what air takes."""
    wet = fftconvolve(x, outdoors(tail, seed, 0.5, 0.06))[: len(x)]
    return through_air(direct * norm(x) + (1 - direct) * norm(wet), metres)


def machine_gun_near(take: int) -> np.ndarray:
    """One round of a machine gun, with its breech."""
    x = shot(1 + 7 * take, 0.00045, 0.11, 0.9, 1.0, 3.5)
    breech = silence(0.3)
    for number, (at, gain) in enumerate(((0.0, 0.5), (0.028, 1.0), (0.055, 0.8))):
        body = strike(400 + 9 * take + number, 14, (1800, 8000), (0.008, 0.045), 0.12, 0.0004)
        put(breech, body, at, gain)
    put(x, breech, 0.012, 0.05)
    return x


def machine_gun_far(take: int) -> np.ndarray:
    """The same from 450 m."""
    return far_off(shot(2 + 5 * take, 0.0009, 0.16, 1.5, 0.6, 2.0), 77 + take, 1.5, 450, 0.5)


def cannon_near(take: int) -> np.ndarray:
    """A gun of 120 mm."""
    x = shot(3 + 11 * take, 0.0042, 0.5, 3.0, 0.7, 5.0)
    t = times(0.6)
    thump = np.sin(2 * np.pi * (34 * t + 22 * (1 - np.exp(-9 * t)) / 9)) * decay(0.6, 0.5)
    put(x, attack(thump, 0.003), 0.004, 0.8)
    return saturate(x, 1.6)


def cannon_far(take: int) -> np.ndarray:
    """The same from 700 m: a thud that rolls."""
    return far_off(cannon_near(take), 91 + take, 3.0, 700, 0.35)


def explosion_near(take: int) -> np.ndarray:
    """A shell bursts; debris falls."""
    x = shot(4 + 13 * take, 0.009, 0.7, 3.4, 0.6, 3.6)
    random = rng(44 + take)
    debris = silence(3.4)
    for _ in range(90):
        body = strike(random.integers(1 << 30), 6, (500, 5000), (0.01, 0.05), 0.1, 0.001)
        put(debris, body, 0.25 + random.exponential(0.7), random.uniform(0.1, 1) ** 2)
    put(x, debris, 0.0, 0.05)
    return saturate(x, 1.15)


def explosion_far(take: int) -> np.ndarray:
    """The same from 800 m."""
    return far_off(shot(4 + 13 * take, 0.012, 0.9, 3.4, 0.5, 3.0), 93 + take, 3.4, 800, 0.35)


def bullet_crack(take: int) -> np.ndarray:
    """A bullet faster than sound goes by: its shock wave, and that of the ground."""
    x = silence(0.5)
    put(x, n_wave(0.00025), 0.001)
    put(x, -band(n_wave(0.00028), 100, 12000), 0.0037 + 0.0009 * take, 0.45)
    wet = fftconvolve(x, outdoors(0.4, 5 + take, 1.0, 0.004, 300))[: len(x)]
    return x + 0.14 * band(norm(wet), 500, 24000)


def ricochet(take: int) -> np.ndarray:
    """A bullet glances off and whines away, tumbling."""
    t = times(0.8)
    f = (900 + 150 * take) + (2600 - 500 * take) * np.exp(-2.6 * t)
    phase = 2 * np.pi * np.cumsum(f) / RATE
    x = np.sin(phase) + 0.4 * np.sin(2.01 * phase) + 0.2 * np.sin(3.02 * phase)
    x *= 0.6 + 0.4 * np.sin(2 * np.pi * (62 - 9 * take) * t)
    x *= 10 ** (-3 * t / 0.8) * np.clip(t / 0.01, 0, 1)
    y = silence(0.9)
    put(y, impact("concrete", take), 0, 0.8)
    put(y, x, 0.006, 0.35)
    return y


def gun_loaded() -> np.ndarray:
    """A breech that closes: the gun is loaded."""
    x = silence(0.9)
    for at, seed, gain in ((0.0, 1, 0.5), (0.16, 2, 1.0), (0.24, 3, 0.5)):
        put(x, strike(480 + seed, 20, (180, 3600), (0.02, 0.22), 0.5, 0.0015), at, gain)
    slide = band(noise(0.16, 484), 900, 5000)
    put(x, attack(norm(slide) * decay(0.16, 0.3), 0.03), 0.0, 0.18)
    return x
