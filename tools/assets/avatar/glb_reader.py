"""Reads the skeleton and the skinned surface of a binary glTF file (.glb), without numpy.

Only what the avatar's own exporter writes is understood: tightly packed accessors, one skin,
no sparse accessors. Frame: metres, Y up, right-handed, the figure faces +Z (glTF and Godot).
"""

import json
import struct
from dataclasses import dataclass, field
from pathlib import Path

from . import vector3 as v3
from .vector3 import Quat, Vec3

LEFT_OUT = ("FarMesh", "DrapeMesh")
"""Meshes that say nothing of the body's shape: the far figure, and what hangs far off the body."""
_GLB_MAGIC = 0x46546C67
_COMPONENT_FORMATS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
_TYPE_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


@dataclass
class Bone:
    """One joint of the skin, in the rest pose and in model space."""

    name: str
    parent: str | None
    head: Vec3
    """Position of the joint, metres."""
    rotation: Quat
    """Rest orientation; the local Y axis points along the bone."""


@dataclass
class SkinVertex:
    """A vertex of the visible surface."""

    position: Vec3
    """Model space, metres."""
    weights: dict[str, float]
    """Share of each bone (by name); sums to one."""
    area: float = 0.0
    """A third of the area of every triangle around the vertex, square metres."""


@dataclass
class SkinnedModel:
    """The rest-pose skeleton and the surface hanging on it."""

    bones: dict[str, Bone] = field(default_factory=dict)
    vertices: list[SkinVertex] = field(default_factory=list)


class _GlbFile:
    """The JSON and the binary chunk of a .glb file."""

    def __init__(self, path: Path) -> None:
        data = path.read_bytes()
        magic, version, _size = struct.unpack_from("<III", data, 0)
        if magic != _GLB_MAGIC or version != 2:
            raise ValueError(f"{path} is not a binary glTF 2.0 file")
        json_size = struct.unpack_from("<I", data, 12)[0]
        self.tree = json.loads(data[20 : 20 + json_size])
        self._binary = data[20 + json_size + 8 :]

    def accessor(self, index: int) -> list[tuple]:
        """Return the elements of an accessor; normalized integers stay integers."""
        accessor = self.tree["accessors"][index]
        view = self.tree["bufferViews"][accessor["bufferView"]]
        width = _TYPE_WIDTHS[accessor["type"]]
        element = struct.Struct("<" + _COMPONENT_FORMATS[accessor["componentType"]] * width)
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stop = start + accessor["count"] * element.size
        return list(element.iter_unpack(self._binary[start:stop]))


def read_skinned_model(path: Path) -> SkinnedModel:
    """Read bones and skinned vertices of the first skin of a .glb file."""
    glb = _GlbFile(path)
    joints = glb.tree["skins"][0]["joints"]
    model = SkinnedModel(bones=_read_bones(glb, joints))
    joint_names = [glb.tree["nodes"][node]["name"] for node in joints]
    for mesh in glb.tree["meshes"]:
        for primitive in mesh["primitives"] if mesh["name"] not in LEFT_OUT else []:
            model.vertices += _read_primitive(glb, primitive, joint_names)
    return model


def read_surfaces(path: Path) -> dict[str, list[SkinVertex]]:
    """Read the skinned vertices of each surface of a .glb file, by "mesh material"."""
    glb = _GlbFile(path)
    joints = glb.tree["skins"][0]["joints"]
    names = [glb.tree["nodes"][node]["name"] for node in joints]
    surfaces: dict[str, list[SkinVertex]] = {}
    for mesh in glb.tree["meshes"]:
        for each in mesh["primitives"]:
            material = glb.tree["materials"][each["material"]]["name"]
            surfaces[f"{mesh['name']} {material}"] = _read_primitive(glb, each, names)
    return surfaces


def _read_bones(glb: _GlbFile, joints: list[int]) -> dict[str, Bone]:
    """Chain the local transforms of the joint nodes into model space."""
    nodes = glb.tree["nodes"]
    parent_of = {c: i for i, node in enumerate(nodes) for c in node.get("children", [])}
    bones: dict[str, Bone] = {}
    for index in joints:  # the exporter lists a parent before its children
        node = nodes[index]
        head = tuple(node.get("translation", (0.0, 0.0, 0.0)))
        rotation = tuple(node.get("rotation", (0.0, 0.0, 0.0, 1.0)))
        parent = bones.get(nodes[parent_of[index]]["name"]) if index in parent_of else None
        if parent is not None:
            head = v3.add(parent.head, v3.rotate(parent.rotation, head))
            rotation = v3.multiply(parent.rotation, rotation)
        name = node["name"]
        bones[name] = Bone(name, parent.name if parent else None, head, v3.normalized(rotation))
    return bones


def _read_primitive(glb: _GlbFile, primitive: dict, joint_names: list[str]) -> list[SkinVertex]:
    """Read one surface and spread the triangles' areas over its vertices."""
    attributes = primitive["attributes"]
    vertices = []
    for position, joints, weights in zip(
        glb.accessor(attributes["POSITION"]),
        glb.accessor(attributes["JOINTS_0"]),
        glb.accessor(attributes["WEIGHTS_0"]),
        strict=True,
    ):
        total = sum(weights)
        shares: dict[str, float] = {}
        for joint, weight in zip(joints, weights, strict=True):
            if weight:
                name = joint_names[joint]
                shares[name] = shares.get(name, 0.0) + weight / total
        vertices.append(SkinVertex(position, shares))
    indices = [index for (index,) in glb.accessor(primitive["indices"])]
    for corner in range(0, len(indices), 3):
        triangle = [vertices[i] for i in indices[corner : corner + 3]]
        edge = v3.subtract(triangle[1].position, triangle[0].position)
        other = v3.subtract(triangle[2].position, triangle[0].position)
        area = v3.length(v3.cross(edge, other)) / 2
        for vertex in triangle:
            vertex.area += area / 3
    return vertices
