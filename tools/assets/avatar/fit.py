"""Solves the body for a wearer's measures, so that the avatar's limbs are as long as theirs.

Run as `python3 -m avatar.fit --data FOLDER '{"height": 1.65, "upper_arm": 0.27, ...}'` in
tools/assets; prints the "body" of a recipe. Measures are distances in metres
between joint centres (a suit's calibration), not tape measures; what is left out stays as it is.
"""

import argparse
import json
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .makehuman import (
    BODY_VERTEX_COUNT,
    BodyParameters,
    MakeHumanData,
    build_body,
    signed_target,
)

Array = NDArray[np.float64]

MEASURE_TARGETS = {
    "upper_arm": "arms/measure-upperarm-length",
    "lower_arm": "arms/measure-lowerarm-length",
    "upper_leg": "legs/measure-upperleg-height",
    "lower_leg": "legs/measure-lowerleg-height",
    "shoulders": "torso/measure-shoulder-dist",
}
"""MakeHuman's target behind each measure."""

_MEASURE_JOINTS = {
    "upper_arm": ("l-shoulder", "l-elbow"),
    "lower_arm": ("l-elbow", "l-hand"),
    "upper_leg": ("l-upper-leg", "l-knee"),
    "lower_leg": ("l-knee", "l-ankle"),
    "shoulders": ("l-shoulder", "r-shoulder"),
}
_NAMES = ("height", *MEASURE_TARGETS)
_TOLERANCE = 5e-4
"""Metres."""
_LARGEST_AMOUNT = 1.5
"""Beyond this the targets tear the body."""


def solve_newton(
    measure: Callable[[Array], Array], start: Array, goal: Array, steps: int = 8
) -> Array:
    """Find parameters whose measures meet the goal, to half a millimetre.

    Newton's method with a numerical derivative; the model is nearly linear, so few steps do.
    Each parameter moves by 0.5 a step at most.
    """
    nudge = 0.05
    parameters = np.array(start, float)
    for _ in range(steps):
        now = measure(parameters)
        error = goal - now
        if abs(error).max() < _TOLERANCE:
            return parameters
        columns = [
            (measure(parameters + nudge * unit) - now) / nudge for unit in np.eye(len(parameters))
        ]
        step = np.linalg.lstsq(np.stack(columns, 1), error, rcond=None)[0]
        parameters = parameters + np.clip(step, -0.5, 0.5)
    remaining = abs(goal - measure(parameters)).max()
    if remaining < _TOLERANCE:
        return parameters
    raise ValueError(f"the measures cannot be met: {remaining * 1e3:.1f} mm are left")


class BodyMeasurer:
    """Measures the body for a global scale and five amounts of MakeHuman's targets."""

    def __init__(self, data: MakeHumanData, parameters: BodyParameters) -> None:
        self._vertices = build_body(data, parameters).vertices * 0.1
        self._groups = data.read_json("mesh_metadata/basemesh_vertex_groups.json")
        self._offsets = {
            (target, sign): data.read_target(signed_target(target, sign)[0]) * 0.1
            for target in MEASURE_TARGETS.values()
            for sign in (1, -1)
        }

    def measure(self, parameters: Array) -> Array:
        """Return height and joint distances (metres) in the order of `_NAMES`."""
        vertices = self._vertices.copy()
        for target, amount in zip(MEASURE_TARGETS.values(), parameters[1:], strict=True):
            vertices += abs(amount) * self._offsets[target, 1 if amount > 0 else -1]
        vertices *= parameters[0]
        distances = [
            np.linalg.norm(self._joint(vertices, a) - self._joint(vertices, b))
            for a, b in _MEASURE_JOINTS.values()
        ]
        return np.array([np.ptp(vertices[:BODY_VERTEX_COUNT, 1]), *distances])

    def _joint(self, vertices: Array, name: str) -> Array:
        """Return the middle of a joint's helper cube."""
        ((first, last),) = self._groups["joint-" + name]
        return vertices[first : last + 1].mean(0)


def fit_body(data: MakeHumanData, wanted: Mapping[str, float]) -> dict:
    """Return `build_avatar`'s parameters for the wanted measures (metres, by name)."""
    unknown = set(wanted) - set(_NAMES)
    if unknown:
        raise ValueError(f"unknown measures {sorted(unknown)}; known are {list(_NAMES)}")
    measurer = BodyMeasurer(data, BodyParameters())
    start = np.array([1.0, 0, 0, 0, 0, 0])
    start[0] = BodyParameters().height / measurer.measure(start)[0]
    goal = measurer.measure(start)
    for name, value in wanted.items():
        goal[_NAMES.index(name)] = value
    solution = solve_newton(measurer.measure, start, goal)
    amounts = dict(zip(MEASURE_TARGETS, solution[1:], strict=True))
    too_far = [name for name, amount in amounts.items() if abs(amount) > _LARGEST_AMOUNT]
    if too_far:
        raise ValueError(f"these measures are too far from the body's: {too_far}")
    extra = {MEASURE_TARGETS[name]: round(amount, 4) for name, amount in amounts.items()}
    return {"height": round(float(goal[0]), 4), "extra": extra}


def main() -> None:
    """Parse the command line and print the parameters."""
    parser = argparse.ArgumentParser(description="Fit the avatar's body to a wearer's measures.")
    parser.add_argument("measures", help=f"JSON with any of {list(_NAMES)}, metres")
    parser.add_argument("--data", type=Path, required=True, help="MakeHuman's mpfb2 data folder")
    arguments = parser.parse_args()
    print(json.dumps(fit_body(MakeHumanData(arguments.data), json.loads(arguments.measures))))


if __name__ == "__main__":
    main()
