"""Caps, head cloths, scarves, goggles, hair and a headset: what is worn beside helmets. Metres."""

import numpy as np
from numpy.typing import NDArray

from .bands import cord
from .bare_parts import Head
from .curves import unit
from .head_kit import CAP_RIM, HelmetFit, fit_helmet, shell_point
from .kit import Kit
from .kit_parts import (
    BLACK,
    BoxShape,
    Limb,
    SlabShape,
    WeightRule,
    grid_mesh,
    nearest_weights,
    rigid_weights,
    rounded_box,
    slab,
)
from .quad_mesh import Layer, QuadMesh, neighbour_mean, subdivide, unique_edges
from .surface import Surface

Array = NDArray[np.float64]

_PEAK_ROWS, _PEAK_COLUMNS = 7, 21
_PEAK_HALF_ANGLE = np.radians(58)
_PEAK_LENGTH = 0.068
_FACE_HALF_ANGLE = 52.0
"""How far the opening of a head cloth reaches to each side, degrees."""


def add_cap(kit: Kit, head: Head) -> None:
    """Add a cap with a peak: six panels, their seams, a button."""
    fit = fit_helmet(head.skin, head.eye_centres[0], CAP_RIM, room=0.011, fullness=0.86)
    weights = rigid_weights(kit.rig, Head=1)
    azimuth = np.linspace(0, 2 * np.pi, 61)[:-1]
    rows = [
        np.stack([shell_point(fit, a, share) for a in azimuth]) for share in np.linspace(0, 1, 13)
    ]
    inner = np.stack([shell_point(fit, a, 0.05, inset=0.004) for a in azimuth])
    dome = grid_mesh(np.stack([inner, *rows]), weights, closed=True)
    if (dome.normals() * (dome.vertices - fit.centre)).sum() < 0:
        dome.flip()
    kit.add(dome, kit.palette.stripe, Layer.WEAVE)
    for k in range(6):
        turn = np.pi / 6 + k * np.pi / 3
        line = np.stack([shell_point(fit, turn, s, -0.0006) for s in np.linspace(0.02, 0.98, 14)])
        kit.add(cord(line, 0.0016, weights, 4), kit.palette.stripe * 0.7, Layer.WEAVE)
    top = shell_point(fit, 0, 1.0)
    button = BoxShape((0.007, 0.004, 0.007), radius=0.0035)
    kit.add(rounded_box(top, np.eye(3), button, weights), kit.palette.stripe * 0.8, Layer.WEAVE)
    _add_peak(kit, fit)


def _add_peak(kit: Kit, fit: HelmetFit) -> None:
    """Bend the peak out of the cap's rim."""
    turns = np.linspace(-_PEAK_HALF_ANGLE, _PEAK_HALF_ANGLE, _PEAK_COLUMNS)
    rim = np.stack([shell_point(fit, turn, 0.03) for turn in turns])
    rim -= unit((rim - fit.centre) * [1, 0, 1]) * 0.003
    across = 1 - (turns / _PEAK_HALF_ANGLE) ** 2
    reach = _PEAK_LENGTH * np.sqrt(np.clip(across, 0, 1))
    rows = []
    for share in np.linspace(0, 1, _PEAK_ROWS):
        out = rim + np.outer(reach * share, [0, 0, 1.0])
        out[:, 1] -= 0.020 * share * reach / _PEAK_LENGTH + 0.006 * share * (1 - across)
        rows.append(out)
    upper = np.stack(rows)
    lower = upper[::-1] - [0, 0.0035, 0]
    sheet = grid_mesh(np.concatenate([upper, lower]), rigid_weights(kit.rig, Head=1))
    above = np.arange(len(sheet.vertices)) < upper.shape[0] * upper.shape[1]
    if (sheet.normals()[:, 1] * above).sum() < 0:
        sheet.flip()
    kit.add(sheet, kit.palette.stripe * 0.85, Layer.WEAVE)


def add_goggles(kit: Kit, fit: HelmetFit) -> None:
    """Push a pair of goggles up onto the helmet's front, with their strap around it."""
    weights = rigid_weights(kit.rig, Head=1)
    turns = np.radians(np.linspace(-52, 52, 17))

    def ring(share: float, lift: float) -> Array:
        return np.stack([shell_point(fit, turn, share, -lift) for turn in turns])

    frame = np.stack([ring(0.10, 0.0), ring(0.10, 0.020), ring(0.40, 0.020), ring(0.40, 0.0)])
    outward = frame.reshape(-1, 3) - fit.centre
    kit.add(grid_mesh(frame, weights, outward=outward), BLACK, Layer.LEATHER)
    glass = np.stack([ring(0.14, 0.0215), ring(0.25, 0.0235), ring(0.36, 0.0215)])
    outward = glass.reshape(-1, 3) - fit.centre
    kit.add(
        grid_mesh(glass, weights, outward=outward),
        np.array([0.05, 0.035, 0.02]),
        Layer.SMOOTH,
        0.95,
    )
    around = np.radians(np.linspace(50, 310, 41))
    band = np.stack(
        [
            np.stack([shell_point(fit, turn, share, -lift) for turn in around])
            for share, lift in ((0.19, 0.000), (0.20, 0.003), (0.30, 0.003), (0.31, 0.0))
        ]
    )
    outward = band.reshape(-1, 3) - fit.centre
    kit.add(grid_mesh(band, weights, outward=outward, along=1), BLACK * 1.6, Layer.WEBBING)


def add_helmet_band(kit: Kit, fit: HelmetFit) -> None:
    """Paint a stripe of the side's colour around a helmet: a thin band."""
    weights = rigid_weights(kit.rig, Head=1)
    turns = np.linspace(0, 2 * np.pi, 49)[:-1]
    band = np.stack(
        [
            np.stack([shell_point(fit, turn, share, -lift) for turn in turns])
            for share, lift in ((0.42, 0.0), (0.425, 0.0015), (0.475, 0.0015), (0.48, 0.0))
        ]
    )
    outward = band.reshape(-1, 3) - fit.centre
    mesh = grid_mesh(band, weights, closed=True, outward=outward, along=1)
    kit.add(mesh, kit.palette.stripe, Layer.WEAVE)


def _scalp(head: Head, height: float) -> QuadMesh:
    """Cut out where hair grows: above a line from the forehead around the ears to the nape."""
    skin = head.skin
    middles = skin.vertices[skin.faces].mean(1)
    eye = head.eye_centres[0]
    x, y, z = np.abs(middles[:, 0]), middles[:, 1] - eye[1], middles[:, 2] - eye[2]
    line = np.interp(
        -z, [-0.03, 0.03, 0.075, 0.10, 0.15, 0.20], [0.075, 0.062, 0.02, 0.025, -0.05, -0.075]
    )
    return skin.subset((y > line + height) & (x < 0.12))


def add_hair(kit: Kit, head: Head, thickness: float = 0.005) -> None:
    """Let short hair stand off the scalp: a shell with strands."""
    hair = _scalp(head, 0.0)
    edges, _, counts = unique_edges(hair.faces)
    rim = np.zeros(len(hair.vertices), bool)
    rim[edges[counts == 1].reshape(-1)] = True
    lift = np.where(rim, -0.002, thickness)
    for _ in range(2):
        lift = np.where(rim, lift, 0.5 * lift + 0.5 * neighbour_mean(lift[:, None], edges)[:, 0])
    noise = kit.figure.noise
    waves = noise.layered(hair.vertices * np.array([90, 30, 60]), 2) - 0.5
    hair.vertices = hair.vertices + hair.normals() * (lift + 0.004 * waves * ~rim)[:, None]
    kit.add(subdivide(hair), head.hair, Layer.HAIR)


def add_hair_bun(kit: Kit, head: Head) -> None:
    """Let hair show below a helmet, tied to a knot at the nape."""
    add_hair(kit, head, 0.006)
    eye = head.eye_centres[0]
    weights = rigid_weights(kit.rig, Head=1)
    centre = np.array([0, eye[1] - 0.075, head.skin.vertices[:, 2].min() - 0.012])
    knot = BoxShape((0.036, 0.032, 0.030), radius=0.0295, segments=(3, 3, 3))
    kit.add(rounded_box(centre, np.eye(3), knot, weights), head.hair, Layer.HAIR)


def add_headset(kit: Kit, head: Head) -> None:
    """Hang a radio's headset over the right ear, its microphone before the mouth."""
    weights = rigid_weights(kit.rig, Head=1)
    eye = head.eye_centres[0]
    skin = Surface(head.skin.vertices, head.skin.faces)
    ear = skin.hit((-0.3, eye[1] - 0.022, eye[2] - 0.105), (1, 0, 0), 0.3)
    if ear is None:
        raise ValueError("no ear under the headset")
    cup = BoxShape((0.011, 0.030, 0.026), radius=0.0105, segments=(1, 3, 3))
    kit.add(rounded_box(ear - [0.004, 0, 0], np.eye(3), cup, weights), BLACK, Layer.SMOOTH)
    mouth = np.array([-0.035, eye[1] - 0.070, eye[2] + 0.018])
    middle = (ear + mouth) / 2 + [-0.028, -0.012, 0.01]
    share = np.linspace(0, 1, 15)[:, None]
    line = ear * (1 - share) ** 2 + 2 * middle * share * (1 - share) + mouth * share**2
    kit.add(cord(line - [0.008, 0, 0], 0.0022, weights, 6), BLACK * 1.4, Layer.SMOOTH)
    tip = BoxShape((0.007, 0.006, 0.010), radius=0.0055)
    kit.add(rounded_box(mouth - [0.008, 0, 0], np.eye(3), tip, weights), BLACK, Layer.LEATHER)


def _wrapped_surface(kit: Kit, head: Head) -> Surface:
    skin, torso = head.skin, kit.uniform
    faces = np.vstack([skin.faces, torso.faces + len(skin.vertices)])
    return Surface(np.vstack([skin.vertices, torso.vertices]), faces)


def add_head_cloth(kit: Kit, head: Head) -> None:
    """Lay a cloth around head, neck and shoulders that leaves the face open."""
    rig, eye = kit.rig, head.eye_centres[0]
    top, chin = head.skin.vertices[:, 1].max(), eye[1] - 0.112
    bottom = rig.heads["Neck"][1] - 0.075
    brow = eye[1] + 0.062
    start = np.array([0, bottom, rig.heads["UpperChest"][2] + 0.02])
    end = np.array([0, top + 0.006, eye[2] - 0.085])
    limb = Limb(_wrapped_surface(kit, head), start, end, np.array([0, 0, 1.0]), _cloth_weights(kit))

    def open_face(angles: Array, along: Array) -> Array:
        y = bottom + (top + 0.006 - bottom) * along
        across = np.clip((y - chin) / (brow - chin), 0, 1)
        half = (
            np.radians(_FACE_HALF_ANGLE) * np.sqrt(np.clip(4 * across * (1 - across), 0, 1)) ** 0.8
        )
        share = (angles - np.pi) / np.pi
        return np.pi + share * (np.pi - half)

    along = np.r_[np.linspace(0, 0.42, 16)[:-1], np.linspace(0.42, 0.995, 34)]
    angles = np.linspace(0.0, 2 * np.pi - 1e-3, 73)
    shape = SlabShape(angles, along, 0.012, 0.004, 0.0015, 5, open_face, widest=_shoulders)
    cloth, _ = slab(limb, shape)
    _round_off(cloth, fit_helmet(head.skin, eye, room=0.009, fullness=0.5), along)
    turn = np.arctan2(cloth.vertices[:, 0], cloth.vertices[:, 2] - start[2])
    low = np.clip((chin + 0.03 - cloth.vertices[:, 1]) / 0.12, 0, 1)
    noise = kit.figure.noise
    wave = np.sin(7 * turn + 30 * cloth.vertices[:, 1] + 5 * noise.layered(cloth.vertices * 9, 2))
    folds = 0.0035 * wave * (0.35 + low) + 0.004 * (noise.layered(cloth.vertices * 22, 2) - 0.5)
    out = unit((cloth.vertices - [0, 0, start[2]]) * [1, 0, 1])
    cloth.vertices = cloth.vertices + out * folds[:, None]
    cloth.is_loose = True
    # In two: the wearer does not see what is before the own face, but what lies on the shoulders.
    on_head = cloth.weights[cloth.faces][:, :, rig.index["Head"]].mean(1) > 0.5
    for chosen in (on_head, ~on_head):
        part = kit.add(cloth.subset(chosen), kit.palette.stripe, Layer.WEAVE)
        part.is_loose = chosen is not on_head


def _shoulders(angles: Array) -> Array:
    """Let a cloth hang wide before the chest and behind the neck, but not over the shoulders."""
    return 0.150 + 0.050 * np.abs(np.cos(angles)) ** 1.5


def _round_off(cloth: QuadMesh, fit: HelmetFit, along: Array) -> None:
    """Lay what is above the brows onto a dome: rays along the crown find nothing to rest on."""
    columns = len(cloth.vertices) // (2 * len(along))
    is_inner = np.arange(len(cloth.vertices)) >= columns * len(along)
    rise = (cloth.vertices[:, 1] - fit.centre[1]) / fit.radii[1]
    width = np.sqrt(np.clip(1 - rise**2, 0, 1))
    out = cloth.vertices - fit.centre
    turn = np.arctan2(out[:, 0] / fit.radii[0], out[:, 2] / fit.radii[2])
    shrunk = np.where(is_inner, 0.96, 1.0) * width
    dome = np.stack([np.sin(turn) * fit.radii[0], 0 * turn, np.cos(turn) * fit.radii[2]], 1)
    dome = fit.centre + dome * shrunk[:, None]
    share = np.clip((rise - 0.15) / 0.35, 0, 1)
    share = (share * share * (3 - 2 * share))[:, None] * [1, 0, 1]
    cloth.vertices = cloth.vertices * (1 - share) + dome * share


def _cloth_weights(kit: Kit) -> WeightRule:
    """Hang the upper part on the head, the lower on the chest."""
    rig = kit.rig
    low, high = rig.heads["Neck"][1] - 0.02, rig.heads["Head"][1] + 0.035

    def weigh(points: Array) -> Array:
        weights = np.zeros((len(points), len(rig.names)))
        share = np.clip((points[:, 1] - low) / (high - low), 0, 1)
        share = share * share * (3 - 2 * share)
        weights[:, rig.index["Head"]] = share
        weights[:, rig.index["UpperChest"]] = 1 - share
        return weights

    return weigh


def add_scarf(kit: Kit, head: Head) -> None:
    """Wind a scarf loosely around the neck."""
    rig = kit.rig
    neck = rig.heads["Neck"]
    surface = _wrapped_surface(kit, head)
    weights = nearest_weights(kit.uniform)
    turns = np.linspace(0, 2 * np.pi, 61)[:-1]
    noise = kit.figure.noise
    for k, (rise, swell) in enumerate(((0.012, 0.012), (0.034, 0.006))):
        tilt = 0.022
        centres = np.tile([0, neck[1] + rise, neck[2] - 0.002], (len(turns), 1))
        directions = np.stack([np.sin(turns), 0 * turns, np.cos(turns)], 1)
        centres[:, 1] -= tilt * np.cos(turns)
        radii = surface.radii(centres, directions, 0.105)
        radii = np.where(np.isnan(radii), np.nanmedian(radii), radii)
        for _ in range(12):
            around = (np.roll(radii, 1) + 2 * radii + np.roll(radii, -1)) / 4
            radii = np.maximum(around, radii - 0.002)
        line = centres + directions * (np.minimum(radii, 0.098) + swell)[:, None]
        rings = []
        for turn in np.linspace(0, 2 * np.pi, 15)[:-1]:
            lumps = 0.005 * (noise.layered(line * 26 + 7 * k + 2 * turn, 2) - 0.5)
            out = np.cos(turn) * 0.014 + lumps
            up = np.sin(turn) * 0.020 + 0.004 * np.sin(3 * turns + k + turn)
            rings.append(line + directions * out[:, None] + np.outer(up, [0, 1, 0]))
        grid = np.stack(rings)
        outward = grid.reshape(-1, 3) - np.tile(line, (len(rings), 1))
        flat = np.vstack([grid, grid[:1]])
        outward = np.vstack([outward, outward[: len(line)]])
        mesh = grid_mesh(flat, weights, closed=True, outward=outward)
        kit.add(mesh, kit.palette.stripe * (1.0 if k else 0.85), Layer.WEAVE)
