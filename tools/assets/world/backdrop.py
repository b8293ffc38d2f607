# SPDX-License-Identifier: MIT
"""Paints the backdrop of the stage: a low sun between rays over dunes, as a printed cloth.

python3 -m world.backdrop OUT.jpg, in tools/assets.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from PIL import Image

WIDTH, HEIGHT = 2048, 1024
SUPER = 2
"""Painted so many times larger, for smooth edges."""
SKY = [
    (0.00, (18, 16, 48)),
    (0.30, (58, 28, 92)),
    (0.52, (148, 40, 104)),
    (0.68, (226, 84, 78)),
    (0.80, (250, 160, 84)),
    (1.00, (255, 206, 120)),
]
"""Share of the height from above, sRGB."""
SUN = (0.5, 0.60, 0.200)
"""Middle (shares of width and height) and radius (share of the height)."""
RANGES = [
    (0.70, 0.050, 3.1, (122, 48, 96)),
    (0.77, 0.060, 2.1, (92, 38, 88)),
    (0.85, 0.050, 1.4, (60, 28, 74)),
    (0.93, 0.040, 0.9, (30, 18, 52)),
]
"""Dunes: height of the crest from above, its waves' height, waves across, sRGB."""


def gradient(share: np.ndarray) -> np.ndarray:
    """Colours of the sky at shares of the height."""
    stops = [stop for stop, _colour in SKY]
    columns = [np.interp(share, stops, [c[i] for _s, c in SKY]) for i in range(3)]
    return np.stack(columns, axis=-1)


def crest(x: np.ndarray, number: int, waves: float) -> np.ndarray:
    """The outline of a range of dunes from -1 to 1: long slopes to windward, short ones to lee."""
    rng = np.random.default_rng(number + 7)
    line = np.zeros_like(x)
    for octave in range(4):
        turn = x * waves * 2.3**octave + rng.uniform(0.0, 1.0)
        saw = turn - np.floor(turn)
        line += np.minimum(saw / 0.72, (1.0 - saw) / 0.28) * 0.5**octave
    return line / 0.94 - 1.0


def paint() -> np.ndarray:
    """The picture, float sRGB."""
    wide, high = WIDTH * SUPER, HEIGHT * SUPER
    y, x = np.mgrid[0:high, 0:wide].astype(np.float32)
    u, v = x / wide, y / high
    picture = gradient(v).astype(np.float32)
    right, down = (u - SUN[0]) * wide / high, v - SUN[1]
    distance = np.hypot(right, down)
    # Rays, wider apart the farther from the sun, that fade upwards.
    angle = np.arctan2(right, -down) / np.pi * 21.0
    ray = ((angle - np.floor(angle)) < 0.5) & (distance > SUN[2])
    fade = np.clip(1.15 - distance * 1.05, 0.0, 1.0)[..., None]
    picture += ray[..., None] * fade * np.array([34.0, 18.0, 8.0], np.float32)
    stars(picture)
    # The sun: a disc with bands that get wider downwards, and a thin ring.
    disc = distance < SUN[2]
    band = (down / SUN[2] + 0.15) * 5.0
    gap = (band > 0.0) & ((band - np.floor(band)) < 0.12 + 0.09 * np.floor(band))
    glow = np.clip(1.0 - (distance - SUN[2]) * 3.2, 0.0, 1.0)[..., None] ** 2
    picture += np.where(disc[..., None], 0.0, glow) * np.array([46.0, 30.0, 6.0], np.float32)
    face = np.array([255, 226, 150], np.float32) + down[..., None] * np.array([0, -260, -300])
    picture = np.where((disc & ~gap)[..., None], face, picture)
    ring = np.abs(distance - SUN[2] * 1.14) < 0.0035
    picture = np.where(ring[..., None], np.array([255, 214, 140], np.float32), picture)
    for number, (top, size, waves, colour) in enumerate(RANGES):
        edge = top - size * crest(u[0], number, waves)
        below = v >= edge[None, :]
        # Each is paler towards its foot: dust between them.
        depth = np.clip((v - edge[None, :]) / 0.14, 0.0, 1.0)[..., None]
        tone = np.array(colour, np.float32) * (0.86 + 0.5 * depth)
        rim = np.clip(1.0 - (v - edge[None, :]) / 0.006, 0.0, 1.0)[..., None]
        tone = tone + rim * np.array([120.0, 60.0, 30.0], np.float32)
        picture = np.where(below[..., None], tone, picture)
    return picture


def stars(picture: np.ndarray) -> None:
    """Small stars in the dark upper part."""
    rng = np.random.default_rng(3)
    high, wide = picture.shape[:2]
    for _ in range(420):
        row = int(rng.uniform(0.0, 0.42) ** 1.2 * high)
        column = int(rng.uniform(0.0, 1.0) * wide)
        size = int(rng.integers(2, 6))
        light = rng.uniform(60.0, 190.0) * (1.0 - row / (0.45 * high))
        picture[row : row + size, column : column + size] += light


def main(arguments: list[str]) -> int:
    """Paints it into the named file."""
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    picture = paint()
    rng = np.random.default_rng(1)
    weave = rng.normal(0.0, 3.0, picture.shape[:2]).astype(np.float32)[..., None]
    pixels = np.clip(picture + weave, 0.0, 255.0).astype(np.uint8)
    image = Image.fromarray(pixels).resize((WIDTH, HEIGHT), Image.LANCZOS)
    Path(arguments[0]).parent.mkdir(parents=True, exist_ok=True)
    image.save(arguments[0], quality=88)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
