"""Facings with eyelets and the lace between them. Metres."""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from .bands import cord
from .boot_upper import BootUpper
from .curves import resample, unit
from .kit import Kit
from .kit_parts import BLACK, WeightRule, grid_mesh, nearest_weights
from .quad_mesh import Layer, QuadMesh

Array = NDArray[np.float64]

_FIRST_RING, _LAST_RING = 11.2, 28.4
_EYELETS = 10
"""On each side."""
_HALF_GAP = 0.014
"""From the middle of the tongue to an eyelet."""
_FACING = (0.009, 0.021)
"""Edges of a facing, from the middle of the tongue."""
_LACE_RADIUS = 0.0019


def add_laces(kit: Kit, upper: BootUpper, leather: QuadMesh) -> None:
    """Lace one boot crosswise."""
    weights = nearest_weights(leather)
    for sign in (1, -1):
        kit.add(_facing(upper, sign, weights), kit.palette.boots * 0.8, Layer.LEATHER)
    seats = _eyelet_rings(upper)
    for ring in seats:
        for sign in (1, -1):
            kit.add(_eyelet(upper, ring, sign, weights), BLACK * 1.5, Layer.SMOOTH)
    for sign in (1, -1):
        for first, second in pairwise(seats):
            kit.add(_crossing(upper, first, second, sign, weights), BLACK * 1.7, Layer.WEBBING)
    for ring in (seats[0], seats[-1]):
        kit.add(_crossing(upper, ring, ring, 1, weights), BLACK * 1.7, Layer.WEBBING)


def _angle(upper: BootUpper, ring: float, distance: float) -> float:
    """Return the angle at which a point lies this far (metres) from the tongue's middle."""
    step = 0.1
    here, beside = upper.at(ring, 0)[0], upper.at(ring, step)[0]
    return distance / np.linalg.norm(beside - here) * step


def _eyelet_rings(upper: BootUpper) -> list[float]:
    """Choose rings at equal distances along the tongue."""
    rings = np.linspace(_FIRST_RING, _LAST_RING, 60)
    line = np.array([upper.at(ring, 0)[0] for ring in rings])
    distance = np.r_[0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]
    wanted = np.linspace(0, distance[-1], _EYELETS)
    return [float(ring) for ring in np.interp(wanted, distance, rings)]


def _facing(upper: BootUpper, sign: int, weights: WeightRule) -> QuadMesh:
    """Sew the strip on that carries the eyelets of one side."""
    rows, facing = [], []
    inner, outer = _FACING
    for ring in np.linspace(_FIRST_RING - 0.5, _LAST_RING + 0.6, 22):
        row = []
        for distance, height in (
            (inner, -0.002),
            (inner, 0.0022),
            (inner + 0.002, 0.003),
            (outer - 0.002, 0.0028),
            (outer, 0.0018),
            (outer, -0.002),
        ):
            point, outward = upper.at(ring, sign * _angle(upper, ring, distance))
            row.append(point + outward * height)
            facing.append(outward)
        rows.append(row)
    return grid_mesh(np.array(rows), weights, outward=np.array(facing))


def _eyelet(upper: BootUpper, ring: float, sign: int, weights: WeightRule) -> QuadMesh:
    """Rivet one eyelet: a low cone."""
    point, outward = upper.at(ring, sign * _angle(upper, ring, _HALF_GAP))
    right = unit(np.cross(outward, [0, 0, 1.0] if abs(outward[2]) < 0.8 else [0, 1.0, 0]))
    up = np.cross(outward, right)
    turns = np.linspace(0, 2 * np.pi, 7)[:-1]
    rows = []
    for radius, height in ((0.0038, 0.0025), (0.0030, 0.0042), (0.0004, 0.0042)):
        ringlet = [right * np.cos(t) * radius + up * np.sin(t) * radius for t in turns]
        rows.append(point + outward * height + np.array(ringlet))
    points = np.array(rows)
    return grid_mesh(points, weights, closed=True, outward=np.tile(outward, (18, 1)))


def _crossing(
    upper: BootUpper, first: float, second: float, sign: int, weights: WeightRule
) -> QuadMesh:
    """Pull the lace from an eyelet to one of the other side."""
    line = []
    for share in np.linspace(0, 1, 7):
        ring = first + (second - first) * share
        distance = _HALF_GAP * (1 - 2 * share) * sign
        angle = np.sign(distance) * _angle(upper, ring, abs(distance)) if distance else 0.0
        point, outward = upper.at(ring, angle)
        # One of the two laces crosses over the other.
        over = (1 - abs(1 - 2 * share)) * (0.0028 if sign > 0 else 0.0)
        line.append(point + outward * (0.0036 + over))
    return cord(resample(np.array(line), 6), _LACE_RADIUS, weights, sides=4)
