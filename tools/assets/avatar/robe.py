"""A long robe over the trousers, from the waist to the ankles. Metres."""

import numpy as np
from numpy.typing import NDArray

from .curves import smooth_line
from .kit import Kit
from .kit_parts import WeightRule, grid_mesh
from .quad_mesh import Layer
from .rig import Rig
from .surface import Surface

Array = NDArray[np.float64]

_ROWS, _COLUMNS = 34, 96
_HEM = 0.075
_FLARE = 0.085
"""How much wider the hem is than what the legs need."""


def add_robe(kit: Kit) -> None:
    """Hang the robe on the waist; it falls in folds that grow towards the hem."""
    rig, noise = kit.rig, kit.figure.noise
    waist = rig.heads["Spine"][1] + 0.075
    surface = Surface(kit.uniform.vertices, kit.uniform.faces[_without_arms(kit)])
    turns = np.linspace(0, 2 * np.pi, _COLUMNS + 1)[:-1]
    directions = np.stack([np.sin(turns), 0 * turns, np.cos(turns)], 1)
    heights = np.r_[
        waist - np.linspace(0, 0.10, 8)[:-1], np.linspace(waist - 0.10, _HEM, _ROWS - 7)
    ]
    radii = np.zeros((_ROWS, _COLUMNS))
    middle = np.array([0, 0, rig.heads["Hips"][2]])
    for i, y in enumerate(heights):
        centres = np.tile(middle + [0, y, 0], (_COLUMNS, 1))
        found = surface.radii(centres, directions, 0.5)
        radii[i] = np.where(np.isnan(found), 0.05, found)
    hull = np.maximum.accumulate(radii, 0)  # cloth falls straight from what is widest above
    hull = np.maximum(hull, radii)
    for _ in range(10):
        hull = (np.roll(hull, 1, 1) + 2 * hull + np.roll(hull, -1, 1)) / 4
        hull = np.maximum(hull, radii + 0.004)
    hull[9:] = smooth_line(hull, 6)[9:]
    hull = np.maximum(hull, radii + 0.006)
    down = np.clip((heights[0] - heights) / (heights[0] - _HEM), 0, 1)[:, None]
    wobble = 2.4 * noise.layered(np.stack([np.sin(turns) * 2, np.cos(turns) * 2, 0 * turns], 1), 2)
    folds = np.sin(9 * turns + 6 * wobble) + 0.6 * np.sin(14 * turns - 7 * wobble + 1.1)
    ring = hull + 0.008 + _FLARE * down**1.5 + 0.017 * down * folds[None]
    rows = []
    for i, y in enumerate(heights):
        rows.append(middle + [0, y, 0] + directions * ring[i][:, None])
    last = rows[-1] - directions * 0.008 + [0, 0.015, 0]
    grid = np.stack([*rows, last])
    outward = np.tile(directions, (len(grid), 1))
    robe = grid_mesh(grid, _weights(rig), closed=True, outward=outward)
    robe.is_loose = True
    kit.add(robe, kit.palette.main, Layer.WEAVE)
    _add_sash(kit, grid[0], directions)


def _add_sash(kit: Kit, top: Array, directions: Array) -> None:
    """Tie a sash over the robe's upper edge."""
    section = ((-0.004, 0.030), (0.008, 0.026), (0.010, 0.0), (0.008, -0.026), (-0.004, -0.030))
    rows = [top + directions * out + [0, up, 0] for out, up in section]
    outward = np.tile(directions, (len(rows), 1))
    mesh = grid_mesh(np.stack(rows), _weights(kit.rig), closed=True, outward=outward)
    mesh.is_loose = True
    kit.add(mesh, kit.palette.stripe * 0.7, Layer.WEAVE)


def _without_arms(kit: Kit) -> NDArray[np.bool_]:
    names = [side + part for side in ("Left", "Right") for part in ("UpperArm", "LowerArm", "Hand")]
    weights = kit.uniform.weights[kit.uniform.faces].mean(1)
    return kit.rig.share(weights, names) < 0.3


def _weights(rig: Rig) -> WeightRule:
    """Let each side follow its leg, the middle both; what is high follows the hips."""
    hips, knee = rig.heads["LeftUpperLeg"][1], rig.heads["LeftLowerLeg"][1]

    def weigh(points: Array) -> Array:
        weights = np.zeros((len(points), len(rig.names)))
        y = points[:, 1]
        legs = np.clip((hips + 0.06 - y) / 0.30, 0, 1) * 0.92
        shin = np.clip((knee + 0.10 - y) / 0.22, 0, 1)
        left = np.clip(points[:, 0] / 0.24 + 0.5, 0, 1)
        left = left * left * (3 - 2 * left)
        weights[:, rig.index["Hips"]] = 1 - legs
        for side, share in (("Left", left), ("Right", 1 - left)):
            weights[:, rig.index[side + "UpperLeg"]] = legs * share * (1 - shin)
            weights[:, rig.index[side + "LowerLeg"]] = legs * share * shin
        return weights

    return weigh
