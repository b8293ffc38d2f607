# SPDX-License-Identifier: MIT
"""Looks at pixels of a real window: the three worlds of the thesis."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import pytest
from toolchain.paths import CLIPS

from .conftest import World

MIN_SHADOWED = 55.0
"""Of 255: median brightness of a back in the shade."""
Pixel = tuple[int, int, int]


def read_png(path: Path) -> list[list[Pixel]]:
    """Rows of red, green, blue of an 8-bit RGB or RGBA picture."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, header = 8, b"", b""
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        kind, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        header = body if kind == b"IHDR" else header
        packed += body if kind == b"IDAT" else b""
        at += 12 + size
    width, height, depth, colour = struct.unpack(">IIBB", header[:10])
    assert depth == 8
    step = {2: 3, 6: 4}[colour]
    raw, rows = zlib.decompress(packed), []
    previous = bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        line = _unfilter(
            raw[start], bytearray(raw[start + 1 : start + 1 + width * step]), previous, step
        )
        rows.append([tuple(line[x : x + 3]) for x in range(0, width * step, step)])
        previous = line
    return rows


def _unfilter(kind: int, line: bytearray, above: bytearray, step: int) -> bytearray:
    for i in range(len(line)):
        left = line[i - step] if i >= step else 0
        up = above[i]
        corner = above[i - step] if i >= step else 0
        if kind == 1:
            line[i] = (line[i] + left) & 255
        elif kind == 2:
            line[i] = (line[i] + up) & 255
        elif kind == 3:
            line[i] = (line[i] + (left + up) // 2) & 255
        elif kind == 4:
            guess = left + up - corner
            distances = abs(guess - left), abs(guess - up), abs(guess - corner)
            line[i] = (line[i] + (left, up, corner)[distances.index(min(distances))]) & 255
    return line


def share(rows: list[list[Pixel]], wanted) -> float:
    """Share of the pixels that a test holds for, without the lines of text."""
    inner = [pixel for row in rows[30:-40] for pixel in row]
    return sum(1 for pixel in inner if wanted(*pixel)) / len(inner)


def is_wire_of_limb(red: int, green: int, blue: int) -> bool:
    return green > 180 and red < 110 and blue < 150


def is_wood(red: int, green: int, blue: int) -> bool:
    return red > 80 and red > green * 1.08 and green > blue * 1.08


def is_wire_of_hall(red: int, green: int, blue: int) -> bool:
    return blue > 180 and red < 130 and blue > green + 40


def still_clip(folder: Path) -> Path:
    """Somebody who stands as at the beginning of a clip."""
    head, _, frames = (CLIPS / "01_01.bvh").read_text(encoding="ascii").partition("Frame Time:")
    first = frames.splitlines()[1]
    skeleton = head[: head.index("Frames:")]
    made = folder / "still.bvh"
    lines = [f"{skeleton}Frames: 200", "Frame Time: 0.0166667", *[first] * 200]
    made.write_text("\n".join(lines) + "\n", encoding="ascii")
    return made


@pytest.fixture
def pictures(world: World, display: dict[str, str]):
    """Takes a picture of some worlds; the trainee stands still, so that all show the same."""
    world.server()
    world.trainee(clip=str(still_clip(world.folder))).await_text("joined")

    def take(views: str) -> list[list[Pixel]]:
        target = world.folder / f"{views}.png"
        options = [f"--views={views}", "--camera=30,25,7"]
        world.take_picture(display, target, *options, name=f"observer-{views}")
        return read_png(target)

    return take


def test_the_three_worlds(pictures) -> None:
    mesh = pictures("mesh")
    static = pictures("static")
    physics = pictures("physics")
    both = pictures("mesh,static,physics")
    # Wire frames of limbs and of the hall are in the physics world alone.
    assert share(mesh, is_wire_of_limb) < 0.0002
    assert share(static, is_wire_of_limb) < 0.0002
    assert share(physics, is_wire_of_limb) > 0.001
    assert share(both, is_wire_of_limb) > 0.0005
    assert share(physics, is_wire_of_hall) > 0.002
    assert share(mesh, is_wire_of_hall) < 0.0005
    # Crates belong to the mesh world, not to the static one.
    assert share(mesh, is_wood) > 0.005
    assert share(static, is_wood) < 0.0005
    # The pictures are of different moments: crates that are pushed show more or less of themselves.
    assert share(physics, is_wood) < share(mesh, is_wood) * 0.75


def test_the_picture_changes_while_the_person_moves(world: World, display: dict[str, str]) -> None:
    world.server()
    world.trainee().await_text("joined")
    shots = []
    for number in (1, 2):
        target = world.folder / f"{number}.png"
        world.take_picture(display, target, name=f"observer{number}")
        shots.append(read_png(target))
    pairs = [(a, b) for x, y in zip(*shots, strict=True) for a, b in zip(x, y, strict=True)]
    changed = sum(1 for a, b in pairs if max(abs(p - q) for p, q in zip(a, b, strict=True)) > 40)
    assert changed > 300


def test_the_shadowed_side_of_a_person_is_readable(world: World, display: dict[str, str]) -> None:
    """The sun shines from azimuth 35 degrees; the camera looks at the other side."""
    world.server()
    world.trainee().await_text("joined")
    target = world.folder / "shadow.png"
    options = ["--views=mesh,static", "--camera=215,5,2.2"]
    world.take_picture(display, target, *options, name="observer")
    rows = read_png(target)
    # The hips are in the middle, 640x360: back, belt and thighs are around it.
    body = [pixel for row in rows[120:240] for pixel in row[300:340]]
    light = sorted(0.2126 * red + 0.7152 * green + 0.0722 * blue for red, green, blue in body)
    assert light[len(light) // 2] > MIN_SHADOWED, light[len(light) // 2]
    # It has parts that differ: light does not wash out cloth, belt and pouches.
    assert light[len(light) * 9 // 10] > 1.4 * light[len(light) // 10]
