"""The leather of a boot as a grid: rings from the toe over the instep up to the collar. Metres."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .curves import smooth_line, unit
from .kit import Kit
from .kit_parts import grid_mesh, nearest_weights
from .quad_mesh import Layer, QuadMesh, neighbour_mean, unique_edges, vertex_normals
from .surface import Surface

Array = NDArray[np.float64]

_COLUMNS = 28
_LEATHER = 0.010
"""From the tights' feet to the leather's outside."""
_TOE_LIFT = 0.007
"""Room over the toes: a boot's toe box is higher than the foot in it."""
TOE_LENGTH = 0.045
"""The toe is round over this length."""
_LOWEST = 0.010
"""Where the leather ends in the sole."""
# Rings by number: the toe's end, the joint of cap and vamp, the first ring of the fan around the
# ankle, the first one of the shaft, the collar.
_CAP, _FAN, _SHAFT, _RINGS = 8, 13, 21, 30
_DARK = 0.5
_EDGE = 0.0016
"""Height of the toe cap and of the heel's counter over the leather around them."""


@dataclass
class BootUpper:
    """The outer face of the leather. Column 0 runs over toe, instep and shin."""

    points: Array
    """Shape (rings, columns, 3)."""
    side: str

    def at(self, ring: float, angle: float) -> tuple[Array, Array]:
        """Return a point and its outward direction; the angle (radians) is from column 0."""
        column = angle / (2 * np.pi) * _COLUMNS
        here = self._point(ring, column)
        along = self._point(ring + 0.2, column) - self._point(ring - 0.2, column)
        around = self._point(ring, column + 0.2) - self._point(ring, column - 0.2)
        outward = unit(np.cross(around, along))
        middle = self.points[min(int(ring), _RINGS - 1)].mean(0)
        return here, outward * np.sign((here - middle) @ outward)

    def _point(self, ring: float, column: float) -> Array:
        r, c = int(np.floor(min(max(ring, 0), _RINGS - 1.001))), int(np.floor(column))
        a, b = ring - r, column - c
        p = self.points

        def row(k: int) -> Array:
            return p[k, c % _COLUMNS] * (1 - b) + p[k, (c + 1) % _COLUMNS] * b

        return row(r) * (1 - a) + row(r + 1) * a

    @property
    def low(self) -> Array:
        """Return the points that stand in the sole."""
        flat = self.points.reshape(-1, 3)
        return flat[flat[:, 1] < 0.045]


def add_upper(kit: Kit, both_feet: QuadMesh, side: str) -> BootUpper:
    """Add the leather of one boot."""
    sign = 1 if side == "Left" else -1
    foot = both_feet.subset(both_feet.vertices[both_feet.faces].mean(1)[:, 0] * sign > 0)
    _stiffen(foot)
    heads = kit.rig.heads
    rings = _trace(
        Surface(foot.vertices, foot.faces), heads[side + "Foot"], heads[side + "LowerLeg"]
    )
    upper = BootUpper(rings, side)
    tip = np.repeat(rings[:1].mean(1, keepdims=True), _COLUMNS, 1)
    inner = rings[-1] + (rings[-1].mean(0) - rings[-1]) * 0.16 - [0, 0.025, 0]
    rows = np.concatenate([tip, rings, inner[None]])
    centres = rows.mean(1, keepdims=True)
    outward = (rows - centres).reshape(-1, 3)
    leather = grid_mesh(rows, nearest_weights(foot), closed=True, outward=outward)
    kit.add(leather, kit.palette.boots, Layer.LEATHER)
    leather.colours = leather.colours * _shade().reshape(-1, 1)
    return upper


def _stiffen(foot: QuadMesh) -> None:
    """Smooth out the toes (leather bridges them) and give the leather its thickness."""
    skin, edges = foot.vertices, unique_edges(foot.faces)[0]
    leather, normals = skin.copy(), vertex_normals(skin, foot.faces)
    for _ in range(10):
        leather = 0.5 * leather + 0.5 * neighbour_mean(leather, edges)
        lift = ((leather - skin) * normals).sum(1)
        leather += normals * np.maximum(-0.003 - lift, 0)[:, None]
    leather += vertex_normals(leather, foot.faces) * _LEATHER
    foot.vertices = leather


def _planes(surface_low: Array, ankle: Array, knee: Array) -> tuple[Array, Array, Array]:
    """Return middle, dorsal direction and plane normal of each ring."""
    toe, up, ahead = surface_low[:, 2].max(), np.array([0, 1.0, 0]), np.array([0, 0, 1.0])
    pivot = np.array([ankle[0], ankle[1] + 0.055, ankle[2] + 0.075])
    rings = []
    depths = (0.003, 0.008, 0.016, 0.026, 0.038, 0.050, 0.060, 0.0625)
    stations = [toe - depth for depth in depths]
    stations += list(np.linspace(stations[-1], pivot[2], _FAN - _CAP + 1)[1:])
    for z in stations:
        rings.append((np.array([ankle[0], 0.030, z]), up, ahead))
    for turn in np.linspace(0, np.pi / 2, _SHAFT - _FAN + 1)[1:]:
        back = -(np.cos(turn) * up + np.sin(turn) * ahead)
        rings.append((pivot + back * 0.07, -back, np.cos(turn) * ahead - np.sin(turn) * up))
    axis = (knee - ankle) / (knee - ankle)[1]
    top = ankle[1] + (knee - ankle)[1] * 0.335
    for y in np.linspace(pivot[1], top, _RINGS - _SHAFT + 1)[1:]:
        middle = ankle + axis * (y - ankle[1])
        rings.append((middle, ahead, -up))
    return tuple(np.array(column) for column in zip(*rings, strict=True))


def _trace(surface: Surface, ankle: Array, knee: Array) -> Array:
    """Find the rings by rays towards their middles, and give them the shape of a boot."""
    low = surface.points[surface.points[:, 1] < 0.1]
    middles, dorsal, normals = _planes(low, ankle, knee)
    angles = np.linspace(0, 2 * np.pi, _COLUMNS + 1)[:-1]
    right = np.cross(dorsal, normals)
    rings = np.zeros((_RINGS, _COLUMNS, 3))
    for _ in range(2):  # the second time about the middles that the first one found
        for i in range(_RINGS):
            for j, angle in enumerate(angles):
                direction = np.cos(angle) * dorsal[i] + np.sin(angle) * right[i]
                hit = surface.hit(middles[i] + direction * 0.2, -direction, 0.2)
                rings[i, j] = middles[i] + direction * 0.004 if hit is None else hit
        centred = (rings.max(1) + rings.min(1)) / 2
        middles = middles + right * ((centred - middles) * right).sum(1, keepdims=True)
    return _shape(rings, middles, normals, low[:, 2].max())


def _shape(rings: Array, middles: Array, normals: Array, toe: float) -> Array:
    """Smooth the rings; raise toe box, toe cap, counter and collar; close the bottom flat."""
    for _ in range(2):
        around = (np.roll(rings, 1, 1) + 2 * rings + np.roll(rings, -1, 1)) / 4
        rings = smooth_line(around, 1)
        rings[0] = around[0]
    _round_toe(rings, toe)
    outward = unit(rings - middles[:, None])
    rings[: _CAP - 1] += outward[: _CAP - 1] * _EDGE
    rings += outward * (_counter() * _EDGE)[..., None]
    padding = np.array([0, 0.0028, 0.0032, 0.0008, 0.0030, 0.0032, 0.0005])
    rings[-len(padding) :] += outward[-len(padding) :] * padding[:, None, None]
    rings[..., 1] = np.maximum(rings[..., 1], _LOWEST)
    return rings


def _round_toe(rings: Array, toe: float) -> None:
    """Give the boot a round toe with room in it, where the foot is pointed and flat."""
    z = rings[:, :1, 2]
    share = np.clip((z - toe + TOE_LENGTH) / TOE_LENGTH, 0, 1)
    first = int(np.nonzero(share[:, 0] == 0)[0][0])
    round_off = np.sqrt(1 - 0.94 * share**2)
    middle = (rings[..., 0].max(1) + rings[..., 0].min(1))[:, None] / 2
    half = np.ptp(rings[..., 0], 1)[:, None] / 2
    wider = np.maximum(half[first] * round_off / half, 1)
    ahead = middle[first] + (middle[0] - middle[first]) * 0.5 * share
    in_toe = share > 0
    rings[..., 0] = np.where(in_toe, ahead + (rings[..., 0] - middle) * wider, rings[..., 0])
    height = rings[..., 1].max(1)[:, None] - _LOWEST
    higher = (height[first] * round_off**0.6 + _TOE_LIFT * share) / height
    raised = _LOWEST + (rings[..., 1] - _LOWEST) * np.maximum(higher, 1)
    rings[..., 1] = np.where(in_toe & (rings[..., 1] > _LOWEST), raised, rings[..., 1])


def _counter() -> Array:
    """Mark the stiff piece around the heel: 1 on it, shape (rings, columns)."""
    mark = np.zeros((_RINGS, _COLUMNS))
    behind = np.abs(np.arange(_COLUMNS) - _COLUMNS / 2)
    for ring in range(_FAN + 3, _SHAFT - 1):
        mark[ring, behind < _COLUMNS * 0.20] = 1
    return mark


def _shade() -> Array:
    """Darken cap, counter, tongue and collar: shape (rings with both ends, columns)."""
    shade = np.ones((_RINGS, _COLUMNS))
    shade[: _CAP - 1] = _DARK
    shade -= _counter() * (1 - _DARK) * 0.7
    tongue = np.r_[0:2, _COLUMNS - 1]
    shade[_CAP + 2 :, tongue] = 0.7
    shade[-3:] = _DARK
    return np.vstack([shade[:1], shade, shade[-1:]])
