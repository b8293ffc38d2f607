"""Rays against meshes, through the search tree that ships with bpy."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .blender import BVHTree, Vector

Array = NDArray[np.float64]


class Surface:
    """A mesh that rays can hit. Positions and distances in metres."""

    def __init__(self, vertices: Array, faces: NDArray[np.int64]) -> None:
        # A triangle is a quad with a repeated corner; the tree wants each corner once.
        polygons = [tuple(dict.fromkeys(face)) for face in faces.tolist()]
        self.points = vertices
        self._tree = BVHTree.FromPolygons([tuple(point) for point in vertices], polygons)

    def hit(self, origin: ArrayLike, direction: ArrayLike, reach: float) -> Array | None:
        """Return the first point on a ray of the given reach, or None."""
        location = self._tree.ray_cast(Vector(origin), Vector(direction), reach)[0]
        return None if location is None else np.array(location)

    def nearest_normal(self, point: ArrayLike) -> Array:
        """Return the normal of the face that is nearest to a point."""
        return np.array(self._tree.find_nearest(Vector(point))[1])

    def hit_distance(self, origin: Vector, direction: ArrayLike, reach: float) -> float | None:
        """Return how far away the first point on a ray is, or None."""
        return self._tree.ray_cast(origin, Vector(direction), reach)[3]

    def radii(self, centres: Array, directions: Array, start: float = 0.6) -> Array:
        """Return how far from its centre the outermost surface lies in each direction.

        Each ray runs inwards from `start` metres out; NaN where nothing is hit.
        """
        result = np.full(len(directions), np.nan)
        for i, (centre, direction) in enumerate(zip(centres, directions, strict=True)):
            distance = self.hit_distance(Vector(centre + direction * start), -direction, start)
            if distance is not None:
                result[i] = start - distance
        return result
