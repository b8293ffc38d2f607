"""Building blocks of the kit: hugging slabs, webbing, rounded boxes, and their skin weights.

Angles are radians about a limb's axis, 0 facing forward (+Z), the figure's left positive.
Lengths are metres, colours linear RGB.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .blender import KDTree
from .quad_mesh import QuadMesh, vertex_normals
from .rig import Rig
from .surface import Surface

Array = NDArray[np.float64]
IntArray = NDArray[np.int64]
WeightRule = Callable[[Array], Array]
"""Gives every point its row of skin weights."""

BLACK = np.array([0.025, 0.025, 0.025])
_LEAST_GAP = 0.0025
"""Between a slab and what it lies on, metres; smoothing would let bumps through."""
_STRAP_TILE = 0.025
"""Length of webbing on one tile, metres."""


def rigid_weights(rig: Rig, **shares: float) -> WeightRule:
    """Hang every point on the same bones, in the given proportion."""
    row = np.zeros(len(rig.names))
    for bone, share in shares.items():
        row[rig.index[bone]] = share
    return lambda points: np.tile(row / row.sum(), (len(points), 1))


def spine_weights(rig: Rig) -> WeightRule:
    """Blend from the hips up to the upper chest by height."""
    bones = ("Hips", "Spine", "Chest", "UpperChest")
    raised = (0.0, 0.04, 0.05, 0.06)
    heights = [rig.heads[bone][1] + extra for bone, extra in zip(bones, raised, strict=True)]

    def weigh(points: Array) -> Array:
        weights = np.zeros((len(points), len(rig.names)))
        y = np.clip(points[:, 1], heights[0], heights[3])
        for i, bone in enumerate(bones):
            weights[:, rig.index[bone]] = np.interp(y, heights, np.eye(4)[i])
        return weights

    return weigh


def nearest_weights(mesh: QuadMesh) -> WeightRule:
    """Take the weights of the four nearest vertices of a mesh, the nearer the more."""
    tree = KDTree(len(mesh.vertices))
    for i, point in enumerate(mesh.vertices):
        tree.insert(tuple(point), i)
    tree.balance()

    def weigh(points: Array) -> Array:
        weights = np.zeros((len(points), mesh.weights.shape[1]))
        for i, point in enumerate(points):
            for _, vertex, distance in tree.find_n(tuple(point), 4):
                weights[i] += mesh.weights[vertex] / (distance + 0.003)
        return weights / weights.sum(1, keepdims=True)

    return weigh


def grid_faces(points: Array, closed: bool = False) -> tuple[Array, IntArray]:
    """Turn a grid of points (rows, columns, 3) into vertices and quads; closed joins the ends."""
    rows, columns = points.shape[:2]
    index = np.arange(rows * columns).reshape(rows, columns)
    if closed:
        index = np.hstack([index, index[:, :1]])
    corners = [index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]]
    return points.reshape(-1, 3), np.stack(corners, -1).reshape(-1, 4)


def strap_uvs(points: Array, along: int, closed: bool) -> Array:
    """Return texture coordinates of each face's corners: u along a strap, v across it."""
    rows, columns = points.shape[:2]
    steps = np.linalg.norm(np.diff(points, axis=along), axis=2).mean(1 - along)
    length = np.r_[0, np.cumsum(steps)] / _STRAP_TILE
    count = columns + 1 if closed else columns
    if along == 0:
        u, v = np.meshgrid(length, np.linspace(0, 1, count), indexing="ij")
    else:
        v, u = np.meshgrid(np.linspace(0, 1, rows), length, indexing="ij")
        if closed:
            u, v = np.hstack([u, u[:, -1:] + 1]), np.hstack([v, v[:, :1]])
    grid = np.stack([u, v], -1)
    corners = [grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]]
    return np.stack(corners, 2).reshape(-1, 4, 2)


def grid_mesh(
    points: Array,
    weights: WeightRule,
    closed: bool = False,
    outward: ArrayLike | None = None,
    along: int | None = None,
) -> QuadMesh:
    """Make a mesh of a grid of points; it is flipped if its faces look against `outward`.

    `outward` holds one direction per vertex (or None to leave the winding as it is). A strap names
    the axis of the grid that runs along it: 0 for the rows' order, 1 for the columns'.
    """
    vertices, faces = grid_faces(points, closed)
    mesh = QuadMesh(vertices, weights(vertices), faces)
    if along is not None:
        mesh.uvs = strap_uvs(points, along, closed)
        mesh.is_mapped = True
    if outward is not None and (mesh.normals() * outward).sum() < 0:
        mesh.flip()
    return mesh


@dataclass(frozen=True)
class Limb:
    """The axis that a slab is wrapped around, and the surface that it hugs."""

    surface: Surface
    start: Array
    end: Array
    forward: Array
    """Direction of angle 0."""
    weights: WeightRule


@dataclass
class Panel:
    """The outer face of a slab, to hang things on. Grids of rows (along) and columns (around)."""

    centres: Array
    directions: Array
    radii: Array
    angles: Array

    def points(self) -> Array:
        """Return the grid of outer points."""
        return self.centres + self.directions * self.radii[..., None]

    def ring(self, y: float, first: float, last: float, count: int) -> Array:
        """Return points on the face at height y, between two angles."""
        points = self.points()
        wanted = np.linspace(first, last, count)
        period = {}
        if np.ptp(self.angles) > 5:
            wanted = np.mod(wanted, 2 * np.pi)
            period = {"period": 2 * np.pi}
        columns = range(points.shape[1])
        level = np.array(
            [[np.interp(y, points[:, j, 1], points[:, j, k]) for k in range(3)] for j in columns]
        )
        angles = np.array([np.interp(y, points[:, j, 1], self.angles[:, j]) for j in columns])
        return np.stack([np.interp(wanted, angles, level[:, k], **period) for k in range(3)], 1)

    def place(self, angle: float, y: float) -> tuple[Array, Array]:
        """Return a point of the face and a frame there: columns right, up, outward."""
        origin = self.ring(y, angle - 0.03, angle + 0.03, 3)[1]
        turned = np.abs(np.angle(np.exp(1j * (self.angles - angle)))) * 0.2
        distance = turned + np.abs(self.points()[..., 1] - y)
        nearest = np.unravel_index(distance.argmin(), distance.shape)
        normal = self.directions[nearest].copy()
        normal[1] *= 0.2  # things hang nearly upright even where the slab leans
        normal /= np.linalg.norm(normal)
        right = np.cross(np.array([0, 1.0, 0]), normal)
        right /= np.linalg.norm(right)
        return origin, np.stack([right, np.cross(normal, right), normal], 1)


@dataclass(frozen=True)
class SlabShape:
    """Dimensions of a slab: where it lies on the limb, and its section."""

    angles: Array
    along: Array
    """0 to 1 from the limb's start to its end."""
    offset: float
    """Gap between the surface and the slab."""
    thickness: float
    bevel: float = 0.006
    smoothing: int = 6
    """Smoothing steps over the surface's bumps."""
    outline: Callable[[Array, Array], Array] | None = None
    """Changes the angles, given angles and positions along: rounds the outline."""
    is_sealed: bool = False
    """Whether its rim is drawn down onto the surface, so that nobody sees under it."""
    widest: Callable[[Array], Array] | None = None
    """Largest distance from the axis, given angles."""


def _smooth_radii(radii: Array, steps: int, closed: bool) -> Array:
    """Blur a grid of radii but never let it sink more than 4 mm a step."""
    for _ in range(steps):
        p = np.pad(radii, ((1, 1), (0, 0)), mode="edge")
        p = np.pad(p, ((0, 0), (1, 1)), mode="wrap" if closed else "edge")
        around = p[:-2, 1:-1] + p[2:, 1:-1] + p[1:-1, :-2] + p[1:-1, 2:]
        radii = np.maximum((around + 4 * p[1:-1, 1:-1]) / 8, radii - 0.004)
    return radii


def _rim(rows: int, columns: int, closed: bool) -> NDArray[np.bool_]:
    """Mark the border of a grid."""
    rim = np.zeros((rows, columns), bool)
    rim[[0, -1]] = True
    if not closed:
        rim[:, [0, -1]] = True
    return rim


def _slab_faces(outer: Array, inner: Array, closed: bool) -> tuple[Array, IntArray]:
    """Close two grids into a slab."""
    outer_vertices, outer_faces = grid_faces(outer, closed)
    inner_vertices, inner_faces = grid_faces(inner, closed)
    count = len(outer_vertices)
    index = np.arange(count).reshape(outer.shape[:2])

    def strip(line: IntArray, wraps: bool) -> IntArray:
        if wraps:
            line = np.append(line, line[0])
        return np.stack([line[:-1], line[:-1] + count, line[1:] + count, line[1:]], 1)

    faces = [outer_faces, inner_faces[:, ::-1] + count]
    faces += [strip(index[0], closed), strip(index[-1], closed)[:, ::-1]]
    if not closed:
        faces += [strip(index[:, 0], False)[:, ::-1], strip(index[:, -1], False)]
    return np.vstack([outer_vertices, inner_vertices]), np.vstack(faces)


def slab(limb: Limb, shape: SlabShape) -> tuple[QuadMesh, Panel]:
    """Wrap a slab around a limb, found by rays from outside; also return its outer face."""
    axis = limb.end - limb.start
    length = np.linalg.norm(axis)
    axis = axis / length
    forward = limb.forward - axis * (limb.forward @ axis)
    forward /= np.linalg.norm(forward)
    sideways = np.cross(axis, forward)
    closed = abs(shape.angles[-1] - shape.angles[0]) > 6.28
    angles, along = np.meshgrid(shape.angles[:-1] if closed else shape.angles, shape.along)
    if shape.outline:
        angles = shape.outline(angles, along)
    directions = np.cos(angles)[..., None] * forward + np.sin(angles)[..., None] * sideways
    centres = limb.start + axis * (along * length)[..., None]

    found = limb.surface.radii(centres.reshape(-1, 3), directions.reshape(-1, 3))
    radii = found.reshape(angles.shape)
    radii = np.where(np.isnan(radii), np.nanmedian(radii), radii)
    if shape.widest:
        radii = np.minimum(radii, shape.widest(angles))
    skin = radii
    radii = _smooth_radii(radii, shape.smoothing, closed) + shape.offset
    radii = np.maximum(radii, skin + _LEAST_GAP)
    rim = _rim(*radii.shape, closed)
    beveled = radii + shape.thickness - np.where(rim, shape.bevel, 0)
    outer = centres + directions * beveled[..., None]
    seat = np.where(rim, np.minimum(radii, skin - 0.004), radii) if shape.is_sealed else radii
    vertices, faces = _slab_faces(outer, centres + directions * seat[..., None], closed)
    face_normals = vertex_normals(*grid_faces(outer, closed))
    mesh = QuadMesh(vertices, limb.weights(vertices), faces)
    if (face_normals * directions.reshape(-1, 3)).sum() < 0:
        mesh.flip()
    return mesh, Panel(centres, directions, radii + shape.thickness, angles)


@dataclass(frozen=True)
class BoxShape:
    """Dimensions of a rounded box."""

    half: tuple[float, float, float]
    """Half edge lengths along the frame's columns."""
    radius: float = 0.008
    """Of the rounded edges."""
    segments: tuple[int, int, int] = (1, 1, 1)
    """Subdivision of the flat part of each edge."""
    bend: float = 0.0
    """Curves the box around the limb: depth drops by bend times x squared (1/m)."""


def rounded_box(
    centre: ArrayLike, frame: ArrayLike, shape: BoxShape, weights: WeightRule
) -> QuadMesh:
    """Make a box with rounded edges; the frame's columns are its axes."""
    half, radius = np.array(shape.half), shape.radius
    frame = np.asarray(frame)
    points, faces = _box_sides(shape)
    core = np.clip(points, -(half - radius), half - radius)
    outward = points - core
    distance = np.linalg.norm(outward, axis=1, keepdims=True)
    points = core + outward / np.maximum(distance, 1e-9) * radius
    # Sides share their border points: weld them, and drop the faces that collapse.
    _, first, inverse = np.unique(
        np.round(points, 6), axis=0, return_index=True, return_inverse=True
    )
    points, faces = points[first], inverse.reshape(-1)[faces]
    faces = faces[[len(set(face)) >= 3 for face in faces.tolist()]]
    if shape.bend:
        points[:, 2] -= shape.bend * points[:, 0] ** 2
    placed = np.asarray(centre) + points @ frame.T
    if np.linalg.det(frame) < 0:
        faces = faces[:, ::-1]
    return QuadMesh(placed, weights(placed), faces)


def _box_sides(shape: BoxShape) -> tuple[Array, IntArray]:
    """Return the six gridded sides of a sharp-edged box, not yet welded."""
    half, radius = np.array(shape.half), shape.radius
    ticks = []
    for h, n in zip(half, shape.segments, strict=True):
        flat = np.linspace(-h + radius, h - radius, n + 1)
        ticks.append(np.unique(np.r_[-h, -h + radius, flat, h - radius, h]))
    vertices, faces, count = [], [], 0
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        for sign in (-1, 1):
            x, y = np.meshgrid(ticks[b], ticks[c], indexing="ij")
            side = np.zeros((*x.shape, 3))
            side[..., axis] = sign * half[axis]
            side[..., b] = x
            side[..., c] = y
            side_vertices, side_faces = grid_faces(side)
            if sign > 0:
                side_faces = side_faces[:, ::-1]
            vertices.append(side_vertices)
            faces.append(side_faces + count)
            count += len(side_vertices)
    return np.vstack(vertices), np.vstack(faces)
