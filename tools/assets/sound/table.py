"""Which sounds there are, by the names of their files. Those of several takes end in _1, _2, ..."""

from collections.abc import Callable
from functools import partial

import numpy as np

from . import blasts, bodies, machines, nature

# Kinds of sound that contact materials name: what strikes, what is stepped on, what is rubbed.
IMPACTS = (
    "cloth",
    "concrete",
    "dirt",
    "flesh",
    "glass",
    "gravel",
    "metal",
    "rubber",
    "sand",
    "wood",
)
STEPS = ("concrete", "dirt", "gravel", "metal", "sand", "wood")
SCRAPES = ("cloth", "concrete", "metal", "rubber", "sand", "wood")
# Revolutions (1/min) and speeds (m/s) of the loops. Neighbours are so near to one another that the
# pitch stays within 0.75 and 1.35: scripts/audio/loop_blend.gd.
RPMS = (700, 1200, 1800, 2600)
SPEEDS = (2.2, 3.4, 5.2, 8.0, 12.3)
# Peak, dB below full scale: of what is not in here -1, of loops -3.
PEAKS = {
    "machine_gun_near": -0.3,
    "cannon_near": -0.3,
    "explosion_near": -0.3,
    "bullet_crack": -0.5,
}
# Sounds of which nothing is left above 10 kHz: half the samples do.
DULL = ("cannon_far", "engine", "explosion_far", "rain_roof", "room", "tracks", "wind")

Maker = Callable[[], np.ndarray]


def sounds() -> dict[str, Maker]:
    """Every sound's maker by its name."""
    made: dict[str, Maker] = {}
    for function, takes in (
        (blasts.machine_gun_near, 3),
        (blasts.machine_gun_far, 2),
        (blasts.cannon_near, 2),
        (blasts.cannon_far, 1),
        (blasts.explosion_near, 2),
        (blasts.explosion_far, 1),
        (blasts.bullet_crack, 3),
        (blasts.ricochet, 3),
        (bodies.door_creak, 2),
        (bodies.door_shut, 2),
        (bodies.hatch, 2),
        (bodies.cloth, 3),
        (bodies.gear, 3),
    ):
        for take in range(takes):
            made[f"{function.__name__}_{take + 1}"] = partial(function, take)
    for kinds, name, function, takes in (
        (IMPACTS, "impact", bodies.impact, 3),
        (STEPS, "step", bodies.step, 4),
    ):
        for kind in kinds:
            for take in range(takes):
                made[f"{name}_{kind}_{take + 1}"] = partial(function, kind, take)
    made["gun_loaded"] = blasts.gun_loaded
    made["radio_begin"] = partial(bodies.radio_click, True)
    made["radio_end"] = partial(bodies.radio_click, False)
    return made | _loops()


def _loops() -> dict[str, Maker]:
    made: dict[str, Maker] = {}
    for rpm in RPMS:
        made[f"engine12_{rpm}_loop"] = partial(machines.engine, rpm, 12, 70)
        made[f"engine12_load_{rpm}_loop"] = partial(machines.engine_load, rpm, 12, 70)
        made[f"engine6_{rpm}_loop"] = partial(machines.engine, rpm, 6, 73)
        made[f"engine6_load_{rpm}_loop"] = partial(machines.engine_load, rpm, 6, 73)
    for speed in SPEEDS:
        made[f"tracks_{round(10 * speed)}_loop"] = partial(machines.tracks, speed)
    for kind in SCRAPES:
        made[f"scrape_{kind}_loop"] = partial(machines.scrape, kind)
    made["motor_loop"] = partial(machines.motor, 0.5)
    made["turret_loop"] = machines.turret
    made["tyres_loop"] = machines.tyres
    for function in (
        nature.wind,
        nature.sand_wind,
        nature.rain,
        nature.rain_roof,
        nature.fire,
        nature.room,
        nature.crickets,
        nature.birds,
    ):
        made[f"{function.__name__}_loop"] = function
    return made
