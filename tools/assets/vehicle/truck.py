"""The wheeled 4x4: a wide, low truck with a cab of four doors and an open bed under a canvas."""

import math

from . import parts, shapes

TEXTURE = 1536
WHEEL_RADIUS, WHEEL_X, AXLE_Y = 0.47, 0.91, 1.65


def make(materials):
    """Builds all; returns the names of the nodes that stay nodes."""
    m = {name: material.made for name, material in materials.items()}
    body = hull(m)
    cab(m, body)
    bed(m, body)
    ends(m, body)
    wheels(m, body)
    for s, side in ((-1, "Left"), (1, "Right")):
        parts.marker(f"HeadlightSpot{side}", body, (s * 0.72, 2.36, 0.98))
    parts.marker("ExhaustRight", body, (1.02, -1.0, 0.45))
    parts.marker("DriverEye", body, (-0.5, 0.12, 1.50))
    own = ["Hull", "LampsFront", "LampsRear", "AntennaLeft", "SteeringWheel"]
    return own + [f"Wheel_{side}{n}" for side in "LR" for n in (1, 2)]


def hull(m):
    """Frame, sills, bonnet, wings with round arches."""
    dark = parts.new()
    for s in (-1, 1):
        shapes.box(dark, s * 0.36, s * 0.46, -2.2, 2.2, 0.52, 0.66)
    for y in (-AXLE_Y, AXLE_Y):
        shapes.lathe(
            dark,
            [(-0.8, 0), (-0.8, 0.07), (-0.2, 0.07), (0, 0.16), (0.2, 0.07), (0.8, 0.07), (0.8, 0)],
            (0, y, 0.5),
            (1, 0, 0),
            14,
        )
    shapes.rod(dark, (0.95, -0.2, 0.46), (0.95, -1.1, 0.46), 0.05, 10)
    body = parts.add("Hull", dark, m["Dark"], smooth_deg=35)
    paint = parts.new()

    # The side's outline with the wheels' arches cut out, as one profile each.
    def arch(middle, low, sign):
        made = []
        for k in range(9):
            a = math.pi * (k / 8)
            made.append((middle - sign * 0.58 * math.cos(a), low + 0.56 * math.sin(a)))
        return made

    low = 0.56
    outline = [(-2.28, low), *arch(-AXLE_Y, low, 1), *arch(AXLE_Y, low, 1), (2.30, low + 0.12)]
    outline += [
        (2.34, 0.86),
        (2.26, 1.10),
        (0.86, 1.20),
        (0.80, 1.16),
        (-0.95, 1.16),
        (-0.95, 1.26),
        (-2.30, 1.26),
    ]
    for s in (-1, 1):
        shapes.prism(paint, outline, s * 0.66, s * 1.05)
    shapes.prism(
        paint, [(0.82, 0.80), (2.30, 0.70), (2.34, 0.90), (2.26, 1.12), (0.82, 1.22)], -0.67, 0.67
    )
    shapes.box(paint, -0.67, 0.67, -2.28, 0.82, 0.62, 0.72)
    part = parts.add("Body", paint, m["Paint"], body, bevel=0.025)
    del part
    steel, grille = parts.new(), parts.new()
    for k in range(9):  # The bonnet's louvres.
        shapes.turned_box(
            grille, (0, 1.20 + k * 0.08, 1.175 - k * 0.0055), (0.62, 0.05, 0.012), 0, 20
        )
    for s in (-1, 1):
        shapes.box(steel, s * 0.48, s * 0.56, 2.02, 2.14, 1.12, 1.17)
        shapes.handle(steel, (s * 0.55, 0.95, 1.21), (s * 0.55, 1.10, 1.20), (0, 0, 0.03), 0.007)
    parts.add("Louvres", grille, m["Plain"], body)
    parts.add("BonnetSteel", steel, m["Steel"], body)
    return body


def cab(m, body):
    """Doors, pillars, windscreen, roof, seats, steering wheel."""
    paint, glass, steel, canvas, dark = (parts.new() for _ in range(5))
    # Roof and pillars.
    roof = [(0.36, 1.80), (0.30, 1.85), (-0.92, 1.85), (-1.00, 1.80), (-1.00, 1.76), (0.40, 1.76)]
    shapes.prism(paint, roof, -0.90, 0.90)
    for s in (-1, 1):
        for (y0, z0), (y1, z1) in (
            ((0.82, 1.16), (0.36, 1.80)),
            ((-0.10, 1.16), (-0.12, 1.80)),
            ((-0.98, 1.16), (-0.97, 1.80)),
        ):
            ring = [
                (s * 0.99, y0 - 0.04, z0),
                (s * 1.03, y0 - 0.04, z0),
                (s * 1.03, y0 + 0.04, z0),
                (s * 0.99, y0 + 0.04, z0),
            ]
            top = [
                (s * 0.86, y1 - 0.035, z1),
                (s * 0.90, y1 - 0.035, z1),
                (s * 0.90, y1 + 0.035, z1),
                (s * 0.86, y1 + 0.035, z1),
            ]
            shapes.loft(paint, [ring, top])
        for y0, y1 in ((-0.08, 0.74), (-0.92, -0.14)):  # Doors and their panes.
            shapes.box(paint, s * 1.045, s * 1.075, y0, y1, 0.70, 1.18)
            shapes.box(steel, s * 1.073, s * 1.095, y0 + 0.06, y0 + 0.17, 1.06, 1.09)
            for z in (0.80, 1.08):
                shapes.rod(steel, (s * 1.08, y1, z - 0.04), (s * 1.08, y1, z + 0.04), 0.016)
            slope = 0.40 if y1 > 0 else 0.0
            pane = [(s * 1.005, y0 + 0.03, 1.20), (s * 1.005, y1 - 0.05, 1.20)]
            pane += [(s * 0.89, y1 - 0.09 - slope, 1.75), (s * 0.89, y0 + 0.03, 1.75)]
            shapes.pane(glass, pane, (s, 0, 0))
        shapes.tube(
            steel, [(s * 1.03, 0.62, 1.24), (s * 1.22, 0.66, 1.30), (s * 1.22, 0.66, 1.38)], 0.012
        )
        shapes.turned_box(paint, (s * 1.22, 0.66, 1.42), (0.14, 0.04, 0.22))
    pane = [(-0.96, 0.80, 1.21), (0.96, 0.80, 1.21), (0.84, 0.39, 1.76), (-0.84, 0.39, 1.76)]
    shapes.pane(glass, pane, (0, 1, 0))
    shapes.loft(
        paint,
        [
            [(-0.03, 0.81, 1.2), (0.03, 0.81, 1.2), (0.03, 0.78, 1.2), (-0.03, 0.78, 1.2)],
            [(-0.03, 0.40, 1.77), (0.03, 0.40, 1.77), (0.03, 0.37, 1.77), (-0.03, 0.37, 1.77)],
        ],
    )
    for s in (-1, 1):
        shapes.rod(dark, (s * 0.5, 0.815, 1.215), (s * 0.18, 0.60, 1.51), 0.008, 6)
        for y in (0.0, -0.78):
            shapes.box(canvas, s * 0.30, s * 0.78, y - 0.20, y + 0.26, 0.86, 1.02)
            shapes.turned_box(canvas, (s * 0.54, y - 0.24, 1.25), (0.46, 0.12, 0.56), 0, 10)
    shapes.box(dark, -0.95, 0.95, 0.55, 0.80, 0.95, 1.20)
    shapes.box(paint, -0.28, 0.28, -1.0, 0.6, 0.72, 1.06)
    parts.add("CabPaint", paint, m["Paint"], body, bevel=0.010)
    parts.add("CabGlass", glass, m["Glass"], body, is_open=True)
    parts.add("CabSteel", steel, m["Steel"], body, smooth_deg=32)
    parts.add("CabSeats", canvas, m["Canvas"], body, bevel=0.03)
    parts.add("CabDark", dark, m["Dark"], body, bevel=0.008)
    wheel = parts.new()
    shapes.eye(wheel, (0, 0, 0), (0, -1, 0), 0.20, 0.016, 22)
    for k in range(3):
        a = math.pi * (0.5 + 2 * k / 3)
        shapes.rod(wheel, (0, 0, 0), (0.19 * math.cos(a), 0, 0.19 * math.sin(a)), 0.012, 6)
    column = parts.add("SteeringWheel", wheel, m["Dark"], body, at=(-0.54, 0.36, 1.24))
    column.rotation_euler[0] = math.radians(-28)
    whip = parts.new()
    rings = [(1.8 * k / 6, 0.010 - 0.006 * k / 6) for k in range(7)]
    shapes.lathe(whip, [(0, 0), *rings, (1.8, 0)], steps=5)
    parts.add("AntennaLeft", whip, m["Dark"], body, at=(-0.98, -2.1, 1.26))


def bed(m, body):
    """The bed with bows and a canvas, tailgate, jerrycans, spare wheel."""
    canvas, paint, steel, rubber = (parts.new() for _ in range(4))
    tilt = [(-0.98, 1.24), (-0.96, 1.66), (-0.72, 1.86), (0.72, 1.86), (0.96, 1.66), (0.98, 1.24)]
    rings = []
    for k in range(7):
        y = -1.04 - 1.20 * k / 6
        sink = 0.0 if k % 2 == 0 else 0.025  # Between the bows the cloth hangs.
        rings.append([(x * (1 - sink * 0.4), y, z - sink * (z > 1.3)) for x, z in tilt])
    shapes.loft(canvas, rings)
    shapes.box(paint, -0.96, 0.96, -2.34, -2.29, 0.74, 1.24)
    for s in (-1, 1):
        for z in (0.85, 1.15):
            shapes.box(steel, s * 0.80, s * 0.90, -2.355, -2.33, z, z + 0.05)
        for y in (-1.10, -1.30, -1.50, -1.70, -1.90, -2.10):
            shapes.rod(steel, (s * 1.048, y, 1.20), (s * 1.065, y, 1.20), 0.012, 6)
        shapes.box(paint, s * 0.55, s * 0.72, -2.52, -2.36, 0.78, 1.22)
    profile = [
        (-0.13, 0.22),
        (-0.13, 0.40),
        (-0.10, 0.46),
        (0.10, 0.46),
        (0.13, 0.40),
        (0.13, 0.22),
        (-0.13, 0.22),
    ]
    shapes.lathe(rubber, profile, (0.0, -2.48, 1.06), (0, 1, 0), 26)
    shapes.lathe(
        paint,
        [(-0.05, 0), (-0.05, 0.23), (0.06, 0.23), (0.06, 0)],
        (0.0, -2.48, 1.06),
        (0, 1, 0),
        20,
    )
    parts.add("BedCanvas", canvas, m["Canvas"], body, bevel=0.02)
    parts.add("BedPaint", paint, m["Paint"], body, bevel=0.012)
    parts.add("BedSteel", steel, m["Steel"], body)
    parts.add("SpareWheel", rubber, m["Rubber"], body)
    for s in (-1, 1):
        parts.text(
            f"Number{s}", "58", m["Stencil"], body, (s * 1.077, 0.35, 0.93), 0.22, (90, 0, s * 90)
        )


def ends(m, body):
    """Grille, lamps, bumpers, winch, tow hooks."""
    steel, dark, lens, red, paint = (parts.new() for _ in range(5))
    shapes.box(dark, -0.52, 0.52, 2.315, 2.345, 0.78, 1.04)
    for k in range(8):
        x = -0.49 + k * 0.14
        shapes.box(paint, x - 0.022, x + 0.022, 2.335, 2.36, 0.77, 1.05)
    for s in (-1, 1):
        shapes.lathe(
            paint,
            [(0, 0.105), (0.05, 0.105), (0.05, 0.09), (0.02, 0.088)],
            (s * 0.74, 2.31, 0.96),
            (0, 1, 0),
            20,
        )
        shapes.lathe(
            lens, [(0.02, 0.09), (0.04, 0.05), (0.045, 0)], (s * 0.74, 2.31, 0.96), (0, 1, 0), 20
        )
        shapes.lathe(
            lens, [(0.0, 0.04), (0.03, 0.03), (0.035, 0)], (s * 0.93, 2.32, 0.92), (0, 1, 0), 14
        )
        shapes.lathe(
            red, [(0, 0.05), (0.012, 0.045), (0.018, 0)], (s * 0.90, -2.30, 0.98), (0, -1, 0), 16
        )
        shapes.lathe(
            red, [(0, 0.035), (0.010, 0.03), (0.015, 0)], (s * 0.90, -2.30, 0.86), (0, -1, 0), 14
        )
        shapes.eye(steel, (s * 0.42, 2.50, 0.66), (1, 0, 0), 0.055, 0.016)
        shapes.box(paint, s * 0.36, s * 0.46, 2.2, 2.42, 0.56, 0.68)
        shapes.box(paint, s * 0.36, s * 0.46, -2.42, -2.2, 0.56, 0.68)
    shapes.box(paint, -0.98, 0.98, 2.38, 2.46, 0.56, 0.72)
    shapes.box(paint, -0.98, 0.98, -2.48, -2.40, 0.56, 0.70)
    shapes.rod(steel, (-0.2, 2.43, 0.79), (0.2, 2.43, 0.79), 0.065, 14)
    guard = [(-0.62, 2.46, 0.70), (-0.62, 2.48, 1.08), (0.62, 2.48, 1.08), (0.62, 2.46, 0.70)]
    shapes.tube(steel, guard, 0.024, 8)
    parts.add("EndPaint", paint, m["Paint"], body, bevel=0.010)
    parts.add("EndSteel", steel, m["Steel"], body, smooth_deg=32)
    parts.add("EndDark", dark, m["Dark"], body)
    parts.add("LampsFront", lens, m["Lens"], body)
    parts.add("LampsRear", red, m["Red"], body)


def wheels(m, body):
    """Four alike; a wheel's outer face looks along +X."""
    r, w = WHEEL_RADIUS, 0.15
    tyre = parts.new()
    profile = [(-w + 0.02, r * 0.56), (-w, r * 0.72), (-w, r * 0.90), (-w + 0.03, r * 0.97), (0, r)]
    profile += [
        (w - 0.03, r * 0.97),
        (w, r * 0.90),
        (w, r * 0.72),
        (w - 0.02, r * 0.56),
        (0, r * 0.5),
    ]
    shapes.lathe(tyre, [*profile, profile[0]], direction=(1, 0, 0), steps=32)
    for k in range(24):  # Lugs, one side after the other.
        a = 2 * math.pi * k / 24
        s = 1 if k % 2 else -1
        middle = (s * 0.075, (r - 0.012) * math.cos(a), (r - 0.012) * math.sin(a))
        shapes.turned_box(tyre, middle, (0.13, 0.07, 0.045), 0, math.degrees(a) - 90)
    wheel = parts.add("Wheel_L1", tyre, m["Rubber"], body, smooth_deg=45)
    disc = parts.new()
    face = w - 0.05
    dish = [
        (-0.08, 0),
        (-0.08, r * 0.55),
        (w - 0.02, r * 0.57),
        (w - 0.02, r * 0.50),
        (face - 0.05, r * 0.44),
    ]
    dish += [(face - 0.05, r * 0.24), (face, r * 0.20), (face + 0.03, r * 0.16), (face + 0.03, 0)]
    shapes.lathe(disc, dish, direction=(1, 0, 0), steps=26)
    shapes.bolt_circle(disc, (w - 0.022, 0, 0), (1, 0, 0), r * 0.535, 16, 0.010)
    shapes.bolt_circle(disc, (face - 0.052, 0, 0), (1, 0, 0), r * 0.33, 8, 0.016, 0.016)
    parts.add("Wheel_L1Disc", disc, m["Plain"], wheel, smooth_deg=32)
    wheel.location = (-WHEEL_X, AXLE_Y, r)
    wheel.rotation_euler[2] = math.pi
    parts.copy(wheel, "Wheel_L2", body, (-WHEEL_X, -AXLE_Y, r), 180)
    parts.copy(wheel, "Wheel_R1", body, (WHEEL_X, AXLE_Y, r))
    parts.copy(wheel, "Wheel_R2", body, (WHEEL_X, -AXLE_Y, r))
