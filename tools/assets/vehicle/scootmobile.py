"""The scootmobile: four small wheels, a seat with arm rests, a handlebar with a basket."""

import math

from . import paint, parts, shapes

TEXTURE = 1024
WHEEL_RADIUS, WHEEL_X, FRONT_Y, REAR_Y = 0.13, 0.26, 0.45, -0.40


def materials():
    """Town colours, hardly any dust."""
    made = [
        paint.Material(
            "Paint", (0.30, 0.020, 0.022), (), 0.25, 0.0, wear=0.15, dust=0.15, grime=0.15
        ),
        paint.Material("Dark", (0.030, 0.030, 0.032), (), 0.6, 0.0, wear=0.1, dust=0.3, grime=0.15),
        paint.Material("Steel", (0.35, 0.35, 0.36), (), 0.35, 0.8, wear=0.2, dust=0.2, grime=0.15),
        paint.Material("Rubber", (0.028, 0.028, 0.028), (), 0.92, 0.0, dust=0.5),
        paint.Material("Seat", (0.045, 0.045, 0.050), (), 0.7, 0.0, dust=0.1, grime=0.1),
        paint.Material("Lens", (0.60, 0.60, 0.55), (), 0.12, 0.0, dust=0.1, grime=0.05),
        paint.Material("Red", (0.35, 0.02, 0.015), (), 0.25, 0.0, dust=0.1, grime=0.05),
        paint.Material("Mat", (0.060, 0.062, 0.064), (), 0.95, 0.0, dust=0.5),
    ]
    return {m.made.name: m for m in made}


def make(given):
    """Builds all; returns the names of the nodes that stay nodes."""
    m = {name: material.made for name, material in given.items()}
    body = chassis(m)
    seat(m, body)
    handlebar(m, body)
    wheels(m, body)
    parts.marker("SeatMiddle", body, (0, -0.25, 0.62))
    parts.marker("LadderLeft1", body, (-0.65, -0.05, 0))
    parts.marker("LadderRight1", body, (0.65, -0.05, 0))
    own = ["Hull", "Handlebar", "LampsFront", "LampsRear"]
    return own + [f"Wheel_{side}{n}" for side in "LR" for n in (1, 2)]


def chassis(m):
    """Platform with a mat, rear hood over motor and batteries, front cowl, bumpers, axles."""
    bm = parts.new()
    base = [
        (-0.55, 0.22),
        (-0.58, 0.30),
        (-0.52, 0.40),
        (-0.12, 0.40),
        (-0.06, 0.30),
        (-0.02, 0.20),
    ]
    base += [(0.32, 0.19), (0.44, 0.30), (0.54, 0.30), (0.60, 0.22), (0.58, 0.15), (-0.50, 0.15)]
    shapes.prism(bm, base, -0.17, 0.17)
    rear = [
        (-0.56, 0.24),
        (-0.54, 0.36),
        (-0.44, 0.41),
        (-0.24, 0.39),
        (-0.10, 0.27),
        (-0.10, 0.20),
        (-0.22, 0.30),
        (-0.42, 0.31),
    ]
    cowl = [
        (0.30, 0.20),
        (0.36, 0.30),
        (0.46, 0.33),
        (0.58, 0.28),
        (0.62, 0.20),
        (0.56, 0.24),
        (0.44, 0.285),
        (0.36, 0.24),
    ]
    for s in (-1, 1):
        shapes.prism(bm, rear, s * 0.15, s * 0.33)
        shapes.prism(bm, cowl, s * 0.15, s * 0.32)
        shapes.prism(
            bm, [(-0.12, 0.16), (0.33, 0.16), (0.33, 0.20), (-0.12, 0.20)], s * 0.15, s * 0.29
        )
    body = parts.add("Hull", bm, m["Paint"], bevel=0.025, segments=2)
    mat, dark, lens, red = (parts.new() for _ in range(4))
    shapes.box(mat, -0.27, 0.27, -0.03, 0.30, 0.198, 0.206)
    for k in range(8):
        shapes.box(mat, -0.25, 0.25, -0.01 + k * 0.038, 0.005 + k * 0.038, 0.205, 0.211)
    shapes.rod(dark, (-WHEEL_X, FRONT_Y, WHEEL_RADIUS), (WHEEL_X, FRONT_Y, WHEEL_RADIUS), 0.018)
    shapes.rod(dark, (-WHEEL_X, REAR_Y, WHEEL_RADIUS), (WHEEL_X, REAR_Y, WHEEL_RADIUS), 0.025)
    shapes.tube(
        dark,
        [(-0.24, 0.58, 0.20), (-0.18, 0.65, 0.20), (0.18, 0.65, 0.20), (0.24, 0.58, 0.20)],
        0.020,
        8,
    )
    shapes.tube(
        dark,
        [(-0.26, -0.54, 0.22), (-0.20, -0.62, 0.22), (0.20, -0.62, 0.22), (0.26, -0.54, 0.22)],
        0.020,
        8,
    )
    for s in (-1, 1):
        shapes.lathe(
            red, [(0, 0.03), (0.012, 0.026), (0.016, 0)], (s * 0.22, -0.552, 0.315), (0, -1, 0), 14
        )
        shapes.rod(dark, (s * 0.12, -0.60, 0.13), (s * 0.12, -0.68, 0.06), 0.012)
        shapes.lathe(
            dark,
            [(-0.012, 0.03), (0.012, 0.03), (0.012, 0), (-0.012, 0)],
            (s * 0.12, -0.69, 0.035),
            (1, 0, 0),
            12,
        )
    shapes.lathe(lens, [(0, 0.05), (0.02, 0.04), (0.03, 0)], (0, 0.575, 0.265), (0, 1, 0.3), 18)
    parts.add("Mat", mat, m["Mat"], body)
    parts.add("Undercarriage", dark, m["Dark"], body, smooth_deg=40)
    parts.add("LampsFront", lens, m["Lens"], body)
    parts.add("LampsRear", red, m["Red"], body)
    return body


def seat(m, body):
    """Post, cushion, back, head rest, arm rests."""
    cushion, steel, dark = parts.new(), parts.new(), parts.new()
    shapes.rod(steel, (0, -0.28, 0.38), (0, -0.28, 0.54), 0.035, 14)
    shapes.box(dark, -0.18, 0.18, -0.46, -0.10, 0.53, 0.55)
    shapes.prism(
        cushion,
        [(-0.48, 0.55), (-0.04, 0.55), (-0.02, 0.60), (-0.06, 0.645), (-0.44, 0.635)],
        -0.23,
        0.23,
    )
    shapes.prism(
        cushion,
        [(-0.42, 0.66), (-0.50, 0.66), (-0.60, 1.05), (-0.56, 1.09), (-0.51, 1.06)],
        -0.21,
        0.21,
    )
    shapes.prism(cushion, [(-0.54, 1.13), (-0.60, 1.13), (-0.63, 1.26), (-0.57, 1.27)], -0.11, 0.11)
    for s in (-1, 1):
        shapes.rod(steel, (s * 0.05, -0.56, 1.06), (s * 0.05, -0.58, 1.16), 0.010)
        shapes.tube(
            steel,
            [(s * 0.24, -0.46, 0.60), (s * 0.27, -0.48, 0.72), (s * 0.27, -0.46, 0.81)],
            0.014,
        )
        shapes.box(cushion, s * 0.235, s * 0.305, -0.50, -0.16, 0.80, 0.845)
    parts.add("Cushions", cushion, m["Seat"], body, bevel=0.022, segments=2)
    parts.add("SeatSteel", steel, m["Steel"], body)
    parts.add("SeatDark", dark, m["Dark"], body, bevel=0.006)


def handlebar(m, body):
    """The tiller turns about its foot; console, loop bar with grips, basket, mirrors."""
    paint_part, dark, steel = parts.new(), parts.new(), parts.new()
    # Relative to the foot; it leans back.
    shapes.tube(paint_part, [(0, 0, 0), (0, -0.05, 0.22), (0, -0.12, 0.52)], 0.045, 12)
    shapes.prism(
        paint_part, [(-0.20, 0.50), (-0.05, 0.56), (-0.06, 0.63), (-0.21, 0.57)], -0.11, 0.11
    )
    shapes.box(dark, -0.06, 0.06, -0.19, -0.09, 0.603, 0.612)
    for s in (-1, 1):
        bar = [
            (0, -0.13, 0.55),
            (s * 0.16, -0.13, 0.58),
            (s * 0.26, -0.20, 0.60),
            (s * 0.27, -0.32, 0.58),
        ]
        shapes.tube(steel, bar, 0.012, 8)
        shapes.rod(dark, (s * 0.268, -0.24, 0.592), (s * 0.272, -0.35, 0.575), 0.019, 10)
        shapes.rod(dark, (s * 0.16, -0.16, 0.57), (s * 0.22, -0.26, 0.565), 0.007, 6)
        shapes.tube(steel, [(s * 0.22, -0.16, 0.595), (s * 0.30, -0.13, 0.72)], 0.006, 6)
        shapes.turned_box(dark, (s * 0.31, -0.13, 0.77), (0.11, 0.02, 0.08), s * 8)
    for z in (0.26, 0.36, 0.46):  # The basket in front.
        ring_x, y0, y1 = 0.17 + (z - 0.26) * 0.1, 0.03, 0.27 + (z - 0.26) * 0.2
        loop = [
            (-ring_x, y0, z),
            (-ring_x, y1, z),
            (ring_x, y1, z),
            (ring_x, y0, z),
            (-ring_x, y0, z),
        ]
        shapes.tube(steel, loop, 0.006, 6)
    for k in range(7):
        x = -0.165 + k * 0.055
        shapes.tube(
            steel,
            [(x, 0.03, 0.46), (x, 0.03, 0.26), (x, 0.27, 0.26), (x * 1.1, 0.31, 0.46)],
            0.004,
            5,
        )
    foot = parts.add("Handlebar", paint_part, m["Paint"], body, smooth_deg=45, at=(0, 0.42, 0.28))
    parts.add("HandlebarDark", dark, m["Dark"], foot, bevel=0.003)
    parts.add("HandlebarSteel", steel, m["Steel"], foot)
    parts.marker("HandleLeft", foot, (-0.27, -0.30, 0.585))
    parts.marker("HandleRight", foot, (0.27, -0.30, 0.585))


def wheels(m, body):
    """Four alike; a wheel's outer face looks along +X."""
    r, w = WHEEL_RADIUS, 0.045
    tyre = parts.new()
    profile = [
        (-w, r * 0.62),
        (-w, r * 0.86),
        (-w * 0.6, r * 0.98),
        (0, r),
        (w * 0.6, r * 0.98),
        (w, r * 0.86),
        (w, r * 0.62),
    ]
    shapes.lathe(tyre, [*profile, (0, r * 0.55), profile[0]], direction=(1, 0, 0), steps=28)
    wheel = parts.add("Wheel_L1", tyre, m["Rubber"], body, smooth_deg=50)
    rim = parts.new()
    dish = [
        (-w * 0.7, 0),
        (-w * 0.7, r * 0.63),
        (w * 0.8, r * 0.64),
        (w * 0.8, r * 0.56),
        (w * 0.3, r * 0.5),
        (w * 0.3, r * 0.24),
        (w * 0.9, r * 0.2),
        (w * 0.9, 0),
    ]
    shapes.lathe(rim, dish, direction=(1, 0, 0), steps=22)
    for k in range(5):
        a = 2 * math.pi * k / 5
        shapes.turned_box(
            rim,
            (w * 0.4, r * 0.38 * math.cos(a), r * 0.38 * math.sin(a)),
            (0.02, r * 0.4, 0.02),
            0,
            math.degrees(a),
        )
    parts.add("Wheel_L1Rim", rim, m["Steel"], wheel, smooth_deg=35)
    wheel.location = (-WHEEL_X, FRONT_Y, r)
    wheel.rotation_euler[2] = math.pi
    parts.copy(wheel, "Wheel_L2", body, (-WHEEL_X, REAR_Y, r), 180)
    parts.copy(wheel, "Wheel_R1", body, (WHEEL_X, FRONT_Y, r))
    parts.copy(wheel, "Wheel_R2", body, (WHEEL_X, REAR_Y, r))
