"""Laced boots with soles, made of the tights' feet. Metres."""

import numpy as np
from numpy.typing import NDArray

from .kit import Kit
from .kit_parts import (
    BLACK,
    BOOT_BROWN,
    BoxShape,
    grid_faces,
    rigid_weights,
    rounded_box,
)
from .quad_mesh import QuadMesh, neighbour_mean, unique_edges, vertex_normals
from .surface import Surface

Array = NDArray[np.float64]

_SOLE_BOTTOM = -0.012
"""The bare sole is at y = 0, the boot's 12 mm lower."""
_SOLE_COLUMNS = 40
# Height and width (relative to the foot's outline) of each ring of the sole, from below.
_SOLE_RINGS = (
    (_SOLE_BOTTOM, 0.94),
    (_SOLE_BOTTOM, 1.0),
    (-0.004, 1.03),
    (0.018, 1.035),
    (0.024, 1.01),
    (0.03, 0.90),
)


def add_boot(kit: Kit, both_boots: QuadMesh, side: str) -> None:
    """Add one boot with laces and sole."""
    sign = 1 if side == "Left" else -1
    boot = both_boots.subset(both_boots.vertices[both_boots.faces].mean(1)[:, 0] * sign > 0)
    shin = kit.rig.along(boot.vertices, side + "LowerLeg", side + "Foot")
    _stiffen(boot, shin)
    kit.add(boot, BOOT_BROWN)
    boot.colours[shin < 0.685] = BOOT_BROWN * 0.6  # the collar
    toe = (boot.vertices - kit.rig.heads[side + "Foot"]) @ np.array([0, 0, 1.0])
    boot.colours[(toe > 0.135) & (boot.vertices[:, 1] < 0.07)] = BOOT_BROWN * 0.62  # the toe cap
    _add_laces(kit, boot, side)
    _add_sole(kit, boot, side)


def _stiffen(boot: QuadMesh, shin: Array) -> None:
    """Smooth out the toes (leather bridges them) and give the leather its thickness."""
    foot, edges = boot.vertices, unique_edges(boot.faces)[0]
    leather = foot.copy()
    foot_normals = vertex_normals(foot, boot.faces)
    for _ in range(10):
        leather = 0.5 * leather + 0.5 * neighbour_mean(leather, edges)
        lift = ((leather - foot) * foot_normals).sum(1)
        leather += foot_normals * np.maximum(-0.003 - lift, 0)[:, None]
    collar = 0.003 * np.exp(-(((shin - 0.665) / 0.02) ** 2))
    leather += vertex_normals(leather, boot.faces) * (0.010 + collar)[:, None]
    leather[:, 1] = np.maximum(leather[:, 1], 0.012)
    boot.vertices = leather


def _lace_seats(kit: Kit, boot: QuadMesh, side: str) -> list[tuple[Array, Array]]:
    """Find points and outward directions down the shin and along the instep."""
    surface = Surface(boot.vertices, boot.faces)
    heads = kit.rig.heads
    ankle, knee, toes = (heads[side + bone] for bone in ("Foot", "LowerLeg", "Toes"))
    seats = []
    for share in np.linspace(0.30, 0.0, 9):
        above = ankle + (knee - ankle) * share + np.array([0, 0, 0.3])
        hit = surface.hit(above, (0, 0, -1), 0.4)
        if hit is not None:
            seats.append((hit, np.array([0, 0.25, 1.0])))
    for forward in np.linspace(0.02, 0.085, 5):
        sideways = (toes[0] - ankle[0]) * forward / 0.13
        above = ankle + np.array([sideways, 0.3, forward + 0.03])
        hit = surface.hit(above, (0, -1, 0), 0.5)
        if hit is not None:
            seats.append((hit, np.array([0, 1.0, 0.35])))
    return seats


def _add_laces(kit: Kit, boot: QuadMesh, side: str) -> None:
    """Lay short bars across the boot's front."""
    ankle_height = kit.rig.heads[side + "Foot"][1]
    lace = BoxShape((0.019, 0.0032, 0.0028), radius=0.0022, segments=(3, 1, 1), bend=9)
    for point, outward in _lace_seats(kit, boot, side):
        outward = outward / np.linalg.norm(outward)
        right = np.array([1.0, 0, 0])
        frame = np.stack([right, np.cross(outward, right), outward], 1)
        bone = "LowerLeg" if point[1] > ankle_height + 0.03 else "Foot"
        weights = rigid_weights(kit.rig, **{side + bone: 1})
        kit.add(rounded_box(point + outward * 0.001, frame, lace, weights), BOOT_BROWN * 0.35)


def convex_hull(points: list[tuple[float, float]]) -> Array:
    """Return the corners of the convex hull in the plane (Andrew's monotone chain)."""

    def half(ordered: list[tuple[float, float]]) -> list[tuple[float, float]]:
        chain: list[tuple[float, float]] = []
        for q in ordered:
            while len(chain) > 1:
                (ax, ay), (bx, by) = chain[-2], chain[-1]
                if (bx - ax) * (q[1] - ay) - (by - ay) * (q[0] - ax) > 0:
                    break
                chain.pop()
            chain.append(q)
        return chain[:-1]

    ordered = sorted(points)
    return np.array(half(ordered) + half(ordered[::-1]))


def _foot_outline(boot: QuadMesh) -> Array:
    """Return the boot's outline seen from above: `_SOLE_COLUMNS` points (x, z)."""
    low = boot.vertices[boot.vertices[:, 1] < 0.05][:, [0, 2]]
    hull = convex_hull([tuple(point) for point in low.round(4)])
    loop = np.vstack([hull, hull[:1]])
    steps = np.linalg.norm(np.diff(loop, axis=0), axis=1)
    distance = np.r_[0, np.cumsum(steps)]
    wanted = np.linspace(0, distance[-1], _SOLE_COLUMNS + 1)[:-1]
    outline = np.stack([np.interp(wanted, distance, loop[:, k]) for k in (0, 1)], 1)
    for _ in range(2):
        outline = (np.roll(outline, 1, 0) + 2 * outline + np.roll(outline, -1, 0)) / 4
    return outline


def _add_sole(kit: Kit, boot: QuadMesh, side: str) -> None:
    """Put a rubber sole under the boot; it bends at the ball of the foot."""
    outline = _foot_outline(boot)
    centre = outline.mean(0)
    rings = []
    for y, width in ((_SOLE_BOTTOM, 0.0), *_SOLE_RINGS):
        ring = centre + (outline - centre) * width
        rings.append(np.column_stack([ring[:, 0], np.full(_SOLE_COLUMNS, y), ring[:, 1]]))
    vertices, faces = grid_faces(np.stack(rings), closed=True)
    weights = np.zeros((len(vertices), len(kit.rig.names)))
    toe_share = np.clip((vertices[:, 2] - kit.rig.heads[side + "Toes"][2] + 0.02) / 0.04, 0, 1)
    weights[:, kit.rig.index[side + "Toes"]] = toe_share
    weights[:, kit.rig.index[side + "Foot"]] = 1 - toe_share
    sole = QuadMesh(vertices, weights, faces)
    if (sole.normals() * (vertices - vertices.mean(0))).sum() < 0:
        sole.flip()
    kit.add(sole, BLACK * 1.6)
