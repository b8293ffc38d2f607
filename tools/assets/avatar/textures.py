"""The avatar's textures and the texture coordinates of its kit."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .bake import (
    Mask,
    bake_attributes,
    encode_jpeg,
    encode_png,
    fill_gutters,
    linear_to_srgb,
)
from .bare_parts import Head
from .camouflage import camouflage, wrinkle_height
from .head_kit import HelmetFit
from .makehuman import MakeHumanData
from .noise import NoiseField
from .quad_mesh import QuadMesh
from .skin_paint import paint_skin, read_lips

Array = NDArray[np.float64]

_UNIFORM_SIZE, _SKIN_SIZE, _CAMOUFLAGE_SIZE, _WEAVE_SIZE = 2048, 1024, 1024, 256
_CAMOUFLAGE_TILE = 0.8
"""Metres of cloth on one tile of the kit's camouflage."""
_WEAVE_TILES_PER_METRE = 13


@dataclass
class Textures:
    """Encoded images."""

    uniform: bytes
    uniform_normals: bytes
    skin: bytes
    weave: bytes
    camouflage: bytes


def paint_textures(
    data: MakeHumanData, uniform: QuadMesh, head: Head, helmet: HelmetFit, noise: NoiseField
) -> Textures:
    """Make all images; fits the head's texture coordinates to the unit square."""
    colour, normals = _paint_uniform(uniform, noise)
    skin = _paint_head(data, head, helmet, noise)
    weave = _paint_weave(noise)
    return Textures(colour, normals, skin, weave, _paint_camouflage_tile(noise))


def _paint_uniform(uniform: QuadMesh, noise: NoiseField) -> tuple[bytes, bytes]:
    """Bake camouflage and wrinkles (as a tangent-space normal map) of the uniform."""
    points, covered = bake_attributes(uniform, uniform.vertices, _UNIFORM_SIZE)
    colour = np.zeros_like(points)
    height = np.zeros(covered.shape)
    seen = points[covered]
    grain = 0.92 + 0.16 * noise.generator.random((len(seen), 1))
    colour[covered] = camouflage(seen, noise) * grain
    height[covered] = wrinkle_height(seen, noise)
    normals = _normal_map(points, covered, height)
    colour = linear_to_srgb(fill_gutters(colour, covered))
    return encode_jpeg(colour), encode_jpeg(normals * 0.5 + 0.5)


def _normal_map(points: Array, covered: Mask, height: Array) -> Array:
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


def _paint_head(data: MakeHumanData, head: Head, helmet: HelmetFit, noise: NoiseField) -> bytes:
    """Fit the head's texture coordinates to the unit square and paint the skin."""
    skin = head.skin
    low, high = skin.uvs.reshape(-1, 2).min(0), skin.uvs.reshape(-1, 2).max(0)
    skin.uvs = (skin.uvs - low) / (high - low) * 0.98 + 0.01
    size = _SKIN_SIZE
    points, covered = bake_attributes(skin, skin.vertices, size)
    rows, columns = np.nonzero(covered)
    u = ((columns + 0.5) / size - 0.01) / 0.98 * (high - low)[0] + low[0]
    v = ((1 - (rows + 0.5) / size) - 0.01) / 0.98 * (high - low)[1] + low[1]
    lips = read_lips(data, np.column_stack([u, v]))
    eye_height = head.eye_centres[0][1]
    image = np.zeros((size, size, 3))
    image[covered] = paint_skin(points[covered], lips, eye_height, helmet.centre[2], noise)
    return encode_jpeg(linear_to_srgb(fill_gutters(image, covered)))


def _paint_weave(noise: NoiseField) -> bytes:
    """Draw woven nylon in grey; the kit's vertex colours tint it."""
    y, x = np.mgrid[0:_WEAVE_SIZE, 0:_WEAVE_SIZE]
    weave = 0.90 + 0.035 * np.sin(x * 2 * np.pi / 4) * np.sign(np.sin(y * 2 * np.pi / 8))
    weave = weave + 0.035 * np.sin(y * 2 * np.pi / 4)
    grain = 0.95 + 0.05 * noise.generator.random((_WEAVE_SIZE, _WEAVE_SIZE))
    return encode_png(np.repeat((weave * grain)[..., None], 3, 2))


def _paint_camouflage_tile(noise: NoiseField) -> bytes:
    """Draw a flat piece of the camouflage for helmet cover and pockets."""
    ticks = np.linspace(0, 1, _CAMOUFLAGE_SIZE, endpoint=False)
    y, x = np.meshgrid(ticks, ticks, indexing="ij")
    points = np.stack([x * _CAMOUFLAGE_TILE, y * _CAMOUFLAGE_TILE, 0 * x + 0.3], -1)
    return encode_jpeg(linear_to_srgb(camouflage(points, noise)))


def map_kit(parts: list[QuadMesh], helmet: HelmetFit) -> None:
    """Lay texture coordinates on the kit: camouflage or weave, to scale."""
    for part in parts:
        if not part.camouflaged:
            part.uvs = _box_projection(part, _WEAVE_TILES_PER_METRE)
            continue
        part.uvs = _box_projection(part, 1 / _CAMOUFLAGE_TILE) + 0.5
        if part.azimuthal:
            part.uvs = _azimuthal_projection(part, helmet)
        part.set_colour(1)


def _box_projection(part: QuadMesh, scale: float) -> Array:
    """Project each face along the axis that it faces most."""
    corners = part.vertices[part.faces]
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    facing = np.abs(normals).argmax(1)
    uvs = np.zeros((len(corners), 4, 2))
    for axis, plane in enumerate(((2, 1), (0, 2), (0, 1))):
        chosen = facing == axis
        uvs[chosen] = corners[chosen][..., list(plane)] * scale
    return uvs


def _azimuthal_projection(part: QuadMesh, helmet: HelmetFit) -> Array:
    """Spread a dome flat from its top, so that the pattern has no seam on it."""
    x, y, z = ((part.vertices - helmet.centre) / helmet.radii).T
    radius = np.arctan2(np.hypot(x, z), y) * 0.16 / _CAMOUFLAGE_TILE
    turn = np.arctan2(x, z)
    flat = np.column_stack([np.sin(turn) * radius + 0.5, np.cos(turn) * radius + 0.5])
    return flat[part.faces]
