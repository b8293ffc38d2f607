# SPDX-License-Identifier: MIT
"""Tests of tools/assets/cmu: from Acclaim's skeletons and motions to BVH."""

import math
import random
import sys
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tools" / "assets"))

from avatar import vector3 as v3
from cmu import to_bvh
from cmu.acclaim import NO_TURN, AcclaimError, Bone, bones_of, read_motion, read_skeleton

SKELETON = """# a comment
:version 1.10
:units
  mass 1.0
  length 0.45
  angle deg
:root
   order TX TY TZ RX RY RZ
   axis XYZ
   position 0 0 0
   orientation 0 0 0
:bonedata
  begin
     id 1
     name thorax
     direction 0 1 0
     length 2
     axis 0 0 0 XYZ
    dof rx ry rz
    limits (-20 20)
           (-30 30)
           (-40 40)
  end
  begin
     id 2
     name lclavicle
     direction 1 0 0
     length 0.5
     axis 10 20 30 XYZ
    dof ry rz
  end
  begin
     id 3
     name lhumerus
     direction 0.6 -0.8 0
     length 3
     axis 15 -40 70 XYZ
    dof rx ry rz
  end
:hierarchy
  begin
    root thorax
    thorax lclavicle
    lclavicle lhumerus
  end
"""
MOTION = """#!OML:ASF
:FULLY-SPECIFIED
:DEGREES
1
root 1 2 3 10 20 30
thorax 5 6 7
lclavicle 8 9
lhumerus 100 -50 20
2
root 1.5 2 3 -170 85 40
thorax 0 0 0
lclavicle 0 0
lhumerus 0 90 0
"""


@pytest.fixture
def skeleton(tmp_path: Path) -> Bone:
    return read_skeleton(written(tmp_path, "person.asf", SKELETON))


def written(folder: Path, name: str, text: str) -> Path:
    path = folder / name
    path.write_text(text, encoding="latin-1")
    return path


def about(axis: str, degrees: float) -> list[list[float]]:
    """A matrix, as another way than the converter's quaternions."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }[axis]


def times(*factors: list[list[float]]) -> list[list[float]]:
    product = factors[0]
    for factor in factors[1:]:
        columns = list(zip(*factor, strict=True))
        product = [
            [sum(a * b for a, b in zip(row, column, strict=True)) for column in columns]
            for row in product
        ]
    return product


def turned(matrix: list[list[float]], v: tuple[float, float, float]) -> list[float]:
    return [sum(a * b for a, b in zip(row, v, strict=True)) for row in matrix]


def in_bvh(text: str, frame: int) -> dict[str, list[float]]:
    """Where the joints of a BVH file, and the end of its last one, are in a frame."""
    head, motion = text.split("Frame Time:")
    values = [float(value) for value in motion.splitlines()[1 + frame].split()]
    place, turn = [0.0, 0.0, 0.0], times(about("x", 0))
    places = {}
    name = ""
    for line in head.splitlines():
        words = line.split()
        if words[0] in ("ROOT", "JOINT", "End"):
            name = words[1]
        elif words[0] == "OFFSET":
            offset = turned(turn, tuple(float(word) for word in words[1:]))
            place = [a + b for a, b in zip(place, offset, strict=True)]
            places[name] = place
        elif words[0] == "CHANNELS":
            assert words[-3:] == ["Zrotation", "Yrotation", "Xrotation"]
            if words[1] == "6":
                place = places[name] = [a + b for a, b in zip(place, values[:3], strict=True)]
                values = values[3:]
            z, y, x = values[:3]
            turn = times(turn, about("z", z), about("y", y), about("x", x))
            values = values[3:]
    assert values == []
    return places


def test_places_are_those_of_the_acclaim_model(tmp_path: Path, skeleton: Bone) -> None:
    text = to_bvh.convert(skeleton, read_motion(written(tmp_path, "a.amc", MOTION), skeleton))
    place = [1.0, 2.0, 3.0]
    turn = times(about("z", 30), about("y", 20), about("x", 10))
    wanted = {"Hips": place}
    for joint, axes, angles, offset in (
        ("LeftShoulder", (0, 0, 0), {"x": 5, "y": 6, "z": 7}, (0, 2, 0)),
        ("LeftArm", (10, 20, 30), {"y": 8, "z": 9}, (0.5, 0, 0)),
        ("Site", (15, -40, 70), {"x": 100, "y": -50, "z": 20}, (1.8, -2.4, 0)),
    ):
        c = times(about("z", axes[2]), about("y", axes[1]), about("x", axes[0]))
        own = times(about("x", 0))
        for axis, angle in angles.items():
            own = times(about(axis, angle), own)
        turn = times(turn, c, own, [list(row) for row in zip(*c, strict=True)])
        place = [a + b for a, b in zip(place, turned(turn, offset), strict=True)]
        wanted[joint] = place
    found = in_bvh(text, 0)
    for joint, there in wanted.items():
        assert found[joint] == pytest.approx(there, abs=2e-5), joint


def test_motion_of_the_root_is_kept_as_it_is(tmp_path: Path, skeleton: Bone) -> None:
    text = to_bvh.convert(skeleton, read_motion(written(tmp_path, "a.amc", MOTION), skeleton))
    assert "Frames: 2\nFrame Time: 0.0083333\n1 2 3 30 20 10 " in text
    assert "CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation" in text
    assert "\n1.5 2 3 40 85 -170 " in text
    assert "-0 " not in text


def test_angles_describe_the_rotation_also_at_the_pole() -> None:
    chance = random.Random(3)
    angles = [[chance.uniform(-180, 180) for _ in range(3)] for _ in range(200)]
    angles += [[20.0, 90.0, 50.0], [0.0, -90.0, 0.0], [180.0, 0.0, 180.0]]
    for x, y, z in angles:
        wanted = Bone("a", freedoms=["x", "y", "z"]).rotation([x, y, z])
        z, y, x = to_bvh.euler_zyx(wanted)
        found = Bone("a", freedoms=["x", "y", "z"]).rotation([x, y, z])
        assert abs(sum(a * b for a, b in zip(wanted, found, strict=True))) > 1 - 1e-12


def test_a_bone_without_motion_keeps_its_rest_pose(skeleton: Bone) -> None:
    for bone in bones_of(skeleton):
        still = v3.normalized(bone.rotation([0.0] * len(bone.freedoms)))
        assert still == pytest.approx(NO_TURN, abs=1e-12)


@pytest.mark.parametrize(
    ("found", "instead", "message"),
    [
        ("order TX", "order TY", "'order'"),
        ("position 0 0 0", "position 0 1 0", "'position'"),
        ("angle deg", "angle rad", "deg"),
        ("dof ry rz", "dof ry l", "rx, ry and rz"),
        ("root thorax", "root chest", "'chest'"),
        (":hierarchy", ":nothing", ":hierarchy"),
        ("position 0 0 0", "position 0 0 x", "expected numbers"),
        ("root thorax", "root thorax thorax", "hangs on a bone already"),
        ("begin", "start", "expected 'begin'"),
        ("direction ", "direction nan ", "finite numbers"),
    ],
)
def test_skeletons_of_another_kind_are_refused(
    tmp_path: Path, found: str, instead: str, message: str
) -> None:
    path = written(tmp_path, "odd.asf", SKELETON.replace(found, instead))
    with pytest.raises(AcclaimError, match=message):
        read_skeleton(path)


@pytest.mark.parametrize(
    ("found", "instead", "message"),
    [
        ("lclavicle 8 9", "lclavicle 8", ":7: found 'lclavicle', expected 2 numbers"),
        ("lclavicle 8 9", "tail 8 9", "'tail'"),
        ("lclavicle 8 9", "lclavicle 8 x", ":7: expected numbers"),
        ("lclavicle 8 9", "lclavicle 8 inf", "finite"),
        ("\n2\n", "\n3\n", ":9: expected frame 2"),
        ("\n1\n", "\n", "a frame's number first"),
    ],
)
def test_motions_that_do_not_fit_are_refused(
    tmp_path: Path, skeleton: Bone, found: str, instead: str, message: str
) -> None:
    path = written(tmp_path, "odd.amc", MOTION.replace(found, instead, 1))
    with pytest.raises(AcclaimError, match=message):
        read_motion(path, skeleton)


def test_a_motion_that_was_cut_out_keeps_its_numbers(tmp_path: Path, skeleton: Bone) -> None:
    cut = MOTION.replace("\n2\n", "\n11\n", 1).replace("\n1\n", "\n10\n", 1)
    whole = read_motion(written(tmp_path, "whole.amc", MOTION), skeleton)
    assert read_motion(written(tmp_path, "cut.amc", cut), skeleton) == whole


def test_command(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    skeleton = str(written(tmp_path, "person.asf", SKELETON))
    motion = str(written(tmp_path, "a.amc", MOTION))
    out = tmp_path / "out.bvh"
    assert to_bvh.main([skeleton, motion, str(out)]) == 0
    assert out.read_text().startswith("HIERARCHY\nROOT Hips\n{\n\tOFFSET 0 0 0\n")
    assert to_bvh.main([skeleton, skeleton, str(out)]) == 2
    assert to_bvh.main([skeleton]) == 2
    assert "expected: SKELETON.asf" in capsys.readouterr().err


def test_our_clips_have_a_thorax() -> None:
    for clip in ("01_01", "01_03"):
        text = (REPOSITORY / "assets" / "motion" / f"{clip}.bvh").read_text(encoding="ascii")
        for joint in ("Neck", "LeftShoulder", "RightShoulder"):
            assert f"JOINT {joint}\n\t\t\t\t{{\n\t\t\t\t\tOFFSET 0.04085 2.06391 0.04828" in text
