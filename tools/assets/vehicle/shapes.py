"""Simple solids added to a bmesh. Metres; the vehicle looks along +Y, +X is its right, +Z up."""

import itertools
import math

from mathutils import Matrix, Vector


def prism(bm, profile, x0, x1):
    """A profile of (y, z) points drawn from x0 to x1."""
    loft(bm, [[(x, y, z) for y, z in profile] for x in (x0, x1)])


def plan(bm, profile, z0, z1, top=1.0):
    """A profile of (x, y) points drawn from z0 to z1, scaled by `top` at its upper end."""
    loft(bm, [[(x, y, z0) for x, y in profile], [(x * top, y * top, z1) for x, y in profile]])


def box(bm, x0, x1, y0, y1, z0, z1):
    """A box between two corners."""
    prism(bm, [(y0, z0), (y1, z0), (y1, z1), (y0, z1)], x0, x1)


def turned_box(bm, centre, size, turn_z=0.0, turn_x=0.0):
    """A box about its centre, turned about X and then about Z (degrees)."""
    turn = Matrix.Rotation(math.radians(turn_z), 3, "Z") @ Matrix.Rotation(
        math.radians(turn_x), 3, "X"
    )
    half = [s / 2 for s in size]
    rings = []
    for y in (-half[1], half[1]):
        corners = ((-1, -1), (1, -1), (1, 1), (-1, 1))
        rings.append(
            [turn @ Vector((half[0] * a, y, half[2] * b)) + Vector(centre) for a, b in corners]
        )
    loft(bm, rings)


def loft(bm, rings, closed_ends=True):
    """Skins equally long rings of points."""
    made = [[bm.verts.new(p) for p in ring] for ring in rings]
    for one, next_one in itertools.pairwise(made):
        count = len(one)
        for k in range(count):
            j = (k + 1) % count
            bm.faces.new((one[k], one[j], next_one[j], next_one[k]))
    if closed_ends:
        bm.faces.new(list(reversed(made[0])))
        bm.faces.new(made[-1])


def pane(bm, points, outward):
    """A pane of glass that is seen from one side only: whoever sits behind it looks through."""
    corners = [Vector(p) for p in points]
    normal = (corners[1] - corners[0]).cross(corners[2] - corners[0])
    if normal.dot(Vector(outward)) < 0:
        corners.reverse()
    bm.faces.new([bm.verts.new(corner) for corner in corners])


def turned_frame(direction):
    """Two directions across one."""
    along = Vector(direction).normalized()
    other = Vector((0, 0, 1)) if abs(along.z) < 0.9 else Vector((0, 1, 0))
    across = along.cross(other).normalized()
    return along, across, along.cross(across)


def lathe(bm, profile, centre=(0, 0, 0), direction=(0, 0, 1), steps=24, turn=0.0):
    """Turns (along, radius) points about a direction; it closes where the radius is zero."""
    along, across, up = turned_frame(direction)
    rings = []
    for way, radius in profile:
        ring = []
        for k in range(steps if radius > 0 else 1):
            angle = 2 * math.pi * k / steps + turn
            offset = radius * (math.cos(angle) * across + math.sin(angle) * up)
            ring.append(bm.verts.new(Vector(centre) + along * way + offset))
        rings.append(ring)
    for one, next_one in itertools.pairwise(rings):
        for k in range(steps):
            j = (k + 1) % steps
            if len(one) == 1 and len(next_one) == 1:
                continue
            if len(one) == 1:
                bm.faces.new((one[0], next_one[k], next_one[j]))
            elif len(next_one) == 1:
                bm.faces.new((one[k], next_one[0], one[j]))
            else:
                bm.faces.new((one[k], next_one[k], next_one[j], one[j]))


def ring(bm, centre, direction, inner, outer, low, high, steps=32):
    """A flat ring with an open middle."""
    profile = [(low, inner), (low, outer), (high, outer), (high, inner), (low, inner)]
    lathe(bm, profile, centre, direction, steps)


def rod(bm, start, end, radius, steps=8, end_radius=None):
    """A round bar between two points."""
    way = Vector(end) - Vector(start)
    last = radius if end_radius is None else end_radius
    lathe(bm, [(0, 0), (0, radius), (way.length, last), (way.length, 0)], start, way, steps)


def tube(bm, points, radius, steps=6):
    """A round bar along a line of points; corners are mitred."""
    points = [Vector(p) for p in points]
    _, across, up = turned_frame(points[1] - points[0])
    rings = []
    for i, point in enumerate(points):
        before = (point - points[i - 1]).normalized() if i else None
        after = (points[i + 1] - point).normalized() if i + 1 < len(points) else None
        along = ((before or after) + (after or before)).normalized()
        across = (across - along * across.dot(along)).normalized()
        up = along.cross(across)
        angles = [2 * math.pi * k / steps for k in range(steps)]
        rings.append([point + radius * (math.cos(a) * across + math.sin(a) * up) for a in angles])
    loft(bm, rings)


def bolt(bm, at, direction, radius=0.014, height=0.012):
    """A hexagonal head."""
    lathe(bm, [(-0.002, radius), (height, radius * 0.85), (height, 0)], at, direction, 5)


def bolts(bm, start, end, count, direction, radius=0.014, height=0.012):
    """A row of heads from one point to another."""
    for k in range(count):
        bolt(bm, Vector(start).lerp(Vector(end), k / max(count - 1, 1)), direction, radius, height)


def bolt_circle(bm, centre, direction, circle, count, radius=0.014, height=0.012, turn=0.0):
    """Heads around a centre."""
    _, across, up = turned_frame(direction)
    for k in range(count):
        a = 2 * math.pi * k / count + turn
        spot = Vector(centre) + circle * (math.cos(a) * across + math.sin(a) * up)
        bolt(bm, spot, direction, radius, height)


def handle(bm, start, end, out, radius=0.010):
    """A grab handle: a bar that stands off a surface by `out` (a vector)."""
    start, end, out = Vector(start), Vector(end), Vector(out)
    inset = (end - start).normalized() * min(0.03, (end - start).length * 0.2)
    tube(
        bm,
        [start, start + out * 0.7, start + out + inset, end + out - inset, end + out * 0.7, end],
        radius,
        5,
    )


def eye(bm, centre, direction, radius=0.045, thick=0.014, steps=10):
    """A lifting eye: a torus."""
    _, across, up = turned_frame(direction)
    made = []
    for k in range(steps):
        a = 2 * math.pi * k / steps
        out = math.cos(a) * across + math.sin(a) * up
        side = turned_frame(direction)[0]
        spots = [2 * math.pi * j / 5 for j in range(5)]
        middle = Vector(centre) + radius * out
        made.append(
            [bm.verts.new(middle + thick * (math.cos(b) * out + math.sin(b) * side)) for b in spots]
        )
    for k in range(steps):
        one, next_one = made[k], made[(k + 1) % steps]
        for j in range(5):
            i = (j + 1) % 5
            bm.faces.new((one[j], one[i], next_one[i], next_one[j]))
