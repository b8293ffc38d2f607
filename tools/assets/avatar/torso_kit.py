"""Plate carrier, belt, pouches, pack and shoulder straps. Metres; angles as in kit_parts.py."""

import numpy as np
from numpy.typing import NDArray

from .kit import Kit
from .kit_parts import (
    COYOTE,
    RANGER_GREEN,
    BoxShape,
    Limb,
    Panel,
    SlabShape,
    grid_mesh,
    rigid_weights,
    rounded_box,
    slab,
    spine_weights,
)
from .rig import SIDES

Array = NDArray[np.float64]

_FORWARD = np.array([0, 0, 1.0])
_WEBBING = RANGER_GREEN * 0.72
_STRAP_SECTION = (
    (-0.027, -0.004),
    (-0.025, 0.006),
    (0, 0.008),
    (0.025, 0.006),
    (0.027, -0.004),
    (0, -0.008),
)
_STRAP_X = 0.088
"""Distance of a shoulder strap from the middle."""


def _tapered(angles: Array, along: Array) -> Array:
    """Narrow a plate towards its top, as real plates are cut for the shoulders."""
    height = (along - along.min()) / (along.max() - along.min())
    cut = np.clip((height - 0.62) / 0.38, 0, 1) ** 1.5
    centre = angles[0].mean()
    return centre + (angles - centre) * (1 - 0.38 * cut)


class TorsoKit:
    """Builds everything that hangs on the torso, piece by piece."""

    def __init__(self, kit: Kit) -> None:
        self._kit = kit
        heads = kit.rig.heads
        self._weights = spine_weights(kit.rig)
        self._start = np.array([0, heads["Hips"][1] - 0.05, heads["Spine"][2]])
        self._end = np.array([0, heads["Neck"][1] + 0.02, heads["UpperChest"][2]])
        self._waist = heads["Spine"][1]
        self._plate_top = heads["Neck"][1] - 0.035
        self._plate_bottom = self._waist + 0.075
        self._build_panels()

    def _limb(self, forward: Array) -> Limb:
        return Limb(self._kit.torso, self._start, self._end, forward, self._weights)

    def _along(self, y: float) -> float:
        """Return where a height lies on the torso's axis, 0 to 1."""
        return (y - self._start[1]) / (self._end[1] - self._start[1])

    def _slab(self, forward: Array, shape: SlabShape, colour: Array) -> Panel:
        mesh, panel = slab(self._limb(forward), shape)
        self._kit.add(mesh, colour)
        return panel

    def _build_panels(self) -> None:
        """Make the two plates, the cummerbund's sides and the belt."""
        bottom, top = self._plate_bottom, self._plate_top
        plate_angles = np.linspace(np.radians(-50), np.radians(50), 17)
        plate_along = np.linspace(self._along(bottom), self._along(top), 15)
        front = SlabShape(plate_angles, plate_along, 0.012, 0.028, smoothing=10, outline=_tapered)
        back = SlabShape(plate_angles, plate_along, 0.010, 0.026, smoothing=10, outline=_tapered)
        self._front = self._slab(_FORWARD, front, RANGER_GREEN)
        self._back = self._slab(-_FORWARD, back, RANGER_GREEN)
        side_along = np.linspace(self._along(bottom + 0.01), self._along(bottom + 0.15), 7)
        self._sides = []
        for first, last in ((38, 142), (-142, -38)):
            angles = np.linspace(np.radians(first), np.radians(last), 13)
            shape = SlabShape(angles, side_along, 0.008, 0.012)
            self._sides.append(self._slab(_FORWARD, shape, RANGER_GREEN * 0.9))
        belt_along = np.linspace(
            self._along(self._waist - 0.055), self._along(self._waist - 0.005), 5
        )
        belt = SlabShape(np.linspace(0, 2 * np.pi, 49), belt_along, 0.006, 0.010, smoothing=8)
        self._belt = self._slab(_FORWARD, belt, RANGER_GREEN * 0.8)

    def _add_webbing(self, panel: Panel, y: float, first: float, last: float, count: int) -> None:
        """Lay a 25 mm band on a panel at height y, between two angles in degrees."""
        half = 0.0125
        middle = np.array([0, 0, ((self._start + self._end) / 2)[2]])
        rows = []
        for rise, lift in (
            (-half, -0.001),
            (-half + 0.001, 0.0035),
            (half - 0.001, 0.0035),
            (half, -0.001),
        ):
            points = panel.ring(y + rise, np.radians(first), np.radians(last), count)
            outward = points - middle
            outward[:, 1] = 0
            outward /= np.linalg.norm(outward, axis=1, keepdims=True)
            rows.append(points + outward * lift)
        band = np.stack(rows)
        outward = band.reshape(-1, 3) - (middle + [0, y, 0])
        self._kit.add(grid_mesh(band, self._weights, outward=outward), _WEBBING)

    def _add_box(self, centre: Array, frame: Array, shape: BoxShape, colour: Array) -> None:
        self._kit.add(rounded_box(centre, frame, shape, self._weights), colour)

    def add_webbing(self) -> None:
        """Lay rows of webbing on plates and sides."""
        bottom = self._plate_bottom
        for rise in (0.045, 0.095, 0.145, 0.195):
            self._add_webbing(self._front, bottom + rise, -46, 46, 15)
        for rise in (0.04, 0.09, 0.14, 0.19, 0.24):
            self._add_webbing(self._back, bottom + rise, -46, 46, 15)
        for rise in (0.05, 0.10):
            self._add_webbing(self._sides[0], bottom + rise, 44, 136, 13)
            self._add_webbing(self._sides[1], bottom + rise, -136, -44, 13)

    def add_plate_pouches(self) -> None:
        """Hang three magazine pouches and an admin pouch in front, a pack at the back."""
        bottom = self._plate_bottom
        for degrees in (-24, 0, 24):
            at, frame = self._front.place(np.radians(degrees), bottom + 0.085)
            _, up, out = frame.T
            pouch = BoxShape((0.039, 0.075, 0.019), radius=0.009)
            self._add_box(at + out * 0.012, frame, pouch, COYOTE * 0.55 + RANGER_GREEN * 0.45)
            flap = BoxShape((0.016, 0.045, 0.004), radius=0.003)
            self._add_box(at + out * 0.034 + up * 0.02, frame, flap, RANGER_GREEN * 0.6)
        at, frame = self._front.place(0, bottom + 0.25)
        admin = BoxShape((0.085, 0.045, 0.012), radius=0.008, bend=1.2)
        self._add_box(at + frame[:, 2] * 0.004, frame, admin, RANGER_GREEN * 1.05)
        at, frame = self._back.place(0, bottom + 0.20)
        _, up, out = frame.T
        pack = BoxShape((0.11, 0.14, 0.045), radius=0.025, segments=(5, 5, 3))
        self._add_box(at + out * 0.035, frame, pack, RANGER_GREEN * 0.95)
        pocket = BoxShape((0.08, 0.08, 0.018), radius=0.012)
        self._add_box(at + out * 0.085 - up * 0.03, frame, pocket, RANGER_GREEN)

    def add_shoulder_strap(self, side: str) -> None:
        """Sweep a strap from the front plate over the shoulder to the back plate."""
        path = self._strap_path(_STRAP_X if side == SIDES[0] else -_STRAP_X)
        tangents = np.gradient(path, axis=0)
        tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
        across = np.array([1.0, 0, 0])
        outward = np.cross(across, tangents)
        body_middle = np.array([path[0, 0], 1.2, 0])
        outward *= np.sign((outward * (path - body_middle)).sum(1, keepdims=True))
        sections = np.stack([path + across * a + outward * b for a, b in _STRAP_SECTION], 1)
        facing = sections.reshape(-1, 3) - path.mean(0)
        self._kit.add(grid_mesh(sections, self._weights, closed=True, outward=facing), RANGER_GREEN)

    def _strap_path(self, x: float) -> Array:
        """Trace the strap's middle line over the torso, front to back."""
        top, torso = self._plate_top, self._kit.torso

        def depth(y: float, facing: int) -> float:
            hit = torso.hit((x, y, facing * 0.6), (0, 0, -facing), 1.2)
            if hit is None:
                raise ValueError(f"no torso under the shoulder strap at x={x:.3f}, y={y:.3f}")
            return hit[2]

        path = [(x, y, depth(y, 1) + 0.03) for y in np.linspace(top - 0.09, top - 0.01, 4)]
        front, back = depth(top - 0.01, 1), depth(top - 0.01, -1)
        for share in np.linspace(0.1, 0.9, 8):
            z = front + (back - front) * share
            hit = torso.hit((x, 2.2, z), (0, -1, 0), 1.5)
            path.append((x, (top if hit is None else hit[1]) + 0.014, z))
        path += [(x, y, depth(y, -1) - 0.028) for y in np.linspace(top - 0.01, top - 0.09, 4)]
        points = np.array(path)
        for _ in range(3):
            points[1:-1] = (points[:-2] + 2 * points[1:-1] + points[2:]) / 4
        return points

    def add_belt_pouches(self, side: str) -> None:
        """Hang pouches on the belt; the front right place is left to the holster."""
        sign = 1 if side == "Left" else -1
        pouches = [(118, (0.05, 0.06, 0.03))]
        if side == "Left":
            pouches.insert(0, (62, (0.045, 0.055, 0.025)))
        for degrees, half in pouches:
            at, frame = self._belt.place(np.radians(degrees * sign), self._waist - 0.05)
            centre = at + frame[:, 2] * half[2] * 0.8 - frame[:, 1] * 0.03
            box = rounded_box(
                centre, frame, BoxShape(half, radius=0.012), rigid_weights(self._kit.rig, Hips=1)
            )
            self._kit.add(box, COYOTE * 0.5 + RANGER_GREEN * 0.5)
