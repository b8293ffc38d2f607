"""Pills and boxes, how to fit them to points, and how far they are apart. No numpy.

Sizes follow the thesis (section 6.2): a pill has a radius and the length of its cylinder
without the two caps, along its local Y axis; a box has full edge lengths. All in metres.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from . import vector3 as v3
from .vector3 import Quat, Vec3


@dataclass
class WeightedPoint:
    """A surface point with the area it stands for."""

    position: Vec3
    area: float


@dataclass
class Pill:
    """A capsule; its long axis is local Y."""

    position: Vec3
    orientation: Quat
    radius: float
    length: float
    """Cylinder part only; the whole pill is length + 2 radius long."""

    def ends(self) -> tuple[Vec3, Vec3]:
        """Return the centres of the two caps, the one towards -Y first."""
        half = v3.rotate(self.orientation, (0.0, self.length / 2, 0.0))
        return v3.subtract(self.position, half), v3.add(self.position, half)


@dataclass
class Box:
    """A box around its centre."""

    position: Vec3
    orientation: Quat
    size: Vec3
    """Full edge lengths along the local axes."""

    def axes(self) -> list[Vec3]:
        """Return the three local axes in model space."""
        units = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        return [v3.rotate(self.orientation, unit) for unit in units]


Shape = Pill | Box


def weighted_percentile(values: Sequence[float], areas: Sequence[float], share: float) -> float:
    """Return the value below which `share` (0 to 1) of the area lies."""
    order = sorted(range(len(values)), key=lambda i: values[i])
    wanted = share * sum(areas)
    reached = 0.0
    for i in order:
        reached += areas[i]
        if reached >= wanted:
            return values[i]
    return values[order[-1]]


def to_local(points: Sequence[WeightedPoint], origin: Vec3, rotation: Quat) -> list[Vec3]:
    """Express points in the frame at origin with the given orientation."""
    inverse = v3.conjugate(rotation)
    return [v3.rotate(inverse, v3.subtract(p.position, origin)) for p in points]


def fit_pill(
    points: Sequence[WeightedPoint],
    origin: Vec3,
    rotation: Quat,
    bone_length: float | None = None,
    radius_share: float = 0.5,
) -> Pill:
    """Fit a pill whose axis is parallel to the frame's Y axis.

    The direction is given (the bone) because a limb must turn about its bone; the sideways
    offset, radius and length come from the points. `radius_share` of the surface lies within
    the radius: the median rather than the mean, so that a knee pad or a pocket does not fatten
    the whole limb. With a `bone_length` (metres) the first cap is centred level with the joint
    and the second with the next joint at the latest, so that a bent knee shows neither a hole
    nor a thigh that sticks out past it.
    """
    areas = [p.area for p in points]
    local = to_local(points, origin, rotation)
    centre = [0.0, 0.0]
    for slot, axis in enumerate((0, 2)):
        values = [p[axis] for p in local]
        low, high = (weighted_percentile(values, areas, s) for s in (0.1, 0.9))
        centre[slot] = (low + high) / 2
    distances = [math.hypot(p[0] - centre[0], p[2] - centre[1]) for p in local]
    radius = weighted_percentile(distances, areas, radius_share)
    along = [p[1] for p in local]
    bottom = weighted_percentile(along, areas, 0.01) + radius
    top = weighted_percentile(along, areas, 0.99) - radius
    if bone_length is not None:
        # Towards the next joint a cap may reach 40 % of the radius past the limb's own surface.
        bottom, top = 0.0, min(bone_length, top + 0.4 * radius)
    if top < bottom:  # shorter than wide: a sphere
        bottom = top = (bottom + top) / 2
    middle = (centre[0], (bottom + top) / 2, centre[1])
    return Pill(v3.add(origin, v3.rotate(rotation, middle)), rotation, radius, top - bottom)


def fit_box(
    points: Sequence[WeightedPoint],
    origin: Vec3,
    rotation: Quat,
    trim: Vec3 = (0.03, 0.03, 0.03),
) -> Box:
    """Fit a box aligned with the frame; `trim` is the share of area cut off at each face."""
    areas = [p.area for p in points]
    local = to_local(points, origin, rotation)
    middle, size = [], []
    for axis in range(3):
        values = [p[axis] for p in local]
        low = weighted_percentile(values, areas, trim[axis])
        high = weighted_percentile(values, areas, 1 - trim[axis])
        middle.append((low + high) / 2)
        size.append(high - low)
    return Box(v3.add(origin, v3.rotate(rotation, tuple(middle))), rotation, tuple(size))


def surface_distance(shape: Shape, point: Vec3) -> float:
    """Return the signed distance (metres) of a point to a shape's surface, inside negative."""
    local = v3.rotate(v3.conjugate(shape.orientation), v3.subtract(point, shape.position))
    if isinstance(shape, Pill):
        along = max(-shape.length / 2, min(shape.length / 2, local[1]))
        return v3.length((local[0], local[1] - along, local[2])) - shape.radius
    beyond = [abs(local[i]) - shape.size[i] / 2 for i in range(3)]
    outside = v3.length(tuple(max(b, 0.0) for b in beyond))
    return outside + min(max(beyond), 0.0)


def separation(a: Shape, b: Shape) -> float:
    """Return the gap between two shapes in metres; negative means that they overlap.

    Between two boxes it is the widest gap along a separating axis: a lower bound of the true
    distance with the right sign.
    """
    if isinstance(a, Box) and isinstance(b, Box):
        return _box_separation(a, b)
    if isinstance(a, Box):
        a, b = b, a
    start, end = a.ends()
    if isinstance(b, Box):
        nearest = _convex_minimum(lambda t: surface_distance(b, _between(start, end, t)))
        return nearest - a.radius
    axis = Pill(b.position, b.orientation, 0.0, b.length)
    nearest = _convex_minimum(lambda t: surface_distance(axis, _between(start, end, t)))
    return nearest - a.radius - b.radius


def _between(start: Vec3, end: Vec3, t: float) -> Vec3:
    return v3.add(start, v3.scale(v3.subtract(end, start), t))


def _convex_minimum(function: Callable[[float], float]) -> float:
    """Minimise a convex function over 0 to 1; the distance to a convex body along a line is."""
    low, high = 0.0, 1.0
    for _ in range(60):
        left, right = low + (high - low) / 3, high - (high - low) / 3
        if function(left) < function(right):
            high = right
        else:
            low = left
    return min(function(0.0), function(1.0), function((low + high) / 2))


def _box_separation(a: Box, b: Box) -> float:
    """Apply the separating-axis test to two boxes."""
    axes_a, axes_b = a.axes(), b.axes()
    candidates = axes_a + axes_b + [v3.cross(u, w) for u in axes_a for w in axes_b]
    offset = v3.subtract(b.position, a.position)
    widest = -math.inf
    for axis in candidates:
        norm = v3.length(axis)
        if norm < 1e-6:  # parallel edges: a face axis says the same
            continue
        reach = sum(
            size * abs(v3.dot(axis, unit)) / 2
            for size, unit in [*zip(a.size, axes_a, strict=True), *zip(b.size, axes_b, strict=True)]
        )
        widest = max(widest, (abs(v3.dot(axis, offset)) - reach) / norm)
    return widest
