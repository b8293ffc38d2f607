"""What shows of the body itself: gloved hands, head and eyes. Metres."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .figure import Figure
from .quad_mesh import QuadMesh, neighbour_mean, subdivide, unique_edges
from .rig import FINGER_NAMES, Rig

Array = NDArray[np.float64]

_BODY = "body"
_PUPIL_RADIUS, _IRIS_RADIUS = 0.0028, 0.0062
_PUPIL, _IRIS, _WHITE = [0.01, 0.01, 0.01], [0.12, 0.075, 0.04], [0.75, 0.7, 0.66]


@dataclass
class Head:
    """Head and neck with the two eyes (left first)."""

    skin: QuadMesh
    eyes: list[QuadMesh]

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


def take_head(figure: Figure) -> Head:
    """Cut head and neck from the body; the collar covers the cut."""
    rig = figure.rig

    def on_head(middles: Array, weights: Array) -> NDArray[np.bool_]:
        above_collar = middles[:, 1] > rig.heads["Neck"][1] - 0.04
        return (rig.share(weights, ("Head", "Neck")) > 0.35) & above_collar

    eyes = [figure.part("helper-l-eye"), figure.part("helper-r-eye")]
    return Head(figure.part(_BODY, on_head), eyes)


def make_eyes(head: Head) -> QuadMesh:
    """Join the eyeballs and paint iris and pupil onto their vertices."""
    left, right = head.eyes
    faces = np.vstack([left.faces, right.faces + len(left.vertices)])
    joined = QuadMesh(
        np.vstack([left.vertices, right.vertices]), np.vstack([left.weights, right.weights]), faces
    )
    eyes = subdivide(joined)
    eyes.occlusion = np.full(len(eyes.vertices), 0.85)
    left_centre, right_centre = head.eye_centres
    out = eyes.vertices - np.where(eyes.vertices[:, :1] > 0, left_centre, right_centre)
    radius = np.linalg.norm(out[:, :2], axis=1)[:, None]
    iris = np.where(radius < _IRIS_RADIUS, _IRIS, _WHITE)
    eyes.colours[:] = np.where(radius < _PUPIL_RADIUS, _PUPIL, iris)
    eyes.colours[out[:, 2] < 0] = _WHITE
    eyes.uvs[:] = eyes.vertices[eyes.faces][..., :2]
    return eyes
