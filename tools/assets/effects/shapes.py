"""The small pictures of particles: flares, sparks, flashes, chunks."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter, map_coordinates

# Frames of the puff's flipbook along an edge.
GRID = 8


def noise(size: int, slope: float, seed: int) -> np.ndarray:
    """Periodic noise with an amplitude spectrum of 1/f^slope, mean 0, deviation 1."""
    spectrum = np.fft.rfftn(np.random.default_rng(seed).standard_normal((size,) * 3))
    axis = np.fft.fftfreq(size)
    f = np.sqrt(
        axis[:, None, None] ** 2 + axis[None, :, None] ** 2 + np.fft.rfftfreq(size)[None, None] ** 2
    )
    f[0, 0, 0] = 1
    spectrum *= f**-slope * (f > 1.5 / size)
    field = np.fft.irfftn(spectrum, s=(size,) * 3, axes=(0, 1, 2))
    return (field / field.std()).astype(np.float32)


def disc(size: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """x to the right, y upwards, and the distance from the middle, for every pixel: -1 to 1."""
    y, x = np.meshgrid(np.linspace(1, -1, size), np.linspace(-1, 1, size), indexing="ij")
    return x, y, np.hypot(x, y)


def white(opacity: np.ndarray) -> np.ndarray:
    """White all over: only the opacity has a shape, so that colours stay pure where it is thin."""
    return np.stack([np.ones_like(opacity)] * 3 + [opacity], axis=-1)


def flash(size: int) -> np.ndarray:
    """2 x 2 muzzle flashes: lobes like a star's, torn by noise, bright in the middle."""
    x, y, r = disc(size)
    angle = np.arctan2(y, x)
    tear = noise(64, 1.7, 9)
    cells = []
    for k in range(4):
        random = np.random.default_rng(20 + k)
        lobes = np.zeros_like(r)
        for _ in range(6):
            at, wide = random.uniform(-np.pi, np.pi), random.uniform(0.12, 0.3)
            off = np.angle(np.exp(1j * (angle - at)))
            lobes = np.maximum(lobes, random.uniform(0.45, 0.9) * np.exp(-((off / wide) ** 2)))
        where = np.stack([y * 14 + 30, x * 14 + 30, np.full_like(x, 9.0 * k)])
        torn = 1 + 0.22 * map_coordinates(tear, where, order=1, mode="grid-wrap")
        body = np.clip(1.0 - r / np.maximum((0.30 + 0.65 * lobes) * torn, 0.05), 0, 1)
        glow = np.exp(-((r / 0.28) ** 2)) + 0.25 * np.exp(-((r / 0.6) ** 2))
        cells.append(np.clip((body**0.8 + 0.9 * glow) * np.clip((1 - r) / 0.15, 0, 1), 0, 1))
    return white(np.block([[cells[0], cells[1]], [cells[2], cells[3]]]))


def spark(size: int) -> np.ndarray:
    """A streak along +Y: a hot head, a thin tail."""
    x, y, _ = disc(size)
    along = np.clip(y * 0.5 + 0.5, 0, 1)
    value = np.exp(-((x / (0.45 * (0.16 + 0.5 * along))) ** 2)) * along**1.5
    return white(np.clip(value * np.clip((1 - np.abs(y)) / 0.25, 0, 1) * 1.4, 0, 1))


def flare(size: int) -> np.ndarray:
    """A round glow."""
    _, _, r = disc(size)
    return white(0.7 * np.exp(-((r / 0.22) ** 2)) + 0.3 * np.clip(1 - r, 0, 1) ** 2)


def chunks(size: int) -> np.ndarray:
    """2 x 2 clods and splinters, shaded from above."""
    x, y, _ = disc(size)
    cells = []
    for k in range(4):
        random = np.random.default_rng(50 + k)
        inside = np.ones_like(x)
        for _ in range(7):
            at = random.uniform(0, 2 * np.pi)
            edge = random.uniform(0.45, 0.8) - (x * np.cos(at) + y * np.sin(at))
            inside = np.minimum(inside, edge)
        rough = noise(64, 1.2, 70 + k)[0]
        rough = rough.repeat(size // 64 + 1, 0).repeat(size // 64 + 1, 1)[:size, :size]
        height = gaussian_filter(np.clip(inside, 0, 0.4) + 0.05 * rough, 2) * size / 2
        down, right = np.gradient(height)
        shade = np.clip(0.62 + 0.30 * down - 0.15 * right, 0.15, 1)
        cells.append(np.stack([shade] * 3 + [np.clip(inside * size / 6, 0, 1)], axis=-1))
    return np.concatenate([np.concatenate(cells[:2], 1), np.concatenate(cells[2:], 1)], 0)
