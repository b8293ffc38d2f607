"""Helmet, ear protection, chin strap and glasses. Metres."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .kit import Kit
from .kit_parts import (
    BLACK,
    RANGER_GREEN,
    BoxShape,
    WeightRule,
    grid_mesh,
    rigid_weights,
    rounded_box,
)
from .quad_mesh import QuadMesh, subdivide
from .surface import Surface

Array = NDArray[np.float64]

# Height of the helmet's rim over its centre by angle from the front (degrees).
_RIM_ANGLES = [0, 35, 60, 80, 110, 135, 180]
_RIM_HEIGHTS = [0.040, 0.040, 0.028, 0.015, 0.005, -0.045, -0.055]
_HELMET_COLUMNS = 48

_LENS_RADIUS_X, _LENS_RADIUS_Z = 0.074, 0.062


@dataclass(frozen=True)
class HelmetFit:
    """The ellipsoid that the helmet follows."""

    centre: Array
    radii: Array


def fit_helmet(head: QuadMesh, eye_centre: Array) -> HelmetFit:
    """Fit an ellipsoid around the scalp, with room for padding."""
    scalp = head.vertices[head.vertices[:, 1] > eye_centre[1] + 0.02]
    x, y, z = scalp.T
    centre = np.array([0, eye_centre[1] + 0.005, (z.min() + z.max()) / 2])
    return HelmetFit(
        centre,
        np.array([np.abs(x).max() + 0.020, y.max() - centre[1] + 0.024, np.ptp(z) / 2 + 0.022]),
    )


def _dome_row(fit: HelmetFit, share: float, inset: float = 0.0) -> Array:
    """Return one ring of the shell: share 0 at the rim, 1 at the top."""
    azimuth = np.linspace(0, 2 * np.pi, _HELMET_COLUMNS + 1)[:-1]
    from_front = np.degrees(np.arccos(np.cos(azimuth)))
    rim = np.interp(from_front, _RIM_ANGLES, _RIM_HEIGHTS)
    lowest = np.arcsin(np.clip(rim / fit.radii[1], -1, 1))
    elevation = lowest + (np.pi / 2 - lowest) * share
    rx, ry, rz = fit.radii - inset
    ring = np.stack(
        [
            np.sin(azimuth) * np.cos(elevation) * rx,
            np.sin(elevation) * ry,
            np.cos(azimuth) * np.cos(elevation) * rz,
        ],
        1,
    )
    return ring + fit.centre


def add_helmet(kit: Kit, fit: HelmetFit) -> None:
    """Add the shell with its cloth cover, the shroud in front and the rails."""
    weights = rigid_weights(kit.rig, Head=1)
    outside = [_dome_row(fit, share) for share in np.linspace(0, 1, 15)]
    inside = [_dome_row(fit, share, 0.010) for share in (0.3, 0.06, 0.0)]
    lip = outside[0] + (outside[0] - fit.centre) * [0.012, 0, 0.012]
    shell = grid_mesh(np.stack([*inside, lip, *outside]), weights, closed=True)
    upper = slice(len(shell.vertices) // 2, None)  # the inside would cancel the outside
    if (shell.normals()[upper] * (shell.vertices - fit.centre)[upper]).sum() < 0:
        shell.flip()
    cover = subdivide(shell)
    kit.add(cover, RANGER_GREEN)
    cover.camouflaged = cover.azimuthal = True

    tilt = np.array([[1, 0, 0], [0, 0.93, 0.36], [0, -0.36, 0.93]])
    shroud = BoxShape((0.022, 0.026, 0.008), radius=0.005)
    at = fit.centre + [0, 0.075, fit.radii[2] * 0.86]
    kit.add(rounded_box(at, tilt, shroud, weights), BLACK)
    for sign in (1, -1):
        _add_rail(kit, fit, sign, weights)


def _add_rail(kit: Kit, fit: HelmetFit, sign: int, weights: WeightRule) -> None:
    """Bend an accessory rail along one side of the helmet."""
    angles = np.radians(np.linspace(68, 122, 13)) * sign
    rows = []
    for y, swell in ((0.024, 1.0), (0.026, 1.075), (0.042, 1.075), (0.044, 1.0)):
        waist = math.sqrt(1 - (y / fit.radii[1]) ** 2)
        x = np.sin(angles) * fit.radii[0] * waist * swell
        z = np.cos(angles) * fit.radii[2] * waist * swell
        rows.append(np.stack([x, y + 0 * angles, z], 1) + fit.centre)
    rail = np.stack(rows)
    kit.add(grid_mesh(rail, weights, outward=rail.reshape(-1, 3) - fit.centre), BLACK)


def add_ear_protection(kit: Kit, fit: HelmetFit) -> None:
    """Add two ear cups below the rails."""
    weights = rigid_weights(kit.rig, Head=1)
    cup = BoxShape((0.018, 0.038, 0.030), radius=0.016, segments=(2, 3, 3))
    for sign in (1, -1):
        at = fit.centre + [sign * (fit.radii[0] - 0.014), -0.035, -0.012]
        kit.add(rounded_box(at, np.eye(3), cup, weights), RANGER_GREEN * 0.7)


def add_chin_strap(kit: Kit, fit: HelmetFit, head: QuadMesh) -> None:
    """Sweep a strap from ear to ear under the chin, 4 mm off the skin."""
    skin = Surface(head.vertices, head.faces)
    origin = fit.centre + [0, -0.035, 0.015]
    path = []
    for angle in np.linspace(-100, 100, 25):
        forward = 0.30 if abs(angle) < 60 else 0.30 - 0.2 * (abs(angle) - 60) / 40
        direction = np.array([math.sin(np.radians(angle)), -math.cos(np.radians(angle)), forward])
        direction /= np.linalg.norm(direction)
        hit = skin.hit(origin + direction * 0.3, -direction, 0.3)
        path.append(origin + direction * 0.1 if hit is None else hit + direction * 0.004)
    line = np.array(path)
    for _ in range(2):
        line[1:-1] = (line[:-2] + 2 * line[1:-1] + line[2:]) / 4
    tangents = np.gradient(line, axis=0)
    outward = line - origin
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
    across = np.cross(tangents, outward)
    section = ((-0.009, 0), (-0.008, 0.003), (0.008, 0.003), (0.009, 0))
    band = np.stack([line + across * a + outward * b for a, b in section], 1)
    strap = grid_mesh(
        band, rigid_weights(kit.rig, Head=1), closed=True, outward=outward.repeat(4, 0)
    )
    kit.add(strap, RANGER_GREEN * 0.6)


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
    kit.add(grid_mesh(frame, weights, closed=True), BLACK)
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
    kit.add(rounded_box((hinge + ear) / 2, frame, arm, weights), BLACK)
