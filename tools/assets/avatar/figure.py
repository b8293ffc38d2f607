"""The naked, rigged figure that everything else is built around."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .makehuman import BodyMesh, BodyParameters, MakeHumanData, build_body, scale_to_height
from .noise import NoiseField
from .quad_mesh import QuadMesh
from .rig import Rig, build_rig, skin_weights

Array = NDArray[np.float64]
FaceFilter = Callable[[Array, Array], NDArray[np.bool_]]
"""Chooses faces by their middles (metres) and their mean weights."""

_SEED = 7


@dataclass
class Figure:
    """The morphed body in metres with its skeleton; parts of it become cloth, gloves, head."""

    body: BodyMesh
    rig: Rig
    weights: Array
    """One row per vertex, one column per bone."""
    noise: NoiseField

    def part(self, group: str, keep: FaceFilter | None = None) -> QuadMesh:
        """Copy a face group of the base mesh, or those of its faces that `keep` chooses."""
        corners, uvs = [], []
        for face, face_uv in zip(self.body.faces[group], self.body.face_uvs[group], strict=True):
            if len(face) == 3:
                face, face_uv = [*face, face[2]], [*face_uv, face_uv[2]]
            corners.append(face)
            uvs.append([self.body.uvs[i] for i in face_uv])
        faces, face_uvs = np.array(corners), np.array(uvs)
        if keep is not None:
            chosen = keep(self.body.vertices[faces].mean(1), self.weights[faces].mean(1))
            faces, face_uvs = faces[chosen], face_uvs[chosen]
        used, inverse = np.unique(faces, return_inverse=True)
        return QuadMesh(
            self.body.vertices[used], self.weights[used], inverse.reshape(faces.shape), face_uvs
        )


def build_figure(data: MakeHumanData, parameters: BodyParameters) -> Figure:
    """Morph, scale and rig the body."""
    body = build_body(data, parameters)
    scale_to_height(body, parameters.height)
    rig = build_rig(data, body)
    weights = skin_weights(data, rig, len(body.vertices))
    return Figure(body, rig, weights, NoiseField(_SEED))
