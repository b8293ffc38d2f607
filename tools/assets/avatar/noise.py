"""Repeatable value noise in three dimensions."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

_CELLS = 64
"""The noise repeats after this many cells along each axis."""


class NoiseField:
    """Smooth noise between 0 and 1, and the random generator it came from.

    Everything random in the build draws from `generator`, in a fixed order: the result is the
    same to the byte on every run.
    """

    def __init__(self, seed: int) -> None:
        self.generator = np.random.default_rng(seed)
        self._lattice = self.generator.random((_CELLS, _CELLS, _CELLS))

    def value(self, points: ArrayLike) -> Array:
        """Return noise at points given in cells."""
        points = np.asarray(points)
        cell = np.floor(points).astype(int)
        inside = points - cell
        inside = inside * inside * (3 - 2 * inside)
        result = 0
        for a in (0, 1):
            for b in (0, 1):
                for c in (0, 1):
                    weight = (
                        (inside[..., 0] if a else 1 - inside[..., 0])
                        * (inside[..., 1] if b else 1 - inside[..., 1])
                        * (inside[..., 2] if c else 1 - inside[..., 2])
                    )
                    result = (
                        result
                        + weight
                        * self._lattice[
                            (cell[..., 0] + a) % _CELLS,
                            (cell[..., 1] + b) % _CELLS,
                            (cell[..., 2] + c) % _CELLS,
                        ]
                    )
        return result

    def layered(self, points: ArrayLike, octaves: int = 3) -> Array:
        """Return noise summed over octaves, each twice as fine and half as strong."""
        points = np.asarray(points)
        total = sum(self.value(points * 2**k + 17 * k) / 2**k for k in range(octaves))
        return total / sum(1 / 2**k for k in range(octaves))
