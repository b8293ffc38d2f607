"""What shows of the body itself: gloved hands, head and eyes. Metres."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from .figure import Figure
from .quad_mesh import Layer, QuadMesh, neighbour_mean, subdivide, unique_edges
from .rig import FINGER_NAMES, Rig

Array = NDArray[np.float64]

_BODY = "body"


@dataclass
class Head:
    """Head and neck with the two eyes (left first)."""

    skin: QuadMesh
    eyes: list[QuadMesh]
    hair: Array = field(default_factory=lambda: np.array([0.03, 0.02, 0.014]))
    """Colour of the hair, linear RGB."""

    @property
    def eye_centres(self) -> list[Array]:
        """Return the middle of each eyeball."""
        return [eye.vertices.mean(0) for eye in self.eyes]


def hand_bones(rig: Rig) -> list[str]:
    """Return the bones of both hands with their fingers."""
    return [name for name in rig.names if "Hand" in name or any(f in name for f in FINGER_NAMES)]


def make_gloves(figure: Figure) -> QuadMesh:
    """Offset the hands' skin to gloves; the sleeves close over their ends."""
    rig = figure.rig
    hands = hand_bones(rig)

    def on_hand(middles: Array, weights: Array) -> NDArray[np.bool_]:
        forearm = rig.share(weights, ("LeftLowerArm", "RightLowerArm"))
        wrist = (forearm > 0.4) & (rig.along_forearm(middles) > 0.84)
        return (rig.share(weights, hands) > 0.5) | wrist

    gloves = figure.part(_BODY, on_hand)
    edges, _, _ = unique_edges(gloves.faces)
    gloves.vertices = gloves.vertices + gloves.normals() * 0.0022
    for _ in range(3):
        gloves.vertices = 0.6 * gloves.vertices + 0.4 * neighbour_mean(gloves.vertices, edges)
    gloves.vertices += gloves.normals() * 0.0012
    return gloves


def make_hands(figure: Figure, from_sleeve: float) -> QuadMesh:
    """Take bare hands and as much of the arms as the sleeves leave open.

    `from_sleeve` is where they begin: 0 at the elbow, 1 at the wrist, -1 at the shoulder.
    """
    rig = figure.rig
    hands = hand_bones(rig)
    lower, upper = (
        [side + bone for side in ("Left", "Right")] for bone in ("LowerArm", "UpperArm")
    )

    def is_bare(middles: Array, weights: Array) -> NDArray[np.bool_]:
        forearm = (rig.share(weights, lower) > 0.3) & (rig.along_forearm(middles) > from_sleeve)
        above = (rig.share(weights, upper) > 0.3) & (rig.along_upper_arm(middles) - 1 > from_sleeve)
        return (rig.share(weights, hands) > 0.5) | forearm | above

    skin = figure.part(_BODY, is_bare)
    return skin


def smooth_head(skin: QuadMesh) -> None:
    """Take a face's features away, but keep its proportions: a dummy's head."""
    edges, _, counts = unique_edges(skin.faces)
    rim = np.zeros(len(skin.vertices), bool)
    rim[edges[counts == 1].reshape(-1)] = True
    for step in range(160):
        moved = neighbour_mean(skin.vertices, edges)
        share = 0.62 if step % 2 == 0 else -0.60
        skin.vertices = np.where(
            rim[:, None], skin.vertices, skin.vertices + share * (moved - skin.vertices)
        )
    for _ in range(14):
        moved = neighbour_mean(skin.vertices, edges)
        skin.vertices = np.where(rim[:, None], skin.vertices, 0.5 * (skin.vertices + moved))


def take_head(figure: Figure) -> Head:
    """Cut head and neck from the body; the collar covers the cut."""
    rig = figure.rig

    def on_head(middles: Array, weights: Array) -> NDArray[np.bool_]:
        above_collar = middles[:, 1] > rig.heads["Neck"][1] - 0.04
        return (rig.share(weights, ("Head", "Neck")) > 0.35) & above_collar

    eyes = [figure.part("helper-l-eye"), figure.part("helper-r-eye")]
    return Head(figure.part(_BODY, on_head), eyes)


def make_eyes(head: Head) -> QuadMesh:
    """Join the eyeballs; texture coordinates are seen from in front, the iris in the middle."""
    left, right = head.eyes
    faces = np.vstack([left.faces, right.faces + len(left.vertices)])
    joined = QuadMesh(
        np.vstack([left.vertices, right.vertices]), np.vstack([left.weights, right.weights]), faces
    )
    eyes = subdivide(joined)
    left_centre, right_centre = head.eye_centres
    out = eyes.vertices - np.where(eyes.vertices[:, :1] > 0, left_centre, right_centre)
    radius = np.linalg.norm(out, axis=1).max()
    flat = out[:, :2] / radius
    # What faces back is laid on the white's edge.
    behind = out[:, 2] < 0
    flat[behind] *= (0.98 / np.maximum(np.linalg.norm(flat[behind], axis=1), 1e-6))[:, None]
    eyes.uvs = (0.5 + 0.5 * flat)[eyes.faces]
    eyes.is_mapped = True
    eyes.layer, eyes.gloss = Layer.SMOOTH, 0.97
    eyes.occlusion = np.clip(1.0 - 26 * np.clip(out[:, 1] - 0.004, 0, 1), 0.45, 1) * 0.9
    return eyes


def fill_eye(eye: QuadMesh, tone: Array) -> None:
    """Close the opening of a blank face by a ball of its colour."""
    middle = eye.vertices.mean(0)
    eye.vertices = middle + (eye.vertices - middle) * 1.22
    eye.set_colour(tone)
    eye.layer, eye.gloss = Layer.SMOOTH, 0.45
    eye.occlusion[:] = 0.9


def fill_mouth(head: Head, tone: Array) -> QuadMesh:
    """Close the slit of a blank face's mouth from behind."""
    eye = head.eye_centres[0]
    skin = head.skin.vertices
    near = (np.abs(skin[:, 0]) < 0.008) & (np.abs(skin[:, 1] - eye[1] + 0.072) < 0.012)
    front = skin[near][:, 2].max()
    ball = head.eyes[0]
    shape = (ball.vertices - ball.vertices.mean(0)) * [1.3, 0.45, 0.5]
    middle = np.array([0, eye[1] - 0.072, front - 0.017])
    plug = QuadMesh(middle + shape, ball.weights, ball.faces)
    fill_eye(plug, tone)
    return plug
