"""Helmet, ear protection and glasses. Metres."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .bands import cord
from .curves import unit
from .kit import Kit
from .kit_parts import (
    BLACK,
    BoxShape,
    WeightRule,
    grid_mesh,
    rigid_weights,
    rounded_box,
)
from .quad_mesh import Layer, QuadMesh, subdivide

Array = NDArray[np.float64]

# Height of the helmet's rim over its centre by angle from the front (degrees).
_RIM_ANGLES = [0, 35, 60, 80, 110, 135, 180]
HIGH_RIM = (0.040, 0.040, 0.028, 0.015, 0.005, -0.045, -0.055)
FULL_RIM = (0.034, 0.032, 0.012, -0.026, -0.046, -0.062, -0.066)
CAP_RIM = (0.046, 0.044, 0.036, 0.022, 0.004, -0.014, -0.018)
_HELMET_COLUMNS = 48
_FULLNESS = 0.78
"""Exponent on the shell's width over its height: 1 is an ellipsoid, less is fuller."""

_LENS_RADIUS_X, _LENS_RADIUS_Z = 0.074, 0.062


@dataclass(frozen=True)
class HelmetFit:
    """The ellipsoid that the helmet follows."""

    centre: Array
    radii: Array
    rim: tuple[float, ...] = HIGH_RIM
    """Heights over the centre at `_RIM_ANGLES`."""
    fullness: float = _FULLNESS


def fit_helmet(
    head: QuadMesh,
    eye_centre: Array,
    rim: tuple[float, ...] = HIGH_RIM,
    room: float = 0.020,
    fullness: float = _FULLNESS,
) -> HelmetFit:
    """Fit an ellipsoid around the scalp, with room for padding."""
    scalp = head.vertices[head.vertices[:, 1] > eye_centre[1] + 0.02]
    x, y, z = scalp.T
    centre = np.array([0, eye_centre[1] + 0.005, (z.min() + z.max()) / 2])
    return HelmetFit(
        centre,
        np.array([np.abs(x).max(), y.max() - centre[1] + 0.004, np.ptp(z) / 2 + 0.002]) + room,
        rim,
        fullness,
    )


def shell_point(fit: HelmetFit, azimuth: float, share: float, inset: float = 0.0) -> Array:
    """Return a point of the shell: azimuth 0 is in front (radians), share 0 the rim, 1 the top."""
    return _shell(fit, np.array([azimuth]), share, inset)[0]


def _shell(fit: HelmetFit, azimuth: Array, share: float, inset: float) -> Array:
    """Return points of the shell; its sides are fuller than an ellipsoid's."""
    from_front = np.degrees(np.arccos(np.cos(azimuth)))
    rim = np.interp(from_front, _RIM_ANGLES, fit.rim)
    lowest = np.arcsin(np.clip(rim / fit.radii[1], -1, 1))
    elevation = lowest + (np.pi / 2 - lowest) * share
    rx, ry, rz = fit.radii - inset
    width = np.clip(np.cos(elevation), 0, 1) ** fit.fullness
    shape = [np.sin(azimuth) * width * rx, np.sin(elevation) * ry, np.cos(azimuth) * width * rz]
    return np.stack(shape, 1) + fit.centre


def _dome_row(fit: HelmetFit, share: float, inset: float = 0.0) -> Array:
    """Return one ring of the shell: share 0 at the rim, 1 at the top."""
    azimuth = np.linspace(0, 2 * np.pi, _HELMET_COLUMNS + 1)[:-1]
    return _shell(fit, azimuth, share, inset)


def add_helmet(kit: Kit, fit: HelmetFit) -> None:
    """Add the shell with its cloth cover, the shroud in front and the rails."""
    add_shell(kit, fit)
    weights = rigid_weights(kit.rig, Head=1)
    _add_shroud(kit, fit, weights)
    for sign in (1, -1):
        _add_rail(kit, fit, sign, weights)


def add_shell(kit: Kit, fit: HelmetFit, has_cover: bool = True) -> QuadMesh:
    """Add a helmet's shell with its rim; with a cover of the uniform's cloth, or painted."""
    weights = rigid_weights(kit.rig, Head=1)
    outside = [_dome_row(fit, share) for share in np.linspace(0, 1, 15)]
    inside = [_dome_row(fit, share, 0.010) for share in (0.3, 0.06, 0.0)]
    lip = outside[0] + (outside[0] - fit.centre) * [0.012, 0, 0.012]
    shell = grid_mesh(np.stack([*inside, lip, *outside]), weights, closed=True)
    upper = slice(len(shell.vertices) // 2, None)  # the inside would cancel the outside
    if (shell.normals()[upper] * (shell.vertices - fit.centre)[upper]).sum() < 0:
        shell.flip()
    cover = subdivide(shell)
    kit.add(cover, kit.palette.main, Layer.WEAVE if has_cover else Layer.SMOOTH)
    cover.camouflaged = cover.azimuthal = has_cover

    rim = (lip + inside[-1]) / 2
    kit.add(cord(np.vstack([rim, rim[:2]]), 0.0075, weights, sides=6), kit.palette.main * 0.5)
    return cover


def _add_shroud(kit: Kit, fit: HelmetFit, weights: WeightRule) -> None:
    """Bolt the mount for night-vision goggles flat onto the front."""
    at, above = (shell_point(fit, 0, share) for share in (0.30, 0.34))
    up = unit(above - at)
    right = np.array([1.0, 0, 0])
    frame = np.stack([right, up, np.cross(right, up)], 1)
    plate = BoxShape((0.024, 0.026, 0.005), radius=0.004, segments=(2, 2, 1), bend=2.0)
    kit.add(rounded_box(at + frame[:, 2] * 0.002, frame, plate, weights), BLACK * 1.3, Layer.SMOOTH)
    socket = BoxShape((0.012, 0.016, 0.004), radius=0.003)
    kit.add(rounded_box(at + frame[:, 2] * 0.007, frame, socket, weights), BLACK, Layer.SMOOTH)


def _add_rail(kit: Kit, fit: HelmetFit, sign: int, weights: WeightRule) -> None:
    """Bend an accessory rail along one side of the helmet."""
    angles = np.radians(np.linspace(68, 122, 13)) * sign
    rows = []
    for y, swell in ((0.024, 1.0), (0.026, 1.075), (0.042, 1.075), (0.044, 1.0)):
        waist = math.sqrt(1 - (y / fit.radii[1]) ** 2) ** fit.fullness
        x = np.sin(angles) * fit.radii[0] * waist * swell
        z = np.cos(angles) * fit.radii[2] * waist * swell
        rows.append(np.stack([x, y + 0 * angles, z], 1) + fit.centre)
    rail = np.stack(rows)
    kit.add(grid_mesh(rail, weights, outward=rail.reshape(-1, 3) - fit.centre), BLACK, Layer.SMOOTH)


def add_ear_protection(kit: Kit, fit: HelmetFit) -> None:
    """Hang two ear cups from the rails: cushion, shell and arm."""
    weights = rigid_weights(kit.rig, Head=1)
    cushion = BoxShape((0.010, 0.036, 0.028), radius=0.009, segments=(1, 3, 3))
    cup = BoxShape((0.014, 0.036, 0.028), radius=0.0135, segments=(1, 4, 4))
    arm = BoxShape((0.003, 0.026, 0.007), radius=0.002)
    for sign in (1, -1):
        outer = sign * (fit.radii[0] - 0.004)
        at = fit.centre + [outer, -0.032, -0.010]
        kit.add(
            rounded_box(at - [sign * 0.016, 0, 0], np.eye(3), cushion, weights),
            BLACK,
            Layer.LEATHER,
        )
        kit.add(rounded_box(at, np.eye(3), cup, weights), kit.palette.main * 0.7, Layer.SMOOTH)
        hook = fit.centre + [sign * (fit.radii[0] + 0.011), 0.010, -0.010]
        kit.add(rounded_box(hook, np.eye(3), arm, weights), BLACK, Layer.SMOOTH)


def add_glasses(kit: Kit, eyes: list[QuadMesh]) -> QuadMesh:
    """Add temples and brow frame to the kit; returns the transparent lens."""
    weights = rigid_weights(kit.rig, Head=1)
    eye_height = eyes[0].vertices.mean(0)[1]
    front = max(eye.vertices[:, 2].max() for eye in eyes)
    centre = np.array([0, eye_height, front + 0.016 - _LENS_RADIUS_Z])
    angles = np.linspace(np.radians(-72), np.radians(72), 25)
    from_nose = np.abs(np.degrees(angles))

    def curve(height: Array, swell: float = 0.0) -> Array:
        x = np.sin(angles) * (_LENS_RADIUS_X + swell)
        z = centre[2] + np.cos(angles) * (_LENS_RADIUS_Z + swell)
        return np.stack([x, eye_height + height, z], 1)

    upper_edge = np.interp(from_nose, [0, 50, 72], [1, 1, 0.7])
    lower_edge = np.interp(from_nose, [0, 8, 20, 50, 72], [0.35, 0.75, 1, 1, 0.55])
    rows = [
        curve(dy * (lower_edge if dy < 0 else upper_edge))
        for dy in (-0.021, -0.012, 0, 0.012, 0.019)
    ]
    lens = grid_mesh(np.stack(rows), weights, outward=np.array([0, 0, 1.0]))
    for sign in (1, -1):
        _add_temple(kit, centre, sign, weights)
    brow, radial = (
        curve(0.019 * upper_edge, 0.001),
        np.stack([np.sin(angles), 0 * angles, np.cos(angles)], 1),
    )
    section = ((-0.003, 0), (-0.003, 0.002), (0.003, 0.002), (0.003, 0))
    frame = np.stack([brow + np.array([0, up, 0]) + radial * out for up, out in section], 1)
    kit.add(grid_mesh(frame, weights, closed=True), BLACK, Layer.SMOOTH)
    return lens


def _add_temple(kit: Kit, lens_centre: Array, sign: int, weights: WeightRule) -> None:
    """Run one arm of the glasses back to the ear."""
    hinge = lens_centre + np.array(
        [
            sign * _LENS_RADIUS_X * math.sin(np.radians(70)),
            0.010,
            _LENS_RADIUS_Z * math.cos(np.radians(70)),
        ]
    )
    ear = hinge + [sign * 0.004, 0.004, -0.085]
    length = np.linalg.norm(ear - hinge)
    back = (ear - hinge) / length
    right = np.cross([0, 1, 0], back)
    right /= np.linalg.norm(right)
    frame = np.stack([right, np.cross(back, right), back], 1)
    arm = BoxShape((0.0025, 0.006, length / 2), radius=0.002, segments=(1, 1, 3))
    kit.add(rounded_box((hinge + ear) / 2, frame, arm, weights), BLACK, Layer.SMOOTH)
