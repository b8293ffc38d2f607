"""Knee pads, cargo pockets and the holster. Metres; angles as in kit_parts.py."""

import numpy as np
from numpy.typing import NDArray

from .kit import Kit
from .kit_parts import (
    BLACK,
    BoxShape,
    Limb,
    SlabShape,
    nearest_weights,
    rigid_weights,
    rounded_box,
    slab,
)
from .quad_mesh import Layer

Array = NDArray[np.float64]


def _rounded_outline(angles: Array, along: Array) -> Array:
    """Narrow a knee pad towards both ends."""
    t = (along - along.mean()) / (np.ptp(along) / 2)
    return angles * np.sqrt(np.clip(1 - 0.45 * t * t, 0, 1))


def add_knee_pad(kit: Kit, side: str) -> None:
    """Strap a pad to the knee; it moves with the cloth below it."""
    heads = kit.rig.heads
    hip, knee, ankle = (heads[side + bone] for bone in ("UpperLeg", "LowerLeg", "Foot"))
    limb = Limb(
        kit.legs[side],
        start=knee + (ankle - knee) * 0.22,
        end=knee + (hip - knee) * 0.22,
        forward=np.array([0, 0, 1.0]),
        weights=nearest_weights(kit.uniform),
    )
    pad = SlabShape(
        angles=np.linspace(np.radians(-62), np.radians(62), 11),
        along=np.linspace(0.05, 0.95, 11),
        offset=0.007,
        thickness=0.014,
        smoothing=8,
        outline=_rounded_outline,
    )
    kit.add(slab(limb, pad)[0], kit.palette.main * 0.75, Layer.LEATHER, 0.3)
    for middle in (0.2, 0.75):
        strap = SlabShape(
            angles=np.linspace(0, 2 * np.pi, 25),
            along=np.linspace(middle - 0.05, middle + 0.05, 3),
            offset=0.001,
            thickness=0.004,
            bevel=0.002,
            smoothing=2,
        )
        kit.add(slab(limb, strap)[0], kit.palette.main * 0.6, Layer.WEBBING)


def add_cargo_pocket(kit: Kit, side: str) -> None:
    """Put a pocket of the uniform's cloth on the outer thigh."""
    seat, frame = _thigh(kit, side)
    _, up, normal = frame.T
    weights = rigid_weights(kit.rig, **{side + "UpperLeg": 1})
    bag = BoxShape((0.075, 0.085, 0.016), radius=0.013, segments=(5, 5, 2), bend=4.5)
    flap = BoxShape((0.078, 0.026, 0.010), radius=0.007, segments=(5, 2, 2), bend=4.5)
    for centre, shape in (
        (seat + normal * 0.001, bag),
        (seat + normal * 0.012 + up * 0.07, flap),
    ):
        part = kit.add(rounded_box(centre, frame, shape, weights), (0.2, 0.2, 0.2), Layer.WEAVE)
        part.camouflaged = True


def _thigh(kit: Kit, side: str) -> tuple[Array, Array]:
    """Return a point on the outer thigh and a frame there: columns right, up, outward."""
    hip, knee = kit.rig.heads[side + "UpperLeg"], kit.rig.heads[side + "LowerLeg"]
    middle = hip + (knee - hip) * 0.52
    outward = np.array([1 if side == "Left" else -1, 0, 0.15])
    outward /= np.linalg.norm(outward)
    seat = kit.legs[side].hit(middle + outward * 0.4, -outward, 0.4)
    if seat is None:
        raise ValueError(f"no {side.lower()} thigh under the cargo pocket")
    up = (hip - knee) / np.linalg.norm(hip - knee)
    normal = outward - up * (outward @ up)
    normal /= np.linalg.norm(normal)
    return seat, np.stack([np.cross(up, normal), up, normal], 1)


def add_holster(kit: Kit) -> None:
    """Hang a pistol in its holster outside the right thigh, below the belt."""
    seat, frame = _thigh(kit, "Right")
    right, up, normal = frame.T
    weights = rigid_weights(kit.rig, RightUpperLeg=0.75, Hips=0.25)
    body = BoxShape((0.032, 0.085, 0.018), radius=0.012)
    kit.add(
        rounded_box(seat + normal * 0.035 + up * 0.13, frame, body, weights),
        BLACK * 1.3,
        Layer.LEATHER,
    )
    grip = BoxShape((0.02, 0.04, 0.014), radius=0.008)
    at = seat + normal * 0.04 + up * 0.225 - right * 0.012
    kit.add(rounded_box(at, frame, grip, weights), BLACK, Layer.SMOOTH)
