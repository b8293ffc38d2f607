"""What is on the battle tank's turret roof: sights, hatches, machine gun, antennas."""

import math

from . import parts, shapes
from .tank_wells import COMMANDER, COMMANDER_RADIUS, LOADER, LOADER_RADIUS, ROOF


def roof(m, turret):
    """Sights, blow-out panels, ventilator, wind sensor."""
    paint, glass, steel, dark = (parts.new() for _ in range(4))
    # The gunner's sight in an armoured box with doors.
    shapes.prism(
        paint, [(0.34, 0.70), (0.94, 0.68), (0.94, 0.90), (0.86, 0.99), (0.34, 0.99)], 0.30, 0.86
    )
    shapes.box(paint, 0.28, 0.88, 0.36, 0.98, 0.985, 1.01)
    shapes.box(glass, 0.36, 0.60, 0.936, 0.946, 0.755, 0.885)
    shapes.box(glass, 0.65, 0.80, 0.936, 0.946, 0.755, 0.885)
    shapes.box(paint, 0.14, 0.29, 0.92, 0.955, 0.70, 0.93)
    shapes.bolts(steel, (0.34, 0.42, 1.01), (0.82, 0.42, 1.01), 4, (0, 0, 1))
    # The panoramic sight: a head on a stalk, looking ahead.
    at = (-0.12, 0.14, ROOF)
    base = [
        (0, 0.20),
        (0.06, 0.20),
        (0.08, 0.17),
        (0.15, 0.16),
        (0.17, 0.175),
        (0.40, 0.165),
        (0.44, 0.12),
        (0.445, 0),
    ]
    shapes.lathe(paint, base, at, steps=28)
    shapes.box(
        paint, at[0] - 0.11, at[0] + 0.11, at[1] + 0.06, at[1] + 0.185, ROOF + 0.18, ROOF + 0.40
    )
    shapes.box(
        glass,
        at[0] - 0.085,
        at[0] + 0.085,
        at[1] + 0.182,
        at[1] + 0.192,
        ROOF + 0.205,
        ROOF + 0.375,
    )
    shapes.bolt_circle(steel, (at[0], at[1], ROOF + 0.055), (0, 0, 1), 0.185, 10, 0.010)
    # Ventilator, blow-out panels, wind sensor.
    shapes.lathe(
        paint, [(0, 0.14), (0.06, 0.14), (0.09, 0.11), (0.095, 0)], (-0.10, -1.15, ROOF), steps=24
    )
    for x0, x1 in ((-1.02, -0.10), (0.10, 1.02)):
        shapes.box(paint, x0, x1, -2.28, -1.56, ROOF - 0.01, ROOF + 0.028)
        shapes.bolts(
            steel, (x0 + 0.06, -2.22, ROOF + 0.028), (x1 - 0.06, -2.22, ROOF + 0.028), 6, (0, 0, 1)
        )
        shapes.bolts(
            steel, (x0 + 0.06, -1.62, ROOF + 0.028), (x1 - 0.06, -1.62, ROOF + 0.028), 6, (0, 0, 1)
        )
        middle = (x0 + x1) / 2
        shapes.handle(
            steel,
            (middle - 0.1, -1.92, ROOF + 0.026),
            (middle + 0.1, -1.92, ROOF + 0.026),
            (0, 0, 0.04),
            0.009,
        )
    shapes.rod(dark, (0.0, -2.34, ROOF - 0.02), (0.0, -2.34, ROOF + 0.42), 0.014, 8)
    shapes.lathe(
        dark, [(0, 0), (0, 0.032), (0.09, 0.032), (0.09, 0)], (0.0, -2.34, ROOF + 0.40), steps=12
    )
    # Weld seams where roof plates meet.
    for y in (0.30, -1.42):
        shapes.rod(paint, (-1.20, y, ROOF - 0.002), (1.20, y, ROOF - 0.002), 0.009, 6)
    parts.add("RoofPaint", paint, m["Paint"], turret, bevel=0.010)
    parts.add("RoofGlass", glass, m["Glass"], turret)
    parts.add("RoofSteel", steel, m["Steel"], turret, smooth_deg=32)
    parts.add("RoofDark", dark, m["Dark"], turret, smooth_deg=32)


def hatches(m, turret):
    """Rings with a clear opening, periscopes round the commander's, lids hinged at the rear."""
    paint, glass, pads = parts.new(), parts.new(), parts.new()
    x, y = COMMANDER
    inner = COMMANDER_RADIUS
    # The cupola's ring, then eight periscopes in its outer slope.
    profile = [
        (-0.02, inner),
        (-0.02, 0.52),
        (0.03, 0.52),
        (0.085, 0.46),
        (0.115, 0.40),
        (0.115, inner),
    ]
    shapes.lathe(paint, [*profile, profile[0]], (x, y, ROOF), steps=36)
    for k in range(8):
        degrees = 22.5 + 45 * k
        a = math.radians(degrees)
        spot = (x + 0.445 * math.cos(a), y + 0.445 * math.sin(a), ROOF + 0.088)
        shapes.turned_box(paint, spot, (0.10, 0.20, 0.10), degrees)
        pane = (x + 0.497 * math.cos(a), y + 0.497 * math.sin(a), ROOF + 0.098)
        shapes.turned_box(glass, pane, (0.008, 0.155, 0.055), degrees)
    shapes.ring(pads, (x, y, ROOF + 0.108), (0, 0, 1), inner, inner + 0.035, 0, 0.022, 40)
    x, y = LOADER
    inner = LOADER_RADIUS
    profile = [(-0.02, inner), (-0.02, inner + 0.10), (0.045, inner + 0.08), (0.055, inner)]
    shapes.lathe(paint, [*profile, profile[0]], (x, y, ROOF), steps=32)
    shapes.ring(pads, (x, y, ROOF + 0.048), (0, 0, 1), inner, inner + 0.03, 0, 0.018, 36)
    parts.add("HatchRings", paint, m["Paint"], turret, bevel=0.006, segments=1)
    parts.add("HatchGlass", glass, m["Glass"], turret)
    parts.add("HatchPads", pads, m["Rubber"], turret)
    lid(m, turret, "HatchCommander", COMMANDER, COMMANDER_RADIUS + 0.02, ROOF + 0.128)
    lid(m, turret, "HatchLoader", LOADER, LOADER_RADIUS + 0.02, ROOF + 0.064)


def lid(m, turret, name, middle, radius, high):
    """A hatch, hinged at its rear edge."""
    bm = parts.new()
    reach = radius + 0.05  # From the hinge to the middle.
    shapes.lathe(
        bm,
        [(0, 0), (0, radius), (0.028, radius), (0.055, radius - 0.06), (0.060, 0)],
        (0, reach, 0),
        steps=32,
    )
    shapes.box(bm, -0.15, 0.15, -0.035, 0.16, 0.000, 0.040)
    lid_part = parts.add(
        name, bm, m["Paint"], turret, bevel=0.006, at=(middle[0], middle[1] - reach, high)
    )
    fittings = parts.new()
    for s in (-1, 1):
        shapes.rod(fittings, (s * 0.06, 0, 0.012), (s * 0.16, 0, 0.012), 0.026, 12)
    shapes.handle(
        fittings, (-0.09, reach + 0.12, 0.058), (0.09, reach + 0.12, 0.058), (0, 0, 0.035), 0.009
    )
    shapes.lathe(
        fittings, [(0, 0), (0, 0.06), (-0.02, 0.055), (-0.02, 0)], (0, reach, 0.0), steps=16
    )
    shapes.rod(fittings, (0, reach, -0.03), (0.10, reach + 0.08, -0.03), 0.012, 8)
    parts.add(name + "Fittings", fittings, m["Steel"], lid_part, smooth_deg=32)
    lining = parts.new()
    shapes.lathe(
        lining,
        [(-0.004, 0), (-0.004, radius - 0.05), (-0.018, radius - 0.07), (-0.018, 0)],
        (0, reach, 0),
        steps=32,
    )
    parts.add(name + "Lining", lining, m["Canvas"], lid_part)


def machine_gun(m, turret):
    """At the loader's hatch, on a pintle."""
    dark, box = parts.new(), parts.new()
    x, y, z = LOADER[0], LOADER[1] + 0.42, ROOF
    shapes.lathe(
        dark, [(0, 0.06), (0.03, 0.06), (0.04, 0.03), (0.30, 0.026), (0.30, 0)], (x, y, z), steps=14
    )
    shapes.box(dark, x - 0.035, x + 0.035, y - 0.32, y + 0.24, z + 0.28, z + 0.39)
    barrel = [
        (0, 0.030),
        (0.22, 0.028),
        (0.23, 0.016),
        (0.70, 0.013),
        (0.71, 0.021),
        (0.80, 0.021),
        (0.80, 0),
    ]
    shapes.lathe(dark, barrel, (x, y + 0.22, z + 0.345), (0, 1, 0), 14)
    for s in (-1, 1):
        shapes.rod(
            dark, (x + s * 0.03, y - 0.34, z + 0.30), (x + s * 0.05, y - 0.36, z + 0.42), 0.013, 6
        )
    shapes.box(dark, x - 0.012, x + 0.012, y - 0.05, y + 0.0, z + 0.39, z + 0.43)
    shapes.box(box, x - 0.20, x - 0.045, y - 0.16, y + 0.10, z + 0.20, z + 0.37)
    shapes.turned_box(dark, (x - 0.04, y - 0.02, z + 0.375), (0.10, 0.07, 0.02))
    parts.add("MachineGun", dark, m["Dark"], turret)
    parts.add("MachineGunBox", box, m["Plain"], turret)


def antennas(m, turret):
    """Two, each a node of its own: it sways."""
    bases = parts.new()
    for name, x, y, high in (
        ("AntennaLeft", -1.04, -2.30, 1.9),
        ("AntennaRight", 1.04, -2.30, 2.35),
    ):
        foot = [
            (0, 0.075),
            (0.05, 0.07),
            (0.07, 0.045),
            (0.16, 0.04),
            (0.17, 0.025),
            (0.20, 0.02),
            (0.20, 0),
        ]
        shapes.lathe(bases, foot, (x, y, ROOF - 0.02), steps=16)
        rod = parts.new()
        rings = []
        for k in range(7):  # Joints, so that it can bend in its shader.
            share = k / 6
            rings.append((high * share, 0.012 * (1 - share) + 0.004 * share))
        shapes.lathe(rod, [(0, 0), *rings, (high, 0)], steps=5)
        parts.add(name, rod, m["Dark"], turret, at=(x, y, ROOF + 0.17))
    parts.add("AntennaBases", bases, m["Dark"], turret, smooth_deg=32)
