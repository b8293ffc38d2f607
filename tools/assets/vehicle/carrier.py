"""The tracked carrier: a box of armour on five road wheels a side, a ramp, a machine gun."""

import math

from . import parts, running_gear, shapes

TEXTURE = 1536
# The sprocket is behind, as the tank's.
GEAR = running_gear.Gear(
    wheels=[(1.33 - 0.665 * i, 0.372, 0.305) for i in range(5)],
    idler=(1.98, 0.62, 0.20),
    sprocket=(-2.02, 0.60, 0.25),
    rollers=[(0.95, 0.79, 0.06), (-0.85, 0.79, 0.06)],
    track_x=1.08,
    track_width=0.38,
    pitch=0.152,
    teeth=10,
    wheel_width=0.13,
    arm_x=(0.80, 0.88),
    arm_shift=(0.28, 0.12),
)


def make(materials):
    """Builds all; returns the names of the nodes that stay nodes."""
    m = {name: material.made for name, material in materials.items()}
    body = hull(m)
    front(m, body)
    top(m, body)
    ramp(m, body)
    running_gear.make(GEAR, materials, body)
    running_gear.link(GEAR, materials)
    markers(body)
    own = ["Hull", "HatchCommander", "FlapRight", "AntennaLeft"]
    own += ["LampsFront", "LampsRear", "TrackLink"]
    return own + running_gear.names(GEAR)


def hull(m):
    """Tub between the tracks, upper box over them, trim vane in front."""
    bm = parts.new()
    tub = [(-2.22, 0.95), (-2.10, 0.42), (1.75, 0.41), (2.20, 0.75), (2.20, 0.95)]
    shapes.prism(bm, tub, -0.80, 0.80)
    body = parts.add("Hull", bm, m["Paint"], bevel=0.02)
    upper = parts.new()
    box = [(-2.42, 0.92), (2.30, 0.92), (2.34, 1.10), (1.55, 1.83), (-2.42, 1.83)]
    shapes.prism(upper, box, -1.32, 1.32)
    part = parts.add("HullUpper", upper, m["Paint"], body, bevel=0.025)
    hole = parts.new()
    shapes.lathe(hole, [(0.95, 0), (0.95, 0.34), (2.2, 0.34), (2.2, 0)], (0.0, 0.25, 0), steps=32)
    parts.cut(part, hole)
    inside = parts.new()
    wall = [(1.85, 0.31), (1.85, 0.338), (0.93, 0.338), (0.93, 0), (0.95, 0), (0.95, 0.31)]
    shapes.lathe(inside, [*wall, wall[0]], (0, 0.25, 0), steps=28)
    parts.add("Well", inside, m["Inside"], body)
    skirts, steel = parts.new(), parts.new()
    for s in (-1, 1):
        for y0, y1 in ((-2.35, -0.82), (-0.80, 0.78), (0.80, 2.05)):
            shapes.box(skirts, s * 1.325, s * 1.345, y0, y1, 0.66, 1.02)
            shapes.bolts(
                steel, (s * 1.345, y0 + 0.1, 0.98), (s * 1.345, y1 - 0.1, 0.98), 5, (s, 0, 0)
            )
        for y in (-1.9, -1.1, -0.3, 0.5, 1.2):
            shapes.eye(steel, (s * 1.33, y, 1.70), (0, 1, 0), 0.035, 0.010)
        shapes.handle(steel, (s * 1.33, 1.15, 1.25), (s * 1.33, 1.15, 1.50), (s * 0.06, 0, 0))
        shapes.handle(steel, (s * 1.33, 0.85, 1.45), (s * 1.33, 0.85, 1.70), (s * 0.06, 0, 0))
        parts.text(
            f"Number{s}", "37", m["Stencil"], body, (s * 1.323, 0.1, 1.40), 0.30, (90, 0, s * 90)
        )
    parts.add("Skirts", skirts, m["Paint"], body, bevel=0.005)
    parts.add("HullSteel", steel, m["Steel"], body, smooth_deg=32)
    return body


def front(m, body):
    """Trim vane, lamps, the driver's hatch with periscopes, tow hooks."""
    paint, steel, lens, glass = (parts.new() for _ in range(4))
    lean = math.degrees(math.atan2(0.73, 0.79))
    shapes.turned_box(paint, (0, 1.985, 1.475), (2.10, 0.95, 0.05), 0, -lean)
    shapes.bolts(steel, (-0.95, 2.27, 1.25), (0.95, 2.27, 1.25), 9, (0, 0.7, 0.7))
    for s in (-1, 1):
        for x in (1.00, 1.18):
            shapes.lathe(
                paint,
                [(-0.10, 0), (-0.09, 0.04), (0, 0.075), (0.03, 0.075), (0.03, 0.06)],
                (s * x, 2.36, 1.22),
                (0, 1, 0),
                18,
            )
            shapes.lathe(
                lens, [(0.01, 0.066), (0.02, 0.04), (0.024, 0)], (s * x, 2.36, 1.22), (0, 1, 0), 18
            )
        guard = [
            (s * 0.88, 2.30, 1.06),
            (s * 0.88, 2.44, 1.34),
            (s * 1.28, 2.44, 1.34),
            (s * 1.28, 2.30, 1.06),
        ]
        shapes.tube(steel, guard, 0.012)
        shapes.eye(steel, (s * 0.62, 2.24, 0.78), (1, 0, 0), 0.06, 0.02)
        shapes.prism(
            paint, [(1.75, 1.04), (2.40, 1.00), (2.42, 1.03), (1.75, 1.07)], s * 0.86, s * 1.33
        )
    at = (-0.62, 1.28, 1.83)
    shapes.lathe(
        paint, [(-0.02, 0), (-0.02, 0.27), (0.05, 0.26), (0.07, 0.2), (0.075, 0)], at, steps=28
    )
    for degrees in (-50, -17, 17, 50):
        a = math.radians(degrees)
        spot = (at[0] + 0.33 * math.sin(a), at[1] + 0.33 * math.cos(a), 1.87)
        shapes.turned_box(paint, spot, (0.17, 0.08, 0.10), -degrees)
        pane = (spot[0] + 0.042 * math.sin(a), spot[1] + 0.042 * math.cos(a), 1.885)
        shapes.turned_box(glass, pane, (0.13, 0.006, 0.05), -degrees)
    shapes.handle(
        steel, (at[0] - 0.08, at[1], 1.902), (at[0] + 0.08, at[1], 1.902), (0, 0, 0.03), 0.008
    )
    parts.add("FrontPaint", paint, m["Paint"], body, bevel=0.008)
    parts.add("FrontSteel", steel, m["Steel"], body, smooth_deg=32)
    parts.add("FrontGlass", glass, m["Glass"], body)
    parts.add("LampsFront", lens, m["Lens"], body)


def top(m, body):
    """Cupola with a heavy machine gun, cargo hatch, engine grilles, exhaust, antenna."""
    paint, steel, dark, glass = (parts.new() for _ in range(4))
    at = (0.0, 0.25, 1.83)
    ring = [(-0.01, 0.31), (-0.01, 0.44), (0.05, 0.44), (0.10, 0.39), (0.12, 0.36), (0.12, 0.31)]
    shapes.lathe(paint, [*ring, ring[0]], at, steps=36)
    for k in range(5):
        degrees = 45 + k * 22.5
        a = math.radians(degrees)
        spot = (0.42 * math.cos(a), 0.25 + 0.42 * math.sin(a), 1.92)
        shapes.turned_box(paint, spot, (0.08, 0.15, 0.09), degrees)
        pane = (0.462 * math.cos(a), 0.25 + 0.462 * math.sin(a), 1.93)
        shapes.turned_box(glass, pane, (0.006, 0.12, 0.05), degrees)
    # The machine gun on its mount before the cupola.
    shapes.rod(dark, (0, 0.72, 1.86), (0, 0.72, 2.14), 0.035)
    shapes.box(dark, -0.055, 0.055, 0.42, 0.98, 2.13, 2.28)
    barrel = [
        (0, 0.045),
        (0.30, 0.045),
        (0.31, 0.022),
        (0.95, 0.02),
        (0.96, 0.03),
        (1.05, 0.03),
        (1.05, 0),
    ]
    shapes.lathe(dark, barrel, (0, 0.96, 2.21), (0, 1, 0), 14)
    shapes.box(paint, -0.25, -0.065, 0.60, 0.85, 2.08, 2.26)
    for s in (-1, 1):
        shapes.rod(dark, (s * 0.03, 0.42, 2.20), (s * 0.06, 0.38, 2.30), 0.014)
    # Cargo hatch behind, its hinges and lifting handles.
    shapes.box(paint, -0.66, 0.66, -1.75, -0.42, 1.825, 1.875)
    for s in (-1, 1):
        shapes.rod(steel, (s * 0.35, -1.80, 1.865), (s * 0.55, -1.80, 1.865), 0.028, 10)
        shapes.handle(steel, (s * 0.3, -0.60, 1.873), (s * 0.5, -0.60, 1.873), (0, 0, 0.04))
    # Engine grille and exhaust at the right of the driver.
    shapes.box(dark, 0.20, 1.10, 0.86, 1.50, 1.825, 1.845)
    for k in range(9):
        shapes.turned_box(steel, (0.65, 0.91 + k * 0.066, 1.852), (0.9, 0.045, 0.010), 0, 28)
    pipe = [(0, 0), (0, 0.062), (0.16, 0.062), (0.16, 0.05), (0.03, 0.048), (0.03, 0)]
    shapes.lathe(dark, pipe, (1.18, 0.78, 1.82), steps=18)
    flap = parts.new()
    shapes.lathe(flap, [(0, 0), (0, 0.068), (0.012, 0.066), (0.012, 0)], (0, 0.066, 0), steps=18)
    shapes.box(flap, -0.025, 0.025, -0.02, 0.03, -0.006, 0.022)
    parts.add("FlapRight", flap, m["Dark"], body, at=(1.18, 0.714, 1.985))
    lid(m, body, "HatchCommander", (0.0, 0.25), 0.33, 1.955)
    shapes.lathe(
        dark, [(0, 0.06), (0.05, 0.05), (0.12, 0.03), (0.14, 0)], (-1.18, -1.2, 1.83), steps=14
    )
    whip = parts.new()
    rings = [(2.0 * k / 6, 0.011 - 0.007 * k / 6) for k in range(7)]
    shapes.lathe(whip, [(0, 0), *rings, (2.0, 0)], steps=5)
    parts.add("AntennaLeft", whip, m["Dark"], body, at=(-1.18, -1.2, 1.96))
    parts.add("TopPaint", paint, m["Paint"], body, bevel=0.008)
    parts.add("TopSteel", steel, m["Steel"], body, smooth_deg=32)
    parts.add("TopDark", dark, m["Dark"], body, smooth_deg=32)
    parts.add("TopGlass", glass, m["Glass"], body)


def lid(m, body, name, middle, radius, high):
    """A hatch, hinged at its rear edge."""
    bm = parts.new()
    reach = radius + 0.05
    shapes.lathe(
        bm,
        [(0, 0), (0, radius), (0.03, radius), (0.05, radius - 0.06), (0.055, 0)],
        (0, reach, 0),
        steps=32,
    )
    shapes.box(bm, -0.12, 0.12, -0.03, 0.14, 0, 0.035)
    shapes.handle(bm, (-0.08, reach, 0.053), (0.08, reach, 0.053), (0, 0, 0.03), 0.009)
    parts.add(name, bm, m["Paint"], body, bevel=0.006, at=(middle[0], middle[1] - reach, high))


def ramp(m, body):
    """The ramp at the rear with its door, lamps, tow gear, boxes."""
    paint, steel, red = parts.new(), parts.new(), parts.new()
    shapes.box(paint, -0.92, 0.92, -2.50, -2.41, 0.62, 1.74)
    shapes.box(paint, -0.30, 0.40, -2.53, -2.49, 0.80, 1.58)
    shapes.rod(steel, (-0.9, -2.47, 0.62), (0.9, -2.47, 0.62), 0.04, 10)
    shapes.rod(steel, (0.46, -2.53, 1.15), (0.46, -2.53, 1.35), 0.014)
    shapes.handle(steel, (-0.20, -2.53, 1.10), (-0.20, -2.53, 1.30), (0, -0.05, 0))
    for s in (-1, 1):
        shapes.box(paint, s * 0.98, s * 1.28, -2.62, -2.42, 1.06, 1.62)
        shapes.lathe(
            red, [(0, 0.045), (0.012, 0.04), (0.018, 0)], (s * 1.13, -2.425, 0.98), (0, -1, 0), 16
        )
        shapes.eye(steel, (s * 0.62, -2.32, 0.56), (1, 0, 0), 0.055, 0.018)
        for z in (1.20, 1.48):
            shapes.box(steel, s * 1.00, s * 1.26, -2.632, -2.618, z, z + 0.035)
    parts.text("RearNumber", "37", m["Stencil"], body, (-0.62, -2.503, 1.45), 0.22, (90, 0, 180))
    parts.add("RampPaint", paint, m["Paint"], body, bevel=0.010)
    parts.add("RampSteel", steel, m["Steel"], body, smooth_deg=32)
    parts.add("LampsRear", red, m["Red"], body)


def markers(body):
    """Places that others ask for."""
    parts.marker("CommanderHatchMiddle", body, (0.0, 0.25, 1.95))
    parts.marker("Muzzle", body, (0.0, 2.02, 2.21))
    parts.marker("ExhaustRight", body, (1.18, 0.78, 2.02))
    parts.marker("DriverEye", body, (-0.62, 1.4, 1.95))
    for s, side in ((-1, "Left"), (1, "Right")):
        parts.marker(f"HeadlightSpot{side}", body, (s * 1.09, 2.42, 1.22))
        for number, spot in enumerate(
            ((s * 1.7, 1.0, 0), (s * 1.42, 1.0, 1.25), (s * 1.1, 0.8, 1.83)), 1
        ):
            parts.marker(f"Ladder{side}{number}", body, spot)
