"""What closes the clothes at the neck, seen from above: an undershirt between collar and skin."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .curves import RoundProfile
from .kit import Kit
from .kit_parts import grid_mesh, nearest_weights
from .quad_mesh import Layer, unique_edges

Array = NDArray[np.float64]

_COLUMNS = 40
# From the collar's edge to the middle: share of its radius, what is added to its height (metres).
_PROFILE = (
    (0.99, -0.002),
    (0.94, -0.004),
    (0.86, -0.010),
    (0.72, -0.014),
    (0.4, -0.020),
    (0.0, -0.024),
)


def add_undershirt(kit: Kit, colour: ArrayLike) -> None:
    """Lay a round sheet from the collar's edge inwards; the neck stands in it."""
    uniform, neck = kit.uniform, kit.rig.heads["Neck"]
    edges, _, counts = unique_edges(uniform.faces)
    border = np.unique(edges[counts == 1])
    points = uniform.vertices[border]
    near = np.hypot(points[:, 0], points[:, 2] - neck[2]) < 0.16
    points = points[near & (points[:, 1] > neck[1] - 0.05)]
    middle = np.array([0, 0, (points[:, 2].min() + points[:, 2].max()) / 2])
    out = points - middle
    angles = np.arctan2(out[:, 0], out[:, 2])
    radius = RoundProfile(angles, np.hypot(out[:, 0], out[:, 2]), 4)
    height = RoundProfile(angles, points[:, 1], 3)
    turns = np.linspace(-np.pi, np.pi, _COLUMNS + 1)[:-1]
    directions = np.stack([np.sin(turns), 0 * turns, np.cos(turns)], 1)
    mean = height.at(turns).mean()
    rows = []
    for share, rise in _PROFILE:
        y = height.at(turns) * share + mean * (1 - share) + rise
        rows.append(
            middle + directions * (radius.at(turns) * share)[:, None] + np.outer(y, [0, 1, 0])
        )
    sheet = grid_mesh(np.stack(rows), nearest_weights(uniform), closed=True)
    if sheet.normals()[:, 1].sum() < 0:
        sheet.flip()
    kit.add(sheet, colour, Layer.WEAVE)
    sheet.is_open = True
