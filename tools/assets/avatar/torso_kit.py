"""Plate carrier, belt, pouches, pack and shoulder straps. Metres; angles as in kit_parts.py."""

import numpy as np
from numpy.typing import NDArray

from .kit import Kit
from .kit_parts import (
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
from .quad_mesh import Layer
from .rig import SIDES

Array = NDArray[np.float64]

_FORWARD = np.array([0, 0, 1.0])
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
        self._strap_lift = 0.03
        self._strap_colour = kit.palette.main

    def _mixed(self, share: float) -> Array:
        """Return a colour between those of pouches and vest."""
        return self._kit.palette.pouch * share + self._kit.palette.main * (1 - share)

    def _limb(self, forward: Array) -> Limb:
        return Limb(self._kit.torso, self._start, self._end, forward, self._weights)

    def _along(self, y: float) -> float:
        """Return where a height lies on the torso's axis, 0 to 1."""
        return (y - self._start[1]) / (self._end[1] - self._start[1])

    def _slab(self, forward: Array, shape: SlabShape, colour: Array) -> Panel:
        mesh, panel = slab(self._limb(forward), shape)
        self._kit.add(mesh, colour)
        return panel

    def add_plates(self) -> None:
        """Make the two plates and the cummerbund's sides, with rows of webbing."""
        bottom, top = self._plate_bottom, self._plate_top
        plate_angles = np.linspace(np.radians(-50), np.radians(50), 17)
        plate_along = np.linspace(self._along(bottom), self._along(top), 15)
        shape = {"smoothing": 10, "outline": _tapered, "is_sealed": True}
        front = SlabShape(plate_angles, plate_along, 0.012, 0.028, **shape)
        back = SlabShape(plate_angles, plate_along, 0.010, 0.026, **shape)
        self._front = self._slab(_FORWARD, front, self._kit.palette.main)
        self._back = self._slab(-_FORWARD, back, self._kit.palette.main)
        side_along = np.linspace(self._along(bottom + 0.01), self._along(bottom + 0.15), 7)
        self._sides = []
        for first, last in ((38, 142), (-142, -38)):
            angles = np.linspace(np.radians(first), np.radians(last), 13)
            shape = SlabShape(angles, side_along, 0.008, 0.012)
            self._sides.append(self._slab(_FORWARD, shape, self._kit.palette.main * 0.9))
        self._add_plate_webbing()

    def add_chest_rig(self) -> None:
        """Make a narrow rig of four pouches on a harness, without plates."""
        self._strap_lift = 0.014
        low, high = self._waist + 0.09, self._waist + 0.235
        along = np.linspace(self._along(low), self._along(high), 9)
        angles = np.linspace(np.radians(-74), np.radians(74), 25)
        shape = SlabShape(angles, along, 0.006, 0.010, smoothing=8, is_sealed=True)
        self._front = self._slab(_FORWARD, shape, self._kit.palette.main)
        back_along = np.linspace(self._along(low + 0.05), self._along(high + 0.16), 11)
        back_angles = np.linspace(np.radians(-30), np.radians(30), 11)
        shape = SlabShape(back_angles, back_along, 0.006, 0.008, smoothing=8, is_sealed=True)
        self._back = self._slab(-_FORWARD, shape, self._kit.palette.main * 0.8)
        strap_along = np.linspace(self._along(low + 0.03), self._along(low + 0.07), 3)
        for first, last in ((70, 160), (-160, -70)):
            angles = np.linspace(np.radians(first), np.radians(last), 13)
            shape = SlabShape(angles, strap_along, 0.004, 0.005, bevel=0.002, is_sealed=True)
            self._slab(_FORWARD, shape, self._kit.palette.main * 0.7)
        for degrees in (-54, -19, 19, 54):
            at, frame = self._front.place(np.radians(degrees), low + 0.062)
            _, up, out = frame.T
            pouch = BoxShape((0.041, 0.070, 0.022), radius=0.010, segments=(2, 3, 1))
            self._add_box(at + out * 0.016, frame, pouch, self._kit.palette.pouch)
            flap = BoxShape((0.042, 0.026, 0.006), radius=0.004, segments=(2, 1, 1))
            place = at + out * 0.037 + up * 0.042
            self._add_box(place, frame, flap, self._kit.palette.pouch * 0.82)
            tab = BoxShape((0.010, 0.020, 0.003), radius=0.002)
            self._add_box(at + out * 0.043 + up * 0.02, frame, tab, self._kit.palette.main * 0.6)

    def add_tabard(self) -> None:
        """Make a thin vest that is seen from afar, with two reflecting stripes around it."""
        self._strap_lift = 0.010
        bottom, top = self._waist - 0.035, self._plate_top
        along = np.linspace(self._along(bottom), self._along(top), 19)
        angles = np.linspace(np.radians(-84), np.radians(84), 33)
        shape = {"bevel": 0.001, "smoothing": 10, "outline": _tapered, "is_sealed": True}
        self._front = self._slab(
            _FORWARD, SlabShape(angles, along, 0.007, 0.0035, **shape), self._kit.palette.main
        )
        self._back = self._slab(
            -_FORWARD, SlabShape(angles, along, 0.007, 0.0035, **shape), self._kit.palette.main
        )
        for panel in (self._front, self._back):
            for y in (bottom + 0.10, bottom + 0.22):
                self._add_webbing(panel, y, -76, 76, 33, 0.025, self._kit.palette.stripe)
        box = BoxShape((0.030, 0.042, 0.012), radius=0.006)
        at, frame = self._front.place(np.radians(34), bottom + 0.31)
        self._add_box(at + frame[:, 2] * 0.008, frame, box, self._kit.palette.pouch)

    def add_belt(self) -> None:
        """Put the belt on."""
        belt_along = np.linspace(
            self._along(self._waist - 0.055), self._along(self._waist - 0.005), 5
        )
        belt = SlabShape(np.linspace(0, 2 * np.pi, 49), belt_along, 0.006, 0.010, smoothing=8)
        self._belt = self._slab(_FORWARD, belt, self._kit.palette.main * 0.8)
        at, frame = self._belt.place(0.0, self._waist - 0.03)
        buckle = BoxShape((0.030, 0.022, 0.006), radius=0.004)
        box = rounded_box(at + frame[:, 2] * 0.004, frame, buckle, self._weights)
        self._kit.add(box, self._kit.palette.main * 0.35, Layer.SMOOTH)

    def _add_webbing(
        self,
        panel: Panel,
        y: float,
        first: float,
        last: float,
        count: int,
        half: float = 0.0125,
        colour: Array | None = None,
    ) -> None:
        """Lay a band of a half width on a panel at height y, between two angles in degrees."""
        rise_over = 0.0035 if colour is None else 0.0060
        middle = np.array([0, 0, ((self._start + self._end) / 2)[2]])
        rows = []
        for rise, lift in (
            (-half, -0.001),
            (-half + 0.001, rise_over),
            (half - 0.001, rise_over),
            (half, -0.001),
        ):
            points = panel.ring(y + rise, np.radians(first), np.radians(last), count)
            outward = points - middle
            outward[:, 1] = 0
            outward /= np.linalg.norm(outward, axis=1, keepdims=True)
            rows.append(points + outward * lift)
        band = np.stack(rows)
        outward = band.reshape(-1, 3) - (middle + [0, y, 0])
        mesh = grid_mesh(band, self._weights, outward=outward, along=1)
        if colour is None:
            self._kit.add(mesh, self._kit.palette.main * 0.72, Layer.WEBBING)
        else:
            self._kit.add(mesh, colour, Layer.SMOOTH, 0.8)

    def _add_box(self, centre: Array, frame: Array, shape: BoxShape, colour: Array) -> None:
        self._kit.add(rounded_box(centre, frame, shape, self._weights), colour)

    def _add_plate_webbing(self) -> None:
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
            self._add_box(at + out * 0.012, frame, pouch, self._mixed(0.55))
            flap = BoxShape((0.016, 0.045, 0.004), radius=0.003)
            self._add_box(at + out * 0.034 + up * 0.02, frame, flap, self._kit.palette.main * 0.6)
        at, frame = self._front.place(0, bottom + 0.25)
        admin = BoxShape((0.085, 0.045, 0.012), radius=0.008, bend=1.2)
        self._add_box(at + frame[:, 2] * 0.004, frame, admin, self._kit.palette.main * 1.05)
        at, frame = self._back.place(0, bottom + 0.20)
        _, up, out = frame.T
        pack = BoxShape((0.11, 0.14, 0.045), radius=0.025, segments=(5, 5, 3))
        self._add_box(at + out * 0.035, frame, pack, self._kit.palette.main * 0.95)
        pocket = BoxShape((0.08, 0.08, 0.018), radius=0.012)
        self._add_box(at + out * 0.085 - up * 0.03, frame, pocket, self._kit.palette.main)

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
        mesh = grid_mesh(sections, self._weights, closed=True, outward=facing, along=0)
        self._kit.add(mesh, self._strap_colour, Layer.WEBBING)

    def _strap_path(self, x: float) -> Array:
        """Trace the strap's middle line over the torso, front to back."""
        top, torso = self._plate_top, self._kit.torso

        def depth(y: float, facing: int) -> float:
            hit = torso.hit((x, y, facing * 0.6), (0, 0, -facing), 1.2)
            if hit is None:
                raise ValueError(f"no torso under the shoulder strap at x={x:.3f}, y={y:.3f}")
            return hit[2]

        path = [
            (x, y, depth(y, 1) + self._strap_lift) for y in np.linspace(top - 0.09, top - 0.01, 4)
        ]
        front, back = depth(top - 0.01, 1), depth(top - 0.01, -1)
        for share in np.linspace(0.1, 0.9, 8):
            z = front + (back - front) * share
            hit = torso.hit((x, 2.2, z), (0, -1, 0), 1.5)
            path.append((x, (top if hit is None else hit[1]) + 0.014, z))
        path += [
            (x, y, depth(y, -1) - self._strap_lift + 0.002)
            for y in np.linspace(top - 0.01, top - 0.09, 4)
        ]
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
            self._kit.add(box, self._mixed(0.5))
