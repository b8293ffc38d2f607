"""Lines in space and closed outlines: resampling, smoothing, convex hulls. Metres."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def unit(vectors: Array) -> Array:
    """Scale vectors (the last axis) to length one."""
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)


def tangents(line: Array) -> Array:
    """Return the unit direction of a line at each of its points."""
    return unit(np.gradient(line, axis=0))


def smooth_line(line: Array, steps: int) -> Array:
    """Blur a line (points, or one number a point); its ends stay."""
    line = line.copy()
    for _ in range(steps):
        line[1:-1] = (line[:-2] + 2 * line[1:-1] + line[2:]) / 4
    return line


def resample(line: Array, count: int) -> Array:
    """Return points at equal distances along a line."""
    distance = np.r_[0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]
    wanted = np.linspace(0, distance[-1], count)
    return np.stack([np.interp(wanted, distance, column) for column in line.T], 1)


def convex_hull(points: list[tuple[float, float]]) -> Array:
    """Return the corners of the convex hull in the plane (Andrew's monotone chain)."""

    def half(ordered: list[tuple[float, float]]) -> list[tuple[float, float]]:
        chain: list[tuple[float, float]] = []
        for q in ordered:
            while len(chain) > 1:
                (ax, ay), (bx, by) = chain[-2], chain[-1]
                if (bx - ax) * (q[1] - ay) - (by - ay) * (q[0] - ax) > 0:
                    break
                chain.pop()
            chain.append(q)
        return chain[:-1]

    ordered = sorted(points)
    return np.array(half(ordered) + half(ordered[::-1]))


class RoundProfile:
    """A radius about an axis as a smooth function of the angle: a short Fourier series."""

    def __init__(self, angles: Array, radii: Array, order: int) -> None:
        self._order = order
        terms = self._terms(angles)
        self._factors = np.linalg.lstsq(terms, radii, rcond=None)[0]

    def _terms(self, angles: Array) -> Array:
        waves = [np.ones_like(angles)]
        for k in range(1, self._order + 1):
            waves += [np.cos(k * angles), np.sin(k * angles)]
        return np.stack(waves, -1)

    def at(self, angles: Array) -> Array:
        """Return the radius (metres) at angles (radians)."""
        return self._terms(angles) @ self._factors
