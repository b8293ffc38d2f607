# SPDX-License-Identifier: MIT
"""Reads Acclaim's skeletons (ASF) and motions (AMC), as Carnegie Mellon's library has them.

A bone reaches from its parent's end along its direction. It turns about axes of its own, which C
(the line `axis`) turns from the world's: by C R C^-1, with R from its degrees of freedom, the first
of which turns first. In the rest pose all frames are the world's.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path

from avatar import vector3 as v3
from avatar.vector3 import Quat, Vec3

NO_TURN: Quat = (0.0, 0.0, 0.0, 1.0)
ROOT = "root"
_ROOT_ORDER = ["TX", "TY", "TZ", "RX", "RY", "RZ"]


class AcclaimError(Exception):
    """What a file has that was not expected, and in which line."""


@dataclass
class Bone:
    """A bone at rest, in the world's axes and the file's length unit."""

    name: str
    end: Vec3 = (0.0, 0.0, 0.0)
    """From its beginning to its end."""
    axes: Quat = NO_TURN
    """C: from the world's axes to those that it turns about."""
    freedoms: list[str] = field(default_factory=list)
    """The axes that it turns about: x, y or z, in their order."""
    children: list[Bone] = field(default_factory=list)

    def rotation(self, degrees: list[float]) -> Quat:
        """Its rotation in its parent's frame."""
        own = _turns(self.freedoms, degrees)
        return v3.multiply(v3.multiply(self.axes, own), v3.conjugate(self.axes))


@dataclass
class Frame:
    """A moment of a motion."""

    place: Vec3
    """Where the root is, in the skeleton's length unit."""
    degrees: dict[str, list[float]]
    """For each bone that moves the angles of its degrees of freedom; the root's about X, Y, Z."""


def read_skeleton(path: Path) -> Bone:
    """The root of an ASF file's skeleton."""
    sections: dict[str, list[tuple[int, list[str]]]] = {}
    rows: list[tuple[int, list[str]]] = []
    for number, line in enumerate(path.read_text(encoding="latin-1").splitlines(), 1):
        words = line.split("#")[0].split()
        if words and words[0].startswith(":"):
            rows = sections.setdefault(words[0], [])
            words = words[1:]
        if words:
            rows.append((number, words))
    for section in (":root", ":bonedata", ":hierarchy"):
        if section not in sections:
            raise AcclaimError(f"{path}: expected a section {section}")
    _check_root(path, sections)
    bones = {bone.name: bone for bone in _read_bones(path, sections[":bonedata"])}
    bones[ROOT] = Bone(ROOT, freedoms=["x", "y", "z"])
    hung = {ROOT}
    for number, words in sections[":hierarchy"]:
        if words[0] in ("begin", "end"):
            continue
        for name in words:
            if name not in bones:
                raise AcclaimError(f"{path}:{number}: no bone '{name}' is described above")
        for name in words[1:]:
            if name in hung:
                raise AcclaimError(f"{path}:{number}: '{name}' hangs on a bone already")
            hung.add(name)
        bones[words[0]].children = [bones[name] for name in words[1:]]
    return bones[ROOT]


def read_motion(path: Path, root: Bone) -> list[Frame]:
    """The frames of an AMC file, whose numbers must fit the skeleton's degrees of freedom."""
    freedoms = {bone.name: len(bone.freedoms) for bone in bones_of(root)}
    freedoms[ROOT] = len(_ROOT_ORDER)
    frames: list[Frame] = []
    # Some motions are cut out of longer ones, and keep those numbers.
    first = 1
    for number, line in enumerate(path.read_text(encoding="latin-1").splitlines(), 1):
        name, *values = line.split("#")[0].split() or [""]
        if name == "" or name.startswith(":"):
            continue
        if name.isdigit():
            first = int(name) if not frames else first
            if int(name) != first + len(frames):
                raise AcclaimError(f"{path}:{number}: expected frame {first + len(frames)}")
            frames.append(Frame((0.0, 0.0, 0.0), {}))
        elif not frames or len(values) != freedoms.get(name):
            wanted = f"{freedoms.get(name)} numbers for it" if frames else "a frame's number first"
            raise AcclaimError(f"{path}:{number}: found '{name}', expected {wanted}")
        else:
            angles = _numbers(path, number, values, len(values))
            if name == ROOT:
                frames[-1].place = (angles[0], angles[1], angles[2])
                angles = angles[3:]
            frames[-1].degrees[name] = angles
    return frames


def bones_of(root: Bone) -> list[Bone]:
    """A bone and all that hang on it, parents first."""
    return [root] + [bone for child in root.children for bone in bones_of(child)]


def _check_root(path: Path, sections: dict[str, list[tuple[int, list[str]]]]) -> None:
    """Refuses what no file of the library has, instead of converting it wrongly."""
    wanted = {"order": _ROOT_ORDER, "axis": ["XYZ"]}
    for number, words in sections[":root"]:
        name, *values = words
        fits = values == wanted.get(name, values)
        if name in ("position", "orientation"):
            fits = not any(_numbers(path, number, values, 3))
        if not fits:
            raise AcclaimError(f"{path}:{number}: no other '{name}' of the root is known")
    for number, words in sections.get(":units", []):
        if words[0] == "angle" and words[1:] != ["deg"]:
            raise AcclaimError(f"{path}:{number}: expected angles in deg")


def _read_bones(path: Path, rows: list[tuple[int, list[str]]]) -> list[Bone]:
    bones: list[Bone] = []
    direction: Vec3 = (0.0, 0.0, 0.0)
    for number, words in rows:
        name, *values = words
        if name == "begin":
            bones.append(Bone(""))
        elif not bones:
            raise AcclaimError(f"{path}:{number}: expected 'begin', found '{name}'")
        elif name == "name":
            bones[-1].name = " ".join(values)
        elif name == "direction":
            x, y, z = _numbers(path, number, values, 3)
            direction = (x, y, z)
        elif name == "length":
            bones[-1].end = v3.scale(direction, _numbers(path, number, values, 1)[0])
        elif name == "axis":
            order = values[-1].lower() if values else ""
            if sorted(order) != ["x", "y", "z"]:
                raise AcclaimError(f"{path}:{number}: expected three angles and an order like XYZ")
            bones[-1].axes = _turns(list(order), _numbers(path, number, values[:-1], 3))
        elif name == "dof":
            bones[-1].freedoms = [value[1:] for value in values if value in ("rx", "ry", "rz")]
            if len(bones[-1].freedoms) != len(values):
                raise AcclaimError(f"{path}:{number}: only rx, ry and rz are known")
    return bones


def _numbers(path: Path, number: int, words: list[str], count: int) -> list[float]:
    """So many finite numbers of a line."""
    try:
        values = [float(word) for word in words]
    except ValueError as error:
        raise AcclaimError(f"{path}:{number}: expected numbers: {error}") from error
    if len(values) != count or not all(math.isfinite(value) for value in values):
        raise AcclaimError(f"{path}:{number}: expected {count} finite numbers, found {words}")
    return values


def _turns(axes: list[str], degrees: list[float]) -> Quat:
    """Rotations about the axes of the frame outside, the first one first."""
    turned = NO_TURN
    for axis, angle in zip(axes, degrees, strict=True):
        half = math.radians(angle) / 2.0
        turn = [0.0, 0.0, 0.0, math.cos(half)]
        turn["xyz".index(axis)] = math.sin(half)
        turned = v3.multiply((turn[0], turn[1], turn[2], turn[3]), turned)
    return turned
