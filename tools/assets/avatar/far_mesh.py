"""The figure as it is seen from afar: one surface of few triangles, its colours in the vertices."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .blender import KDTree, bpy
from .quad_mesh import Joined, Layer, QuadMesh, join

Array = NDArray[np.float64]

_TRIANGLES = 4000
"""About so many; the limit is 5000."""
_SMALLEST = 0.0022
"""What has less area is left out, m2."""


@dataclass
class Coloured:
    """A mesh and the linear RGB of each of its vertices, pictures included."""

    mesh: QuadMesh
    colours: Array


def sample(mesh: QuadMesh, picture: Array) -> Array:
    """Return a picture's colour at each vertex (of one of its corners)."""
    size = len(picture)
    uvs = np.zeros((len(mesh.vertices), 2))
    uvs[mesh.faces.reshape(-1)] = mesh.uvs.reshape(-1, 2)
    column = np.clip((uvs[:, 0] % 1.0 * size).astype(int), 0, size - 1)
    row = np.clip(((1 - uvs[:, 1]) % 1.0 * size).astype(int), 0, size - 1)
    return picture[row, column]


def _triangle_counts(meshes: Sequence[Coloured], triangles: int) -> NDArray[np.int64]:
    """Share the triangles out: more for what is large, none for what nobody sees from afar."""
    areas = np.array([_area(each.mesh) for each in meshes])
    wanted = np.where(areas > _SMALLEST, areas**0.75, 0)
    counts = wanted / wanted.sum() * triangles
    return np.where(counts > 0, np.maximum(counts, 12), 0).astype(int)


def _area(mesh: QuadMesh) -> float:
    corners = mesh.vertices[mesh.faces]
    across = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    return float(np.linalg.norm(across, axis=1).sum() / 2)


def _decimate(mesh: QuadMesh, count: int) -> tuple[Array, Array]:
    """Reduce a mesh in Blender to so many triangles; returns vertices and triangles."""
    data = bpy.data.meshes.new("part")
    faces = [tuple(dict.fromkeys(face)) for face in mesh.faces.tolist()]
    data.from_pydata([tuple(p) for p in mesh.vertices], [], [f for f in faces if len(f) > 2])
    thing = bpy.data.objects.new("part", data)
    bpy.context.collection.objects.link(thing)
    thing.modifiers.new("triangles", "TRIANGULATE")
    modifier = thing.modifiers.new("fewer", "DECIMATE")
    modifier.ratio = min(1.0, count / (2 * len(faces)))
    result = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    result.calc_loop_triangles()
    points = np.array([vertex.co[:] for vertex in result.vertices])
    triangles = np.array([triangle.vertices[:] for triangle in result.loop_triangles])
    bpy.data.objects.remove(thing)
    return points, triangles


def build_far_mesh(meshes: Sequence[Coloured], triangles: int = _TRIANGLES) -> Joined:
    """Reduce all meshes to one of about so many triangles.

    Weights, colours and occlusion are those of the nearest vertex.
    """
    bpy.ops.wm.read_factory_settings(use_empty=True)
    parts, normals, looks = [], [], []
    for each, count in zip(meshes, _triangle_counts(meshes, triangles), strict=True):
        if count == 0:
            continue
        points, faces = _decimate(each.mesh, int(count))
        if len(faces) == 0:
            continue
        tree = KDTree(len(each.mesh.vertices))
        for i, point in enumerate(each.mesh.vertices):
            tree.insert(tuple(point), i)
        tree.balance()
        own = _vertex_normals(points, faces)
        there = each.mesh.normals()
        nearest = np.array([_facing(tree, there, p, n) for p, n in zip(points, own, strict=True)])
        part = QuadMesh(points, each.mesh.weights[nearest], faces[:, [0, 1, 2, 2]])
        part.colours, part.occlusion = each.colours[nearest], each.mesh.occlusion[nearest]
        layer = Layer.GLOW if each.mesh.layer == Layer.GLOW else Layer.SMOOTH
        parts.append(part)
        normals.append(own)
        looks.append(np.tile([layer, each.mesh.gloss], (len(points), 1)))
    return Joined(join(parts).mesh, np.vstack(normals), np.vstack(looks))


def _facing(tree: KDTree, normals: Array, point: Array, normal: Array) -> int:
    """Return the nearest vertex that looks the same way: not on the cloth's inside."""
    found = tree.find_n(tuple(point), 12)
    for _, vertex, _distance in found:
        if normals[vertex] @ normal > 0.3:
            return vertex
    return found[0][1]


def _vertex_normals(points: Array, triangles: NDArray[np.int64]) -> Array:
    corners = points[triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = np.zeros_like(points)
    for corner in range(3):
        np.add.at(normals, triangles[:, corner], across)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
