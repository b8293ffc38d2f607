"""What a show figure and a dummy have on: mask, crest, ruff, lines of light, joints. Metres."""

import numpy as np
from numpy.typing import NDArray

from .bands import cord
from .bare_parts import Head
from .curves import resample, smooth_line, unit
from .kit import Kit
from .kit_parts import (
    BoxShape,
    WeightRule,
    grid_mesh,
    nearest_weights,
    rigid_weights,
    rounded_box,
    spine_weights,
)
from .quad_mesh import Layer
from .rig import SIDES
from .surface import Surface

Array = NDArray[np.float64]

_RAYS = 40


def _ring(surface: Surface, centre: Array, axis: Array, lift: float) -> Array | None:
    """Return a closed line around a limb, where a plane cuts it."""
    forward = unit(np.array([0, 0, 1.0]) - axis * axis[2])
    sideways = np.cross(axis, forward)
    turns = np.linspace(0, 2 * np.pi, _RAYS + 1)[:-1]
    directions = np.cos(turns)[:, None] * forward + np.sin(turns)[:, None] * sideways
    radii = surface.radii(np.tile(centre, (_RAYS, 1)), directions, 0.16)
    if np.isnan(radii).mean() > 0.3:
        return None
    radii = np.where(np.isnan(radii), np.nanmedian(radii), radii)
    for _ in range(3):
        radii = (np.roll(radii, 1) + 2 * radii + np.roll(radii, -1)) / 4
    return centre + directions * (radii + lift)[:, None]


def _closed_cord(kit: Kit, line: Array, radius: float, colour: Array, layer: Layer) -> None:
    weights = nearest_weights(kit.uniform)
    kit.add(cord(np.vstack([line, line[:2]]), radius, weights, 6), colour, layer)


def _limb_rings(kit: Kit) -> list[tuple[Array, Array]]:
    """Return middle and axis of a ring at each elbow, knee, wrist, ankle, shoulder, hip."""
    heads = kit.rig.heads
    rings = []
    for side in SIDES:
        for bone, end, shares in (
            ("UpperArm", "LowerArm", (0.16, 0.97)),
            ("LowerArm", "Hand", (0.90,)),
            ("UpperLeg", "LowerLeg", (0.24, 0.96)),
            ("LowerLeg", "Foot", (0.90,)),
        ):
            a, b = heads[side + bone], heads[side + end]
            rings += [(a + (b - a) * share, unit(b - a)) for share in shares]
    return rings


def add_joint_rings(kit: Kit) -> None:
    """Mark the dummy's joints by dark rubber rings, and put it on heavy soles."""
    surface = Surface(kit.uniform.vertices, kit.uniform.faces)
    for centre, axis in _limb_rings(kit):
        line = _ring(surface, centre, axis, 0.001)
        if line is not None:
            _closed_cord(kit, line, 0.0055, kit.palette.main, Layer.SMOOTH)
    for side in SIDES:
        foot, toes = kit.rig.heads[side + "Foot"], kit.rig.tails[side + "Toes"]
        centre = np.array([foot[0], 0.004, (foot[2] - 0.055 + toes[2] + 0.03) / 2])
        half = (0.052, 0.010, (toes[2] + 0.03 - foot[2] + 0.055) / 2)
        weights = rigid_weights(kit.rig, **{side + "Foot": 1})
        sole = rounded_box(centre, np.eye(3), BoxShape(half, radius=0.009), weights)
        kit.add(sole, kit.palette.main, Layer.SMOOTH, 0.1)


def _drawn(surface: Surface, line: Array, lift: float) -> Array | None:
    """Put a line onto a surface from outside, along the normals there."""
    found = []
    for point in line:
        hit = surface.hit(point[0], point[1], 0.6)
        if hit is not None:
            found.append(hit - point[1] * lift)
    return smooth_line(resample(np.array(found), 40), 3) if len(found) > 8 else None


def add_glow_lines(kit: Kit) -> None:
    """Run lines of light down arms, legs, chest and back, and rings around the joints."""
    surface = Surface(kit.uniform.vertices, kit.uniform.faces)
    weights = nearest_weights(kit.uniform)
    glow = kit.palette.stripe
    for centre, axis in _limb_rings(kit):
        line = _ring(surface, centre, axis, 0.0005)
        if line is not None:
            _closed_cord(kit, line, 0.0042, glow, Layer.GLOW)
    heads = kit.rig.heads
    for sign in (1.0, -1.0):
        for facing in (1.0, -1.0):
            x = np.interp(np.linspace(0, 1, 40), [0, 0.5, 1], [0.055, 0.085, 0.035]) * sign
            y = np.linspace(heads["Hips"][1] - 0.02, heads["Neck"][1] - 0.03, 40)
            rays = np.stack(
                [np.stack([x, y, 0 * x + 0.5 * facing], 1), np.tile([0, 0, -facing], (40, 1))], 1
            )
            line = _drawn(surface, rays, 0.0005)
            if line is not None:
                kit.add(cord(line, 0.0040, weights, 6), glow, Layer.GLOW)
    for side, sign in (("Left", 1.0), ("Right", -1.0)):
        for bone, end in (("UpperLeg", "LowerLeg"), ("LowerLeg", "Foot")):
            a, b = heads[side + bone], heads[side + end]
            share = np.linspace(0.30 if bone == "UpperLeg" else 0.06, 0.86, 30)[:, None]
            out = np.tile([sign, 0, 0], (30, 1))
            rays = np.stack([a + (b - a) * share + out * 0.3, -out], 1)
            line = _drawn(surface, rays, 0.0005)
            if line is not None:
                kit.add(cord(line, 0.0036, weights, 6), glow, Layer.GLOW)


def add_mask(kit: Kit, head: Head) -> None:
    """Put a smooth golden mask before the face, with two slits of light."""
    weights = rigid_weights(kit.rig, Head=1)
    skin = Surface(head.skin.vertices, head.skin.faces)
    eye = head.eye_centres[0]
    top, chin = eye[1] + 0.085, eye[1] - 0.125
    heights = np.linspace(chin, top, 25)
    turns = np.radians(np.linspace(-78, 78, 33))
    middle = np.array([0, 0, eye[2] - 0.075])
    rows = []
    for y in heights:
        directions = np.stack([np.sin(turns), 0 * turns, np.cos(turns)], 1)
        radii = skin.radii(np.tile(middle + [0, y, 0], (len(turns), 1)), directions, 0.2)
        radii = np.where(np.isnan(radii), 0.06, radii)
        rows.append(radii)
    radii = np.array(rows)
    keep = radii.copy()
    for _ in range(24):
        p = np.pad(radii, 1, mode="edge")
        radii = (p[:-2, 1:-1] + p[2:, 1:-1] + p[1:-1, :-2] + p[1:-1, 2:] + 4 * radii) / 8
        radii = np.maximum(radii, keep - 0.010)
    radii = np.maximum(radii, keep) * 0.5 + radii * 0.5
    directions = np.stack([np.sin(turns), 0 * turns, np.cos(turns)], 1)
    grid = middle + directions[None] * (radii + 0.010)[..., None]
    bulge = (turns / turns[-1]) ** 2
    share = ((heights - chin) / (top - chin))[:, None]
    # Its outline is an egg's: low at the temples, high at the jaw.
    grid[..., 1] = (chin + 0.055 * bulge) * (1 - share) + (top - 0.050 * bulge) * share
    outer = grid.copy()
    rim = grid - directions[None] * 0.012
    grid = np.concatenate([rim[:1], outer, rim[-1:]])
    outward = np.tile(directions, (len(grid), 1))
    kit.add(grid_mesh(grid, weights, outward=outward), kit.palette.main, Layer.SMOOTH, 0.9)
    for sign in (1.0, -1.0):
        columns = [j for j, turn in enumerate(turns) if 0.20 < sign * turn < 0.74]
        line = []
        for j in columns:
            share = (abs(turns[j]) - 0.20) / 0.54
            y = eye[1] + 0.004 + 0.014 * share
            i = int(np.abs(heights - y).argmin())
            point = outer[i, j].copy()
            point[1] = y
            line.append(point + directions[j] * 0.001)
        kit.add(cord(np.array(line), 0.0048, weights, 8), kit.palette.stripe, Layer.GLOW)


def add_crest(kit: Kit, head: Head) -> None:
    """Raise a fan of feathers from forehead to nape."""
    weights = rigid_weights(kit.rig, Head=1)
    eye = head.eye_centres[0]
    centre = np.array([0, eye[1] + 0.02, eye[2] - 0.085])
    for k, turn in enumerate(np.radians(np.linspace(48, 158, 13))):
        out = np.array([0, np.sin(turn), np.cos(turn)])
        length = 0.15 + 0.07 * np.sin(np.pi * k / 12)
        root, tip = centre + out * 0.085, centre + out * (0.10 + length)
        _add_feather(kit, root, tip, np.array([1.0, 0, 0]), 0.020, k, weights)


def add_ruff(kit: Kit, head: Head) -> None:
    """Lay a collar of stiff petals around the neck and over the shoulders."""
    rig = kit.rig
    weights = spine_weights(rig)
    neck = rig.heads["Neck"] + [0, -0.010, 0]
    for row, (count, length, rise) in enumerate(((17, 0.17, 0.035), (14, 0.12, 0.085))):
        for k in range(count):
            turn = 2 * np.pi * (k + 0.5 * row) / count
            out = np.array([np.sin(turn), 0, np.cos(turn)])
            root = neck + out * 0.055
            reach = length * (1.0 + 0.25 * abs(np.sin(turn)))
            tip = neck + out * (0.055 + reach) + [0, rise - 0.02, 0]
            across = np.array([np.cos(turn), 0, -np.sin(turn)])
            _add_feather(kit, root, tip, across, 0.034, k + row, weights)


def _add_feather(
    kit: Kit,
    root: Array,
    tip: Array,
    across: Array,
    half: float,
    number: int,
    weights: WeightRule,
) -> None:
    """Make one petal: a curved leaf with a quill of light."""
    along = tip - root
    up = unit(np.cross(along, across))
    share = np.linspace(0, 1, 11)
    width = half * np.sin(np.pi * np.clip(share * 0.94 + 0.06, 0, 1)) ** 0.7
    spine = (
        root
        + share[:, None] * along
        + np.outer(0.10 * np.sin(np.pi * share), up) * np.linalg.norm(along)
    )
    section = ((-1.0, -0.25), (-0.5, 0.0), (0.0, 0.12), (0.5, 0.0), (1.0, -0.25))
    face = np.stack(
        [spine + np.outer(width * x, across) + np.outer(width * z, up) for x, z in section]
    )
    back = face[::-1] - up * 0.0025
    grid = np.concatenate([face, back, face[:1]])
    leaf = grid_mesh(grid, weights)
    leaf.is_loose = True
    if (leaf.normals()[: 5 * 11] @ up).sum() < 0:
        leaf.flip()
    colours = (kit.palette.pouch, kit.palette.main)
    kit.add(leaf, colours[number % 2], Layer.HAIR, 0.7)
    quill = cord(spine + up * 0.012 * half / 0.034, 0.0016, weights, 4)
    quill.is_loose = True
    kit.add(quill, kit.palette.stripe, Layer.GLOW)
