"""Paints the face by position: there is no photograph behind it, only sums of soft spots."""

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from .makehuman import MakeHumanData
from .noise import NoiseField

Array = NDArray[np.float64]

_SKIN = np.array([0.235, 0.14, 0.098])
"""Linear RGB of tanned skin; a paler face glares in the sun beside the dark uniform."""
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


def paint_skin(
    points: Array, lips: Array, eye_height: float, middle_z: float, noise: NoiseField
) -> Array:
    """Return linear RGB for points on the head (metres).

    `middle_z` separates face from nape. Draws from the noise's generator: call it in order.
    """
    random = noise.generator.random
    x, y, z = np.abs(points[:, 0]), points[:, 1], points[:, 2]
    colour = _SKIN * (0.90 + 0.2 * noise.layered(points * 60, 3))[:, None]
    colour = colour * (0.96 + 0.08 * random((len(points), 1)))

    cheeks = _spot(x, y, (0.038, eye_height - 0.045), (0.022, 0.025)) * (z > middle_z)
    colour = colour * (1 - cheeks[:, None] * 0.16 * np.array([0, 1, 0.9]))
    colour = colour * (1 - lips[:, None] * np.array([0.25, 0.5, 0.45]))

    stubble = _stubble(x, y, z, eye_height, middle_z) * (1 - lips)
    colour *= (1 - stubble * (0.18 + 0.28 * random(len(points))))[:, None]

    brow_height = eye_height + 0.024 + 0.010 * np.clip((x - 0.012) / 0.03, 0, 1)
    brow_height = brow_height - 0.010 * np.clip((x - 0.042) / 0.016, 0, 1)
    brows = np.exp(-(((y - brow_height) / 0.0048) ** 4))
    brows = brows * ((x > 0.012) & (x < 0.060)) * (z > middle_z)
    colour *= (1 - brows * (0.55 + 0.35 * random(len(points))))[:, None]
    return colour


def _stubble(x: Array, y: Array, z: Array, eye_height: float, middle_z: float) -> Array:
    """Return how much beard shadow there is: jaw and upper lip, not the cheeks."""
    below_nose = np.clip((eye_height - 0.045 - y) / 0.02, 0, 1)
    front = np.clip((z - middle_z + 0.01) / 0.03, 0, 1)
    above_neck = np.clip((y - (eye_height - 0.15)) / 0.03, 0, 1)
    cheek = _spot(x, y, (0.04, eye_height - 0.055), (0.018, 0.018))
    return below_nose * front * above_neck * (1 - cheek)
