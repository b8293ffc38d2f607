"""Reads MakeHuman's base mesh and morph targets (CC0) and blends a body.

The data set works in decimetres, Y up, the figure faces +Z. The mesh holds the visible body
first (`BODY_VERTEX_COUNT` vertices) and behind it helper geometry such as tights and eyes, which
follows every morph and is the cloth's pattern here.
"""

import gzip
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BODY_VERTEX_COUNT = 13380
"""Vertices of the skin itself; those behind it are helpers."""
_VERTEX_COUNT = 19158

_YOUNG, _OLD = 25.0, 90.0
"""Ages of MakeHuman's two grown-up anchors, years."""
_ORIGINS = {"caucasian": 0.7, "asian": 0.15, "african": 0.15}
"""Blend of MakeHuman's three origin targets (its own names), unless said otherwise."""


@dataclass
class BodyMesh:
    """The base mesh, morphed: vertices shared by all groups, faces by group name."""

    vertices: Array
    """Shape (19158, 3)."""
    uvs: Array
    """Texture coordinates, v upwards."""
    faces: dict[str, list[list[int]]]
    """Vertex indices of each face (3 or 4) by group."""
    face_uvs: dict[str, list[list[int]]]
    """Indices into `uvs`, parallel to `faces`."""


@dataclass(frozen=True)
class BodyParameters:
    """What the figure is built from; ranges 0 to 1 unless said otherwise."""

    height: float = 1.80
    """Bare stature in metres."""
    female: float = 0.0
    age: float = _YOUNG
    """Years, 25 to 90."""
    muscle: float = 0.68
    weight: float = 0.52
    proportions: float = 0.75
    """0.5 is average, 1 MakeHuman's ideal proportions."""
    origins: Mapping[str, float] | None = None
    """Shares of MakeHuman's three origin targets; sum 1."""
    measures: Mapping[str, float] | None = None
    """Extra targets without their -incr/-decr ending, with a signed amount (keep within 1.5)."""

    @classmethod
    def from_tree(cls, tree: Mapping) -> "BodyParameters":
        """Read {"height", "female", "age", "muscle", "weight", "extra": {target: amount}}."""
        rest = dict(tree)
        measures = rest.pop("extra", {})
        return cls(measures=measures, **rest)


class MakeHumanData:
    """The unpacked data folder (`mpfb2`) with base mesh, targets and rigs."""

    def __init__(self, root: Path) -> None:
        self.root = root

    def read_json(self, path: str) -> dict:
        """Read a JSON file of the data folder."""
        return json.loads((self.root / path).read_text())

    def read_base_mesh(self) -> BodyMesh:
        """Read the base mesh (Wavefront OBJ), in decimetres."""
        vertices: list[list[float]] = []
        uvs: list[list[float]] = []
        faces: dict[str, list[list[int]]] = {}
        face_uvs: dict[str, list[list[int]]] = {}
        group = ""
        for line in (self.root / "3dobjs/base.obj").read_text().splitlines():
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                vertices.append([float(x) for x in words[1:4]])
            elif words[0] == "vt":
                uvs.append([float(x) for x in words[1:3]])
            elif words[0] == "g":
                group = words[1]
            elif words[0] == "f":
                corners = [corner.split("/") for corner in words[1:]]
                faces.setdefault(group, []).append([int(c[0]) - 1 for c in corners])
                face_uvs.setdefault(group, []).append([int(c[1]) - 1 for c in corners])
        return BodyMesh(np.array(vertices), np.array(uvs), faces, face_uvs)

    def has_target(self, name: str) -> bool:
        """Tell whether a morph target exists; not every combination does."""
        return self._target_path(name).exists()

    def read_target(self, name: str) -> Array:
        """Read one morph target: an offset per vertex, decimetres."""
        offsets = np.zeros((_VERTEX_COUNT, 3))
        with gzip.open(self._target_path(name), "rt") as file:
            for line in file:
                words = line.split()
                if len(words) == 4 and words[0][0] != "#":
                    offsets[int(words[0])] = [float(x) for x in words[1:]]
        return offsets

    def _target_path(self, name: str) -> Path:
        return self.root / "targets" / f"{name}.target.gz"


def blend_three(value: float, names: tuple[str, str, str]) -> dict[str, float]:
    """Spread a value (0 to 1) over two of three anchors at 0, 0.5 and 1."""
    if value < 0.5:
        return {names[0]: 1 - 2 * value, names[1]: 2 * value}
    return {names[1]: 2 - 2 * value, names[2]: 2 * value - 1}


def signed_target(name: str, amount: float) -> tuple[str, float]:
    """Return the growing or shrinking target of a measure and its positive amount."""
    return name + ("-incr" if amount > 0 else "-decr"), abs(amount)


def macro_shares(parameters: BodyParameters) -> dict[str, float]:
    """Return the share of each of MakeHuman's people by sex and age: "male-young" and so on."""
    years = min(max((parameters.age - _YOUNG) / (_OLD - _YOUNG), 0.0), 1.0)
    sexes = {"male": 1 - parameters.female, "female": parameters.female}
    ages = {"young": 1 - years, "old": years}
    shares = {f"{sex}-{age}": a * b for sex, a in sexes.items() for age, b in ages.items()}
    return {kind: share for kind, share in shares.items() if share > 0}


def build_body(data: MakeHumanData, parameters: BodyParameters) -> BodyMesh:
    """Blend the morph targets; the result is in decimetres, at MakeHuman's own height."""
    body = data.read_base_mesh()
    vertices = body.vertices
    muscles = blend_three(parameters.muscle, ("minmuscle", "averagemuscle", "maxmuscle"))
    weights = blend_three(parameters.weight, ("minweight", "averageweight", "maxweight"))
    if parameters.proportions > 0.5:
        proportions = ("idealproportions", 2 * parameters.proportions - 1)
    else:
        proportions = ("uncommonproportions", 1 - 2 * parameters.proportions)
    for kind, kind_share in macro_shares(parameters).items():
        for origin, share in (parameters.origins or _ORIGINS).items():
            vertices += kind_share * share * data.read_target(f"macrodetails/{origin}-{kind}")
        for muscle, muscle_share in muscles.items():
            for weight, weight_share in weights.items():
                share = kind_share * muscle_share * weight_share
                if not share:
                    continue
                build = f"{kind}-{muscle}-{weight}"
                vertices += share * data.read_target(f"macrodetails/universal-{build}")
                target = f"macrodetails/proportions/{build}-{proportions[0]}"
                if proportions[1] and data.has_target(target):
                    vertices += share * proportions[1] * data.read_target(target)
    for measure, amount in (parameters.measures or {}).items():
        target, share = signed_target(measure, amount)
        vertices += share * data.read_target(target)
    return body


def scale_to_height(body: BodyMesh, height: float) -> None:
    """Turn decimetres into metres, put the sole at y = 0 and scale to a stature in metres."""
    vertices = body.vertices * 0.1
    vertices[:, 1] -= vertices[:BODY_VERTEX_COUNT, 1].min()
    vertices *= height / vertices[:BODY_VERTEX_COUNT, 1].max()
    body.vertices = vertices
