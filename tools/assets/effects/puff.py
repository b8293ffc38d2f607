"""A puff of smoke as a flipbook that is lit from six sides: a volume is marched frame by frame."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter, map_coordinates

from .shapes import GRID, noise

CELL, DEPTH = 128, 64
# Edge of the cube of noise.
SIZE = 96


def flipbook() -> tuple[np.ndarray, np.ndarray]:
    """From a dense ball to wisps, a frame after the other.

    Of the first: brightness lit from +X (right), +Y (top), +Z (the viewer), and the opacity. Of the
    second: the same from -X, -Y, -Z (behind), and the heat.
    """
    shape = noise(SIZE, 2.15, 1)
    warp = [noise(SIZE, 3.2, seed) for seed in (2, 3, 4)]
    axes = [np.linspace(0.88, -0.88, CELL), np.linspace(-0.88, 0.88, CELL)]
    y, x, z = np.meshgrid(*axes, np.linspace(-0.88, 0.88, DEPTH), indexing="ij")
    place = np.stack([y, x, z]).astype(np.float32)
    frames = [frame(place, shape, warp, i / (GRID * GRID - 1)) for i in range(GRID * GRID)]
    return atlas([one[0] for one in frames]), atlas([one[1] for one in frames])


def frame(
    place: np.ndarray, shape: np.ndarray, warp: list[np.ndarray], age: float
) -> tuple[np.ndarray, np.ndarray]:
    """One frame of the flipbook, at an age from 0 to 1."""
    density, pattern = volume(place, shape, warp, age)
    absorbed = (11.0 * (1 - age) ** 1.5 + 2.0) * 2.0 / DEPTH
    before = np.cumsum(density[:, :, ::-1], axis=2) - density[:, :, ::-1]
    weight = np.exp(-absorbed * before)[:, :, ::-1] * (1 - np.exp(-absorbed * density))
    opacity = weight.sum(axis=2)
    light = [lit(density, weight, absorbed, *side) for side in SIDES]
    shown = opacity * np.clip((1 - age) / 0.25, 0, 1) ** 0.7
    distance = np.sqrt(np.sum(place**2, axis=0))
    hot = np.clip(1.25 * (1 - 1.5 * age) + 0.35 * pattern - 0.5 * distance, 0, 1) * density
    heat = np.clip((weight * hot).sum(axis=2) / np.maximum(opacity, 1e-3), 0, 1)
    return np.stack([*light[:3], shown], axis=-1), np.stack([*light[3:], heat], axis=-1)


# Axis of the volume, and whether the light comes from its far end.
SIDES = ((1, True), (0, False), (2, True), (1, False), (0, True), (2, False))


def volume(
    place: np.ndarray, shape: np.ndarray, warp: list[np.ndarray], age: float
) -> tuple[np.ndarray, np.ndarray]:
    """The density of the puff, and the pattern that tears it."""
    at = (place * 0.30 / (0.75 + 0.35 * age) + 0.5) * SIZE
    swirl = [map_coordinates(field, at + 40 * age, order=1, mode="grid-wrap") for field in warp]
    at += np.stack(swirl) * (2.0 + 3.0 * age)
    at[0] += 14 * age  # The pattern rolls upwards through the puff.
    pattern = map_coordinates(shape, at, order=1, mode="grid-wrap")
    billow = 1.0 - np.abs(pattern)
    distance = np.sqrt(np.sum(place**2, axis=0))
    inside = 0.52 + 0.26 * age**0.6 + (0.20 + 0.08 * age) * billow - 0.10 - distance
    density = np.clip(inside / (0.16 + 0.12 * age), 0, 1)
    density *= np.clip(1.15 - 0.95 * age + 0.55 * age * pattern, 0, 1)
    return density * np.clip((0.87 - distance) / 0.10, 0, 1), pattern


def lit(
    density: np.ndarray, weight: np.ndarray, absorbed: float, axis: int, is_far: bool
) -> np.ndarray:
    """How bright each pixel is with light along an axis."""
    # Forward scattering lets more light through than the view ray loses.
    step = 0.55 * absorbed * (1.0 if axis == 2 else DEPTH / CELL)
    field = np.flip(density, axis) if is_far else density
    through = np.exp(-step * (np.cumsum(field, axis=axis) - 0.5 * field))
    through = np.flip(through, axis) if is_far else through
    through = 0.88 * through + 0.12 * gaussian_filter(through, 5)
    return (weight * through).sum(axis=2) / np.maximum(weight.sum(axis=2), 1e-3)


def atlas(frames: list[np.ndarray]) -> np.ndarray:
    """All frames in rows of GRID."""
    rows = [np.concatenate(frames[row * GRID : (row + 1) * GRID], axis=1) for row in range(GRID)]
    return np.concatenate(rows, axis=0)
