"""What holds the helmet: straps from its rim to below the ears, and the one around the chin."""

import numpy as np
from numpy.typing import NDArray

from .bands import BandShape, drape_band
from .curves import convex_hull, resample, smooth_line, unit
from .head_kit import HelmetFit, shell_point
from .kit import Kit
from .kit_parts import BLACK, BoxShape, WeightRule, rigid_weights, rounded_box
from .quad_mesh import Layer, QuadMesh
from .surface import Surface

Array = NDArray[np.float64]

_JUNCTION = np.array([0.060, -0.090, -0.006])
"""Where the straps of a side meet, below the ear, from the helmet's centre."""
_CHIN_HEIGHT = -0.116
"""Of the chin strap's middle over the helmet's centre: the lower half of the chin's front."""
_SIDE_HALF_WIDTH, _CUP_HALF_WIDTH = 0.0075, 0.0150
# Rim anchors of a side's straps: angle from the front in degrees.
_ANCHORS = (63, 134)


def add_chin_strap(kit: Kit, fit: HelmetFit, head: QuadMesh) -> None:
    """Run the harness: a cup before the chin, and two straps of each side up to the rim."""
    skin = Surface(head.vertices, head.faces)
    weights = rigid_weights(kit.rig, Head=1)
    line, outward = _chin_line(fit, skin)
    share = np.linspace(-1, 1, len(line))
    cup = np.exp(-((share / 0.27) ** 4))
    widths = _SIDE_HALF_WIDTH + (_CUP_HALF_WIDTH - _SIDE_HALF_WIDTH) * cup
    shape = BandShape(tuple(widths), 0.0035, lift=0.0015, columns=5)
    kit.add(drape_band(skin, line, outward, shape, weights), kit.palette.main * 0.55, Layer.WEBBING)
    for end, sign in ((line[0], -1), (line[-1], 1)):
        for degrees in _ANCHORS:
            _add_side_strap(kit, fit, skin, end, np.radians(degrees) * sign)
        _add_buckle(kit, skin, end, weights)


def _chin_line(fit: HelmetFit, skin: Surface) -> tuple[Array, Array]:
    """Trace the strap from the right ear past the chin's front to the left one: line, outward.

    A taut strap is the convex hull of what it goes around, in the plane of both ears and the chin.
    """
    middle = fit.centre + _JUNCTION * [0, 1, 1]
    chin = skin.hit(fit.centre + [0, _CHIN_HEIGHT, 0.4], (0, 0, -1), 0.5)
    if chin is None:
        raise ValueError("no chin under the helmet's strap")
    forward = unit(chin - middle)
    origin = middle + forward * 0.03
    reach = np.arctan2(_JUNCTION[0], -0.03)
    corners = []
    for angle in np.linspace(-reach, reach, 61):
        flat = np.array([np.sin(angle), np.cos(angle)])
        direction = np.array([flat[0], 0, 0]) + forward * flat[1]
        hit = skin.hit(origin + direction * 0.2, -direction, 0.2)
        if hit is not None:
            corners.append((hit[0], (hit - origin) @ forward))
    hull = convex_hull([tuple(corner) for corner in np.round(corners, 5)])
    first = hull[:, 1] > hull[np.abs(hull[:, 0]).argmax(), 1] - 0.02
    hull = hull[first][np.argsort(np.arctan2(hull[first][:, 0], hull[first][:, 1]))]
    flat = smooth_line(resample(hull, 45), 2)
    line = origin + np.stack([flat[:, 0], 0 * flat[:, 0], 0 * flat[:, 0]], 1)
    line = line + forward * flat[:, 1:]
    outward = np.array([skin.nearest_normal(point) for point in line])
    outward = unit(smooth_line(outward, 10))
    return line, unit((outward + outward[::-1] * [-1, 1, 1]) / 2)


def _add_side_strap(kit: Kit, fit: HelmetFit, skin: Surface, end: Array, azimuth: float) -> None:
    """Run one strap from inside the rim over cheek or nape to the chin strap's end."""
    rim = shell_point(fit, azimuth, 0.05, inset=0.006)
    line = np.stack([end + (rim - end) * share for share in np.linspace(0, 1, 11)])
    sideways = np.array([np.sign(end[0]), 0, 0])
    outward = unit(line - (fit.centre + [0, -0.03, 0.0])) * 0.5 + sideways
    outward = unit(outward * [1, 0.2, 1])
    shape = BandShape(0.0075, 0.0022, lift=0.001)
    band = drape_band(skin, line, outward, shape, rigid_weights(kit.rig, Head=1))
    kit.add(band, kit.palette.main * 0.55, Layer.WEBBING)


def _add_buckle(kit: Kit, skin: Surface, end: Array, weights: WeightRule) -> None:
    """Put the slider on that joins the three straps of a side."""
    out = skin.nearest_normal(end)
    up = unit(np.array([0, 1.0, 0.35]) - out * (np.array([0, 1.0, 0.35]) @ out))
    frame = np.stack([np.cross(up, out), up, out], 1)
    slider = BoxShape((0.012, 0.013, 0.0025), radius=0.002)
    kit.add(rounded_box(end + out * 0.006, frame, slider, weights), BLACK * 1.2, Layer.SMOOTH)
