"""Makes the desert's ground: scenes/world/desert/desert.height from desert_layout.json.

    cd tools/assets && python3 -m worlds.desert_heights

Dunes in the north-west, a wadi from north to south, a gravel plain, mesas on slopes of debris,
ground to try a tank on, a road that is level across. Needs numpy, scipy and zstandard.
"""

import json
import struct
from pathlib import Path

import numpy as np
import zstandard
from scipy.interpolate import CubicSpline
from scipy.ndimage import gaussian_filter, map_coordinates, shift
from scipy.spatial import cKDTree

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
LAYOUT = json.loads((HERE / "desert_layout.json").read_text(encoding="utf-8"))
CELL = LAYOUT["cell_m"]
SIDE = round(LAYOUT["edge_m"] / CELL) + 1
AXIS = (np.arange(SIDE) - (SIDE - 1) / 2) * CELL
# x towards the east (columns), z towards the south (rows), m.
X, Z = np.meshgrid(AXIS, AXIS)


def noise(length, seed, octaves=3, gain=0.5, stretch=(1.0, 1.0)):
    """Smooth noise of about -1 to 1 with features of a length in m; stretched along x, z."""
    total, weight, norm = np.zeros((SIDE, SIDE)), 1.0, 0.0
    for octave in range(octaves):
        rng = np.random.default_rng(seed + 31 * octave)
        scale = length / 2**octave
        count = int(LAYOUT["edge_m"] / scale) + 6
        grid = rng.normal(size=(count, count))
        rows = (Z - AXIS[0]) / (scale * stretch[1]) + 2
        columns = (X - AXIS[0]) / (scale * stretch[0]) + 2
        total += weight * map_coordinates(grid, [rows, columns], order=3, mode="grid-wrap")
        norm += weight**2
        weight *= gain
    return total / np.sqrt(norm) / 1.3


def step(field, low, high):
    """0 below low, 1 above high, smooth between."""
    t = np.clip((field - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def line(points, spacing=1.0):
    """A smooth line through points: places every spacing m."""
    points = np.array(points, dtype=float)
    run = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    spline = CubicSpline(run, points)
    return spline(np.arange(0, run[-1], spacing))


def away(places):
    """Distance of each point from a line, and the number of the line's nearest place."""
    tree = cKDTree(places)
    distance, which = tree.query(np.stack([X.ravel(), Z.ravel()], 1))
    return distance.reshape(X.shape), which.reshape(X.shape)


def from_box(low, high):
    """Distance of each point from a rectangle, m."""
    dx = np.maximum(np.maximum(low[0] - X, X - high[0]), 0)
    dz = np.maximum(np.maximum(low[1] - Z, Z - high[1]), 0)
    return np.hypot(dx, dz)


def dunes():
    """Transverse dunes: gentle to windward (west), steep to leeward, with crests that wander."""
    height = np.zeros_like(X)
    for length, tall, seed, bend in ((64.0, 6.2, 5, 26.0), (27.0, 1.9, 6, 11.0)):
        phase = (X * 0.86 + Z * 0.5 + bend * noise(90.0, seed, 2)) / length
        part = phase - np.floor(phase)
        top = 0.72
        wave = np.where(part < top, step(part, 0, top), 1 - step(part, top, 1.0))
        wave = gaussian_filter(wave, 1.2 / CELL)
        crest = step(noise(75.0, seed + 40, 2), -0.75, 0.75)
        height += tall * wave * (0.25 + 0.75 * crest)
    return height


def where_dunes():
    """How far dunes cover the ground, 0 to 1: the north-west, with fingers."""
    edge = (-X - 0.75 * Z) / 1.25 + 26 * noise(80.0, 11, 3)
    return step(edge, 35, 130)


def base():
    """Rolling ground with bumps that a tank feels."""
    height = 3.6 * noise(150.0, 1, 3) + 0.55 * noise(26.0, 2, 2) + 0.11 * noise(6.5, 3, 2)
    bumpy = step(noise(60.0, 4, 2), 0.1, 0.8)
    return height + bumpy * 0.16 * noise(3.4, 8, 1)


def add_mesas(height, paint):
    """Slopes of debris at the feet of the rocks, and rock below them."""
    for rock in LAYOUT["mesas"] + LAYOUT["needles"]:
        distance = np.hypot(X - rock["at"][0], Z - rock["at"][1])
        distance = distance + rock["radius"] * 0.16 * noise(9.0, rock["seed"], 2)
        reach = rock["radius"] * 0.9 + rock["height"] * 0.55
        slope = np.clip(1 - (distance - rock["radius"] * 0.55) / reach, 0, 1)
        rough = 1 + 0.35 * noise(4.0, rock["seed"] + 50, 2)
        height += rock["height"] * 0.30 * slope**1.9 * rough
        near = step(distance, rock["radius"] * 1.55, rock["radius"] * 0.95)
        paint[..., 0] = np.maximum(
            paint[..., 0], step(distance, rock["radius"] * 2.6, rock["radius"])
        )
        paint[..., 1] = np.maximum(paint[..., 1], near * step(noise(5.0, rock["seed"]), -0.6, 0.5))
    return height


def add_wadi(height, paint):
    """A dry river bed with banks; the road goes through it by a ford."""
    places = line(LAYOUT["wadi"])
    distance, which = away(places)
    along = gaussian_filter(height[to_index(places[:, 1]), to_index(places[:, 0])], 40)
    along = np.minimum.accumulate(along)
    depth, half = LAYOUT["wadi_depth_m"], LAYOUT["wadi_half_width_m"]
    wide = half * (1 + 0.35 * noise(38.0, 60, 2))
    bed = along[which] - depth + 0.12 * noise(5.0, 61, 2) + 0.35 * step(distance, 0, wide)
    cut = step(distance, wide + 7.0 + 3 * noise(14.0, 62, 2), wide)
    height = height * (1 - cut) + np.minimum(bed, height) * cut
    paint[..., 3] = np.maximum(paint[..., 3], step(distance, wide * 0.95, wide * 0.55))
    bars = step(noise(11.0, 63, 2, stretch=(1, 2)), 0.25, 0.6) * step(distance, wide, wide * 0.8)
    paint[..., 0] = np.maximum(paint[..., 0], bars)
    paint[..., 3] *= 1 - 0.9 * bars
    return height


def limit_slopes(height, steepest):
    """Lowers what stands too steep: banks slide, and the physics keeps heights exactly."""
    for reach in (16, 8, 4, 2, 1, 1, 2, 1):
        for dz, dx in ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (1, -1), (-1, 1), (-1, -1)):
            padded = np.pad(height, reach, mode="edge")
            rows = slice(reach + dz * reach, reach + dz * reach + SIDE)
            columns = slice(reach + dx * reach, reach + dx * reach + SIDE)
            far = steepest * reach * CELL * np.hypot(dx, dz)
            height = np.minimum(height, padded[rows, columns] + far)
    return height


def to_index(values):
    """Rows or columns of coordinates."""
    return np.clip(np.round((values - AXIS[0]) / CELL).astype(int), 0, SIDE - 1)


def add_tank_ground(height, paint):
    """Even ground with waves, two ramps up to a table, and a trench."""
    area = LAYOUT["bumps"]
    inside = step(from_box(area["from"], area["to"]), 14, 0)
    even = gaussian_filter(height, 12 / CELL)
    waves = 0.42 * np.sin((Z - area["from"][1]) * 2 * np.pi / 8.0)
    waves += 0.22 * np.sin((X - area["from"][0]) * 2 * np.pi / 11.0 + Z * 0.3)
    height = height * (1 - inside) + (even + waves * step(inside, 0.7, 1.0)) * inside
    ramp = LAYOUT["ramps"]
    dx, dz = X - ramp["at"][0], Z - ramp["at"][1]
    floor = even[to_index(np.array(ramp["at"][1])), to_index(np.array(ramp["at"][0]))]
    top, (gentle, steep) = ramp["height"], ramp["slopes"]
    table = np.minimum(
        np.where(
            dz < 0, top - np.maximum(-dz - 5, 0) * gentle, top - np.maximum(dz - 5, 0) * steep
        ),
        top - np.maximum(np.abs(dx) - 6, 0) * 0.8,
    )
    raised = gaussian_filter(np.maximum(table, 0), 0.6 / CELL)
    near = step(
        from_box(
            [ramp["at"][0] - 14, ramp["at"][1] - 26], [ramp["at"][0] + 14, ramp["at"][1] + 18]
        ),
        10,
        0,
    )
    height = height * (1 - near) + (even * 0.4 + floor * 0.6 + raised) * near
    trench = LAYOUT["trench"]
    dx, dz = np.abs(X - trench["at"][0]), np.abs(Z - trench["at"][1])
    cut = step(dx, trench["width"] / 2 + 0.5, trench["width"] / 2 - 0.1)
    cut *= step(dz, trench["length"] / 2 + 1.0, trench["length"] / 2 - 1.0)
    rim = step(dx, 3.4, 2.0) * step(dz, trench["length"] / 2 + 2, trench["length"] / 2) * (1 - cut)
    height = height - trench["depth"] * cut + 0.35 * rim
    paint[..., 0] = np.maximum(
        paint[..., 0], 0.5 * np.maximum(inside, near) * step(noise(6.0, 70), 0, 0.6)
    )
    return height


def add_road(height, paint):
    """A road, level across, with ditches that sand fills, and the tracks of wheels beside it."""
    places = line(LAYOUT["road"])
    distance, which = away(places)
    along = gaussian_filter(height[to_index(places[:, 1]), to_index(places[:, 0])], 18)
    in_town = step(places[:, 0], 78, 94) * step(places[:, 0], 222, 206)
    along = along * (1 - in_town)
    half = LAYOUT["road_half_width_m"]
    level = (
        along[which] + 0.10 - 0.05 * (distance / half) ** 2 - 0.25 * step(distance, half, half + 2)
    )
    blend = step(distance, half + 11, half + 0.5)
    height = height * (1 - blend) + level * blend
    worn = 0.55 * noise(7.0, 80, 2) + 0.4 * noise(2.4, 81, 1)
    paint[..., 2] = step(distance + 0.55 * worn, half + 0.25, half - 0.75)
    paint[..., 2] *= 1 - 0.85 * step(noise(30.0, 82, 3), 0.75, 1.3)
    side = step(distance, half + 5.5, half) * (1 - paint[..., 2])
    paint[..., 0] = np.maximum(paint[..., 0], 0.75 * side * step(noise(5.0, 83, 2), -0.5, 0.5))
    for keep in (0, 1, 3):
        if keep != 0:
            paint[..., keep] *= 1 - step(distance, half + 4, half)
    for track in LAYOUT["tracks"]:
        distance, _ = away(line(track, 0.5))
        distance = distance + 0.25 * noise(12.0, 84, 2)
        rut = np.exp(-(((distance - 0.95) / 0.30) ** 2))
        bed = step(distance, 4.5, 1.5)
        height = height * (1 - 0.8 * bed) + gaussian_filter(height, 3.0 / CELL) * 0.8 * bed
        height -= 0.09 * rut
        height += 0.06 * np.exp(-(((distance - 1.7) / 0.35) ** 2))
        paint[..., 0] = np.maximum(paint[..., 0] * (1 - 0.5 * bed), 0.9 * rut)
    return height


def sky_share(height, tops):
    """Share of the sky that each point sees, over the ground and what stands on it."""
    seen = np.zeros_like(height)
    directions = 16
    high = np.maximum(height, tops)
    for number in range(directions):
        angle = 2 * np.pi * (number + 0.5) / directions
        horizon = np.zeros_like(height)
        for reach in (0.7, 1.2, 2.0, 3.2, 5.0, 8.0, 12.5, 19.0, 28.0, 42.0, 65.0):
            dx, dz = np.cos(angle) * reach / CELL, np.sin(angle) * reach / CELL
            moved = shift(high, (-dz, -dx), order=1, mode="nearest", prefilter=False)
            horizon = np.maximum(horizon, (moved - height) / reach)
        seen += 1 - (horizon / np.sqrt(1 + horizon**2)) ** 2
    return seen / directions


def tops_of_rocks(height):
    """How high what stands on the ground reaches, for its shade."""
    tops = np.full_like(height, -1e3)
    for rock in LAYOUT["mesas"] + LAYOUT["needles"]:
        distance = np.hypot(X - rock["at"][0], Z - rock["at"][1])
        inside = distance < rock["radius"] * 0.92
        ground = height[to_index(np.array(rock["at"][1])), to_index(np.array(rock["at"][0]))]
        tops = np.where(inside, np.maximum(tops, ground + rock["height"] * 0.85), tops)
    return tops


def make():
    """Heights (m), paint (0 to 1: gravel, rock, road, clay) and share of the sky."""
    paint = np.zeros((SIDE, SIDE, 4))
    sandy = where_dunes()
    height = base() * (1 - 0.5 * sandy) + dunes() * sandy + 0.9 * sandy
    plain = step(noise(70.0, 20, 3) - 1.1 * sandy, -0.1, 0.9)
    paint[..., 0] = 0.85 * plain
    height = add_mesas(height, paint)
    height = add_wadi(height, paint)
    height = gaussian_filter(limit_slopes(height, 0.95), 0.5)
    height = add_tank_ground(height, paint)
    height = add_road(height, paint)
    town = LAYOUT["town"]
    flat = step(from_box(town["from"], town["to"]), 26, 2)
    height = height * (1 - flat)
    # The town has floors of its own at 0: they must not lie in the same plane.
    height -= 0.06 * step(from_box(town["from"], town["to"]), 4, 0)
    keep = step(from_box(town["from"], town["to"]), 0, 12)
    paint[..., 0] = paint[..., 0] * keep + 0.35 * (1 - keep) * step(noise(9.0, 90, 2), -0.2, 0.7)
    paint[..., 1] *= keep
    paint[..., 3] *= keep
    # Nothing but ground may stand at the edge: hills go on from there.
    border = step(np.maximum(np.abs(X), np.abs(Z)), 225, 250)
    height = height * (1 - border) + gaussian_filter(height, 6 / CELL) * border
    return height, np.clip(paint, 0, 1), sky_share(height, tops_of_rocks(height))


def main() -> None:
    """Writes the file, in the format of HeightFile."""
    height, paint, light = make()
    rounded = np.round(height * 1024) / 1024
    body = rounded.astype("<f4").tobytes()
    body += (paint * 255 + 0.5).astype(np.uint8).tobytes()
    body += (np.clip(light, 0, 1) * 255 + 0.5).astype(np.uint8).tobytes()
    packed = zstandard.ZstdCompressor(level=19).compress(body)
    header = b"DMTH" + struct.pack("<HHIIfI", 1, 0, SIDE, SIDE, CELL, len(packed))
    target = PROJECT / "scenes/world/desert/desert.height"
    target.write_bytes(header + packed)
    print(
        f"{target.name}: {target.stat().st_size / 1e6:.1f} MB, "
        f"{height.min():.1f} to {height.max():.1f} m"
    )


if __name__ == "__main__":
    main()
