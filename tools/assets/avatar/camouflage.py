"""The camouflage pattern: a solid texture, evaluated in space so that it has no seams."""

import numpy as np
from numpy.typing import NDArray

from .noise import NoiseField

Array = NDArray[np.float64]

_GROUND = np.array([0.19, 0.165, 0.105])
_GROUND_SHADE = np.array([-0.09, -0.04, -0.06])
"""Added where the ground's slow noise is high: tan turns to green."""
_STRETCH = np.array([1, 0.75, 1])
"""Blotches are longer along the body than across."""

# Blotches per metre, noise threshold (higher means rarer), linear RGB; later ones lie on top.
_BLOTCHES = (
    (11, 0.55, (0.090, 0.100, 0.050)),
    (14, 0.60, (0.075, 0.055, 0.034)),
    (8, 0.61, (0.145, 0.135, 0.08)),
    (26, 0.68, (0.035, 0.03, 0.022)),
    (28, 0.72, (0.27, 0.245, 0.175)),
)


def camouflage(points: Array, noise: NoiseField) -> Array:
    """Return the pattern's linear RGB at points (metres)."""
    warp = np.stack([noise.layered(points * 6 + k * 31, 2) for k in (0, 1, 2)], -1)
    place = (points + 0.05 * warp) * _STRETCH
    shade = noise.layered(place * 9 + 5, 3) - 0.5
    colour = _GROUND + shade[..., None] * _GROUND_SHADE
    for scale, threshold, blotch in _BLOTCHES:
        height = noise.layered(place * scale + scale * 3.3, 2)
        cover = np.clip((height - threshold) / 0.015, 0, 1)[..., None]
        colour = colour * (1 - cover) + np.array(blotch) * cover
    return np.clip(colour, 0.01, 1)


def wrinkle_height(points: Array, noise: NoiseField) -> Array:
    """Return the height (metres) of fine wrinkles and of the weave at points (metres)."""
    warp = np.stack([noise.layered(points * 12 + k * 9, 2) for k in (0, 1, 2)], -1)
    place = points + 0.03 * warp
    ridge = 1 - np.abs(2 * noise.layered(place * np.array([26, 17, 26]), 2) - 1)
    return 0.006 * ridge**2 + 0.0005 * noise.value(points * 260)
