"""The uniform: MakeHuman's tights, let out, draped and cut into jacket-with-trousers and boots."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .figure import Figure
from .quad_mesh import Layer, QuadMesh, neighbour_mean, subdivide, unique_edges
from .rig import SIDES, Rig

Array = NDArray[np.float64]

_PATTERN = "helper-tights"
_DRAPE_STEPS = 14
_TROUSERS_END = {"fatigues": 0.82, "shirt": 0.985, "polo": 0.985}
"""Where trousers are cut off, 0 at the knee, 1 at the ankle."""


@dataclass
class UniformCut:
    """The pieces cut from the tights."""

    uniform: QuadMesh
    """Jacket and trousers, loose; boots are left out."""
    boots: QuadMesh
    """The tight shell of both boots."""
    body_form: QuadMesh
    """The tights themselves: what the cloth must not sink into."""


def cut_uniform(figure: Figure, cut: str) -> UniformCut:
    """Make the pieces; texture coordinates fill the unit square. For cuts see recipe.CUTS."""
    rig = figure.rig
    pattern = figure.part(_PATTERN)
    low, high = pattern.uvs.reshape(-1, 2).min(0), pattern.uvs.reshape(-1, 2).max(0)
    pattern.uvs = (pattern.uvs - low) / (high - low) * 0.98 + 0.01
    tight_shell = subdivide(pattern)
    if cut != "suit":
        _drape(pattern, rig)
    loose_shell = subdivide(pattern)

    middles = loose_shell.vertices[loose_shell.faces].mean(1)
    weights = loose_shell.weights[loose_shell.faces].mean(1)
    shin = rig.along_shin(middles)
    on_leg = _limb_share(rig, weights, ("LowerLeg", "Foot", "Toes")) > 0.5
    on_arm = _limb_share(rig, weights, ("UpperArm", "LowerArm", "Hand")) > 0.5
    hand = on_arm & (rig.along_forearm(middles) > 1.02)
    collar = (middles[:, 1] > rig.heads["Neck"][1] + 0.055) & ~on_arm
    if cut == "suit":
        uniform = loose_shell.subset(~hand & ~collar)
    else:
        last = _TROUSERS_END[cut]
        sleeve = on_arm & (rig.along_upper_arm(middles) > 0.62) if cut == "polo" else hand
        uniform = loose_shell.subset(~(on_leg & (shin > last)) & ~hand & ~sleeve & ~collar)
    uniform.layer = Layer.WEAVE if cut != "suit" else Layer.SMOOTH
    uniform.gloss = 0.08 if cut != "suit" else 0.45
    boots = tight_shell.subset(on_leg & (shin > 0.64))
    return UniformCut(uniform, boots, subdivide(figure.part(_PATTERN)))


def _limb_share(rig: Rig, weights: Array, parts: tuple[str, ...]) -> Array:
    """Return the weight on parts of both sides together."""
    return sum(weights[:, rig.index[side + part]] for side in SIDES for part in parts)


def _ease(pattern: QuadMesh, rig: Rig) -> Array:
    """Return how far (metres) the cloth hangs off the body at each vertex."""
    ease = np.full(len(pattern.vertices), 0.010)
    points, weights = pattern.vertices, pattern.weights
    for side in SIDES:
        leg = rig.share(weights, (side + "UpperLeg", side + "LowerLeg"))
        foot = rig.share(weights, (side + "Foot", side + "Toes"))
        arm = rig.share(weights, (side + "UpperArm", side + "LowerArm"))
        shin = rig.along(points, side + "LowerLeg", side + "Foot")
        forearm = rig.along(points, side + "LowerArm", side + "Hand")
        # Trousers widen towards the shin, sleeves narrow towards the cuff.
        ease = np.maximum(ease, leg * (0.022 + 0.010 * np.clip((shin - 0.25) / 0.4, 0, 1)))
        ease = np.where(foot > 0.5, 0.007, ease)
        sleeve = 0.017 - 0.010 * np.clip(forearm - 0.75, 0, 0.25) / 0.25
        ease = np.where(arm > 0.5, sleeve, ease)
    return ease


def _drape(pattern: QuadMesh, rig: Rig) -> None:
    """Push the cloth off the body and smooth it, never below four fifths of its ease."""
    body, normals = pattern.vertices, pattern.normals()
    edges, _, _ = unique_edges(pattern.faces)
    ease = _ease(pattern, rig)
    cloth = body + normals * ease[:, None]
    for _ in range(_DRAPE_STEPS):
        cloth = 0.5 * cloth + 0.5 * neighbour_mean(cloth, edges)
        lift = ((cloth - body) * normals).sum(1)
        cloth += normals * np.maximum(ease * 0.8 - lift, 0)[:, None]
    pattern.vertices = cloth
