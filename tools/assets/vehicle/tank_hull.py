"""The battle tank's hull: armour, mudguards, skirts, engine deck, driver's hatch, lamps, tools."""

import math

from . import parts, shapes, tank_hull_ends

TURRET_AT = (0.0, 0.15, 1.50)
WELL_RADIUS = 1.05


def make(materials):
    """Builds the hull and all on it; returns its part."""
    m = {name: material.made for name, material in materials.items()}
    body = armour(m)
    skirts(m, body)
    fenders(m, body)
    deck(m, body)
    tank_hull_ends.front(m, body)
    tank_hull_ends.rear(m, body)
    tools(m, body)
    tank_hull_ends.flaps(m, body)
    return body


def armour(m):
    """Tub, upper hull, sponsons, and the ring on which the turret turns."""
    bm = parts.new()
    # Tub between the tracks.
    tub = [(-3.50, 1.06), (-3.56, 0.95), (-3.30, 0.50), (2.80, 0.48), (3.58, 0.96), (3.66, 1.06)]
    shapes.prism(bm, tub, -1.04, 1.04)
    body = parts.add("Hull", bm, m["Paint"], bevel=0.02)
    upper = parts.new()
    # Upper hull over the tracks: nose, glacis, roof, engine deck.
    roof = [
        (-3.60, 1.04),
        (3.68, 1.04),
        (3.72, 1.12),
        (2.02, 1.475),
        (-1.30, 1.515),
        (-1.36, 1.555),
    ]
    roof += [(-3.58, 1.535), (-3.66, 1.10)]
    shapes.prism(upper, roof, -1.12, 1.12)
    upper_part = parts.add("HullUpper", upper, m["Paint"], body, bevel=0.02)
    well = parts.new()
    x, y, _ = TURRET_AT
    shapes.lathe(
        well, [(0.98, 0), (0.98, WELL_RADIUS), (1.8, WELL_RADIUS), (1.8, 0)], (x, y, 0), steps=40
    )
    parts.cut(upper_part, well)
    well = parts.new()
    shapes.lathe(
        well, [(0.98, 0), (0.98, WELL_RADIUS), (1.8, WELL_RADIUS), (1.8, 0)], (x, y, 0), steps=40
    )
    parts.cut(body, well)
    sponsons = parts.new()
    for s in (-1, 1):
        side = [
            (-3.62, 1.15),
            (3.02, 1.15),
            (3.10, 1.19),
            (1.98, 1.44),
            (-1.30, 1.475),
            (-3.60, 1.475),
        ]
        shapes.prism(sponsons, side, s * 1.10, s * 1.70)
    parts.add("HullSponsons", sponsons, m["Paint"], body, bevel=0.02)
    ring = parts.new()
    shapes.ring(ring, (x, y, 1.47), (0, 0, 1), WELL_RADIUS - 0.03, WELL_RADIUS + 0.05, 0, 0.075, 36)
    parts.add("HullRing", ring, m["Dark"], body)
    return body


def skirts(m, body):
    """Plates over the upper run, the front ones thick; steps below them."""
    plates, trims, fixings = parts.new(), parts.new(), parts.new()
    for s in (-1, 1):
        for i in range(7):
            y1 = 3.06 - i * 0.945
            y0, low = y1 - 0.925, 0.60 if i < 3 else 0.70
            thick = 0.055 if i < 3 else 0.022
            face = s * (1.73 + thick)
            profile = [
                (y0, low + 0.05),
                (y0 + 0.06, low),
                (y1 - 0.06, low),
                (y1, low + 0.05),
                (y1, 1.27),
                (y0, 1.27),
            ]
            if i == 0:
                profile = [
                    (y0, low + 0.05),
                    (y0 + 0.06, low),
                    (y1 - 0.34, low),
                    (y1, low + 0.36),
                    (y1, 1.27),
                    (y0, 1.27),
                ]
            shapes.prism(plates, profile, s * 1.73, face)
            shapes.bolts(
                fixings,
                (face, y0 + 0.10, 1.21),
                (face, y1 - 0.10, 1.21),
                4,
                (s, 0, 0),
                0.016,
                0.012,
            )
            if i < 3:
                shapes.bolts(
                    fixings,
                    (face, y0 + 0.10, 0.98),
                    (face, y1 - 0.36, 0.98),
                    3,
                    (s, 0, 0),
                    0.020,
                    0.016,
                )
            else:
                shapes.prism(
                    trims,
                    [(y0 + 0.03, 0.94), (y1 - 0.03, 0.94), (y1 - 0.03, 0.975), (y0 + 0.03, 0.975)],
                    s * 1.745,
                    s * 1.768,
                )
            # Hinges.
            for y in (y0 + 0.18, y1 - 0.18):
                shapes.rod(
                    fixings, (s * 1.745, y - 0.05, 1.292), (s * 1.745, y + 0.05, 1.292), 0.018, 6
                )
            shapes.handle(
                fixings,
                (face, (y0 + y1) / 2 - 0.07, 0.86),
                (face, (y0 + y1) / 2 + 0.07, 0.86),
                (s * 0.035, 0, 0),
                0.007,
            )
        # Two steps for climbing on, below the front plates.
        for y in (2.42, 0.55):
            shapes.tube(
                trims,
                [
                    (s * 1.79, y - 0.14, 0.64),
                    (s * 1.81, y - 0.14, 0.50),
                    (s * 1.81, y + 0.14, 0.50),
                    (s * 1.79, y + 0.14, 0.64),
                ],
                0.013,
                6,
            )
    parts.add("Skirts", plates, m["Paint"], body, bevel=0.008)
    parts.add("SkirtTrims", trims, m["Plain"], body)
    parts.add("SkirtFixings", fixings, m["Steel"], body, smooth_deg=32)


def fenders(m, body):
    """Mudguards with rubber flaps."""
    sheet, rubber, ribs = parts.new(), parts.new(), parts.new()
    for s in (-1, 1):
        front = [
            (2.95, 1.09),
            (3.50, 1.06),
            (3.78, 0.93),
            (3.92, 0.76),
            (3.94, 0.775),
            (3.80, 0.955),
            (3.51, 1.085),
            (2.95, 1.115),
        ]
        shapes.prism(sheet, front, s * 1.06, s * 1.77)
        back = [
            (-3.55, 1.10),
            (-3.55, 1.125),
            (-3.86, 1.115),
            (-3.97, 1.03),
            (-3.955, 1.015),
            (-3.85, 1.09),
        ]
        shapes.prism(sheet, back, s * 1.06, s * 1.77)
        shapes.prism(
            rubber, [(3.905, 0.78), (3.925, 0.785), (3.955, 0.50), (3.94, 0.50)], s * 1.09, s * 1.75
        )
        shapes.prism(
            rubber,
            [(-3.955, 1.03), (-3.975, 1.03), (-4.00, 0.62), (-3.985, 0.62)],
            s * 1.09,
            s * 1.75,
        )
        for x in (1.27, 1.57):
            rib = [
                (3.02, 1.115),
                (3.50, 1.085),
                (3.80, 0.955),
                (3.81, 0.967),
                (3.51, 1.102),
                (3.02, 1.130),
            ]
            shapes.prism(ribs, rib, s * (x - 0.012), s * (x + 0.012))
        shapes.bolts(ribs, (s * 1.14, 3.93, 0.80), (s * 1.70, 3.93, 0.80), 6, (0, 1, 0.2), 0.012)
    parts.add("Fenders", sheet, m["Paint"], body, bevel=0.004, segments=1)
    parts.add("FenderRibs", ribs, m["Plain"], body)
    parts.add("MudFlaps", rubber, m["Rubber"], body)


def deck(m, body):
    """Grilles, fans, filler caps, stowage boxes."""
    dark, steel, paint = parts.new(), parts.new(), parts.new()
    for s in (-1, 1):
        # Intake grilles with slats, and radiator fans under guards.
        shapes.box(dark, s * 0.16, s * 1.02, -2.14, -1.50, 1.535, 1.562)
        for i in range(9):
            shapes.turned_box(
                steel, (s * 0.59, -2.09 + i * 0.068, 1.575), (0.84, 0.052, 0.010), 0, 28
            )
        for x in (0.15, 0.45, 0.74, 1.03):
            shapes.box(steel, s * (x - 0.012), s * (x + 0.012), -2.15, -1.49, 1.535, 1.595)
        middle = (s * 0.56, -2.80, 1.545)
        shapes.lathe(dark, [(0, 0), (0, 0.36), (0.01, 0.36), (0.012, 0)], middle, steps=36)
        shapes.ring(paint, middle, (0, 0, 1), 0.36, 0.41, 0, 0.05, 40)
        for radius in (0.09, 0.18, 0.27):
            shapes.ring(steel, middle, (0, 0, 1), radius - 0.008, radius + 0.008, 0.030, 0.042, 30)
        for k in range(8):
            a = math.pi * k / 4
            end = (middle[0] + 0.37 * math.cos(a), middle[1] + 0.37 * math.sin(a), 1.583)
            shapes.rod(steel, (middle[0], middle[1], 1.583), end, 0.009, 6)
        shapes.bolt_circle(steel, (middle[0], middle[1], 1.595), (0, 0, 1), 0.385, 12, 0.012)
        # Filler caps and lifting eyes.
        shapes.lathe(
            paint,
            [(0, 0), (0, 0.085), (0.03, 0.08), (0.035, 0)],
            (s * 0.93, -3.36, 1.535),
            steps=20,
        )
        shapes.handle(
            steel, (s * 0.88, -3.36, 1.568), (s * 0.98, -3.36, 1.568), (0, 0, 0.03), 0.007
        )
        for y in (-1.40, -3.48):
            shapes.eye(steel, (s * 1.06, y, 1.565), (1, 0, 0), 0.035, 0.012)
        # Stowage boxes on the sponsons.
        for y0, y1, high in ((-1.02, 0.02, 1.635), (-2.30, -1.10, 1.62), (0.10, 0.98, 1.60)):
            shapes.box(paint, s * 1.20, s * 1.69, y0, y1, 1.465, high)
            shapes.box(
                paint, s * 1.19, s * 1.70, y0 - 0.008, y1 + 0.008, high - 0.035, high + 0.012
            )
            for y in (y0 + 0.2, y1 - 0.2):
                shapes.box(
                    steel, s * 1.698, s * 1.712, y - 0.025, y + 0.025, high - 0.09, high - 0.005
                )
    shapes.bolts(steel, (-1.05, -1.44, 1.552), (1.05, -1.44, 1.552), 9, (0, 0, 1), 0.013)
    shapes.bolts(steel, (-1.05, -3.52, 1.545), (1.05, -3.52, 1.545), 9, (0, 0, 1), 0.013)
    shapes.box(paint, -0.11, 0.11, -3.42, -1.52, 1.545, 1.575)
    shapes.handle(steel, (0.0, -1.80, 1.573), (0.0, -1.62, 1.573), (0, 0, 0.04), 0.009)
    parts.add("DeckDark", dark, m["Dark"], body)
    parts.add("DeckSteel", steel, m["Steel"], body, smooth_deg=32)
    parts.add("DeckPaint", paint, m["Paint"], body, bevel=0.008)


def tools(m, body):
    """What is strapped to the sponsons."""
    wood, steel = parts.new(), parts.new()
    # Shovel, axe and crowbar along the left sponson, jack block behind.
    shapes.rod(wood, (-1.16, 1.05, 1.53), (-1.16, 1.92, 1.475), 0.019, 6)
    shapes.turned_box(steel, (-1.16, 0.94, 1.54), (0.16, 0.24, 0.018), 0, 4)
    shapes.rod(wood, (1.24, 1.08, 1.495), (1.24, 1.84, 1.472), 0.018, 6)
    shapes.turned_box(steel, (1.30, 1.78, 1.50), (0.20, 0.07, 0.035))
    shapes.rod(steel, (1.36, 1.06, 1.50), (1.36, 2.00, 1.462), 0.014, 6)
    for y in (1.25, 1.62):
        shapes.box(steel, -1.20, -1.12, y - 0.015, y + 0.015, 1.46, 1.545)
        shapes.box(steel, 1.20, 1.40, y - 0.015, y + 0.015, 1.45, 1.515)
    shapes.box(wood, -1.64, -1.34, 1.12, 1.42, 1.45, 1.555)
    parts.add("ToolWood", wood, m["Wood"], body, bevel=0.004, segments=1)
    parts.add("ToolSteel", steel, m["Steel"], body, bevel=0.003, segments=1)
