"""A mesh of quads that carries skin weights, colours and texture coordinates.

Triangles are quads whose last corner is repeated. Frame and units as in rig.py (metres).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
IntArray = NDArray[np.int64]


class Layer(IntEnum):
    """Pictures of fine structure, in the order of `details.py`."""

    SMOOTH = 0
    CORDURA = 1
    WEBBING = 2
    LEATHER = 3
    WEAVE = 4
    SKIN = 5
    HAIR = 6
    GLOW = 7


class QuadMesh:
    """Vertices with weights and colours, and quads with their own texture coordinates."""

    def __init__(
        self, vertices: ArrayLike, weights: Array, faces: ArrayLike, uvs: ArrayLike | None = None
    ) -> None:
        self.vertices: Array = np.array(vertices, float)
        self.weights: Array = weights
        """One column per bone of the rig."""
        self.faces: IntArray = np.array(faces, int)
        """Shape (n, 4), counter-clockwise seen from outside."""
        self.uvs: Array = np.zeros((len(self.faces), 4, 2)) if uvs is None else np.array(uvs, float)
        """Shape (n, 4, 2), one per corner, v upwards."""
        self.colours: Array = np.ones((len(self.vertices), 3))
        """Linear RGB."""
        self.occlusion: Array = np.ones(len(self.vertices))
        """Share of open sky seen by each vertex."""
        self.camouflaged = False
        """Whether the part is textured with the cloth's pattern instead of its colours."""
        self.azimuthal = False
        """Whether that is laid on from the pole (a dome has no seam then)."""
        self.layer = Layer.SMOOTH
        """Its fine structure."""
        self.gloss = 0.15
        """0 dull to 1 polished."""
        self.is_mapped = False
        """Whether its texture coordinates are final already."""
        self.is_open = False
        """Whether it is seen lit where the head hides it from others: the wearer's own view."""
        self.is_loose = False
        """Whether it hangs far off the body, as a robe does: no limb's shape is taken from it."""

    def set_colour(self, colour: ArrayLike) -> None:
        """Give every vertex the same linear RGB colour."""
        self.colours[:] = colour

    def flip(self) -> None:
        """Turn every face inside out."""
        self.faces = self.faces[:, ::-1]
        self.uvs = self.uvs[:, ::-1]

    def normals(self) -> Array:
        """Return unit vertex normals, weighted by face area."""
        return vertex_normals(self.vertices, self.faces)

    def subset(self, keep: NDArray[np.bool_]) -> "QuadMesh":
        """Return the part with the chosen faces only."""
        used, inverse = np.unique(self.faces[keep], return_inverse=True)
        faces = inverse.reshape(-1, 4)
        part = QuadMesh(self.vertices[used], self.weights[used], faces, self.uvs[keep])
        part.colours = self.colours[used]
        part.look_like(self)
        return part

    def look_like(self, other: "QuadMesh") -> None:
        """Take over how another mesh's surface looks."""
        self.layer, self.gloss = other.layer, other.gloss
        self.camouflaged, self.azimuthal = other.camouflaged, other.azimuthal
        self.is_mapped, self.is_loose = other.is_mapped, other.is_loose


def vertex_normals(vertices: Array, faces: IntArray) -> Array:
    """Return unit vertex normals, weighted by face area."""
    diagonal = vertices[faces[:, 2]] - vertices[faces[:, 0]]
    other = vertices[faces[:, 3]] - vertices[faces[:, 1]]
    face_normals = np.cross(diagonal, other)
    normals = np.zeros_like(vertices)
    for corner in range(4):
        np.add.at(normals, faces[:, corner], face_normals)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)


def unique_edges(faces: IntArray) -> tuple[IntArray, IntArray, IntArray]:
    """Return the edges as vertex pairs, each corner's edge, and how many faces each edge has."""
    pairs = np.stack([faces, np.roll(faces, -1, 1)], -1).reshape(-1, 2)
    edges, inverse, counts = np.unique(
        np.sort(pairs, 1), axis=0, return_inverse=True, return_counts=True
    )
    return edges, inverse.reshape(-1), counts


def neighbour_mean(vertices: Array, edges: IntArray) -> Array:
    """Return the mean of each vertex's neighbours along the edges."""
    total = np.zeros_like(vertices)
    count = np.zeros(len(vertices))
    for a, b in ((0, 1), (1, 0)):
        np.add.at(total, edges[:, a], vertices[edges[:, b]])
        np.add.at(count, edges[:, a], 1)
    return total / np.maximum(count, 1)[:, None]


def subdivide(mesh: QuadMesh) -> QuadMesh:
    """Do one step of Catmull-Clark subdivision, on weights and colours as on positions."""
    faces, vertex_count = mesh.faces, len(mesh.vertices)
    values = np.hstack([mesh.vertices, mesh.weights, mesh.colours])
    edges, corner_edges, face_counts = unique_edges(faces)
    face_points = values[faces].mean(1)
    middles = values[edges].mean(1)
    edge_faces = np.zeros((len(edges), values.shape[1]))
    np.add.at(edge_faces, corner_edges, np.repeat(face_points, 4, 0))
    edge_points = middles.copy()
    inner = face_counts == 2
    edge_points[inner] = (middles[inner] * 2 + edge_faces[inner]) / 4
    moved = _moved_vertices(values, faces, edges, face_counts, face_points, middles)

    stacked = np.vstack([moved, edge_points, face_points])
    new_faces, new_uvs = _split_quads(mesh, corner_edges.reshape(-1, 4) + vertex_count, len(edges))
    colour_start = 3 + mesh.weights.shape[1]
    result = QuadMesh(stacked[:, :3], stacked[:, 3:colour_start], new_faces, new_uvs)
    result.colours = stacked[:, colour_start:]
    result.look_like(mesh)
    return result


def _moved_vertices(
    values: Array,
    faces: IntArray,
    edges: IntArray,
    face_counts: IntArray,
    face_points: Array,
    middles: Array,
) -> Array:
    """Return the old vertices after a Catmull-Clark step."""
    count = len(values)
    valence = np.zeros(count)
    np.add.at(valence, faces.reshape(-1), 1)
    face_sum = np.zeros_like(values)
    np.add.at(face_sum, faces.reshape(-1), np.repeat(face_points, 4, 0))
    edge_sum, edge_count = np.zeros_like(values), np.zeros(count)
    border_sum, border_count = np.zeros_like(values), np.zeros(count)
    border = face_counts == 1
    for end in (0, 1):
        np.add.at(edge_sum, edges[:, end], middles)
        np.add.at(edge_count, edges[:, end], 1)
        np.add.at(border_sum, edges[border, end], middles[border])
        np.add.at(border_count, edges[border, end], 1)
    moved = values.copy()
    inner = (border_count == 0) & (valence > 2)
    n = valence[inner, None]
    moved[inner] = (
        face_sum[inner] / n
        + 2 * edge_sum[inner] / edge_count[inner, None]
        + (n - 3) * values[inner]
    ) / n
    rim = border_count == 2
    moved[rim] = (values[rim] * 2 + border_sum[rim]) / 4
    return moved


def _split_quads(mesh: QuadMesh, corner_edges: IntArray, edge_count: int) -> tuple[IntArray, Array]:
    """Cut every quad in four; returns faces and texture coordinates."""
    faces, uvs = mesh.faces, mesh.uvs
    centres = len(mesh.vertices) + edge_count + np.arange(len(faces))
    uv_centres = uvs.mean(1)
    new_faces, new_uvs = [], []
    for k in range(4):
        after, before = uvs[:, (k + 1) % 4], uvs[:, k - 1]
        new_faces.append(
            np.stack([faces[:, k], corner_edges[:, k], centres, corner_edges[:, k - 1]], 1)
        )
        new_uvs.append(
            np.stack([uvs[:, k], (uvs[:, k] + after) / 2, uv_centres, (uvs[:, k] + before) / 2], 1)
        )
    return np.vstack(new_faces), np.vstack(new_uvs)


@dataclass
class Joined:
    """Several meshes as one, with what each of them had on its own. One row a vertex."""

    mesh: QuadMesh
    normals: Array
    looks: Array
    """Layer and gloss."""


def join(meshes: Sequence[QuadMesh]) -> Joined:
    """Put meshes into one."""
    starts = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])
    joined = QuadMesh(
        np.vstack([mesh.vertices for mesh in meshes]),
        np.vstack([mesh.weights for mesh in meshes]),
        np.vstack([mesh.faces + start for mesh, start in zip(meshes, starts, strict=False)]),
        np.vstack([mesh.uvs for mesh in meshes]),
    )
    joined.colours = np.vstack([mesh.colours for mesh in meshes])
    joined.occlusion = np.concatenate([mesh.occlusion for mesh in meshes])
    looks = [np.tile([mesh.layer, mesh.gloss], (len(mesh.vertices), 1)) for mesh in meshes]
    return Joined(joined, np.vstack([mesh.normals() for mesh in meshes]), np.vstack(looks))
