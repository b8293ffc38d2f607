"""Fits the sixteen limbs of the ragdoll to the avatar's skinned surface.

Run as `python3 -m avatar.limb_shapes MODEL.glb OUT.json` in tools/assets; needs no packages.
The result is the thesis's kind of description (section 6.2): a list of pills and boxes in the
rest pose, in model space (metres, Y up, right-handed, the figure faces +Z, origin between the
feet on the bare foot's sole; the boot's sole lies a little lower).
"""

import json
import math
import sys
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path

from . import vector3 as v3
from .glb_reader import SkinnedModel, read_skinned_model
from .shapes import (
    Box,
    Pill,
    Shape,
    WeightedPoint,
    fit_box,
    fit_pill,
    separation,
    surface_distance,
    weighted_percentile,
)
from .vector3 import Quat, Vec3

SOURCE = (
    "Shapes: fitted to the skinned surface of the avatar of this name by dominant bone weight "
    "(tools/assets/avatar/limb_shapes.py). Masses: P. de Leva, Adjustments to "
    "Zatsiorsky-Seluyanov's segment inertia parameters, Journal of Biomechanics 29 (9), "
    "1223-1230, 1996, table 4, males; upper, middle and lower trunk taken as Chest, Spine and "
    "Hips; the body alone, without equipment."
)
FRAME = (
    "Rest pose in model space: Y up, right-handed, the figure faces +Z, origin between the feet. "
    "A pill's long axis is its local Y; its length is the cylinder part without the caps. "
    "A box's size is full edge lengths along local x, y, z. "
    "Orientations are quaternions x, y, z, w."
)
UNITS = "metres; mass_fraction: share of the whole body's mass"

_GAP = 0.004
"""Least distance kept between limbs that are not neighbours, metres."""

_FINGERS = ("Thumb", "Index", "Middle", "Ring", "Little")
_NEXT_JOINT = {
    "UpperArm": "LowerArm",
    "LowerArm": "Hand",
    "UpperLeg": "LowerLeg",
    "LowerLeg": "Foot",
}


@dataclass(frozen=True)
class LimbKind:
    """What a limb is, whichever side it is on."""

    parent: str | None
    """Limb at the other end of its joint, with the side left out."""
    mass_fraction: float
    is_pill: bool
    paired: bool = True
    """Whether there is a left and a right one."""


LIMB_KINDS: dict[str, LimbKind] = {
    "Hips": LimbKind(None, 0.1117, is_pill=False, paired=False),
    "Spine": LimbKind("Hips", 0.1633, is_pill=False, paired=False),
    "Chest": LimbKind("Spine", 0.1596, is_pill=False, paired=False),
    "Head": LimbKind("Chest", 0.0694, is_pill=True, paired=False),
    "UpperArm": LimbKind("Chest", 0.0271, is_pill=True),
    "LowerArm": LimbKind("UpperArm", 0.0162, is_pill=True),
    "Hand": LimbKind("LowerArm", 0.0061, is_pill=False),
    "UpperLeg": LimbKind("Hips", 0.1416, is_pill=True),
    "LowerLeg": LimbKind("UpperLeg", 0.0433, is_pill=True),
    "Foot": LimbKind("LowerLeg", 0.0137, is_pill=False),
}


def limb_of_bone(bone: str) -> str:
    """Return the limb that a bone belongs to, with its side; the neck is decided by height."""
    if bone in ("Root", "Hips"):
        return "Hips"
    if bone in ("Chest", "UpperChest", "LeftShoulder", "RightShoulder", "Neck"):
        return "Chest"
    side = "Left" if bone.startswith("Left") else "Right" if bone.startswith("Right") else ""
    part = bone.removeprefix(side)
    if part.startswith(_FINGERS):
        return side + "Hand"
    return side + ("Foot" if part == "Toes" else part)


def gather_limb_points(model: SkinnedModel) -> dict[str, list[WeightedPoint]]:
    """Give every surface point to one limb: the one with the most weight on it.

    The right side is mirrored onto the left and both are fitted together, so that the two sides
    of the ragdoll are equal although holster and pockets are not.
    """
    mid_neck = (model.bones["Neck"].head[1] + model.bones["Head"].head[1]) / 2
    points: dict[str, list[WeightedPoint]] = {name: [] for name in LIMB_KINDS}
    for vertex in model.vertices:
        shares: dict[str, float] = {}
        for bone, weight in vertex.weights.items():
            upper_neck = bone == "Neck" and vertex.position[1] > mid_neck
            limb = "Head" if upper_neck else limb_of_bone(bone)
            shares[limb] = shares.get(limb, 0.0) + weight
        limb = max(shares, key=lambda name: (shares[name], name))
        x, y, z = vertex.position
        if limb.startswith("Right"):
            x = -x
        kind = limb.removeprefix("Left").removeprefix("Right")
        points[kind].append(WeightedPoint((x, y, z), vertex.area))
        if not LIMB_KINDS[kind].paired:  # the middle of the body is made symmetric as well
            points[kind].append(WeightedPoint((-x, y, z), vertex.area))
    return points


def fit_limb_shapes(model: SkinnedModel) -> dict[str, Shape]:
    """Fit one shape per kind of limb; paired ones are those of the left side."""
    points = gather_limb_points(model)
    shapes: dict[str, Shape] = {}
    for kind, limb in LIMB_KINDS.items():
        bone = model.bones["Left" + kind if limb.paired else kind]
        if kind == "Head":
            # The helmet is what hits things: the face, its inside and the neck lie within it.
            shapes[kind] = fit_pill(points[kind], bone.head, bone.rotation, None, 0.75)
        elif limb.is_pill:
            end = model.bones["Left" + _NEXT_JOINT[kind]].head
            bone_length = v3.length(v3.subtract(end, bone.head))
            shapes[kind] = fit_pill(points[kind], bone.head, bone.rotation, bone_length)
        elif kind == "Hand":
            shapes[kind] = fit_box(points[kind], bone.head, bone.rotation, (0.06, 0.02, 0.06))
        elif kind == "Foot":
            shapes[kind] = _fit_foot(model, points[kind])
    shapes |= _fit_torso(model, points)
    return {kind: shapes[kind] for kind in LIMB_KINDS}


def _fit_foot(model: SkinnedModel, points: list[WeightedPoint]) -> Box:
    """Fit a level box that points where the foot points and stands on the boot's sole."""
    heel, toes = model.bones["LeftFoot"].head, model.bones["LeftToes"].head
    turn = v3.yaw(math.atan2(toes[0] - heel[0], toes[2] - heel[2]))
    box = fit_box(points, heel, turn, (0.02, 0.05, 0.005))
    sole = min(p.position[1] for p in points)
    top = box.position[1] + box.size[1] / 2
    box.position = (box.position[0], (top + sole) / 2, box.position[2])
    box.size = (box.size[0], top - sole, box.size[2])
    return box


def _fit_torso(model: SkinnedModel, points: dict[str, list[WeightedPoint]]) -> dict[str, Shape]:
    """Fit three upright boxes stacked at the spine's joints."""
    upright: Quat = (0.0, 0.0, 0.0, 1.0)
    waist, ribs = model.bones["Spine"].head[1], model.bones["Chest"].head[1]
    levels = {"Hips": (None, waist), "Spine": (waist, ribs), "Chest": (ribs, None)}
    shapes: dict[str, Shape] = {}
    for kind, (bottom, top) in levels.items():
        # Sideways the box is cut to where the arms or legs do not bulge; front and back more
        # is cut so that a pack or a pouch counts little against the body behind it.
        box = fit_box(points[kind], (0.0, 0.0, 0.0), upright, (0.05, 0.03, 0.10))
        low = bottom if bottom is not None else box.position[1] - box.size[1] / 2
        high = top if top is not None else box.position[1] + box.size[1] / 2
        box.position = (0.0, (low + high) / 2, box.position[2])
        box.size = (box.size[0], high - low, box.size[2])
        shapes[kind] = box
    return shapes


def mirrored(shape: Shape) -> Shape:
    """Return the shape on the other side of the plane x = 0."""
    x, y, z = shape.position
    qx, qy, qz, qw = shape.orientation
    position, turn = (-x, y, z), (qx, -qy, -qz, qw)
    if isinstance(shape, Pill):
        return Pill(position, turn, shape.radius, shape.length)
    return Box(position, turn, shape.size)


def both_sides(shapes: dict[str, Shape]) -> dict[str, Shape]:
    """Name the shapes after their bones and add the right side."""
    limbs: dict[str, Shape] = {k: s for k, s in shapes.items() if not LIMB_KINDS[k].paired}
    for side in ("Left", "Right"):
        for kind, shape in shapes.items():
            if LIMB_KINDS[kind].paired:
                limbs[side + kind] = shape if side == "Left" else mirrored(shape)
    return limbs


def parent_limb(limb: str) -> str | None:
    """Return the name of the limb at the other end of a limb's joint."""
    side = "Left" if limb.startswith("Left") else "Right" if limb.startswith("Right") else ""
    parent = LIMB_KINDS[limb.removeprefix(side)].parent
    if parent is None or not LIMB_KINDS[parent].paired:
        return parent
    return side + parent


def overlapping_pairs(limbs: dict[str, Shape], gap: float = _GAP) -> list[tuple[str, str]]:
    """List pairs that are closer than `gap` metres though no joint connects them."""
    return [
        (a, b)
        for a, b in combinations(limbs, 2)
        if parent_limb(a) != b and parent_limb(b) != a and separation(limbs[a], limbs[b]) < gap
    ]


def shrink_until_apart(shapes: dict[str, Shape]) -> list[str]:
    """Make limbs thinner, in steps of 2 %, until none touches one it is not joined to.

    Returns the kinds of limb that were shrunk.
    """
    shrunk: set[str] = set()
    for _ in range(60):
        pairs = overlapping_pairs(both_sides(shapes))
        if not pairs:
            return sorted(shrunk)
        kinds = {n.removeprefix("Left").removeprefix("Right") for pair in pairs for n in pair}
        for kind in kinds:
            _make_thinner(shapes[kind])
        shrunk |= kinds
    raise RuntimeError(f"limbs still overlap after shrinking: {pairs}")


def _make_thinner(shape: Shape) -> None:
    """Take 2 % off a pill's radius or a box's width; lengths along the bone stay."""
    if isinstance(shape, Pill):
        shape.radius *= 0.98
    else:
        shape.size = (shape.size[0] * 0.98, shape.size[1], shape.size[2])


def describe(model: SkinnedModel, limbs: dict[str, Shape]) -> dict:
    """Build the JSON tree of the limb description."""
    geoms = []
    for name, shape in limbs.items():
        kind = LIMB_KINDS[name.removeprefix("Left").removeprefix("Right")]
        geom = {
            "bone": name,
            "parent_bone": parent_limb(name),
            "type": "pill" if isinstance(shape, Pill) else "box",
            "position": _rounded(shape.position),
            "orientation": _rounded(shape.orientation, 8),
        }
        if isinstance(shape, Pill):
            geom |= {"radius": round(shape.radius, 5), "length": round(shape.length, 5)}
        else:
            geom["size"] = _rounded(shape.size)
        geom["anchor"] = _rounded(model.bones[name].head)
        geom["mass_fraction"] = kind.mass_fraction
        geoms.append(geom)
    return {"frame": FRAME, "units": UNITS, "source": SOURCE, "geoms": geoms}


def _rounded(values: Vec3 | Quat, digits: int = 5) -> list[float]:
    """Round to 0.01 mm by default, without negative zeros."""
    return [round(v, digits) + 0.0 for v in values]


def report(model: SkinnedModel, shapes: dict[str, Shape]) -> str:
    """Say how far the surface lies from each shape, in millimetres."""
    lines = []
    for kind, points in gather_limb_points(model).items():
        distances = [surface_distance(shapes[kind], p.position) for p in points]
        areas = [p.area for p in points]
        mean = sum(abs(d) * a for d, a in zip(distances, areas, strict=True)) / sum(areas)
        low, high = (weighted_percentile(distances, areas, s) * 1e3 for s in (0.05, 0.95))
        lines.append(f"{kind:9s} mean {mean * 1e3:4.0f} mm, 5-95 % {low:4.0f} to {high:4.0f} mm")
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    """Fit and write; the fit's residuals go to standard output."""
    if len(arguments) != 2:
        print("usage: python3 -m avatar.limb_shapes MODEL.glb OUT.json", file=sys.stderr)
        return 2
    model = read_skinned_model(Path(arguments[0]))
    shapes = fit_limb_shapes(model)
    shrunk = shrink_until_apart(shapes)
    print(report(model, shapes))
    print("made thinner to keep unconnected limbs apart:", ", ".join(shrunk) or "none")
    tree = describe(model, both_sides(shapes))
    Path(arguments[1]).write_text(json.dumps(tree, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
