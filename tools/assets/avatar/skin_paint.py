"""Paints the face by position: there is no photograph behind it, only sums of soft spots."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from .makehuman import MakeHumanData
from .noise import NoiseField
from .recipe import Face

Array = NDArray[np.float64]

_LIPS_IMAGE = "textures/mpfb_lips.jpg"


def _spot(x: Array, y: Array, centre: tuple[float, float], size: tuple[float, float]) -> Array:
    """Return a soft elliptical spot, 1 in its centre; metres."""
    return np.exp(-(((x - centre[0]) / size[0]) ** 2) - ((y - centre[1]) / size[1]) ** 2)


def read_lips(data: MakeHumanData, uvs: Array) -> Array:
    """Look up MakeHuman's lip mask at the body's texture coordinates: 1 on the lips."""
    mask = np.asarray(Image.open(data.root / _LIPS_IMAGE).convert("L"), float) / 255
    rows, columns = mask.shape
    row = np.clip(((1 - uvs[:, 1]) * rows).astype(int), 0, rows - 1)
    column = np.clip((uvs[:, 0] * columns).astype(int), 0, columns - 1)
    lips = mask[row, column]
    return 1 - lips if lips.mean() > 0.5 else lips


@dataclass(frozen=True)
class FacePlace:
    """Where a face is."""

    eye: Array
    """Middle of the left eyeball, metres."""
    eye_radius: float
    middle_z: float
    """Separates face from nape."""


def paint_skin(
    points: Array, lips: Array, place: FacePlace, face: Face, noise: NoiseField
) -> Array:
    """Return linear RGB for points on the head (metres).

    Draws from the noise's generator: call it in order.
    """
    random = noise.generator.random
    x, y, z = np.abs(points[:, 0]), points[:, 1] - place.eye[1], points[:, 2]
    front = np.clip((z - place.middle_z) / 0.02, 0, 1)
    colour = face.tone * (0.90 + 0.2 * noise.layered(points * 60, 3))[:, None]
    colour = colour * (0.965 + 0.07 * random((len(points), 1)))
    if face.is_blank:
        return colour

    for centre, size, depth in (
        ((0.038, -0.045), (0.022, 0.025), 0.17),
        ((0.0, -0.038), (0.014, 0.014), 0.16),
        ((0.075, -0.02), (0.012, 0.03), 0.16),
    ):
        warm = _spot(x, y, centre, size) * np.maximum(front, centre[0] > 0.06)
        colour = colour * (1 - warm[:, None] * depth * np.array([0, 1, 0.9]))
    hollow = _spot(x, y, (place.eye[0], -0.004), (0.022, 0.015)) * front
    colour = colour * (1 - 0.22 * hollow[:, None] * np.array([0.8, 1, 0.9]))
    colour = colour * (1 - face.lips * lips[:, None] * np.array([0.22, 0.50, 0.45]))
    parting = np.exp(-(((y + 0.0725) / 0.0016) ** 2)) * lips * (x < 0.024)
    colour = colour * (1 - 0.45 * parting[:, None])

    stubble = _stubble(x, y, z - place.middle_z) * (1 - lips)
    strands = noise.layered(points * np.array([420, 130, 420]), 2)
    depth = np.clip(stubble * face.stubble * (0.16 + 0.5 * strands * random(len(points))), 0, 0.9)
    colour = colour * (1 - depth[:, None]) + face.hair * depth[:, None] * 0.8
    return _paint_hair(colour, points, place, face, noise)


def _paint_hair(
    colour: Array, points: Array, place: FacePlace, face: Face, noise: NoiseField
) -> Array:
    """Paint brows, lashes and what grows on the scalp."""
    random = noise.generator.random
    x, y = np.abs(points[:, 0]), points[:, 1] - place.eye[1]
    front = points[:, 2] > place.middle_z
    arch = 0.0235 + 0.0075 * np.clip((x - 0.012) / 0.03, 0, 1)
    arch = arch - 0.010 * np.clip((x - 0.042) / 0.016, 0, 1)
    half = face.brows * np.interp(x, [0.010, 0.018, 0.045, 0.060], [0.0032, 0.0044, 0.0034, 0.0006])
    strokes = noise.layered(np.stack([x * 900 - y * 500, y * 130, 0 * x], 1), 2)
    brows = np.clip(1.35 - ((y - arch) / np.maximum(half, 1e-4)) ** 2, 0, 1)
    brows = brows * (x > 0.011) * (x < 0.060) * front * np.clip(0.55 + 0.9 * strokes, 0, 1)
    brows = np.clip(brows * (0.75 + 0.25 * random(len(points))), 0, 0.92)[:, None]
    colour = colour * (1 - brows) + face.hair * brows

    eye = np.array([place.eye[0], 0, place.eye[2]])
    from_ball = np.sqrt((x - eye[0]) ** 2 + y**2 + (points[:, 2] - eye[2]) ** 2)
    lashes = np.exp(-(((from_ball - place.eye_radius) / 0.0013) ** 2)) * front
    lashes = (lashes * np.where(y > 0.001, 0.85, 0.40))[:, None]
    colour = colour * (1 - lashes) + 0.5 * face.hair * lashes

    back = place.eye[2] - points[:, 2]
    line = np.interp(
        back, [-0.03, 0.03, 0.075, 0.10, 0.15, 0.20], [0.077, 0.064, 0.0, 0.02, -0.055, -0.08]
    )
    ragged = 0.016 * (noise.layered(points * 130, 2) - 0.5)
    scalp = np.clip((y + ragged - line) / 0.012, 0, 1) * (0.62 + 0.3 * random(len(points)))
    return colour * (1 - scalp[:, None]) + face.hair * scalp[:, None]


def _stubble(x: Array, y: Array, ahead: Array) -> Array:
    """Return how much beard shadow there is: jaw and upper lip, not the cheeks."""
    below_nose = np.clip((-0.047 - y) / 0.018, 0, 1)
    front = np.clip((ahead + 0.01) / 0.03, 0, 1)
    above_neck = np.clip((y + 0.15) / 0.03, 0, 1)
    cheek = _spot(x, y, (0.04, -0.055), (0.018, 0.018))
    sideburn = _spot(x, y, (0.070, -0.030), (0.010, 0.030)) * (ahead < 0.03) * (ahead > -0.03)
    return np.clip(below_nose * front * above_neck * (1 - cheek) + 0.8 * sideburn, 0, 1)


def paint_eye(face: Face, size: int = 256) -> Array:
    """Paint an eyeball seen from in front: linear RGB, the iris in the middle."""
    generator = np.random.default_rng(5)
    y, x = np.mgrid[0:size, 0:size] / (size / 2) - 1 + 1 / size
    radius, turn = np.hypot(x, y), np.arctan2(y, x)
    rays = np.zeros_like(turn)
    for count in (23, 41, 67, 97):
        rays += generator.uniform(0.5, 1) * np.sin(count * turn + generator.uniform(0, 6.28))
    rays /= 4
    share = radius / 0.46
    iris = face.iris * (0.75 + 0.55 * rays + 0.5 * np.clip(share - 0.35, 0, 0.4))[..., None]
    ring = np.clip((share - 0.82) / 0.18, 0, 1)
    iris = iris * (1 - 0.75 * ring[..., None])
    white = np.array([0.46, 0.42, 0.38]) * (1 - 0.30 * np.clip(radius - 0.5, 0, 1))[..., None]
    veins = np.clip(np.sin(turn * 31 + 9 * radius) - 0.93, 0, 1) * 5 * np.clip(radius - 0.6, 0, 1)
    white = white * (1 - veins[..., None] * np.array([0.0, 0.5, 0.5]))
    inside = np.clip((0.47 - radius) / 0.02, 0, 1)[..., None]
    colour = white * (1 - inside) + iris * inside
    pupil = np.clip((0.20 - radius) / 0.02, 0, 1)[..., None]
    colour = colour * (1 - pupil) + 0.004 * pupil
    return colour
