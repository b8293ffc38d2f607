"""The wells below the battle tank's hatches, in which people stand."""

import math

from . import parts, shapes

ROOF = 0.74
COMMANDER = (0.52, -0.42)
LOADER = (-0.52, -0.54)
# Clear radius of the commander's ring and of the loader's, and how deep their wells are, m.
COMMANDER_RADIUS, LOADER_RADIUS, WELL_DEPTH = 0.31, 0.27, 1.22


def make(m, turret):
    """Tubes below the hatches in which people stand, with a seat's edge, boxes and a floor."""
    bm, dark, canvas = parts.new(), parts.new(), parts.new()
    for (x, y), radius in ((COMMANDER, COMMANDER_RADIUS), (LOADER, LOADER_RADIUS)):
        # Wider below the roof: shoulders turn there.
        wide, floor = radius + 0.02, ROOF - WELL_DEPTH
        wall = [
            (ROOF + 0.01, radius),
            (ROOF - 0.06, radius),
            (ROOF - 0.10, wide),
            (floor, wide),
            (floor, 0),
        ]
        wall += [
            (floor - 0.02, 0),
            (floor - 0.02, wide + 0.02),
            (ROOF - 0.10, wide + 0.02),
            (ROOF - 0.06, radius + 0.025),
        ]
        wall.append((ROOF + 0.01, radius + 0.025))
        shapes.lathe(bm, [*wall, wall[0]], (x, y, 0), steps=28)
        shapes.ring(
            dark, (x, y, ROOF - 0.075), (0, 0, 1), radius - 0.004, radius + 0.02, 0, 0.03, 32
        )
        for degrees, high in ((200, 0.22), (250, 0.10), (310, 0.26), (25, 0.18)):
            a = math.radians(degrees)
            spot = (x + (wide - 0.03) * math.cos(a), y + (wide - 0.03) * math.sin(a), high)
            shapes.turned_box(dark, spot, (0.07, 0.16, 0.13), degrees)
        shapes.turned_box(canvas, (x, y - wide + 0.10, 0.02), (0.34, 0.16, 0.07))
    parts.add("Wells", bm, m["Inside"], turret)
    parts.add("WellBoxes", dark, m["Dark"], turret, bevel=0.008, segments=1)
    parts.add("WellSeats", canvas, m["Canvas"], turret, bevel=0.015)
    parts.marker("CommanderHatchMiddle", turret, (*COMMANDER, ROOF + 0.12))
    parts.marker("LoaderHatchMiddle", turret, (*LOADER, ROOF + 0.06))
