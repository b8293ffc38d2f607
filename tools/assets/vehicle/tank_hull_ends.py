"""What is at the ends of the battle tank's hull: lamps, hatch of the driver, exhausts, tow gear."""

import math

from . import parts, shapes


def front(m, body):
    """The driver's hatch, lamps, tow hooks, spare links, a cable."""
    paint, steel, glass, lens, dark = (parts.new() for _ in range(5))
    # Driver's hatch with three periscopes.
    at = (-0.58, 1.78, 1.475)
    shapes.ring(paint, at, (0, 0, 1), 0.285, 0.345, -0.05, 0.035, 36)
    shapes.lathe(
        paint, [(0.0, 0), (0.0, 0.28), (0.035, 0.28), (0.055, 0.22), (0.060, 0)], at, steps=32
    )
    shapes.handle(
        steel,
        (at[0] - 0.08, at[1] - 0.12, 1.532),
        (at[0] + 0.08, at[1] - 0.12, 1.532),
        (0, 0, 0.035),
        0.009,
    )
    shapes.rod(
        steel, (at[0] - 0.42, at[1] - 0.02, 1.50), (at[0] - 0.20, at[1] - 0.02, 1.525), 0.035, 12
    )
    for degrees in (-42, 0, 42):
        a = math.radians(degrees)
        spot = (at[0] + 0.43 * math.sin(a), at[1] + 0.43 * math.cos(a))
        tall = 1.545 - 0.10 * math.cos(a)
        shapes.turned_box(paint, (spot[0], spot[1], tall - 0.06), (0.21, 0.11, 0.17), -degrees)
        pane = (spot[0] + 0.057 * math.sin(a), spot[1] + 0.057 * math.cos(a), tall - 0.012)
        shapes.turned_box(glass, pane, (0.16, 0.008, 0.055), -degrees)
    # Headlights: a large and a small one in a guard on each side.
    for s in (-1, 1):
        for x, radius in ((1.34, 0.085), (1.15, 0.055)):
            spot = (s * x, 3.10, 1.26)
            bowl = [
                (-0.11, 0),
                (-0.10, radius * 0.5),
                (-0.03, radius),
                (0.03, radius),
                (0.03, radius * 0.88),
                (0.012, radius * 0.86),
            ]
            shapes.lathe(paint, bowl, spot, (0, 1, 0), 20)
            shapes.lathe(
                lens,
                [(0.012, radius * 0.87), (0.022, radius * 0.5), (0.026, 0)],
                spot,
                (0, 1, 0),
                20,
            )
            shapes.box(paint, s * x - 0.02, s * x + 0.02, 3.06, 3.12, 1.12, 1.26 - radius * 0.8)
        arch = [
            (s * 1.03, 3.22, 1.10),
            (s * 1.03, 3.24, 1.36),
            (s * 1.47, 3.24, 1.36),
            (s * 1.47, 3.22, 1.10),
        ]
        shapes.tube(steel, arch, 0.013, 6)
        for x in (1.03, 1.47):
            shapes.tube(
                steel, [(s * x, 3.24, 1.36), (s * x, 2.98, 1.34), (s * x, 2.94, 1.12)], 0.013, 6
            )
        # Tow hooks and shackles on the nose.
        shapes.box(paint, s * 0.62, s * 0.76, 3.48, 3.70, 0.83, 0.98)
        shapes.eye(steel, (s * 0.69, 3.76, 0.90), (1, 0, 0), 0.065, 0.022, 16)
        shapes.rod(steel, (s * 0.60, 3.67, 0.90), (s * 0.78, 3.67, 0.90), 0.022, 10)
        # Splash board and lifting eyes on the glacis.
        shapes.turned_box(paint, (s * 0.52, 2.72, 1.375), (1.02, 0.014, 0.11), s * -14, 0)
        shapes.eye(steel, (s * 0.95, 2.35, 1.44), (1, 0, 0), 0.045, 0.014)
    # Spare links across the lower nose, held by a bar.
    for k in range(5):
        x = -0.42 + k * 0.21
        shapes.turned_box(dark, (x, 3.28, 1.245), (0.19, 0.30, 0.05), 0, -12)
        shapes.turned_box(dark, (x, 3.28, 1.285), (0.05, 0.08, 0.07), 0, -12)
    shapes.tube(
        steel,
        [(-0.58, 3.36, 1.21), (-0.56, 3.36, 1.262), (0.56, 3.36, 1.262), (0.58, 3.36, 1.21)],
        0.013,
        6,
    )
    # Tow cable on the glacis and along the right sponson.
    path = [(0.98, 2.98, 1.315), (0.90, 2.2, 1.465), (0.97, 1.5, 1.505), (1.00, 1.30, 1.515)]
    shapes.tube(steel, path, 0.020, 6)
    shapes.eye(steel, (0.985, 3.04, 1.305), (0.3, 0, 1), 0.05, 0.016, 14)
    for point in path[1:3]:
        shapes.box(
            paint,
            point[0] - 0.04,
            point[0] + 0.04,
            point[1] - 0.02,
            point[1] + 0.02,
            point[2] - 0.03,
            point[2] + 0.026,
        )
    parts.add("FrontPaint", paint, m["Paint"], body, bevel=0.008)
    parts.add("FrontSteel", steel, m["Steel"], body, smooth_deg=32)
    parts.add("FrontGlass", glass, m["Glass"], body)
    parts.add("FrontDark", dark, m["Steel"], body)
    parts.add("LampsFront", lens, m["Lens"], body)


def rear(m, body):
    """Grille, boxes, rear lamps, exhausts, tow gear."""
    paint, steel, dark, red = (parts.new() for _ in range(4))
    shapes.box(dark, -0.98, 0.98, -3.665, -3.60, 1.14, 1.42)
    for i in range(8):
        shapes.turned_box(paint, (0, -3.675, 1.16 + i * 0.036), (1.96, 0.045, 0.010), 0, 32)
    for x in (-0.99, -0.33, 0.33, 0.99):
        shapes.box(paint, x - 0.02, x + 0.02, -3.70, -3.58, 1.11, 1.45)
    for s in (-1, 1):
        shapes.box(paint, s * 1.15, s * 1.66, -3.90, -3.58, 1.13, 1.44)  # Boxes beside the grille.
        shapes.box(paint, s * 1.14, s * 1.67, -3.91, -3.57, 1.40, 1.455)
        for x in (1.25, 1.55):
            shapes.box(steel, s * (x - 0.02), s * (x + 0.02), -3.915, -3.90, 1.33, 1.42)
        lamp = (s * 1.40, -3.90, 1.24)
        shapes.box(paint, s * 1.30, s * 1.50, -3.935, -3.89, 1.19, 1.29)
        shapes.lathe(
            red,
            [(0, 0.038), (0.012, 0.034), (0.016, 0)],
            (lamp[0] - s * 0.045, -3.935, 1.24),
            (0, -1, 0),
            16,
        )
        shapes.lathe(
            red,
            [(0, 0.028), (0.010, 0.024), (0.013, 0)],
            (lamp[0] + s * 0.05, -3.935, 1.24),
            (0, -1, 0),
            16,
        )
        shapes.box(paint, s * 0.62, s * 0.76, -3.72, -3.46, 0.80, 0.95)
        shapes.eye(steel, (s * 0.69, -3.77, 0.88), (1, 0, 0), 0.065, 0.022, 16)
    shapes.box(paint, -0.14, 0.14, -3.70, -3.45, 0.72, 0.94)
    shapes.lathe(
        steel, [(0, 0.05), (0.10, 0.05), (0.10, 0.03), (0, 0.03)], (0, -3.70, 0.83), (0, -1, 0), 16
    )
    # Tow cable looped over the rear.
    path = [
        (-0.9, -3.70, 1.02),
        (-0.5, -3.72, 1.08),
        (0.0, -3.72, 1.06),
        (0.5, -3.72, 1.08),
        (0.9, -3.70, 1.02),
    ]
    shapes.tube(steel, path, 0.020, 6)
    # Exhausts on the deck's rear corners, each under its flap.
    for s in (-1, 1):
        shapes.box(dark, s * 1.22, s * 1.54, -3.50, -3.14, 1.47, 1.53)
        pipe = [
            (0, 0),
            (0, 0.098),
            (0.20, 0.098),
            (0.21, 0.092),
            (0.21, 0.084),
            (0.04, 0.080),
            (0.03, 0),
        ]
        shapes.lathe(dark, pipe, (s * 1.38, -3.32, 1.50), (0, 0, 1), 24)
        shapes.ring(dark, (s * 1.38, -3.32, 1.53), (0, 0, 1), 0.095, 0.118, 0, 0.03, 24)
    parts.add("RearPaint", paint, m["Paint"], body, bevel=0.008)
    parts.add("RearSteel", steel, m["Steel"], body, smooth_deg=32)
    parts.add("RearDark", dark, m["Dark"], body, smooth_deg=32)
    parts.add("LampsRear", red, m["Red"], body)
    parts.text("RearNumber", "214", m["Stencil"], body, (0.0, -3.735, 1.275), 0.17, (90, 0, 180))


def flaps(m, body):
    """Hinged at their rear edge, on top of the pipes."""
    for s, name in ((-1, "FlapLeft"), (1, "FlapRight")):
        bm = parts.new()
        shapes.lathe(
            bm,
            [(0, 0), (0, 0.104), (0.012, 0.104), (0.020, 0.085), (0.020, 0)],
            (0, 0.100, 0),
            steps=24,
        )
        shapes.box(bm, -0.035, 0.035, -0.026, 0.05, -0.010, 0.030)
        shapes.rod(bm, (-0.055, 0, 0.010), (0.055, 0, 0.010), 0.014, 8)
        shapes.rod(bm, (0, -0.02, 0.012), (0, -0.075, -0.012), 0.012, 8, 0.022)
        parts.add(name, bm, m["Dark"], body, bevel=0.003, segments=1, at=(s * 1.38, -3.42, 1.712))
