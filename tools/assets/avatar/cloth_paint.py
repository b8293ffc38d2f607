"""The garment's pictures: what is printed on it, its seams, wrinkles and wear.

Seams are lines of constant angle or position on a limb, so that they run where a tailor sews them.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .bake import Mask, bake_attributes, fill_gutters
from .camouflage import wrinkle_height
from .figure import Figure
from .noise import NoiseField
from .patterns import PATTERNS, ClothPoints
from .quad_mesh import QuadMesh
from .recipe import Clothes
from .rig import SIDES, Rig

Array = NDArray[np.float64]

_SEAM = 0.0022
"""Half the width of a seam's groove, metres."""
_GROOVE, _FELL = 0.0011, 0.0007
"""Depth of the groove and height of the fold beside it, metres."""
_DUST = np.array([0.30, 0.24, 0.165])


@dataclass(frozen=True)
class ClothPicture:
    """The pictures of a garment, not yet encoded."""

    colour: Array
    """Linear RGB, gutters filled."""
    normals: Array
    """Tangent space, -1 to 1."""


@dataclass(frozen=True)
class _Limb:
    """Attributes of a kind of limb at points: position along, across (metres), share of weight."""

    along: Array
    ahead: Array
    aside: Array
    share: Array

    def seam(self, degrees: float) -> Array:
        """Return the distance from a line at an angle about the limb, 0 in front; metres."""
        turn = np.radians(degrees)
        along_line = self.ahead * np.cos(turn) + self.aside * np.sin(turn)
        across = -self.ahead * np.sin(turn) + self.aside * np.cos(turn)
        return np.where(along_line > 0, np.abs(across), 1.0)


def _limb_attributes(uniform: QuadMesh, rig: Rig, bone: str, end: str) -> Array:
    """Return along, ahead, aside (outwards positive) and share at each vertex."""
    result = np.zeros((len(uniform.vertices), 4))
    for side, sign in zip(SIDES, (1.0, -1.0), strict=True):
        head, axis = rig.heads[side + bone], rig.heads[side + end] - rig.heads[side + bone]
        length = np.linalg.norm(axis)
        axis = axis / length
        forward = np.array([0, 0, 1.0]) - axis * axis[2]
        forward /= np.linalg.norm(forward)
        out = uniform.vertices - head
        chosen = uniform.vertices[:, 0] * sign > 0
        aside = sign * np.cross(forward, axis)
        values = np.stack([out @ axis / length, out @ forward, out @ aside], 1)
        result[chosen, :3] = values[chosen]
    return result


def _seams(points: Array, arm: _Limb, fore: _Limb, leg: _Limb, rig: Rig, cut: str) -> Array:
    """Return the distance from the nearest seam, metres."""
    x, y, z = points.T
    neck, waist = rig.heads["Neck"], rig.heads["Spine"]
    on_arm, on_leg = arm.share > 0.5, leg.share > 0.5
    trunk = ~on_arm & ~on_leg
    distance = np.full(len(points), 1.0)

    def add(where: Array, from_line: Array) -> None:
        np.minimum(distance, np.where(where, from_line, 1.0), out=distance)

    add(on_leg, leg.seam(86))
    add(on_leg, leg.seam(-86))
    add(on_leg, np.abs(leg.along - 0.93) * 0.9)
    add(on_arm, arm.seam(-90))
    add(on_arm, fore.seam(-90))
    add(on_arm, np.abs(arm.along - 0.10) * 0.28)
    add(trunk & (np.abs(x) > 0.09) & (y > waist[1] - 0.1), np.abs(z - waist[2] + 0.004))
    add(trunk & (z > waist[2]), np.abs(np.abs(x) - 0.017))
    add(trunk & (y > waist[1]), np.abs(y - neck[1] + 0.095 + 0.10 * np.abs(x)))
    add(trunk, np.abs(y - waist[1] + 0.012))
    add((y < waist[1] - 0.02) & (np.abs(x) < 0.012) & ~on_arm, np.abs(x) * 1.0)
    pocket = np.maximum(np.abs(np.abs(x) - 0.088) - 0.052, np.abs(y - neck[1] + 0.21) - 0.062)
    add(trunk & (z > waist[2] + 0.02), np.abs(pocket))
    add(
        trunk & (z > waist[2] + 0.02) & (np.abs(np.abs(x) - 0.088) < 0.052),
        np.abs(y - neck[1] + 0.172),
    )
    if cut == "fatigues":
        for along in (0.40, 0.57):
            add(on_leg & (leg.ahead > -0.01), np.abs(leg.along - along) * 0.85)
        add(on_arm, np.abs(fore.along - 0.84) * 0.25)
    return distance


def paint_cloth(figure: Figure, uniform: QuadMesh, clothes: Clothes, size: int) -> ClothPicture:
    """Bake a garment's colour and its normals."""
    rig, noise = figure.rig, figure.noise
    names = {kind: [side + kind for side in SIDES] for kind in ("UpperArm", "LowerArm", "Hand")}
    arms = rig.share(uniform.weights, [bone for each in names.values() for bone in each])
    legs = rig.share(uniform.weights, [s + k for s in SIDES for k in ("UpperLeg", "LowerLeg")])
    leg = _limb_attributes(uniform, rig, "UpperLeg", "Foot")
    arm = _limb_attributes(uniform, rig, "UpperArm", "LowerArm")
    fore = _limb_attributes(uniform, rig, "LowerArm", "Hand")
    leg[:, 3], arm[:, 3], fore[:, 3] = legs, arms, arms
    table = np.hstack([uniform.vertices, leg, arm, fore])
    baked, covered = bake_attributes(uniform, table, size)
    seen = baked[covered]
    points = seen[:, :3]
    limbs = [_Limb(*seen[:, k : k + 4].T) for k in (3, 7, 11)]
    chest = np.array([0, rig.heads["UpperChest"][1] + 0.02, 0])
    cloth = ClothPoints(points, rig.heads["Spine"][1] - 0.012, chest)
    colour_seen = PATTERNS[clothes.pattern](cloth, clothes.colours, noise)
    height_seen = np.zeros(len(points))
    if clothes.cut != "suit":
        distance = _seams(points, limbs[1], limbs[2], limbs[0], rig, clothes.cut)
        groove = np.exp(-((distance / _SEAM) ** 2))
        fell = np.exp(-(((distance - 2.2 * _SEAM) / (1.1 * _SEAM)) ** 2))
        height_seen = wrinkle_height(points, noise) - _GROOVE * groove + _FELL * fell
        pucker = noise.value(points * 190) * np.exp(-distance / 0.010)
        height_seen += 0.0009 * pucker
        colour_seen = colour_seen * (1 - 0.38 * groove + 0.10 * fell)[:, None]
        colour_seen = _wear(colour_seen, points, limbs, noise, rig)
    colour_seen = colour_seen * (0.93 + 0.14 * noise.generator.random((len(points), 1)))
    colour = np.zeros((size, size, 3))
    height = np.zeros(covered.shape)
    colour[covered], height[covered] = np.clip(colour_seen, 0.003, 1), height_seen
    positions = np.where(covered[..., None], baked[..., :3], 0)
    return ClothPicture(fill_gutters(colour, covered), normal_map(positions, covered, height))


def _wear(colour: Array, points: Array, limbs: list[_Limb], noise: NoiseField, rig: Rig) -> Array:
    """Fade elbows and knees, and lay dust on shins and seat."""
    leg, _arm, fore = limbs
    knee = np.exp(-(((leg.along - 0.47) / 0.07) ** 2)) * (leg.ahead > 0) * (leg.share > 0.5)
    elbow = np.exp(-((fore.along / 0.25) ** 2)) * (fore.ahead < 0.01) * (fore.share > 0.5)
    patchy = noise.layered(points * 17 + 5, 3)
    fade = np.clip((knee + elbow) * (0.25 + 0.5 * patchy), 0, 0.5)[:, None]
    colour = colour * (1 - fade) + (colour * 1.35 + 0.025) * fade
    low = np.clip((rig.heads["LeftLowerLeg"][1] - points[:, 1]) / 0.40, 0, 1)
    dust = np.clip((0.10 + 0.50 * low) * (patchy - 0.22), 0, 0.45)[:, None]
    return colour * (1 - dust) + _DUST * dust


def normal_map(points: Array, covered: Mask, height: Array) -> Array:
    """Turn heights (metres) into tangent-space normals, from the positions of the texels."""

    def span(axis: int, forwards: int) -> tuple[Array, Array]:
        """Return distance and height difference between the two neighbours of each texel."""
        after, before = np.roll(points, forwards, axis), np.roll(points, -forwards, axis)
        rise = np.roll(height, forwards, axis) - np.roll(height, -forwards, axis)
        return np.linalg.norm(after - before, axis=2), rise

    length_x, rise_x = span(1, -1)
    length_y, rise_y = span(0, 1)
    valid = covered.copy()
    for axis in (0, 1):
        for shift in (1, -1):
            valid &= np.roll(covered, shift, axis)
    for length in (length_x, length_y):  # at a chart's border the neighbour is elsewhere
        valid &= (length < 0.03) & (length > 1e-5)
    slope_x = np.where(valid, -rise_x / np.maximum(length_x, 1e-5), 0)
    slope_y = np.where(valid, -rise_y / np.maximum(length_y, 1e-5), 0)
    normals = np.stack([slope_x, slope_y, np.ones_like(slope_x)], -1)
    return normals / np.linalg.norm(normals, axis=-1, keepdims=True)
