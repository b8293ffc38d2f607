"""Straps, facings and laces: bands that lie taut on a surface. Metres."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .curves import smooth_line, tangents, unit
from .kit_parts import WeightRule, grid_mesh
from .quad_mesh import QuadMesh
from .surface import Surface

Array = NDArray[np.float64]

_SEARCH = 0.03
"""A band finds the surface this far (metres) off its line."""


@dataclass(frozen=True)
class BandShape:
    """The section of a band."""

    half_width: float | Sequence[float]
    """One, or one for each point of the line."""
    thickness: float
    lift: float = 0.001
    """Gap between the surface and the band."""
    columns: int = 3
    """Points across its outer face, without the rounded edges."""


def drape_band(
    surface: Surface, line: Array, outward: Array, shape: BandShape, weights: WeightRule
) -> QuadMesh:
    """Lay a band along a line, nowhere below the surface; it bridges hollows as a taut one does."""
    across = unit(np.cross(tangents(line), outward))
    half = np.broadcast_to(np.asarray(shape.half_width, float), (len(line),))
    shares = np.linspace(-1, 1, shape.columns)
    rise = np.array([_rise(surface, line + across * (half * s)[:, None], outward) for s in shares])
    rise = np.maximum(rise + shape.lift, 0)
    rise = np.stack([np.maximum(smooth_line(row, 2), row) for row in rise])
    section = [
        (-1, 0, -0.002),
        *((s * 0.86, i, None) for i, s in enumerate(shares)),
        (1, -1, -0.002),
    ]
    rows = []
    for share, column, depth in section:
        height = rise[column] + (shape.thickness if depth is None else depth)
        rows.append(line + across * (half * share)[:, None] + outward * height[:, None])
    middle = np.repeat(outward, len(section), 0)
    points = np.stack(rows, 1)
    facing = np.where(np.arange(len(middle)) % len(section) == len(section) // 2, 1.0, 0.0)
    outward = middle * facing[:, None]
    return grid_mesh(points, weights, closed=True, outward=outward, along=0)


def _rise(surface: Surface, points: Array, outward: Array) -> Array:
    """Return how far the surface stands out above each point; -inf where there is none."""
    heights = np.full(len(points), -np.inf)
    for i, (point, direction) in enumerate(zip(points, outward, strict=True)):
        hit = surface.hit(point + direction * _SEARCH, -direction, 2 * _SEARCH)
        if hit is not None:
            heights[i] = (hit - point) @ direction
    return heights


def cord(line: Array, radius: float, weights: WeightRule, sides: int = 5) -> QuadMesh:
    """Make a round cord along a line."""
    along = tangents(line)
    helper = np.where(np.abs(along[:, 1:2]) > 0.9, [[0, 0, 1.0]], [[0, 1.0, 0]])
    right = unit(np.cross(along, helper))
    up = np.cross(right, along)
    turns = np.linspace(0, 2 * np.pi, sides + 1)[:-1]
    rings = [line + right * np.cos(t) * radius + up * np.sin(t) * radius for t in turns]
    points = np.stack(rings, 1)
    outward = points.reshape(-1, 3) - line.repeat(sides, 0)
    return grid_mesh(points, weights, closed=True, outward=outward)
