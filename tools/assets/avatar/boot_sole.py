"""The sole: welt, heel, arch and lugs, lofted from heel to toe. Metres."""

from collections.abc import Callable
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from .boot_upper import TOE_LENGTH, BootUpper
from .curves import convex_hull, smooth_line
from .kit import Kit
from .kit_parts import BLACK, grid_mesh
from .quad_mesh import Layer, QuadMesh

Array = NDArray[np.float64]
Edge = Callable[[float], float]
"""Gives x for z."""

SOLE_BOTTOM = -0.012
"""The bare sole is at y = 0, the boot's 12 mm lower."""
_WELT_TOP, _WELT_BOTTOM = 0.023, 0.016
_WELT = 0.0055
"""The welt stands out this far from the leather."""
_HEEL_LENGTH, _BREAST = 0.078, 0.008
_ARCH_HEIGHT = 0.014
"""Of the sole between heel and ball over the ground."""
_TOE_SPRING = 0.007
_LUG, _GROOVE, _GROOVE_DEPTH = 0.0105, 0.0065, 0.0028
_ROUND_HEEL = 0.036
"""The heel is round over this length; the rings are closer there."""


def add_sole(kit: Kit, upper: BootUpper) -> QuadMesh:
    """Put a rubber sole with heel and lugs under the boot; it bends at the ball of the foot."""
    left, right, ends = _outline(upper)
    stations, is_lug = _stations(*ends)
    rows = []
    for z, lug in zip(stations, is_lug, strict=True):
        rows.append(_section(z, np.array([left(z), right(z)]), ends, lug))
    points = np.array(rows)
    points = np.concatenate(
        [
            points[:1].mean(1, keepdims=True).repeat(points.shape[1], 1),
            points,
            points[-1:].mean(1, keepdims=True).repeat(points.shape[1], 1),
        ]
    )
    outward = (points - points.mean(1, keepdims=True)).reshape(-1, 3)
    sole = grid_mesh(points, lambda p: _weights(kit, upper.side, p), closed=True, outward=outward)
    kit.add(sole, BLACK, Layer.SMOOTH, 0.1)
    low = np.clip((0.012 - sole.vertices[:, 1]) / 0.006, 0, 1)
    sole.colours = BLACK * (1.8 - 0.9 * low)[:, None]
    return sole


def _weights(kit: Kit, side: str, points: Array) -> Array:
    weights = np.zeros((len(points), len(kit.rig.names)))
    toe_share = np.clip((points[:, 2] - kit.rig.heads[side + "Toes"][2] + 0.02) / 0.04, 0, 1)
    weights[:, kit.rig.index[side + "Toes"]] = toe_share
    weights[:, kit.rig.index[side + "Foot"]] = 1 - toe_share
    return weights


def _outline(upper: BootUpper) -> tuple[Edge, Edge, tuple[float, float]]:
    """Return both edges of the welt as functions of z, and where it begins and ends."""
    hull = convex_hull([tuple(p) for p in upper.low[:, [0, 2]].round(4)])
    back, front = hull[:, 1].min(), hull[:, 1].max()
    ticks = np.linspace(back + 0.0005, front - 0.0005, 80)
    loop = np.vstack([hull, hull[:1]])
    edges = []
    for side in (-1, 1):
        xs = []
        for z in ticks:
            crossing = []
            for a, b in pairwise(loop):
                if (a[1] - z) * (b[1] - z) <= 0 and a[1] != b[1]:
                    crossing.append(a[0] + (b[0] - a[0]) * (z - a[1]) / (b[1] - a[1]))
            xs.append(max(crossing) if side > 0 else min(crossing))
        edges.append(smooth_line(np.array(xs), 12))
    ends = (back - _WELT, front + _WELT)
    sign = 1 if upper.side == "Left" else -1
    heel, toe = ends[0] + _ROUND_HEEL, ends[1] - TOE_LENGTH

    def edge(k: int) -> Edge:
        outside = -1 if k == 0 else 1
        waist = 0.007 if outside * sign < 0 else 0.003

        def x(z: float) -> float:
            held = np.clip(z, heel, toe)
            both = [np.interp(held, ticks, side) for side in edges]
            at, core = both[k] + outside * _WELT, (both[0] + both[1]) / 2
            at -= outside * waist * np.exp(-(((z - back - 0.115) / 0.035) ** 2))
            share = max((heel - z) / _ROUND_HEEL, (z - toe) / TOE_LENGTH, 0)
            return float(core + (at - core) * np.sqrt(max(1 - share**2, 0)))

        return x

    return edge(0), edge(1), ends


def _stations(back: float, front: float) -> tuple[Array, Array]:
    """Choose where the rings are, and which of them are on lugs."""
    heel, toe = (
        length * (1 - np.cos(np.linspace(0.12, 1.45, 7))) for length in (_ROUND_HEEL, TOE_LENGTH)
    )
    inner_back, inner_front = back + heel[-1], front - toe[-1]
    zs, lugs = list(back + heel), [True] * len(heel)
    z = inner_back
    while z + _LUG + _GROOVE < inner_front - 0.002:
        for step, lug in (
            (0.001, False),
            (_GROOVE - 0.001, False),
            (_GROOVE, True),
            (_LUG + _GROOVE, True),
        ):
            zs.append(z + step)
            lugs.append(lug or _arch(z + step, back) > 0.3)
        z += _LUG + _GROOVE
    zs += list((front - toe)[::-1])
    lugs += [True] * len(toe)
    return np.array(zs), np.array(lugs)


def _arch(z: float, back: float) -> float:
    """Return how much of the arch is there: 0 under heel and ball, 1 between them."""
    breast = back + _HEEL_LENGTH
    return float(
        np.clip((z - breast) / _BREAST, 0, 1) * np.clip((breast + 0.062 - z) / 0.035, 0, 1)
    )


def _bottom(z: float, ends: tuple[float, float]) -> float:
    """Return the height of the tread: heel, arch, ball, and up again at the toe."""
    back, front = ends
    arch = _arch(z, back)
    spring = np.clip((z - front + 0.06) / 0.06, 0, 1) ** 2
    heel_edge = np.clip((back + 0.02 - z) / 0.02, 0, 1) ** 2
    return SOLE_BOTTOM + _ARCH_HEIGHT * arch + _TOE_SPRING * spring + 0.004 * heel_edge


def _section(z: float, edges: Array, ends: tuple[float, float], lug: bool) -> Array:
    """Return one ring across the sole, from the left welt under the foot to the right one."""
    bottom = _bottom(z, ends) + (0 if lug else _GROOVE_DEPTH)
    inset = 0.0 if lug else 0.0025
    middle, half = edges.mean(), (edges[1] - edges[0]) / 2
    lift = _TOE_SPRING * 0.7 * np.clip((z - ends[1] + 0.06) / 0.06, 0, 1) ** 2
    # Distance inwards from the welt's edge, height.
    profile = (
        (0.010, _WELT_TOP + 0.004 + lift),
        (0.0035, _WELT_TOP + lift),
        (0.0, _WELT_TOP - 0.002 + lift),
        (0.0, _WELT_BOTTOM + lift),
        (0.0035, _WELT_BOTTOM - 0.0015 + lift),
        (0.0025 + inset, min(bottom + 0.004, 0.012)),
        (0.005 + inset, bottom),
    )
    row = [(middle - max(half - d, 0), y, z) for d, y in profile]
    row.append((middle, bottom + 0.0005, z))
    row += [(middle + max(half - d, 0), y, z) for d, y in reversed(profile)]
    return np.array(row)
