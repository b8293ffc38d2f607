"""An avatar's pictures and the texture coordinates of its kit."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .bake import bake_attributes, encode_jpeg, fill_gutters, linear_to_srgb
from .bare_parts import Head
from .cloth_paint import ClothPicture, paint_cloth
from .figure import Figure
from .head_kit import HelmetFit
from .makehuman import MakeHumanData
from .noise import NoiseField
from .patterns import PATTERNS, ClothPoints
from .quad_mesh import Layer, QuadMesh
from .recipe import Clothes, Face, Recipe
from .skin_paint import FacePlace, paint_eye, paint_skin, read_lips

Array = NDArray[np.float64]

_CLOTH_SIZE, _SKIN_SIZE, _TILE_SIZE = 2048, 1024, 512
_TILE = 0.8
"""Metres of cloth on one tile of the kit's cloth."""
_TILES_PER_METRE = {Layer.SKIN: 16.0, Layer.HAIR: 9.0, Layer.LEATHER: 20.0}
_WEAVE_PER_METRE = 13.0


@dataclass
class Textures:
    """Linear RGB; of the cloth also its normals."""

    cloth: ClothPicture
    skin: Array
    eyes: Array | None
    """None for a blank face."""
    tile: Array | None
    """The cloth's pattern for pockets and helmet covers; only where there are any."""

    def encode(self) -> dict[str, bytes]:
        """Return the files by their names' endings."""
        files = {
            "cloth.jpg": encode_jpeg(linear_to_srgb(self.cloth.colour)),
            "cloth_normals.jpg": encode_jpeg(self.cloth.normals * 0.5 + 0.5),
            "skin.jpg": encode_jpeg(linear_to_srgb(self.skin)),
        }
        if self.eyes is not None:
            files["eyes.jpg"] = encode_jpeg(linear_to_srgb(self.eyes))
        if self.tile is not None:
            files["tile.jpg"] = encode_jpeg(linear_to_srgb(self.tile))
        return files


def paint_textures(
    data: MakeHumanData,
    figure: Figure,
    recipe: Recipe,
    uniform: QuadMesh,
    head: Head,
    has_tile: bool,
) -> Textures:
    """Make all pictures; fits the head's texture coordinates to the unit square."""
    cloth = paint_cloth(figure, uniform, recipe.clothes, _CLOTH_SIZE)
    skin = _paint_head(data, head, recipe.face, figure.noise)
    eyes = None if recipe.face.is_blank else paint_eye(recipe.face)
    tile = _paint_tile(recipe.clothes, figure.noise) if has_tile else None
    return Textures(cloth, skin, eyes, tile)


def _paint_head(data: MakeHumanData, head: Head, face: Face, noise: NoiseField) -> Array:
    """Fit the head's texture coordinates to the unit square and paint the skin."""
    skin = head.skin
    low, high = skin.uvs.reshape(-1, 2).min(0), skin.uvs.reshape(-1, 2).max(0)
    skin.uvs = (skin.uvs - low) / (high - low) * 0.98 + 0.01
    skin.is_mapped = True
    size = _SKIN_SIZE
    points, covered = bake_attributes(skin, skin.vertices, size)
    rows, columns = np.nonzero(covered)
    u = ((columns + 0.5) / size - 0.01) / 0.98 * (high - low)[0] + low[0]
    v = ((1 - (rows + 0.5) / size) - 0.01) / 0.98 * (high - low)[1] + low[1]
    lips = read_lips(data, np.column_stack([u, v]))
    eye = head.eyes[0].vertices
    radius = float(np.linalg.norm(eye - head.eye_centres[0], axis=1).max())
    middle = (skin.vertices[:, 2].min() + skin.vertices[:, 2].max()) / 2 + 0.005
    place = FacePlace(head.eye_centres[0], radius, middle)
    image = np.zeros((size, size, 3))
    image[covered] = np.clip(paint_skin(points[covered], lips, place, face, noise), 0.002, 1)
    return fill_gutters(image, covered)


def paint_flesh(hands: QuadMesh, face: Face, noise: NoiseField) -> None:
    """Colour bare hands and arms by vertex: warmer knuckles, paler palms."""
    points = hands.vertices
    tone = face.tone * (0.88 + 0.24 * noise.layered(points * 45, 3))[:, None]
    normals = hands.normals()
    palm = np.clip(-normals[:, 1] * 0.5 - 0.1, 0, 0.4)[:, None]
    hands.colours = tone * (1 - palm) + (face.tone * 1.18 + 0.012) * palm
    hands.layer, hands.gloss = Layer.SKIN, 0.35


def _paint_tile(clothes: Clothes, noise: NoiseField) -> Array:
    """Draw a flat piece of the pattern."""
    ticks = np.linspace(0, 1, _TILE_SIZE, endpoint=False)
    y, x = np.meshgrid(ticks, ticks, indexing="ij")
    points = np.stack([x * _TILE, y * _TILE, 0 * x + 0.3], -1).reshape(-1, 3)
    cloth = ClothPoints(points, 10.0, np.array([0, -10.0, 0]))
    colour = PATTERNS[clothes.pattern](cloth, clothes.colours, noise)
    return colour.reshape(_TILE_SIZE, _TILE_SIZE, 3)


def map_kit(parts: list[QuadMesh], helmet: HelmetFit) -> None:
    """Lay texture coordinates on the kit: pattern or fine structure, to scale."""
    for part in parts:
        if part.is_mapped:
            continue
        if not part.camouflaged:
            part.uvs = _box_projection(part, _TILES_PER_METRE.get(part.layer, _WEAVE_PER_METRE))
            continue
        part.uvs = _box_projection(part, 1 / _TILE) + 0.5
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
    radius = np.arctan2(np.hypot(x, z), y) * 0.16 / _TILE
    turn = np.arctan2(x, z)
    flat = np.column_stack([np.sin(turn) * radius + 0.5, np.cos(turn) * radius + 0.5])
    return flat[part.faces]
