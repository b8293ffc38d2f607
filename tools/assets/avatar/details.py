"""Fine structures that tile: weave, webbing, leather, skin, hair. One picture, layer beside layer.

R and G are the slope (0.5 is level), B brightens or darkens (0.5 leaves as it is).
"""

import numpy as np
from numpy.typing import NDArray

from .bake import encode_png
from .quad_mesh import Layer

Array = NDArray[np.float64]

SIZE = 256


def _tiled_noise(generator: np.random.Generator, cells: tuple[int, int]) -> Array:
    """Return smooth noise (0 to 1) that repeats, with so many cells down and across."""
    lattice = generator.random(cells)
    ticks = [np.arange(SIZE) / SIZE * n for n in cells]
    y, x = np.meshgrid(*ticks, indexing="ij")
    row, column = np.floor(y).astype(int), np.floor(x).astype(int)
    a, b = y - row, x - column
    a, b = a * a * (3 - 2 * a), b * b * (3 - 2 * b)

    def at(down: int, right: int) -> Array:
        return lattice[(row + down) % cells[0], (column + right) % cells[1]]

    return (at(0, 0) * (1 - b) + at(0, 1) * b) * (1 - a) + (at(1, 0) * (1 - b) + at(1, 1) * b) * a


def _weave(threads: int, twill: int) -> Array:
    """Return the height of woven threads; a twill shifts by a thread each row."""
    y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE * threads
    over = (
        (np.floor(x) + twill * np.floor(y)) % 2
        if twill == 1
        else (np.floor(x) + np.floor(y)) % 4 < 2
    )
    warp = np.sin(np.pi * (x % 1)) ** 0.7
    weft = np.sin(np.pi * (y % 1)) ** 0.7
    return np.where(over, warp * (0.6 + 0.4 * weft), weft * (0.6 + 0.4 * warp))


def _layer(height: Array, slope: float, tone: Array) -> Array:
    """Turn a height (0 to 1) and a tone (0 to 1) into a picture."""
    dx = np.roll(height, 1, 1) - np.roll(height, -1, 1)
    dy = np.roll(height, -1, 0) - np.roll(height, 1, 0)
    return np.stack([0.5 + dx * slope, 0.5 + dy * slope, np.clip(tone, 0, 1)], -1)


def _cordura(generator: np.random.Generator) -> Array:
    height = _weave(64, 1) * (0.75 + 0.5 * _tiled_noise(generator, (48, 48)))
    return _layer(height, 0.22, 0.36 + 0.22 * height + 0.06 * _tiled_noise(generator, (9, 9)))


def _webbing(generator: np.random.Generator) -> Array:
    """Ribs across a band that runs to the right; stitches along both edges."""
    y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE
    ribs = 0.5 + 0.5 * np.sin(2 * np.pi * 16 * x + 0.9 * np.sin(2 * np.pi * 6 * y))
    height = 0.55 * ribs + 0.12 * _tiled_noise(generator, (40, 40))
    tone = 0.40 + 0.14 * ribs
    for line in (0.16, 0.84):
        near = np.exp(-(((y - line) / 0.022) ** 2))
        stitch = (x * 8 % 1) < 0.62
        height = height * (1 - near) + near * np.where(stitch, 1.0, 0.05)
        tone = tone * (1 - near) + near * np.where(stitch, 0.62, 0.25)
    edge = np.clip(np.minimum(y, 1 - y) / 0.05, 0, 1)
    return _layer(height * edge, 0.30, tone * (0.7 + 0.3 * edge))


def _leather(generator: np.random.Generator) -> Array:
    points = generator.random((420, 2)) * SIZE
    y, x = np.mgrid[0:SIZE, 0:SIZE]
    nearest = np.full((2, SIZE, SIZE), 1e9)
    for py, px in points:
        dy, dx = np.abs(y - py), np.abs(x - px)
        distance = np.hypot(np.minimum(dy, SIZE - dy), np.minimum(dx, SIZE - dx))
        nearest[1] = np.minimum(nearest[1], np.maximum(nearest[0], distance))
        nearest[0] = np.minimum(nearest[0], distance)
    grain = np.clip((nearest[1] - nearest[0]) / 4, 0, 1)
    return _layer(grain, 0.16, 0.40 + 0.12 * grain + 0.06 * _tiled_noise(generator, (6, 6)))


def _twill(generator: np.random.Generator) -> Array:
    """A fine twill, its lines aslant."""
    height = _weave(48, 2) * (0.8 + 0.4 * _tiled_noise(generator, (64, 64)))
    return _layer(height, 0.17, 0.40 + 0.14 * height + 0.06 * _tiled_noise(generator, (5, 5)))


def _skin(generator: np.random.Generator) -> Array:
    pores = _tiled_noise(generator, (64, 64)) * 0.6 + _tiled_noise(generator, (110, 110)) * 0.4
    blotch = _tiled_noise(generator, (7, 7))
    return _layer(pores, 0.13, 0.42 + 0.07 * pores + 0.08 * blotch)


def _hair(generator: np.random.Generator) -> Array:
    strands = _tiled_noise(generator, (4, 120)) * 0.6 + _tiled_noise(generator, (3, 60)) * 0.4
    return _layer(strands, 0.30, 0.20 + 0.55 * strands)


def paint_details() -> bytes:
    """Draw all layers side by side, in the order of Layer; the smooth and the glowing are level."""
    generator = np.random.default_rng(11)
    level = np.full((SIZE, SIZE, 3), 0.5)
    layers = {
        Layer.CORDURA: _cordura(generator),
        Layer.WEBBING: _webbing(generator),
        Layer.LEATHER: _leather(generator),
        Layer.WEAVE: _twill(generator),
        Layer.SKIN: _skin(generator),
        Layer.HAIR: _hair(generator),
    }
    return encode_png(np.hstack([layers.get(layer, level) for layer in Layer]))
