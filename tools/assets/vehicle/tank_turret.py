"""The battle tank's turret: armour, gun, hatches, sights, antennas, the wells below the hatches."""

import math
import random

from . import parts, shapes, tank_roof, tank_wells
from .tank_hull import TURRET_AT
from .tank_wells import COMMANDER, COMMANDER_RADIUS, LOADER, LOADER_RADIUS, ROOF

LOW = [
    (0.44, 1.98),
    (1.50, 0.70),
    (1.62, -0.95),
    (1.38, -2.50),
    (-1.38, -2.50),
    (-1.62, -0.95),
    (-1.50, 0.70),
    (-0.44, 1.98),
]
TOP = [
    (0.42, 1.42),
    (1.26, 0.42),
    (1.36, -0.90),
    (1.18, -2.40),
    (-1.18, -2.40),
    (-1.36, -0.90),
    (-1.26, 0.42),
    (-0.42, 1.42),
]


def make(materials, body):
    """Builds the turret and all on it; returns its part."""
    m = {name: material.made for name, material in materials.items()}
    turret = shell(m, body)
    tank_wells.make(m, turret)
    cheeks(m, turret)
    rack(m, turret)
    tank_roof.roof(m, turret)
    tank_roof.hatches(m, turret)
    tank_roof.machine_gun(m, turret)
    tank_roof.antennas(m, turret)
    gun(m, turret)
    return turret


def shell(m, body):
    """The armour, with holes for the hatches and the mantlet."""
    bm = parts.new()
    foot = [(a * 0.90, b * 0.93) for a, b in LOW]
    rings = [[(x, y, 0.075) for x, y in foot], [(x, y, 0.27) for x, y in LOW]]
    rings.append([(x, y, ROOF - (0.05 if y > 1 else 0.0)) for x, y in TOP])
    shapes.loft(bm, rings)
    turret = parts.add("Turret", bm, m["Paint"], body, bevel=0.024, at=TURRET_AT)
    for (x, y), radius in ((COMMANDER, COMMANDER_RADIUS + 0.03), (LOADER, LOADER_RADIUS + 0.03)):
        hole = parts.new()
        shapes.lathe(
            hole, [(-0.2, 0), (-0.2, radius), (1.0, radius), (1.0, 0)], (x, y, 0), steps=36
        )
        parts.cut(turret, hole)
    slot = parts.new()  # Where the mantlet turns.
    shapes.box(slot, -0.43, 0.43, 1.20, 2.3, 0.12, 0.66)
    parts.cut(turret, slot)
    dark = parts.new()
    shapes.box(dark, -0.42, 0.42, 1.16, 1.22, 0.13, 0.65)
    shapes.ring(dark, (0, 0, -0.02), (0, 0, 1), 0.99, 1.09, 0, 0.12, 36)
    parts.add("TurretRing", dark, m["Dark"], turret)
    return turret


def cheeks(m, turret):
    """Wedges of added armour in blocks, side boxes, smoke launchers, lifting eyes."""
    paint, steel, dark = parts.new(), parts.new(), parts.new()
    for s in (-1, 1):
        # Added armour lies along the front faces in four blocks with gaps.
        for k in range(4):
            a, b = (k + 0.03) / 4, (k + 0.97) / 4
            ends = []
            for share in (a, b):
                lx, ly = 0.50 + (1.50 - 0.50) * share, 1.93 + (0.70 - 1.93) * share
                tx, ty = 0.50 + (1.26 - 0.50) * share, 1.34 + (0.42 - 1.34) * share
                nx, ny = 0.07, 0.06
                ends.append(
                    [
                        (s * (lx + nx), ly + ny, 0.29),
                        (s * (tx + nx * 0.6), ty + ny * 0.6, ROOF - 0.075),
                    ]
                    + [
                        (s * (tx - 0.02), ty - 0.02, ROOF - 0.02),
                        (s * (lx - 0.02), ly - 0.02, 0.27),
                    ]
                )
            shapes.loft(paint, ends)
        # Boxes along the sides, and the launchers before them.
        for y0, y1 in ((-2.36, -1.66), (-1.62, -0.98)):
            x_low, x_top = 1.40 + 0.10 * (y1 + 2.4), 1.24 + 0.10 * (y1 + 2.4)
            ring = [
                (s * (x_low - 0.10), 0.30),
                (s * (x_low + 0.14), 0.32),
                (s * (x_top + 0.17), 0.66),
                (s * (x_top - 0.04), 0.70),
            ]
            shapes.loft(paint, [[(x, y, z) for x, z in ring] for y in (y0, y1)])
            for y in (y0 + 0.16, y1 - 0.16):
                shapes.box(
                    steel,
                    s * (x_low + 0.045),
                    s * (x_low + 0.078),
                    y - 0.025,
                    y + 0.025,
                    0.50,
                    0.60,
                )
            shapes.handle(
                steel,
                (s * (x_low + 0.105), y0 + 0.26, 0.40),
                (s * (x_low + 0.105), y1 - 0.26, 0.40),
                (s * 0.035, 0, 0),
                0.008,
            )
        for i in range(4):
            for row in range(2):
                a = math.radians(18 + 18 * i)
                way = (s * math.sin(a) * 0.9, math.cos(a) * 0.9, 0.38)
                base = (s * 1.585, -0.30 - 0.145 * i, 0.36 + 0.14 * row)
                pipe = [(0, 0), (0, 0.052), (0.20, 0.052), (0.20, 0.040), (0.17, 0.039), (0.17, 0)]
                shapes.lathe(dark, pipe, base, way, 10)
        shapes.box(paint, s * 1.46, s * 1.60, -0.86, -0.20, 0.28, 0.34)
        for y, z in ((0.55, ROOF - 0.02), (-2.25, ROOF - 0.02)):
            shapes.eye(
                steel, (s * (1.20 if y > 0 else 1.06), y, z + 0.03), (1, 0, 0.2), 0.045, 0.014
            )
        # The face between the blocks and the launchers carries the number.
        lean = math.degrees(math.atan2(0.26, 0.47))
        parts.text(
            f"Number{s}",
            "214",
            m["Stencil"],
            turret,
            (s * 1.432, 0.15, 0.475),
            0.26,
            (90 - lean, 0, s * 94.2),
        )
    parts.add("TurretCheeks", paint, m["Paint"], turret, bevel=0.012)
    parts.add("TurretCheekSteel", steel, m["Steel"], turret, smooth_deg=32)
    parts.add("SmokeLaunchers", dark, m["Plain"], turret, smooth_deg=32)


def rack(m, turret):
    """The bustle rack with what is stowed in it."""
    steel, canvas, boxes = parts.new(), parts.new(), parts.new()
    for z in (0.14, 0.32, 0.50, 0.66):
        bar = [(-1.22, -2.46, z), (-1.22, -3.02, z), (1.22, -3.02, z), (1.22, -2.46, z)]
        shapes.tube(steel, bar, 0.015 if z < 0.6 else 0.019, 6)
    for k in range(9):
        x = -1.22 + 0.305 * k
        shapes.rod(steel, (x, -3.02, 0.14), (x, -3.02, 0.66), 0.011, 5)
        shapes.rod(steel, (x, -2.46, 0.14), (x, -3.02, 0.14), 0.011, 5)
    for s in (-1, 1):
        for y in (-2.62, -2.82):
            shapes.rod(steel, (s * 1.22, y, 0.14), (s * 1.22, y, 0.66), 0.011, 5)
    random.seed(5)
    x = -1.14
    kinds = ["roll", "box", "pack", "roll", "box", "pack"]
    for kind in kinds:
        w = {"roll": 0.46, "box": 0.34, "pack": 0.36}[kind]
        if kind == "roll":
            high = random.uniform(0.30, 0.36)
            for z, y in ((high, -2.86), (high + 0.02, -2.62)):
                ends = [
                    (0, 0),
                    (0, 0.10),
                    (0.02, 0.118),
                    (w - 0.05, 0.118),
                    (w - 0.03, 0.10),
                    (w - 0.03, 0),
                ]
                shapes.lathe(canvas, ends, (x, y, z), (1, 0, 0), 14)
                for strap in (0.10, w - 0.14):
                    shapes.lathe(
                        boxes, [(strap, 0.121), (strap + 0.03, 0.121)], (x, y, z), (1, 0, 0), 14
                    )
        elif kind == "box":
            shapes.box(boxes, x, x + w - 0.04, -2.96, -2.56, 0.17, random.uniform(0.44, 0.56))
        else:
            tall = random.uniform(0.52, 0.66)
            shapes.box(canvas, x, x + w - 0.03, -2.94, -2.58, 0.17, tall)
            shapes.box(canvas, x + 0.05, x + w - 0.09, -3.00, -2.92, 0.20, tall - 0.16)
        x += w
    parts.add("RackBars", steel, m["Steel"], turret)
    parts.add("RackCanvas", canvas, m["Canvas"], turret, bevel=0.045, segments=2)
    parts.add("RackBoxes", boxes, m["Plain"], turret, bevel=0.010)


def gun(m, turret):
    """The mantlet turns with the gun; the barrel recoils along it."""
    bm = parts.new()
    profile = [
        (-0.20, -0.24),
        (0.30, -0.235),
        (0.62, -0.17),
        (0.68, -0.10),
        (0.68, 0.10),
        (0.62, 0.17),
        (0.30, 0.235),
        (-0.20, 0.24),
    ]
    shapes.prism(bm, profile, -0.40, 0.40)
    made = parts.add("Gun", bm, m["Paint"], turret, bevel=0.03, at=(0, 1.36, 0.40))
    steel = parts.new()
    shapes.lathe(
        steel,
        [(0.40, 0), (0.40, 0.19), (0.74, 0.175), (0.78, 0.15), (0.78, 0)],
        direction=(0, 1, 0),
        steps=28,
    )
    shapes.bolt_circle(steel, (0, 0.735, 0), (0, 1, 0), 0.162, 10, 0.012)
    parts.add("GunCollar", steel, m["Paint"], made, bevel=0.008)
    coax = parts.new()
    shapes.lathe(
        coax,
        [(0.5, 0.036), (0.70, 0.036), (0.70, 0.020), (0.60, 0.018)],
        (0.27, 0, 0.04),
        (0, 1, 0),
        12,
    )
    parts.add("Coax", coax, m["Dark"], made)
    barrel = parts.new()
    tube = [
        (0.30, 0),
        (0.30, 0.132),
        (1.05, 0.126),
        (1.10, 0.104),
        (2.36, 0.100),
        (2.38, 0.104),
        (2.42, 0.138),
        (3.02, 0.138),
    ]
    tube += [
        (3.08, 0.104),
        (3.10, 0.096),
        (5.02, 0.084),
        (5.05, 0.095),
        (5.26, 0.095),
        (5.28, 0.088),
        (5.28, 0.0605),
        (4.7, 0.0595),
        (4.7, 0),
    ]
    shapes.lathe(barrel, tube, direction=(0, 1, 0), steps=30)
    for y, r in (
        (1.5, 0.106),
        (1.95, 0.104),
        (2.25, 0.103),
        (3.5, 0.098),
        (4.0, 0.095),
        (4.5, 0.092),
    ):
        shapes.lathe(
            barrel,
            [(y, r - 0.01), (y, r + 0.004), (y + 0.035, r + 0.004), (y + 0.035, r - 0.01)],
            direction=(0, 1, 0),
            steps=26,
        )
        shapes.box(barrel, -0.018, 0.018, y, y + 0.035, r, r + 0.018)
    shapes.box(barrel, -0.035, 0.035, 5.10, 5.22, 0.088, 0.135)
    made_barrel = parts.add("Barrel", barrel, m["Paint"], made, smooth_deg=35)
    bore = parts.new()
    shapes.lathe(
        bore,
        [(4.72, 0), (4.72, 0.0615), (5.285, 0.062), (5.285, 0.0585), (4.75, 0.058), (4.75, 0)],
        direction=(0, 1, 0),
        steps=24,
    )
    parts.add("Bore", bore, m["Dark"], made_barrel)
    parts.marker("Muzzle", made_barrel, (0, 5.30, 0))
