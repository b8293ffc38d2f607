"""Baking surface attributes into images by texture coordinate, and image encoding.

Images are arrays with row 0 at the top; texture coordinates have v upwards.
"""

import io

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from .quad_mesh import QuadMesh

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_JPEG_QUALITY = 90


def bake_attributes(mesh: QuadMesh, attributes: Array, size: int) -> tuple[Array, Mask]:
    """Interpolate vertex attributes over the texture; returns the image and what is covered."""
    image = np.zeros((size, size, attributes.shape[1]))
    covered = np.zeros((size, size), bool)
    for corners in ((0, 1, 2), (0, 2, 3)):
        uvs = mesh.uvs[:, corners] * size
        values = attributes[mesh.faces[:, corners]]
        for uv, value in zip(uvs, values, strict=True):
            triangle = uv.copy()
            triangle[:, 1] = size - triangle[:, 1]
            _bake_triangle(triangle, value, image, covered)
    return image, covered


def _bake_triangle(p: Array, values: Array, image: Array, covered: Mask) -> None:
    """Fill one triangle (pixel coordinates) and a thin margin where nothing is yet."""
    size = len(image)
    x0, y0 = np.maximum(np.floor(p.min(0) - 1).astype(int), 0)
    x1, y1 = np.minimum(np.ceil(p.max(0) + 1).astype(int), size)
    if x1 <= x0 or y1 <= y0:
        return
    x, y = np.meshgrid(np.arange(x0, x1) + 0.5, np.arange(y0, y1) + 0.5)
    # Barycentric coordinates; the denominator is twice the triangle's area.
    area = (p[1, 1] - p[2, 1]) * (p[0, 0] - p[2, 0]) + (p[2, 0] - p[1, 0]) * (p[0, 1] - p[2, 1])
    if abs(area) < 1e-9:
        return
    a = ((p[1, 1] - p[2, 1]) * (x - p[2, 0]) + (p[2, 0] - p[1, 0]) * (y - p[2, 1])) / area
    b = ((p[2, 1] - p[0, 1]) * (x - p[2, 0]) + (p[0, 0] - p[2, 0]) * (y - p[2, 1])) / area
    c = 1 - a - b
    margin = -0.6 / max(np.sqrt(abs(area)), 1.2)
    window = np.s_[y0:y1, x0:x1]
    inside = (a >= 0) & (b >= 0) & (c >= 0)
    near = (a >= margin) & (b >= margin) & (c >= margin)
    fill = near & (~covered[window] | inside)
    if fill.any():
        mixed = a[..., None] * values[0] + b[..., None] * values[1] + c[..., None] * values[2]
        image[window][fill] = mixed[fill]
        covered[window] |= fill


def fill_gutters(image: Array, covered: Mask, steps: int = 6) -> Array:
    """Grow colours over the borders of the charts, so that filtering shows no seams."""
    image, covered = image.copy(), covered.copy()
    for _ in range(steps):
        for axis, shift in ((0, 1), (0, -1), (1, 1), (1, -1)):
            grown = np.roll(covered, shift, axis) & ~covered
            image[grown] = np.roll(image, shift, axis)[grown]
            covered |= grown
    return image


def linear_to_srgb(colour: Array) -> Array:
    """Encode linear light for an image."""
    curve = 1.055 * np.clip(colour, 0, None) ** (1 / 2.4) - 0.055
    return np.where(colour <= 0.0031308, colour * 12.92, curve)


def _encode(image: Array, kind: str, **options: int) -> bytes:
    buffer = io.BytesIO()
    pixels = (np.clip(image, 0, 1) * 255 + 0.5).astype(np.uint8)
    Image.fromarray(pixels).save(buffer, kind, **options)
    return buffer.getvalue()


def encode_jpeg(image: Array) -> bytes:
    """Encode an RGB image with values 0 to 1."""
    return _encode(image, "JPEG", quality=_JPEG_QUALITY)


def encode_png(image: Array) -> bytes:
    """Encode an RGB image with values 0 to 1 without loss."""
    return _encode(image, "PNG")
