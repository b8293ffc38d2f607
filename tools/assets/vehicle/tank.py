"""The battle tank: hull, turret, running gear, places that others ask for."""

from . import parts, running_gear, tank_hull, tank_turret, tank_wells

# Eight road wheels a side of 0.64 m on links of 0.16 m; the sprocket is behind.
GEAR = running_gear.Gear(
    wheels=[(2.40 - 0.685 * i, 0.404, 0.32) for i in range(8)],
    idler=(3.06, 0.69, 0.28),
    sprocket=(-3.10, 0.70, 0.33),
    rollers=[(1.95 - 1.31 * i, 0.89 + 0.015 * i, 0.09) for i in range(4)],
    track_x=1.40,
    track_width=0.60,
    pitch=0.16,
    teeth=14,
)


def make(materials):
    """Builds all; returns the names of the nodes that stay nodes."""
    body = tank_hull.make(materials)
    tank_turret.make(materials, body)
    running_gear.make(GEAR, materials, body)
    running_gear.link(GEAR, materials)
    markers(body)
    own = [
        "Hull",
        "Turret",
        "Gun",
        "Barrel",
        "HatchCommander",
        "HatchLoader",
        "FlapLeft",
        "FlapRight",
    ]
    own += ["AntennaLeft", "AntennaRight", "LampsFront", "LampsRear", "TrackLink"]
    return own + running_gear.names(GEAR)


def markers(body):
    """Ladder points: on the ground, on the step, on the fender, beside the commander's hatch."""
    for s, side in ((-1, "Left"), (1, "Right")):
        spots = [
            (s * 2.10, 2.42, 0.0),
            (s * 1.86, 2.42, 0.52),
            (s * 1.48, 2.30, 1.30),
            (s * 1.45, 0.45, 1.60),
        ]
        spots.append((s * 1.0, -0.9, tank_hull.TURRET_AT[2] + tank_wells.ROOF))
        for number, spot in enumerate(spots, 1):
            parts.marker(f"Ladder{side}{number}", body, spot)
        parts.marker(f"Exhaust{side}", body, (s * 1.38, -3.32, 1.74))
        parts.marker(f"HeadlightSpot{side}", body, (s * 1.34, 3.16, 1.26))
    parts.marker("DriverEye", body, (-0.58, 1.95, 1.62))
