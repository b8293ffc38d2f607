"""The skeleton: MakeHuman's Mixamo rig under the names and axes of Godot's humanoid profile.

Frame: metres, Y up, right-handed, the figure faces +Z, its left is +X.
"""

import json
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .makehuman import BodyMesh, MakeHumanData

Array = NDArray[np.float64]

SIDES = ("Left", "Right")
_PREFIX = "mixamorig:"
_HUMANOID_REST = Path(__file__).with_name("humanoid_rest.json")

_MIDDLE_BONES = {
    "Hips": "Hips",
    "Spine": "Spine",
    "Spine1": "Chest",
    "Spine2": "UpperChest",
    "Neck": "Neck",
    "Head": "Head",
}
_SIDE_BONES = {
    "Shoulder": "Shoulder",
    "Arm": "UpperArm",
    "ForeArm": "LowerArm",
    "Hand": "Hand",
    "UpLeg": "UpperLeg",
    "Leg": "LowerLeg",
    "Foot": "Foot",
    "ToeBase": "Toes",
    "HandThumb1": "ThumbMetacarpal",
    "HandThumb2": "ThumbProximal",
    "HandThumb3": "ThumbDistal",
}
_FINGERS = {"Index": "Index", "Middle": "Middle", "Ring": "Ring", "Pinky": "Little"}
_PHALANGES = ("Proximal", "Intermediate", "Distal")
FINGER_NAMES = ("Thumb", "Index", "Middle", "Ring", "Little")

_REFERENCE_ORIENTED = ("Root", "Hips", "LeftToes", "RightToes")
"""Bones that keep the reference pose's axes instead of being turned onto their own direction."""


def mixamo_to_godot() -> dict[str, str]:
    """Return Godot's bone name for each Mixamo bone (without prefix)."""
    names = dict(_MIDDLE_BONES)
    for side in SIDES:
        names |= {side + old: side + new for old, new in _SIDE_BONES.items()}
        for old, new in _FINGERS.items():
            for i, phalanx in enumerate(_PHALANGES):
                names[f"{side}Hand{old}{i + 1}"] = side + new + phalanx
    return names


@dataclass
class Rig:
    """Bones in the rest pose, a parent before its children, "Root" first."""

    names: list[str] = field(default_factory=lambda: ["Root"])
    heads: dict[str, Array] = field(default_factory=lambda: {"Root": np.zeros(3)})
    """Joint positions, metres."""
    tails: dict[str, Array] = field(default_factory=lambda: {"Root": np.array([0, 0.1, 0])})
    parents: dict[str, str | None] = field(default_factory=lambda: {"Root": None})
    rest: dict[str, Array] = field(default_factory=dict)
    """4x4 model-space rest transforms; local Y points along the bone."""
    index: dict[str, int] = field(default_factory=dict)
    """Column of each bone in a weight matrix."""

    def columns(self, *bones: str) -> list[int]:
        """Return the weight-matrix columns of bones."""
        return [self.index[bone] for bone in bones]

    def share(self, weights: Array, bones: Iterable[str]) -> Array:
        """Return how much of each row of a weight matrix belongs to the bones together."""
        return weights[:, self.columns(*bones)].sum(1)

    def dominant(self, weights: Array) -> NDArray[np.str_]:
        """Return the name of the bone with the most weight in each row."""
        return np.array(self.names)[weights.argmax(1)]

    def along(self, points: Array, bone: str, end: str | None = None) -> Array:
        """Project points onto a bone: 0 at its head, 1 at the head of `end` or at its tail."""
        head = self.heads[bone]
        axis = (self.heads[end] if end else self.tails[bone]) - head
        return (points - head) @ axis / (axis @ axis)

    def along_sides(self, points: Array, bone: str, end: str) -> Array:
        """Like `along`, on the left or the right bone according to the side of each point."""
        left = self.along(points, "Left" + bone, "Left" + end)
        right = self.along(points, "Right" + bone, "Right" + end)
        return np.where(points[:, 0] > 0, left, right)

    def along_shin(self, points: Array) -> Array:
        """Project points onto the lower leg of their side: 0 at the knee, 1 at the ankle."""
        return self.along_sides(points, "LowerLeg", "Foot")

    def along_upper_arm(self, points: Array) -> Array:
        """Project points onto the upper arm of their side: 0 at the shoulder, 1 at the elbow."""
        return self.along_sides(points, "UpperArm", "LowerArm")

    def along_forearm(self, points: Array) -> Array:
        """Project points onto the forearm of their side: 0 at the elbow, 1 at the wrist."""
        return self.along_sides(points, "LowerArm", "Hand")


def build_rig(data: MakeHumanData, body: BodyMesh) -> Rig:
    """Place the bones in the morphed body (metres)."""
    bones = data.read_json("rigs/standard/rig.mixamo.json")["bones"]
    groups = data.read_json("mesh_metadata/basemesh_vertex_groups.json")
    godot_names = mixamo_to_godot()
    rig = Rig()

    def visit(mixamo: str) -> None:
        bone = bones[_PREFIX + mixamo]
        name = godot_names[mixamo]
        rig.names.append(name)
        rig.heads[name] = _locate(bone["head"], body.vertices, groups)
        rig.tails[name] = _locate(bone["tail"], body.vertices, groups)
        parent = bone["parent"]
        rig.parents[name] = godot_names[parent.removeprefix(_PREFIX)] if parent else "Root"
        for child, properties in bones.items():
            if properties["parent"] == _PREFIX + mixamo:
                visit(child.removeprefix(_PREFIX))

    visit("Hips")
    for name in _MIDDLE_BONES.values():  # means of vertices leave it a hair off the middle
        rig.heads[name][0] = rig.tails[name][0] = 0
    rig.index = {name: i for i, name in enumerate(rig.names)}
    rig.rest = _rest_transforms(rig)
    return rig


def _locate(strategy: dict, vertices: Array, groups: dict) -> Array:
    """Find a joint as the rig file says: the middle of a helper cube or of some vertices."""
    if strategy["strategy"] == "CUBE":
        ((first, last),) = groups[strategy["cube_name"]]
        return vertices[first : last + 1].mean(0)
    if strategy["strategy"] == "MEAN":
        return vertices[strategy["vertex_indices"]].mean(0)
    return vertices[strategy["vertex_index"]]


def _rest_transforms(rig: Rig) -> dict[str, Array]:
    """Take Godot's reference axes and turn them by the least angle onto our bones."""
    reference = json.loads(_HUMANOID_REST.read_text())

    def reference_axes(name: str) -> Array:
        bone = reference[name]
        axes = np.stack([bone["x"], bone["y"], bone["z"]], 1)
        return reference_axes(bone["parent"]) @ axes if bone["parent"] else axes

    rest = {}
    for name in rig.names:
        axes = reference_axes(name) if name in reference else np.eye(3)
        if name not in _REFERENCE_ORIENTED:
            child = reference.get(name, {}).get("tail", "")
            end = rig.heads[child] if child in rig.heads else rig.tails[name]
            axes = least_rotation(axes[:, 1], end - rig.heads[name]) @ axes
        transform = np.eye(4)
        transform[:3, :3] = axes
        transform[:3, 3] = rig.heads[name]
        rest[name] = transform
    return rest


def least_rotation(start: Array, end: Array) -> Array:
    """Return the smallest rotation (3x3) that turns one direction onto another."""
    start = start / np.linalg.norm(start)
    end = end / np.linalg.norm(end)
    v = np.cross(start, end)
    skew = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return np.eye(3) + skew + skew @ skew / (1 + start @ end)


def skin_weights(data: MakeHumanData, rig: Rig, vertex_count: int) -> Array:
    """Read the weight of every bone (column) on every vertex (row); rows sum to one."""
    groups = data.read_json("rigs/standard/weights.mixamo.json")["weights"]
    godot_names = mixamo_to_godot()
    weights = np.zeros((vertex_count, len(rig.names)))
    for group, entries in groups.items():
        name = godot_names.get(group.removeprefix(_PREFIX))
        if name is not None:
            for vertex, weight in entries:
                weights[vertex, rig.index[name]] += weight
    weights[weights.sum(1) == 0, rig.index["Hips"]] = 1
    weights /= weights.sum(1, keepdims=True)  # the file's rows sum to anything from 0.2 to 1.5
    return weights
