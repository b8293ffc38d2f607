"""What is struck, stepped on and rubbed: damped modes, contact times, grains."""

import numpy as np
from scipy.signal import fftconvolve

from .waves import attack, band, decay, noise, norm, put, rng, samples, silence, times

# Of each material: modes, their span (Hz), their times (s: shortest, longest), length (s), contact
# time (s) and how fast higher ones lose strength.
MODES = {
    "metal": (34, (340, 9500), (0.05, 1.3), 1.4, 0.0002, 0.25),
    "wood": (12, (180, 2600), (0.02, 0.11), 0.4, 0.0012, 0.5),
    "concrete": (16, (420, 5200), (0.008, 0.045), 0.4, 0.0004, 0.3),
    "glass": (26, (1400, 12500), (0.02, 0.30), 0.6, 0.0001, 0.1),
    "rubber": (6, (90, 700), (0.012, 0.06), 0.25, 0.0045, 0.7),
    "cloth": (4, (70, 420), (0.008, 0.035), 0.2, 0.006, 0.8),
    "flesh": (5, (60, 300), (0.01, 0.045), 0.22, 0.007, 0.9),
}
# What crumbles off: grains a second, lowest and highest frequency (Hz), time (s), share.
CRUMBS = {
    "concrete": (500, 1500, 11000, 0.3, 0.22),
    "glass": (900, 3500, 16000, 0.35, 0.3),
    "wood": (120, 900, 6000, 0.08, 0.06),
}
# What has no modes: grains a second, lowest and highest frequency (Hz), time (s), size, and how
# loud thud and grains are.
LOOSE = {
    "sand": (2600, 900, 9000, 0.12, 0.7, 0.9, 0.30),
    "gravel": (900, 1200, 9500, 0.26, 1.6, 0.55, 0.7),
    "dirt": (700, 400, 4200, 0.12, 0.9, 0.9, 0.3),
}


def strike(
    seed: int,
    modes: int,
    span: tuple[float, float],
    lasts: tuple[float, float],
    seconds: float,
    contact: float,
    tilt: float = 0.5,
) -> np.ndarray:
    """A struck body: damped modes, higher ones shorter, driven by a half sine of contact s."""
    random = rng(int(seed))
    t = times(seconds)
    x = np.zeros(len(t))
    for f in np.exp(random.uniform(np.log(span[0]), np.log(span[1]), modes)):
        time = lasts[1] * (span[0] / f) ** 0.5 * random.uniform(0.6, 1.4) + lasts[0]
        gain = random.uniform(0.3, 1) * (span[0] / f) ** tilt
        x += gain * np.sin(2 * np.pi * f * t + random.uniform(0, 6.28)) * 10 ** (-3 * t / time)
    pulse = np.sin(np.linspace(0, np.pi, max(3, samples(contact))))
    x = fftconvolve(x, pulse / pulse.sum())[: len(t)]
    return norm(x)


def grains(
    seed: int, seconds: float, rate: float, low: float, high: float, time: float, size: float = 1.0
) -> np.ndarray:
    """Sand and gravel: many tiny impacts, each a short burst; exponential sizes."""
    random = rng(seed)
    x = silence(seconds)
    for _ in range(int(rate * seconds)):
        at = random.uniform(0, seconds)
        burst = random.standard_normal(samples(0.004)) * decay(0.004, 0.003 * size)
        put(x, burst, at, random.exponential(1.0) * 10 ** (-3 * at / time))
    return band(x, low, high)


def impact(kind: str, take: int) -> np.ndarray:
    """Something hits this material, or something of it hits something hard."""
    seed = 1000 + 37 * take + 7 * sum(kind.encode())
    if kind in LOOSE:
        return _loose(kind, seed)
    modes, span, lasts, seconds, contact, tilt = MODES[kind]
    # The place that is struck rings differently each time.
    shift = 1 + 0.09 * (take - 1)
    x = strike(seed, modes, (span[0] * shift, span[1]), lasts, seconds, contact, tilt)
    if kind == "metal":
        put(x, band(noise(0.02, seed + 1), 2000, 16000) * decay(0.02, 0.012), 0, 0.25)
    if kind in ("cloth", "flesh", "rubber"):
        thud = band(noise(0.08, seed + 2), 60, 900) * decay(0.08, 0.05)
        put(x, attack(norm(thud), 0.002), 0, 0.5)
    if kind in CRUMBS:
        rate, low, high, time, share = CRUMBS[kind]
        put(x, norm(grains(seed + 3, seconds * 0.9, rate, low, high, time)), 0.004, share)
    return x


def _loose(kind: str, seed: int) -> np.ndarray:
    """The ground gives way: a thud and its grains."""
    rate, low, high, time, size, thud_gain, gain = LOOSE[kind]
    x = silence(0.45)
    thud = band(noise(0.1, seed), 50, 350) * decay(0.1, 0.055)
    put(x, attack(norm(thud), 0.002), 0, thud_gain)
    part = grains(seed + 1, 0.4, rate, low, high, time, size)
    put(x, attack(norm(part), 0.004), 0.003, gain)
    return x


def step(kind: str, take: int) -> np.ndarray:
    """Heel, then toe 90-150 ms later; the ground decides what each sounds like."""
    seed = 100 + 17 * take + sum(kind.encode())
    random = rng(seed)
    x = silence(0.5)
    toe = 0.002 + random.uniform(0.09, 0.15)
    for at, gain in ((0.002, 1.0), (toe, random.uniform(0.35, 0.6))):
        thud = band(random.standard_normal(samples(0.075)), 55, 210) * decay(0.075, 0.06)
        put(x, norm(attack(thud, 0.003)), at, gain * STEP_THUD[kind])
        for part, later, share in _sole(kind, seed + int(at * 1e4)):
            put(x, part, at + later, share * gain)
    return x


# How much of the ground's own body a step has.
STEP_THUD = {
    "concrete": 0.45,
    "metal": 0.35,
    "wood": 0.5,
    "sand": 0.35,
    "gravel": 0.3,
    "dirt": 0.5,
}


def _sole(kind: str, seed: int) -> list[tuple[np.ndarray, float, float]]:
    """What a sole does to a ground: sounds, when each begins (s), and how loud it is."""
    if kind == "metal":
        return [(strike(900 + seed % 3, 22, (260, 4200), (0.03, 0.42), 0.45, 0.0011, 0.45), 0, 0.7)]
    if kind == "wood":
        return [(strike(seed * 5, 8, (110, 1300), (0.015, 0.07), 0.2, 0.0016), 0, 0.8)]
    if kind == "concrete":
        body = strike(seed * 7, 9, (700, 5200), (0.004, 0.022), 0.06, 0.0009)
        return [(body, 0, 0.6), (norm(grains(seed + 3, 0.12, 260, 2000, 9000, 0.09)), 0.004, 0.1)]
    rate, low, high, size = {
        "sand": (1500, 700, 7500, 0.6),
        "gravel": (620, 1100, 9000, 1.7),
        "dirt": (520, 400, 4200, 0.8),
    }[kind]
    part = grains(seed, 0.22, rate, low, high, 0.13, size)
    return [(attack(norm(part), 0.012), 0, 0.5)]


def door_creak(take: int) -> np.ndarray:
    """A hinge that sticks and slips."""
    random = rng(60 + take)
    x = silence(1.0)
    at, rate = 0.05, 55.0 + 12 * take
    while at < 0.85:
        rate = np.clip(rate * random.uniform(0.93, 1.08), 35, 130)
        swell = np.sin(np.pi * (at - 0.05) / 0.8) * random.uniform(0.5, 1)
        put(x, strike(61 + take, 10, (420, 3200), (0.005, 0.03), 0.05, 0.0005), at, swell)
        at += random.uniform(0.9, 1.1) / rate
    return x


def door_shut(take: int) -> np.ndarray:
    """The leaf meets its frame; the latch falls in."""
    x = silence(0.6)
    put(x, strike(62 + take, 14, (90, 1500), (0.02, 0.16), 0.5, 0.003), 0)
    for at, gain in ((0.02, 1.0), (0.055, 0.7)):
        put(x, strike(63 + take, 14, (1200, 6000), (0.008, 0.045), 0.12, 0.0004), at, 0.35 * gain)
    return x


def hatch(take: int) -> np.ndarray:
    """A heavy lid of steel falls into place."""
    x = silence(0.9)
    put(x, strike(640 + take, 26, (140, 3200), (0.03, 0.5), 0.9, 0.0014, 0.45), 0.0)
    put(x, strike(650 + take, 18, (700, 5200), (0.02, 0.12), 0.3, 0.0006), 0.07, 0.4)
    return x


def cloth(take: int) -> np.ndarray:
    """A sleeve rubs along a vest."""
    length = 0.26 + 0.05 * take
    x = band(noise(length, 660 + take), 900, 7000)
    flutter = 1 + 0.5 * np.sin(2 * np.pi * (23 + 6 * take) * times(length))
    return norm(x) * np.sin(np.linspace(0, np.pi, len(x))) ** 1.6 * flutter


def gear(take: int) -> np.ndarray:
    """Straps, buckles and magazines of somebody who runs."""
    random = rng(670 + take)
    x = silence(0.3)
    for _ in range(7):
        body = strike(random.integers(1 << 30), 9, (900, 6500), (0.006, 0.04), 0.12, 0.0007)
        put(x, body, random.uniform(0, 0.14), random.uniform(0.1, 1) ** 1.5)
    rub = band(noise(0.22, 680 + take), 400, 3500) * np.sin(np.linspace(0, np.pi, samples(0.22)))
    put(x, norm(rub), 0.0, 0.3)
    return x


def radio_click(is_begin: bool) -> np.ndarray:
    """The key of a radio is pressed, or let go with a tail of noise."""
    x = silence(0.12 if is_begin else 0.22)
    tick = strike(690, 8, (1200, 5200), (0.002, 0.01), 0.03, 0.0002)
    put(x, tick, 0.004, 0.8)
    length = 0.05 if is_begin else 0.17
    hiss = norm(band(noise(length, 691), 420, 3100, 3)) * 0.5
    hiss[-samples(0.006) :] *= np.linspace(1, 0, samples(0.006))
    put(x, attack(hiss, 0.004), 0.012)
    return x
