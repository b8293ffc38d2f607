"""Ambient occlusion per vertex: how much of the sky each point sees past its neighbours."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .blender import Vector
from .quad_mesh import QuadMesh
from .surface import Surface

Array = NDArray[np.float64]

_RAYS = 24
_REACH = 0.25
"""Metres; what is farther away does not darken."""
_LIFT = 0.0025
"""Rays start this far (metres) off the surface, so that they do not hit it."""


def _hemisphere(count: int) -> Array:
    """Spread directions evenly over the hemisphere around +Z (golden-angle spiral)."""
    i = np.arange(count) + 0.5
    polar = np.arccos(1 - i / count)
    turn = np.pi * (1 + 5**0.5) * i
    return np.stack([np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)], 1)


def bake_occlusion(parts: Sequence[QuadMesh]) -> None:
    """Set the `occlusion` of every part, all of them shading each other."""
    starts = np.cumsum([0] + [len(part.vertices) for part in parts])
    everything = Surface(
        np.vstack([part.vertices for part in parts]),
        np.vstack([part.faces + start for part, start in zip(parts, starts, strict=False)]),
    )
    directions = _hemisphere(_RAYS)
    for part in parts:
        part.occlusion = _part_occlusion(part, everything, directions)
        if part.is_open:
            part.occlusion = np.maximum(part.occlusion, 0.6)


def _part_occlusion(part: QuadMesh, surface: Surface, directions: Array) -> Array:
    """Return the open share of the hemisphere over each vertex, cosine-weighted."""
    normals = part.normals()
    helper = np.where(np.abs(normals[:, :1]) > 0.9, [[0, 1, 0]], [[1, 0, 0]])
    tangents = np.cross(normals, helper)
    tangents /= np.maximum(np.linalg.norm(tangents, axis=1, keepdims=True), 1e-9)
    bitangents = np.cross(normals, tangents)
    cosines = directions[:, 2]
    result = np.zeros(len(normals))
    for k in range(len(normals)):
        rays = (
            directions[:, :1] * tangents[k]
            + directions[:, 1:2] * bitangents[k]
            + directions[:, 2:] * normals[k]
        )
        origin = Vector(part.vertices[k] + normals[k] * _LIFT)
        blocked = 0.0
        for ray, cosine in zip(rays, cosines, strict=True):
            distance = surface.hit_distance(origin, ray, _REACH)
            if distance is not None:
                blocked += (1 - distance / _REACH) ** 0.5 * cosine
        result[k] = 1 - blocked / cosines.sum()
    return np.clip(result, 0, 1)
