"""What a stranger sees of the soldier at first sight, measured on the file. Metres."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tools" / "assets"))

from avatar import vector3 as v3
from avatar.glb_reader import SkinnedModel, SkinVertex, read_skinned_model, read_surfaces

AVATAR = REPOSITORY / "assets" / "avatar" / "soldier.glb"
SECTORS = 16
LIMBS = [s + b for s in ("Left", "Right") for b in ("LowerLeg", "LowerArm")]


@pytest.fixture(scope="module")
def surfaces() -> dict[str, list[SkinVertex]]:
    return read_surfaces(AVATAR)


@pytest.fixture(scope="module")
def model() -> SkinnedModel:
    return read_skinned_model(AVATAR)


def share(vertex: SkinVertex, *bones: str) -> float:
    return sum(vertex.weights.get(bone, 0.0) for bone in bones)


def test_the_chin_strap_lies_before_the_chin(surfaces: dict[str, list[SkinVertex]]) -> None:
    eyes = [vertex.position[1] for vertex in surfaces["HeadMesh soldier_eyes"]]
    below = sum(eyes) / len(eyes) - 0.095
    face = [
        v.position[2]
        for v in surfaces["HeadMesh soldier_skin"]
        if below - 0.03 < v.position[1] < below
    ]
    strap = [
        vertex.position[2]
        for vertex in surfaces["HeadMesh parts"]
        if share(vertex, "Head") > 0.99 and vertex.position[1] < below
        if abs(vertex.position[0]) < 0.01
    ]
    assert strap, "nothing passes the middle of the chin"
    assert 0.0 < max(strap) - max(face) < 0.015


@pytest.mark.parametrize("bone", LIMBS)
def test_sleeves_and_trousers_end_in_a_straight_hem(
    bone: str, surfaces: dict[str, list[SkinVertex]], model: SkinnedModel
) -> None:
    side = bone.removesuffix("LowerLeg").removesuffix("LowerArm")
    ends = [side + "Foot", side + "Toes"] if bone.endswith("Leg") else [side + "Hand"]
    head = model.bones[bone].head
    along = v3.subtract(model.bones[ends[0]].head, head)
    along = v3.scale(along, 1 / v3.length(along))
    right = v3.cross(along, (0.0, 0.0, 1.0))
    right = v3.scale(right, 1 / v3.length(right))
    front = v3.cross(right, along)
    farthest = [0.0] * SECTORS
    for vertex in surfaces["BodyMesh soldier_cloth"]:
        if share(vertex, bone, *ends) < 0.5:
            continue
        out = v3.subtract(vertex.position, head)
        turn = math.atan2(v3.dot(out, right), v3.dot(out, front)) / math.tau % 1
        sector = int(turn * SECTORS) % SECTORS
        farthest[sector] = max(farthest[sector], v3.dot(out, along))
    assert max(farthest) - min(farthest) < 0.006


@pytest.mark.parametrize("side", ["Left", "Right"])
def test_boots_stand_on_heel_and_ball(side: str, surfaces: dict[str, list[SkinVertex]]) -> None:
    low = [
        (vertex.position[2], vertex.position[1])
        for vertex in surfaces["BodyMesh parts"]
        if share(vertex, side + "Foot", side + "Toes") > 0.99 and vertex.position[1] < 0.01
    ]
    back, front = min(z for z, _ in low), max(z for z, _ in low)

    def lowest(first: float, last: float) -> float:
        """Height of the sole between two shares of its length, from the heel."""
        between = [y for z, y in low if first <= (z - back) / (front - back) <= last]
        return min(between)

    ground = min(y for _, y in low)
    assert lowest(0.08, 0.25) == pytest.approx(ground, abs=0.001), "heel"
    assert lowest(0.5, 0.8) == pytest.approx(ground, abs=0.001), "ball"
    assert lowest(0.31, 0.39) > ground + 0.006, "no arch"
    assert lowest(0.975, 1.0) > ground + 0.002, "no toe spring"
