"""The ends of the uniform: trousers bloused over the boots, sleeves closed over the gloves.

The simulated cloth is loose there; it is laid into smooth rings about the limb. Metres.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .curves import RoundProfile, unit
from .quad_mesh import QuadMesh
from .rig import SIDES, Rig
from .surface import Surface

Array = NDArray[np.float64]

_RAYS = 48
# Knots of a hem: position along the bone (before), position (after), share of the radius that is
# the inner one (boot or glove), what is added to it. The last ones turn in under the edge.
_TROUSER = np.array(
    [
        (0.54, 0.540, 0.00, 0.000),
        (0.60, 0.590, 0.10, 0.003),
        (0.65, 0.645, 0.25, 0.007),
        (0.70, 0.695, 0.40, 0.010),
        (0.735, 0.728, 0.60, 0.010),
        (0.765, 0.742, 0.85, 0.010),
        (0.79, 0.738, 1.00, 0.004),
        (0.83, 0.715, 1.00, -0.012),
    ]
)
_SLEEVE = np.array(
    [
        (0.72, 0.720, 0.00, 0.000),
        (0.77, 0.780, 0.30, 0.002),
        (0.82, 0.850, 0.65, 0.004),
        (0.855, 0.895, 0.90, 0.0055),
        (0.875, 0.925, 1.00, 0.0060),
        (0.890, 0.950, 1.00, 0.0055),
        (0.902, 0.953, 1.00, 0.0025),
        (0.915, 0.940, 1.00, -0.0030),
    ]
)
# Trousers that fall over shoes.
_WIDE_TROUSER = np.array(
    [
        (0.60, 0.600, 0.00, 0.000),
        (0.66, 0.663, 0.25, 0.014),
        (0.72, 0.727, 0.45, 0.016),
        (0.76, 0.770, 0.65, 0.020),
        (0.84, 0.855, 0.85, 0.022),
        (0.90, 0.915, 1.00, 0.025),
        (0.95, 0.955, 1.00, 0.026),
        (0.965, 0.957, 1.00, 0.0245),
        (0.99, 0.951, 1.00, 0.0235),
    ]
)
_BARE_CUFF = np.array(
    [
        (0.72, 0.720, 0.00, 0.000),
        (0.77, 0.780, 0.30, 0.002),
        (0.82, 0.850, 0.65, 0.005),
        (0.855, 0.895, 0.90, 0.0085),
        (0.875, 0.925, 1.00, 0.0095),
        (0.890, 0.950, 1.00, 0.0095),
        (0.902, 0.953, 1.00, 0.0065),
        (0.915, 0.940, 1.00, 0.0040),
    ]
)
_BOOT_RADIUS_AT, _GLOVE_RADIUS_AT = 0.69, 0.93
_LEATHER, _GLOVE = 0.0115, 0.0030
"""Thickness of boots and gloves over the surfaces that the radii are taken from."""
_GATHER = 0.0022
"""Depth of the trousers' pleats."""


@dataclass(frozen=True)
class _Axis:
    """A limb's axis with the directions that angles are measured from."""

    head: Array
    bone: Array
    forward: Array
    sideways: Array

    def split(self, points: Array) -> tuple[Array, Array, Array]:
        """Return position along the axis, angle and radius of points."""
        along = (points - self.head) @ self.bone / (self.bone @ self.bone)
        out = points - self.head - along[:, None] * self.bone
        return (
            along,
            np.arctan2(out @ self.sideways, out @ self.forward),
            np.linalg.norm(out, axis=1),
        )

    def join(self, along: Array, angle: Array, radius: Array) -> Array:
        """Return the points of `split`."""
        out = np.cos(angle)[:, None] * self.forward + np.sin(angle)[:, None] * self.sideways
        return self.head + along[:, None] * self.bone + out * radius[:, None]


def _axis(rig: Rig, bone: str, end: str) -> _Axis:
    along = rig.heads[end] - rig.heads[bone]
    forward = unit(np.array([0, 0, 1.0]) - along * along[2] / (along @ along))
    return _Axis(rig.heads[bone], along, forward, unit(np.cross(along, forward)))


def _limb_profile(axis: _Axis, surface: Surface, along: float, added: float) -> RoundProfile:
    """Measure a surface around a limb."""
    angles = np.linspace(-np.pi, np.pi, _RAYS + 1)[:-1]
    centres = np.repeat((axis.head + axis.bone * along)[None], _RAYS, 0)
    directions = np.cos(angles)[:, None] * axis.forward + np.sin(angles)[:, None] * axis.sideways
    radii = surface.radii(centres, directions, 0.12)
    known = ~np.isnan(radii)
    return RoundProfile(angles[known], radii[known] + added, 3)


def finish_hems(uniform: QuadMesh, feet: QuadMesh, body: QuadMesh, rig: Rig, cut: str) -> None:
    """Lay the ends of trousers and sleeves into rings."""
    foot, skin = Surface(feet.vertices, feet.faces), Surface(body.vertices, body.faces)
    for side in SIDES:
        leg = rig.share(uniform.weights, (side + "LowerLeg", side + "Foot", side + "Toes")) > 0.5
        axis = _axis(rig, side + "LowerLeg", side + "Foot")
        boot = _limb_profile(axis, foot, _BOOT_RADIUS_AT, _LEATHER)
        is_wide = cut != "fatigues"
        _lay(uniform, leg, axis, boot, _WIDE_TROUSER if is_wide else _TROUSER, _GATHER)
        if cut == "polo":
            continue
        arm = rig.share(uniform.weights, (side + "LowerArm", side + "Hand")) > 0.5
        axis = _axis(rig, side + "LowerArm", side + "Hand")
        glove = _limb_profile(axis, skin, _GLOVE_RADIUS_AT, _GLOVE)
        _lay(uniform, arm, axis, glove, _BARE_CUFF if is_wide else _SLEEVE, 0.0)


def _lay(
    cloth: QuadMesh,
    limb: NDArray[np.bool_],
    axis: _Axis,
    inner: RoundProfile,
    knots: Array,
    gather: float,
) -> None:
    """Move the cloth of one limb from the first knot on into the hem's shape."""
    along, angle, radius = axis.split(cloth.vertices)
    near = limb & (np.abs(along - knots[0, 0]) < 0.05)
    loose = RoundProfile(angle[near], radius[near], 4)
    chosen = limb & (along > knots[0, 0])
    a, turn = along[chosen], angle[chosen]
    after, share, added = (np.interp(a, knots[:, 0], knots[:, k]) for k in (1, 2, 3))
    ring = loose.at(turn) * (1 - share) + inner.at(turn) * share + added
    pleats = np.sin(5 * turn + 9 * a) + 0.7 * np.sin(8 * turn - 14 * a + 1.3)
    ring += gather * pleats * np.clip(share * 3, 0, 1) * np.clip((1 - share) * 3, 0, 1)
    settled = np.clip((a - knots[0, 0]) / (knots[2, 0] - knots[0, 0]), 0, 1)
    ring = radius[chosen] * (1 - settled) + ring * settled
    cloth.vertices[chosen] = axis.join(after, turn, ring)
