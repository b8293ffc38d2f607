"""Writes the skinned avatar as a binary glTF 2.0 file. Metres, Y up, faces +Z."""

import json
import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .bake import linear_to_srgb
from .blender import Matrix
from .quad_mesh import Joined, QuadMesh
from .rig import Rig

Array = NDArray[np.float64]

_FLOAT, _UINT32, _UINT16, _UINT8 = 5126, 5125, 5123, 5121
_ARRAY_BUFFER, _INDEX_BUFFER = 34962, 34963
_GENERATOR = "Dismount avatar tools"


@dataclass
class Surface:
    """One material's mesh."""

    material: str
    """Its resource is assets/avatar/materials/NAME.tres."""
    joined: Joined


@dataclass
class Part:
    """A node of the file: what is shown or hidden as a whole."""

    name: str
    surfaces: list[Surface]


class _Buffer:
    """Collects binary data and its descriptions."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.views: list[dict] = []
        self.accessors: list[dict] = []

    def pad(self) -> None:
        """Align to four bytes, as glTF demands."""
        self.data.extend(bytes(-len(self.data) % 4))

    def add_view(self, content: bytes, target: int | None = None) -> int:
        """Append bytes; returns the index of the buffer view."""
        self.pad()
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content)}
        if target:
            view["target"] = target
        self.data.extend(content)
        self.views.append(view)
        return len(self.views) - 1

    def add_array(
        self,
        array: NDArray,
        component: int,
        kind: str,
        target: int | None = _ARRAY_BUFFER,
        bounds: bool = False,
        normalized: bool = False,
    ) -> int:
        """Append an array; returns the index of the accessor."""
        view = self.add_view(np.ascontiguousarray(array).tobytes(), target)
        accessor = {
            "bufferView": view,
            "componentType": component,
            "count": len(array),
            "type": kind,
        }
        if bounds:
            accessor["min"] = array.min(0).tolist()
            accessor["max"] = array.max(0).tolist()
        if normalized:
            accessor["normalized"] = True
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def _strongest_four(weights: Array) -> tuple[NDArray, NDArray]:
    """Return the four strongest bones of each vertex, weights as 16 bit that sum exactly."""
    bones = np.argsort(-weights, 1)[:, :4]
    shares = np.take_along_axis(weights, bones, 1)
    shares /= shares.sum(1, keepdims=True)
    quantized = np.round(shares * 65535).astype(np.int64)
    quantized[:, 0] += 65535 - quantized.sum(1)
    return np.where(quantized > 0, bones, 0), quantized


def _split_seams(mesh: QuadMesh) -> tuple[NDArray, Array, NDArray]:
    """Make one vertex per position and texture coordinate.

    Returns the source vertex and the texture coordinate of each, and the triangles.
    """
    corner_vertices = mesh.faces.reshape(-1)
    corner_uvs = mesh.uvs.reshape(-1, 2)
    keys = np.column_stack([corner_vertices, np.round(corner_uvs * 16384)]).astype(np.int64)
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    quads = inverse.reshape(-1, 4)
    t = np.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    t = t[(t[:, 0] != t[:, 1]) & (t[:, 1] != t[:, 2]) & (t[:, 0] != t[:, 2])]
    return corner_vertices[first], corner_uvs[first], t


def _primitive(surface: Surface, material: int, buffer: _Buffer, is_ours: bool) -> dict:
    """Write one surface."""
    mesh = surface.joined.mesh
    source, uvs, triangles = _split_seams(mesh)
    bones, weights = _strongest_four(mesh.weights[source])
    uvs = np.column_stack([uvs[:, 0], 1 - uvs[:, 1]])  # glTF's v points down
    # sRGB, against the letter of glTF: eight bits of linear light are too few in the dark.
    colours, occlusion = mesh.colours[source], np.clip(mesh.occlusion[source], 0, 1)
    if is_ours:
        colours = linear_to_srgb(np.clip(colours, 0, 1))
    else:
        colours, occlusion = colours * (0.3 + 0.7 * occlusion[:, None]), np.ones(len(source))
    rgba = np.column_stack([np.clip(colours, 0, 1), occlusion])
    add = buffer.add_array
    attributes = {
        "POSITION": add(mesh.vertices[source].astype("f4"), _FLOAT, "VEC3", bounds=True),
        "NORMAL": add(surface.joined.normals[source].astype("f4"), _FLOAT, "VEC3"),
        "TEXCOORD_0": add(uvs.astype("f4"), _FLOAT, "VEC2"),
        "TEXCOORD_1": add(surface.joined.looks[source].astype("f4"), _FLOAT, "VEC2"),
        "COLOR_0": add(np.round(rgba * 255).astype("u1"), _UINT8, "VEC4", normalized=True),
        "JOINTS_0": add(bones.astype("u1"), _UINT8, "VEC4"),
        "WEIGHTS_0": add(weights.astype("u2"), _UINT16, "VEC4", normalized=True),
    }
    kind, width = (_UINT16, "u2") if len(source) < 65535 else (_UINT32, "u4")
    indices = add(triangles.astype(width).reshape(-1), kind, "SCALAR", _INDEX_BUFFER)
    return {"attributes": attributes, "indices": indices, "material": material}


def _material(name: str) -> dict:
    """Describe a dull material, for importers that know nothing of ours."""
    properties = {"metallicFactor": 0, "roughnessFactor": 0.9}
    return {"name": name, "pbrMetallicRoughness": properties, "doubleSided": True}


def _nodes(name: str, rig: Rig, parts: list[Part]) -> list[dict]:
    """Write the bones (node index is bone index), then the meshes, then the root."""
    nodes = []
    for bone in rig.names:
        parent = rig.parents[bone]
        local = np.linalg.inv(rig.rest[parent]) @ rig.rest[bone] if parent else rig.rest[bone]
        turn = Matrix(local[:3, :3].tolist()).to_quaternion()
        node: dict = {
            "name": bone,
            "translation": local[:3, 3].tolist(),
            "rotation": [turn.x, turn.y, turn.z, turn.w],
        }
        children = [rig.index[child] for child in rig.names if rig.parents[child] == bone]
        if children:
            node["children"] = children
        nodes.append(node)
    first = len(nodes)
    nodes += [{"name": part.name, "mesh": i, "skin": 0} for i, part in enumerate(parts)]
    nodes.append({"name": name, "children": [0, *range(first, len(nodes))]})
    return nodes


def export_avatar(path: Path, name: str, rig: Rig, parts: list[Part], is_ours: bool = True) -> None:
    """Write the whole file. Materials are names only: our importer puts ours in their place.

    What is not for our importer has its vertex colours as glTF wants them, darkened by occlusion.
    """
    buffer = _Buffer()
    materials = list(dict.fromkeys(s.material for part in parts for s in part.surfaces))
    meshes = [
        {
            "name": part.name,
            "primitives": [
                _primitive(surface, materials.index(surface.material), buffer, is_ours)
                for surface in part.surfaces
            ],
        }
        for part in parts
    ]
    inverse_binds = np.stack([np.linalg.inv(rig.rest[b]).T.reshape(-1) for b in rig.names])
    skin = {
        "joints": list(range(len(rig.names))),
        "inverseBindMatrices": buffer.add_array(inverse_binds.astype("f4"), _FLOAT, "MAT4", None),
        "skeleton": 0,
        "name": "Skeleton",
    }
    nodes = _nodes(name, rig, parts)
    buffer.pad()
    tree = {
        "asset": {"version": "2.0", "generator": _GENERATOR},
        "scene": 0,
        "scenes": [{"nodes": [len(nodes) - 1]}],
        "nodes": nodes,
        "meshes": meshes,
        "skins": [skin],
        "materials": [_material(material) for material in materials],
        "bufferViews": buffer.views,
        "accessors": buffer.accessors,
        "buffers": [{"byteLength": len(buffer.data)}],
    }
    path.write_bytes(_glb(tree, bytes(buffer.data)))


def _glb(tree: dict, binary: bytes) -> bytes:
    """Frame the JSON and binary chunks."""
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    header = struct.pack("<III", 0x46546C67, 2, 12 + 8 + len(text) + 8 + len(binary))
    text_header = struct.pack("<II", len(text), 0x4E4F534A)
    binary_header = struct.pack("<II", len(binary), 0x4E4942)
    return header + text_header + text + binary_header + binary
