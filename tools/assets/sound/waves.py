"""What all sounds are made of: noise, envelopes, filters, loops that end where they begin."""

from collections.abc import Callable

import numpy as np
from scipy.signal import butter, sosfilt

# Samples a second.
RATE = 48000


def rng(seed: int) -> np.random.Generator:
    """A source of random numbers that gives the same ones each time."""
    return np.random.default_rng(seed)


def samples(seconds: float) -> int:
    """How many samples a time is."""
    return int(seconds * RATE)


def silence(seconds: float) -> np.ndarray:
    """Nothing, for so long."""
    return np.zeros(samples(seconds))


def times(seconds: float) -> np.ndarray:
    """The time of each sample, s."""
    return np.arange(samples(seconds)) / RATE


def noise(seconds: float, seed: int) -> np.ndarray:
    """White noise."""
    return rng(seed).standard_normal(samples(seconds))


def put(into: np.ndarray, what: np.ndarray, at: float, gain: float = 1.0) -> None:
    """Adds a sound at a time, s. What goes beyond the end is lost."""
    start = int(at * RATE)
    if start < len(into):
        end = min(len(into), start + len(what))
        into[start:end] += gain * what[: end - start]


def put_round(into: np.ndarray, what: np.ndarray, at: float, gain: float = 1.0) -> None:
    """Adds a sound to a loop: what goes beyond the end comes in at the beginning."""
    places = (int(at * RATE) + np.arange(len(what))) % len(into)
    np.add.at(into, places, gain * what)


def band(x: np.ndarray, low: float, high: float, order: int = 2) -> np.ndarray:
    """Keeps what is between two frequencies, Hz; 0 and half the rate are no limits."""
    if low <= 0:
        return sosfilt(butter(order, high, "low", fs=RATE, output="sos"), x)
    if high >= RATE / 2:
        return sosfilt(butter(order, low, "high", fs=RATE, output="sos"), x)
    return sosfilt(butter(order, [low, high], "band", fs=RATE, output="sos"), x)


def decay(seconds: float, time_60db: float) -> np.ndarray:
    """An envelope that loses 60 dB in a time, s."""
    return 10 ** (-3 * times(seconds) / time_60db)


def attack(x: np.ndarray, seconds: float) -> np.ndarray:
    """Lets a sound begin softly."""
    count = samples(seconds)
    x[:count] *= np.linspace(0, 1, count) ** 2
    return x


def norm(x: np.ndarray) -> np.ndarray:
    """Brings the peak to 1."""
    return x / np.abs(x).max()


def saturate(x: np.ndarray, drive: float) -> np.ndarray:
    """What the limits of a microphone do to a loud sound, and what makes it sound loud."""
    return np.tanh(drive * norm(x)) / np.tanh(drive)


def bump(f: np.ndarray, centre: float, octaves: float) -> np.ndarray:
    """A hill of a spectrum about a frequency, Hz."""
    return np.exp(-((np.log2(f / centre) / octaves) ** 2))


def periodic_noise(
    seconds: float, shape: Callable[[np.ndarray], np.ndarray], seed: int
) -> np.ndarray:
    """Noise whose end meets its beginning: drawn as a spectrum, shape(f) is its amplitude."""
    count = round(seconds * RATE)
    f = np.fft.rfftfreq(count, 1 / RATE)
    phases = np.exp(2j * np.pi * rng(seed).random(len(f)))
    x = np.fft.irfft(shape(np.maximum(f, 1.0)) * phases, count)
    return x / x.std()


def circular(x: np.ndarray, response: np.ndarray) -> np.ndarray:
    """Filters a loop so that it stays one."""
    count = len(x)
    folded = np.zeros(count)
    np.add.at(folded, np.arange(len(response)) % count, response)
    return np.fft.irfft(np.fft.rfft(x) * np.fft.rfft(folded), count)


def through_air(x: np.ndarray, metres: float) -> np.ndarray:
    """What air leaves of a sound: 0.4, 0.8, 2.4, 9 dB in 100 m at 1, 2, 4, 8 kHz (ISO 9613-1)."""
    spectrum = np.fft.rfft(x, 2 * len(x))
    f = np.fft.rfftfreq(2 * len(x), 1 / RATE)
    loss_db = metres / 100 * (0.3 + 0.125 * (f / 1000) ** 2.05)
    return np.fft.irfft(spectrum * 10 ** (-np.minimum(loss_db, 90) / 20))[: len(x)]
