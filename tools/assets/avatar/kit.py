"""The soldier's equipment: collects the parts and the surfaces that they are fitted to."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .figure import Figure
from .quad_mesh import Layer, QuadMesh
from .recipe import Palette
from .rig import SIDES
from .surface import Surface

Array = NDArray[np.float64]

_TORSO_BONES = ("Hips", "Spine", "Chest", "UpperChest", "LeftShoulder", "RightShoulder", "Neck")
_ARM_BONES = ("LeftLowerArm", "LeftUpperArm", "RightUpperArm", "RightLowerArm")


GLOSS = {
    Layer.SMOOTH: 0.35,
    Layer.CORDURA: 0.12,
    Layer.WEBBING: 0.18,
    Layer.LEATHER: 0.42,
    Layer.WEAVE: 0.06,
    Layer.SKIN: 0.35,
    Layer.HAIR: 0.4,
    Layer.GLOW: 0.5,
}
"""How polished each structure is, 0 to 1."""


class Kit:
    """The parts so far, and what they hug."""

    def __init__(self, figure: Figure, uniform: QuadMesh, palette: Palette) -> None:
        self.figure = figure
        self.palette = palette
        self.rig = figure.rig
        self.uniform = uniform
        self.parts: list[QuadMesh] = []
        self.torso = Surface(uniform.vertices, uniform.faces[self._torso_faces()])
        self.legs = {
            side: Surface(uniform.vertices, uniform.faces[self._leg_faces(side)]) for side in SIDES
        }

    def add(
        self,
        part: QuadMesh,
        colour: ArrayLike,
        layer: Layer = Layer.CORDURA,
        gloss: float | None = None,
    ) -> QuadMesh:
        """Take up a part in one linear RGB colour, with a fine structure."""
        part.set_colour(colour)
        part.layer = layer
        part.gloss = GLOSS[layer] if gloss is None else gloss
        self.parts.append(part)
        return part

    def _corner_share(self, bones: tuple[str, ...]) -> Array:
        """Return the weight on some bones at each corner of each face of the uniform."""
        return self.uniform.weights[self.uniform.faces][:, :, self.rig.columns(*bones)].sum(2)

    def _torso_faces(self) -> NDArray[np.bool_]:
        """Choose the torso; around the hips also what the thighs move, but no sleeves."""
        torso = (self._corner_share(_TORSO_BONES) > 0.45).all(1)
        height = self.uniform.vertices[self.uniform.faces].mean(1)[:, 1]
        hips = self.rig.heads["Hips"][1]
        weights = self.uniform.weights[self.uniform.faces].mean(1)
        arms = self.rig.share(weights, _ARM_BONES) > 0.3
        return torso | ((height < hips + 0.08) & (height > hips - 0.12) & ~arms)

    def _leg_faces(self, side: str) -> NDArray[np.bool_]:
        return (self._corner_share((side + "UpperLeg", side + "LowerLeg")) > 0.3).all(1)
