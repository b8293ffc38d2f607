"""Writes the skinned avatar as a binary glTF 2.0 file. Metres, Y up, faces +Z."""

import json
import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .bake import linear_to_srgb
from .blender import Matrix
from .quad_mesh import QuadMesh
from .rig import Rig
from .textures import Textures

Array = NDArray[np.float64]

_FLOAT, _UINT32, _UINT16, _UINT8 = 5126, 5125, 5123, 5121
_ARRAY_BUFFER, _INDEX_BUFFER = 34962, 34963
_LINEAR, _LINEAR_MIPMAPS, _REPEAT = 9729, 9987, 10497
_GENERATOR = "Dismount avatar tools"
_DARKEST = 0.3
"""Brightness of a fully occluded vertex."""


@dataclass
class Surface:
    """One material's mesh."""

    name: str
    mesh: QuadMesh
    normals: Array
    shaded: bool = True
    """Whether occlusion darkens the vertex colours."""


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


def _primitive(surface: Surface, material: int, buffer: _Buffer) -> dict:
    """Write one surface."""
    mesh = surface.mesh
    source, uvs, triangles = _split_seams(mesh)
    bones, weights = _strongest_four(mesh.weights[source])
    uvs = np.column_stack([uvs[:, 0], 1 - uvs[:, 1]])  # glTF's v points down
    colours = mesh.colours[source]
    if surface.shaded:
        light = _DARKEST + (1 - _DARKEST) * mesh.occlusion[source]
        colours = colours * light[:, None]
    # sRGB, against the letter of glTF: see avatar_import.gd.
    colours = linear_to_srgb(np.clip(colours, 0, 1))
    rgba = np.column_stack([colours, np.ones(len(colours))])
    add = buffer.add_array
    attributes = {
        "POSITION": add(mesh.vertices[source].astype("f4"), _FLOAT, "VEC3", bounds=True),
        "NORMAL": add(surface.normals[source].astype("f4"), _FLOAT, "VEC3"),
        "TEXCOORD_0": add(uvs.astype("f4"), _FLOAT, "VEC2"),
        "COLOR_0": add(rgba.astype("f4"), _FLOAT, "VEC4"),
        "JOINTS_0": add(bones.astype("u1"), _UINT8, "VEC4"),
        "WEIGHTS_0": add(weights.astype("u2"), _UINT16, "VEC4", normalized=True),
    }
    indices = add(triangles.astype("u4").reshape(-1), _UINT32, "SCALAR", _INDEX_BUFFER)
    return {"attributes": attributes, "indices": indices, "material": material}


class _Images:
    """Adds images and textures to the file."""

    def __init__(self, buffer: _Buffer) -> None:
        self._buffer = buffer
        self.images: list[dict] = []
        self.textures: list[dict] = []

    def add(self, content: bytes, kind: str = "image/jpeg") -> dict:
        """Return the reference to a new texture."""
        self.images.append({"bufferView": self._buffer.add_view(content), "mimeType": kind})
        self.textures.append({"source": len(self.images) - 1, "sampler": 0})
        return {"index": len(self.textures) - 1}


def _material(name: str, roughness: float, texture: dict | None = None) -> dict:
    """Describe a non-metallic material."""
    properties: dict = {"baseColorTexture": texture} if texture else {}
    properties |= {"metallicFactor": 0, "roughnessFactor": roughness}
    return {"name": name, "pbrMetallicRoughness": properties}


def _materials(textures: Textures, images: _Images) -> list[dict]:
    """Describe the materials, in the order of the surfaces."""
    uniform = _material("Uniform", 0.92, images.add(textures.uniform))
    uniform["normalTexture"] = {**images.add(textures.uniform_normals), "scale": 1.0}
    uniform["doubleSided"] = True
    skin = _material("Skin", 0.62, images.add(textures.skin))
    kit = _material("Kit", 0.85, images.add(textures.weave, "image/png"))
    kit["doubleSided"] = True
    camouflaged = _material("KitCamo", 0.92, images.add(textures.camouflage))
    camouflaged["doubleSided"] = True
    lens = {
        "name": "Lens",
        "pbrMetallicRoughness": {
            "baseColorFactor": [0.02, 0.02, 0.018, 0.82],
            "metallicFactor": 0.2,
            "roughnessFactor": 0.06,
        },
        "alphaMode": "BLEND",
        "doubleSided": True,
    }
    return [uniform, skin, _material("Eyes", 0.12), kit, camouflaged, lens]


def _nodes(rig: Rig) -> list[dict]:
    """Write the bones (node index is bone index), then the mesh, then the root."""
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
    nodes.append({"name": "Body", "mesh": 0, "skin": 0})
    nodes.append({"name": "Soldier", "children": [0, len(rig.names)]})
    return nodes


def export_avatar(path: Path, rig: Rig, surfaces: list[Surface], textures: Textures) -> None:
    """Write the whole file; the surfaces are in the order of the materials."""
    buffer = _Buffer()
    images = _Images(buffer)
    primitives = [_primitive(surface, i, buffer) for i, surface in enumerate(surfaces)]
    materials = _materials(textures, images)
    inverse_binds = np.stack([np.linalg.inv(rig.rest[b]).T.reshape(-1) for b in rig.names])
    skin = {
        "joints": list(range(len(rig.names))),
        "inverseBindMatrices": buffer.add_array(inverse_binds.astype("f4"), _FLOAT, "MAT4", None),
        "skeleton": 0,
        "name": "Skeleton",
    }
    nodes = _nodes(rig)
    sampler = {
        "magFilter": _LINEAR,
        "minFilter": _LINEAR_MIPMAPS,
        "wrapS": _REPEAT,
        "wrapT": _REPEAT,
    }
    buffer.pad()
    tree = {
        "asset": {"version": "2.0", "generator": _GENERATOR},
        "scene": 0,
        "scenes": [{"nodes": [len(nodes) - 1]}],
        "nodes": nodes,
        "meshes": [{"name": "Body", "primitives": primitives}],
        "skins": [skin],
        "materials": materials,
        "textures": images.textures,
        "images": images.images,
        "samplers": [sampler],
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
