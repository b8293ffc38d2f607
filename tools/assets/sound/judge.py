"""Figures and pictures of sounds, for those who judge them by eye.

    cd tools/assets && python3 -m sound.judge [--picture OUT.png] [NAME...]

Peak, crest, how soon 90 % of the energy is past, spectrum, and the seams of loops.
"""

import argparse
import sys
import wave
from pathlib import Path

import numpy as np
from scipy.signal import spectrogram

from .make import FOLDER

COLUMNS = 6


def load(path: Path) -> tuple[np.ndarray, int]:
    """The samples of a file, 1 is full scale, and how many there are in a second."""
    with wave.open(str(path)) as file:
        return np.frombuffer(file.readframes(file.getnframes()), "<i2") / 32768, file.getframerate()


def decibels(ratio: float) -> float:
    """A ratio of amplitudes in dB."""
    return 20 * np.log10(max(ratio, 1e-9))


def figures(name: str, x: np.ndarray, rate: int) -> str:
    """A line of figures."""
    peak, rms = np.abs(x).max(), np.sqrt(np.mean(x**2))
    energy = np.cumsum(x**2) / np.sum(x**2)
    power, f = np.abs(np.fft.rfft(x)) ** 2, np.fft.rfftfreq(len(x), 1 / rate)
    at = np.argmax(np.abs(x))
    near = x[max(0, at - int(0.005 * rate)) : at + int(0.045 * rate)]
    text = f"{name:22} peak {decibels(peak):5.1f} dB, crest {decibels(peak / rms):4.1f} dB"
    text += f" (50 ms about the peak {decibels(peak / np.sqrt(np.mean(near**2))):4.1f}),"
    text += f" 90 % of energy in {1e3 * np.searchsorted(energy, 0.9) / rate:6.1f} ms,"
    text += f" 85 % below {f[np.searchsorted(np.cumsum(power) / power.sum(), 0.85)]:5.0f} Hz"
    if name.endswith("_loop"):
        steps = np.abs(np.diff(x))
        text += f", strongest {f[np.argmax(power * (f > 20))]:.1f} Hz"
        text += f", seam {abs(x[0] - x[-1]):.4f} (95 % of steps < {np.percentile(steps, 95):.4f},"
        text += f" largest {steps.max():.4f})"
    return text


def draw(sounds: list[tuple[str, np.ndarray, int]], target: Path) -> None:
    """Waves and spectrograms of all in one picture."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    rows = -(-len(sounds) // COLUMNS)
    size = (COLUMNS * 3.2, rows * 3.4)
    figure, axes = plt.subplots(rows * 2, COLUMNS, figsize=size, squeeze=False)
    for axis in axes.flat:
        axis.axis("off")
    for number, (name, x, rate) in enumerate(sounds):
        top = axes[number // COLUMNS * 2][number % COLUMNS]
        low = axes[number // COLUMNS * 2 + 1][number % COLUMNS]
        top.plot(x, lw=0.4)
        top.set_title(name, fontsize=8)
        window = min(1024, len(x) // 4)
        f, t, z = spectrogram(x, rate, nperseg=window, noverlap=window * 3 // 4)
        z = 10 * np.log10(z + 1e-14)
        low.pcolormesh(t, np.maximum(f, 20), z, vmin=z.max() - 80, vmax=z.max(), shading="auto")
        low.set_yscale("log")
        low.set_ylim(30, rate / 2)
        low.axis("on")
    figure.tight_layout(pad=0.3)
    figure.savefig(target, dpi=62)


def main(arguments: list[str]) -> None:
    """Judges the sounds that are named, or all."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folder", type=Path, default=FOLDER)
    parser.add_argument("--picture", type=Path)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args(arguments)
    files = sorted(options.folder.glob("*.wav"))
    found = [(p.stem, *load(p)) for p in files if not options.names or p.stem in options.names]
    for one in found:
        print(figures(*one))
    if options.picture:
        draw(found, options.picture)


if __name__ == "__main__":
    main(sys.argv[1:])
