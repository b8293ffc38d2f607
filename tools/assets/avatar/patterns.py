"""What is printed on cloth: solid patterns, evaluated in space so that they have no seams.

Each takes points (metres) with what is known of them and returns linear RGB.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .camouflage import camouflage
from .noise import NoiseField

Array = NDArray[np.float64]
Pattern = Callable[["ClothPoints", Mapping[str, Array], NoiseField], Array]

_BLOCK = 0.011
"""Edge of a block of the blocks' pattern, metres."""
_CHECK = 0.045
_RING = 0.028
"""Width of a ring of a target, metres."""


@dataclass(frozen=True)
class ClothPoints:
    """Points of a garment, and where they are on the body."""

    points: Array
    waist: float
    """Height of the waist, metres."""
    chest: Array
    """The middle of the target on the chest."""

    def trousers(self) -> Array:
        """Return 1 below the waist, 0 above."""
        return (self.points[:, 1] < self.waist).astype(float)[:, None]


def _woodland(cloth: ClothPoints, _colours: Mapping[str, Array], noise: NoiseField) -> Array:
    return camouflage(cloth.points, noise)


def _blocks(cloth: ClothPoints, _colours: Mapping[str, Array], noise: NoiseField) -> Array:
    """Small blocks in greys and a cold green."""
    fine = np.floor(cloth.points / _BLOCK) * _BLOCK
    coarse = np.floor(cloth.points / (2 * _BLOCK)) * (2 * _BLOCK)
    first = noise.layered(coarse * 7 + 3, 3) + 0.10 * (noise.value(fine * 90) - 0.5)
    second = noise.layered(coarse * 11 + 29, 2) + 0.16 * (noise.value(fine * 90 + 7) - 0.5)
    third = noise.layered(fine * 15 + 61, 2)
    colour = np.tile([0.150, 0.160, 0.150], (len(fine), 1))
    colour[first > 0.53] = [0.078, 0.092, 0.076]
    colour[second > 0.60] = [0.038, 0.042, 0.043]
    colour[(third > 0.70) & (first < 0.50)] = [0.26, 0.27, 0.25]
    return colour


def _plain(cloth: ClothPoints, colours: Mapping[str, Array], noise: NoiseField) -> Array:
    """Shirt and trousers, each of one colour."""
    share = cloth.trousers()
    colour = colours["jacket"] * (1 - share) + colours["trousers"] * share
    return colour * (0.88 + 0.24 * noise.layered(cloth.points * 7, 2))[:, None]


def _checks(cloth: ClothPoints, colours: Mapping[str, Array], noise: NoiseField) -> Array:
    """A shirt with checks over plain trousers."""
    x, y, z = cloth.points.T
    around = np.where(np.abs(x) > 0.20, np.abs(x) * 1.4 + z, np.arctan2(x, z + 0.02) * 0.16)
    lines = np.zeros(len(x))
    for place, width, depth in ((0.0, 0.16, 0.8), (0.30, 0.05, 0.5)):
        for along in (around, y):
            phase = np.abs((along / _CHECK - place + 0.5) % 1 - 0.5)
            lines += depth * (phase < width / 2)
    shirt = colours["jacket"] * (1 - np.clip(lines, 0, 1))[:, None]
    shirt = shirt + colours["line"] * np.clip(lines, 0, 1)[:, None]
    share = cloth.trousers()
    colour = shirt * (1 - share) + colours["trousers"] * share
    return colour * (0.9 + 0.2 * noise.layered(cloth.points * 7, 2))[:, None]


def _target(cloth: ClothPoints, colours: Mapping[str, Array], noise: NoiseField) -> Array:
    """A scuffed dummy with rings before the chest and on the back, and a line down the middle."""
    points = cloth.points
    scuffs = np.clip((noise.layered(points * np.array([40, 8, 40]), 2) - 0.62) * 9, 0, 1)
    grain = 0.94 + 0.12 * noise.layered(points * np.array([60, 6, 60]), 2)
    colour = colours["base"] * grain[:, None]
    radius = np.hypot(points[:, 0], points[:, 1] - cloth.chest[1])
    number = np.floor(radius / _RING).astype(int)
    colour[number == 0] = colours["ring"]
    edge = np.abs(radius / _RING - np.round(radius / _RING)) * _RING
    is_line = (edge < 0.0032) & (radius < 5.2 * _RING) & (radius > 0.5 * _RING)
    colour[is_line] = colours["mark"]
    middle = (np.abs(points[:, 0]) < 0.0025) & (radius > 5.2 * _RING)
    colour[middle] = colours["mark"] * 2.2
    return colour * (1 - 0.35 * scuffs)[:, None] + 0.16 * scuffs[:, None]


def _show(cloth: ClothPoints, colours: Mapping[str, Array], noise: NoiseField) -> Array:
    """Dark, with flames of a warm and a cold colour that run up and down the body."""
    points = cloth.points
    swirl = noise.layered(points * np.array([5, 2.2, 5]) + 11, 3)
    flame = 0.5 + 0.5 * np.sin(points[:, 1] * 13 + swirl * 14)
    cover = np.clip((flame - 0.62) / 0.10, 0, 1)[:, None]
    height = np.clip((points[:, 1] - 0.25) / 1.2, 0, 1)[:, None]
    tint = colours["cold"] * (1 - height) + colours["warm"] * height
    glitter = np.clip((noise.value(points * 330) - 0.80) * 5, 0, 1)[:, None]
    return colours["base"] * (1 - cover) + tint * cover + 0.25 * glitter * (1 - cover)


PATTERNS: dict[str, Pattern] = {
    "woodland": _woodland,
    "blocks": _blocks,
    "plain": _plain,
    "checks": _checks,
    "target": _target,
    "show": _show,
}
