"""Road wheels, idlers, sprockets, suspension arms and links, for everything on tracks."""

import math
from dataclasses import dataclass, field

from . import parts, shapes

# What is between the pins' line and the surface that wheels run on, and the ground's side, m.
LINK_INNER, LINK_OUTER = 0.026, 0.058


@dataclass
class Gear:
    """Where the running gear of a tracked vehicle is: (y, z, radius), y ahead, m."""

    wheels: list
    idler: tuple
    sprocket: tuple
    rollers: list
    track_x: float
    track_width: float
    pitch: float
    teeth: int
    wheel_width: float = 0.20
    arm_x: tuple = (1.05, 1.16)
    spokes: int = 8
    arm_shift: tuple = field(default=(0.40, 0.22))


def make(gear, materials, body):
    """All that turns and swings, below the hull: one mesh each, shared by the copies."""
    steel, rubber, paint = (materials[n].made for n in ("Steel", "Rubber", "Plain"))
    wheel = idler = sprocket = arm = roller = None
    for side, letter in ((-1, "L"), (1, "R")):
        x, turn = side * gear.track_x, 0 if side > 0 else 180
        for number, (y, z, radius) in enumerate(gear.wheels, 1):
            name = f"Wheel_{letter}{number}"
            if wheel is None:
                wheel = road_wheel(name, radius, gear.wheel_width, rubber, paint, steel, body)
                wheel.location = (x, y, z)
                wheel.rotation_euler[2] = math.radians(turn)
            else:
                parts.copy(wheel, name, body, (x, y, z), turn)
            arm_name, inner = f"Arm_{letter}{number}", side * gear.arm_x[0]
            spot = (inner, y + gear.arm_shift[0], z + gear.arm_shift[1])
            if arm is None:
                arm = swing_arm(arm_name, gear, steel, body)
                arm.location = spot
            else:
                parts.copy(arm, arm_name, body, spot)
        y, z, radius = gear.idler
        if idler is None:
            idler = idler_wheel(f"Idler_{letter}", radius, gear.wheel_width, steel, paint, body)
            idler.rotation_euler[2] = math.radians(turn)
        else:
            parts.copy(idler, f"Idler_{letter}", body, (0, 0, 0), turn)
        parts.bpy.data.objects[f"Idler_{letter}"].location = (x, y, z)
        y, z, radius = gear.sprocket
        if sprocket is None:
            sprocket = cog(f"Cog_{letter}", gear, steel, paint, body)
            sprocket.rotation_euler[2] = math.radians(turn)
        else:
            parts.copy(sprocket, f"Cog_{letter}", body, (0, 0, 0), turn)
        parts.bpy.data.objects[f"Cog_{letter}"].location = (x, y, z)
        for number, (y, z, radius) in enumerate(gear.rollers, 1):
            name = f"Roller_{letter}{number}"
            if roller is None:
                roller = return_roller(name, radius, gear, rubber, steel, body)
                roller.location = (x, y, z)
                roller.rotation_euler[2] = math.radians(turn)
            else:
                parts.copy(roller, name, body, (x, y, z), turn)


def road_wheel(name, radius, width, rubber, paint, steel, body):
    """Twin discs with rubber tyres; guide horns run between them. Its outer face looks along +X."""
    bm = parts.new()
    for s in (-1, 1):
        rim = [(s * 0.055, radius * 0.82), (s * 0.055, radius * 0.985), (s * 0.07, radius)]
        rim += [
            (s * (width - 0.012), radius),
            (s * width, radius * 0.985),
            (s * width, radius * 0.82),
        ]
        shapes.lathe(bm, rim, direction=(1, 0, 0), steps=30)
    tyre = parts.add(name, bm, rubber, body, smooth_deg=50)
    disc = parts.new()
    inner, face = [(-width + 0.01, 0), (-width + 0.01, radius * 0.83)], width - 0.012
    shapes.lathe(disc, inner + [(-0.06, radius * 0.83), (-0.06, 0)], direction=(1, 0, 0), steps=26)
    dish = [(0.06, 0), (0.06, radius * 0.83), (face, radius * 0.84), (face, radius * 0.76)]
    dish += [
        (face - 0.05, radius * 0.68),
        (face - 0.065, radius * 0.42),
        (face - 0.01, radius * 0.36),
    ]
    dish += [(face + 0.006, radius * 0.33), (face + 0.006, 0)]
    shapes.lathe(disc, dish, direction=(1, 0, 0), steps=30)
    shapes.bolt_circle(disc, (face - 0.060, 0, 0), (1, 0, 0), radius * 0.53, 10, 0.017, 0.020)
    shapes.bolt_circle(disc, (face - 0.002, 0, 0), (1, 0, 0), radius * 0.80, 12, 0.011, 0.010)
    parts.add(name + "Disc", disc, paint, tyre, smooth_deg=32)
    hub = parts.new()
    cap = [
        (face, radius * 0.25),
        (face + 0.03, radius * 0.24),
        (face + 0.045, radius * 0.18),
        (face + 0.045, 0),
    ]
    shapes.lathe(hub, cap, direction=(1, 0, 0), steps=18)
    shapes.bolt_circle(hub, (face + 0.042, 0, 0), (1, 0, 0), radius * 0.13, 5, 0.009, 0.008)
    shapes.bolt_circle(hub, (face + 0.004, 0, 0), (1, 0, 0), radius * 0.295, 8, 0.010, 0.010)
    parts.add(name + "Hub", hub, steel, tyre, smooth_deg=32)
    return tyre


def idler_wheel(name, radius, width, steel, paint, body):
    """A wheel with openings, without a tyre."""
    bm = parts.new()
    for s in (-1, 1):
        profile = [
            (s * 0.06, radius * 0.80),
            (s * 0.06, radius),
            (s * width, radius),
            (s * width, radius * 0.80),
        ]
        shapes.lathe(bm, [*profile, profile[0]], direction=(1, 0, 0), steps=30)
    rim = parts.add(name, bm, steel, body, smooth_deg=35)
    disc = parts.new()
    face = width - 0.03
    for k in range(8):
        a = 2 * math.pi * k / 8
        spoke = [(0.07, 0.0), (face, 0.0)]
        middle = (0, radius * 0.58 * math.cos(a), radius * 0.58 * math.sin(a))
        shapes.turned_box(
            disc,
            (sum(s[0] for s in spoke) / 2, middle[1], middle[2]),
            (face - 0.07, radius * 0.5, 0.05),
            0,
            math.degrees(a),
        )
    shapes.lathe(
        disc,
        [(-width, 0), (-width, radius * 0.82), (-0.07, radius * 0.82), (-0.07, 0)],
        direction=(1, 0, 0),
        steps=26,
    )
    hub = [
        (0.0, radius * 0.40),
        (face + 0.02, radius * 0.38),
        (face + 0.05, radius * 0.28),
        (face + 0.05, 0),
    ]
    shapes.lathe(disc, hub, direction=(1, 0, 0), steps=22)
    shapes.bolt_circle(disc, (face + 0.048, 0, 0), (1, 0, 0), radius * 0.2, 6, 0.012, 0.012)
    parts.add(name + "Disc", disc, paint, rim, smooth_deg=32)
    return rim


def return_roller(name, radius, gear, rubber, steel, body):
    """A small roller that carries the upper run, on a bracket of the hull."""
    bm = parts.new()
    for s in (-1, 1):
        profile = [(s * 0.06, 0), (s * 0.06, radius), (s * 0.16, radius), (s * 0.16, 0)]
        shapes.lathe(bm, profile, direction=(1, 0, 0), steps=18)
    made = parts.add(name, bm, rubber, body)
    axle = parts.new()
    reach = gear.track_x - gear.arm_x[0] + 0.1
    shapes.lathe(
        axle, [(-reach, 0), (-reach, 0.05), (0.18, 0.05), (0.18, 0)], direction=(1, 0, 0), steps=12
    )
    parts.add(name + "Axle", axle, steel, made)
    return made


def swing_arm(name, gear, steel, body):
    """From its pivot (the origin) back and down to the wheel's hub."""
    bm = parts.new()
    dy, dz = -gear.arm_shift[0], -gear.arm_shift[1]
    width = gear.arm_x[1] - gear.arm_x[0]
    length = math.hypot(dy, dz)
    ny, nz = -dz / length, dy / length
    rings = []
    for share, half in ((-0.12, 0.085), (0.1, 0.10), (0.9, 0.07), (1.12, 0.06)):
        middle = (dy * share, dz * share)
        one = (middle[0] + ny * half, middle[1] + nz * half)
        other = (middle[0] - ny * half, middle[1] - nz * half)
        x = width / 2
        rings.append([(-x, *one), (x, *one), (x, *other), (-x, *other)])
    shapes.loft(bm, rings)
    shapes.lathe(
        bm, [(-0.12, 0), (-0.12, 0.11), (0.10, 0.11), (0.10, 0)], direction=(1, 0, 0), steps=16
    )
    shapes.lathe(
        bm, [(-0.30, 0), (-0.30, 0.06), (0.30, 0.06), (0.30, 0)], (0, dy, dz), (1, 0, 0), 12
    )
    return parts.add(name, bm, steel, body, bevel=0.012, segments=1)


def cog(name, gear, steel, paint, body):
    """The sprocket. A tooth points straight back; teeth stand between the connectors."""
    pitch_radius = gear.teeth * gear.pitch / (2 * math.pi)
    seat = pitch_radius - LINK_INNER - 0.012
    half = gear.track_width / 2
    bm = parts.new()
    for s in (-1, 1):
        x0, x1 = s * (half - 0.062), s * (half - 0.014)
        profile = [(x0, seat * 0.52), (x0, seat), (x1, seat), (x1, seat * 0.52), (x0, seat * 0.52)]
        shapes.lathe(bm, profile, direction=(1, 0, 0), steps=gear.teeth * 2)
        for k in range(gear.teeth):
            a = 2 * math.pi * k / gear.teeth + math.pi

            def at(radius, angle, x):
                return (x, radius * math.cos(angle), radius * math.sin(angle))

            foot, tip = 0.036 / pitch_radius, 0.014 / pitch_radius
            low, high = seat - 0.02, pitch_radius + 0.040
            waist = pitch_radius
            ring = []
            for x in (x0, x1):
                ring.append(
                    [
                        at(low, a - foot * 1.15, x),
                        at(waist, a - foot * 0.8, x),
                        at(high, a - tip, x),
                    ]
                    + [
                        at(high, a + tip, x),
                        at(waist, a + foot * 0.8, x),
                        at(low, a + foot * 1.15, x),
                    ]
                )
            shapes.loft(bm, ring)
        shapes.bolt_circle(bm, (x1 - s * 0.002, 0, 0), (s, 0, 0), seat * 0.80, 12, 0.014, 0.016)
    teeth = parts.add(name, bm, steel, body)
    hub = parts.new()
    drum = [
        (-half + 0.07, 0),
        (-half + 0.07, seat * 0.72),
        (-0.12, seat * 0.60),
        (0.10, seat * 0.60),
    ]
    drum += [(half - 0.07, seat * 0.66), (half - 0.02, seat * 0.52), (half - 0.01, seat * 0.34)]
    drum += [(half + 0.045, seat * 0.30), (half + 0.045, 0)]
    shapes.lathe(hub, drum, direction=(1, 0, 0), steps=28)
    shapes.bolt_circle(hub, (half - 0.016, 0, 0), (1, 0, 0), seat * 0.43, 8, 0.014, 0.014)
    shapes.bolt_circle(hub, (half + 0.043, 0, 0), (1, 0, 0), seat * 0.2, 6, 0.010, 0.010)
    parts.add(name + "Hub", hub, paint, teeth, smooth_deg=32)
    return teeth


def link(gear, materials, name="TrackLink"):
    """Along +Y by a pitch, the ground below (-Z), the origin in the pins' line between two pins."""
    steel, rubber = materials["Steel"].made, materials["Rubber"].made
    half, w = gear.pitch / 2, gear.track_width / 2
    bm = parts.new()
    for s in (-1, 1):
        body = [(-half + 0.016, -0.022), (half - 0.016, -0.022), (half - 0.010, 0.0)]
        body += [(half - 0.022, 0.024), (-half + 0.022, 0.024), (-half + 0.010, 0.0)]
        shapes.prism(bm, body, s * 0.040, s * (w - 0.072))
        # A connector around the pins of two links: teeth stand between connectors.
        knob = [
            (half - 0.040, -0.020),
            (half + 0.040, -0.020),
            (half + 0.040, 0.018),
            (half - 0.040, 0.018),
        ]
        shapes.prism(bm, knob, s * (w - 0.062), s * w)
        shapes.rod(bm, (s * 0.03, half, 0), (s * (w + 0.012), half, 0), 0.017, 6)
    shapes.prism(
        bm, [(-0.052, 0.012), (0.052, 0.012), (0.020, 0.115), (-0.020, 0.115)], -0.026, 0.026
    )
    made = parts.add(name, bm, steel, None)
    pad = parts.new()
    for s in (-1, 1):
        profile = [
            (-half + 0.024, -0.022),
            (half - 0.024, -0.022),
            (half - 0.038, -LINK_OUTER),
            (-half + 0.038, -LINK_OUTER),
        ]
        shapes.prism(pad, profile, s * 0.050, s * (w - 0.080))
    parts.add(name + "Pad", pad, rubber, made)
    # Above the ground while dust is baked; build.py puts it back.
    made.location = (0, 0, 0.35)
    return made


def names(gear):
    """The names of all nodes of the running gear."""
    found = []
    for letter in "LR":
        for number in range(1, len(gear.wheels) + 1):
            found += [f"Wheel_{letter}{number}", f"Arm_{letter}{number}"]
        found += [f"Idler_{letter}", f"Cog_{letter}"]
        found += [f"Roller_{letter}{n}" for n in range(1, len(gear.rollers) + 1)]
    return found
