"""Tests of tools/assets/avatar: what needs no Blender, and numpy only where marked."""

import json
import math
import random
import sys
from itertools import combinations
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tools" / "assets"))

from avatar import limb_shapes, shapes
from avatar import vector3 as v3
from avatar.glb_reader import read_skinned_model
from avatar.shapes import Box, Pill, WeightedPoint

AVATAR = REPOSITORY / "assets" / "avatar"
UPRIGHT = (0.0, 0.0, 0.0, 1.0)
SIDE_LIMBS = ("UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot")
LIMBS = {"Hips", "Spine", "Chest", "Head"} | {s + k for s in ("Left", "Right") for k in SIDE_LIMBS}


@pytest.fixture(scope="module")
def geoms() -> dict[str, dict]:
    """The limb descriptions in the repository, by bone."""
    tree = json.loads((AVATAR / "shapes" / "soldier.json").read_text())
    return {geom["bone"]: geom for geom in tree["geoms"]}


@pytest.fixture(scope="module")
def model() -> limb_shapes.SkinnedModel:
    """The avatar's skeleton and surface."""
    return read_skinned_model(AVATAR / "soldier.glb")


def rotation_matrix(q: list[float]) -> list[list[float]]:
    """Turn a quaternion x, y, z, w into a matrix (a second way, not vector3's)."""
    x, y, z, w = q
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]


def contains(geom: dict, point: list[float]) -> bool:
    """Tell whether a point (metres) lies inside a described limb."""
    m = rotation_matrix(geom["orientation"])
    offset = [point[i] - geom["position"][i] for i in range(3)]
    local = [sum(m[row][column] * offset[row] for row in range(3)) for column in range(3)]
    if geom["type"] == "box":
        return all(abs(local[i]) < geom["size"][i] / 2 for i in range(3))
    beyond = max(abs(local[1]) - geom["length"] / 2, 0.0)
    return math.hypot(local[0], beyond, local[2]) < geom["radius"]


def surface_points(geom: dict, count: int) -> list[list[float]]:
    """Scatter points over the surface of a described limb."""
    generator = random.Random(geom["bone"])
    m = rotation_matrix(geom["orientation"])
    points = []
    for _ in range(count):
        if geom["type"] == "box":
            local = [generator.uniform(-s / 2, s / 2) for s in geom["size"]]
            axis = generator.randrange(3)
            local[axis] = math.copysign(geom["size"][axis] / 2, local[axis])
        else:
            direction = [generator.gauss(0, 1) for _ in range(3)]
            norm = math.hypot(*direction)
            local = [geom["radius"] * d / norm for d in direction]
            local[1] += generator.choice((-1, 1)) * generator.random() * geom["length"] / 2
        points.append(
            [geom["position"][i] + sum(m[i][j] * local[j] for j in range(3)) for i in range(3)]
        )
    return points


def connected(a: dict, b: dict) -> bool:
    return a["parent_bone"] == b["bone"] or b["parent_bone"] == a["bone"]


def test_description_names_the_sixteen_limbs(geoms: dict[str, dict]) -> None:
    assert set(geoms) == LIMBS
    tree = json.loads((AVATAR / "shapes" / "soldier.json").read_text())
    assert set(tree) == {"frame", "units", "source", "geoms"}
    assert "de Leva" in tree["source"]
    assert [g["bone"] for g in tree["geoms"] if g["parent_bone"] is None] == ["Hips"]
    for geom in tree["geoms"]:
        expected = {"radius", "length"} if geom["type"] == "pill" else {"size"}
        assert expected <= set(geom)


def test_parents_come_first_and_masses_sum_to_one(geoms: dict[str, dict]) -> None:
    seen: set[str | None] = {None}
    for bone, geom in geoms.items():
        assert geom["parent_bone"] in seen
        seen.add(bone)
    assert sum(g["mass_fraction"] for g in geoms.values()) == pytest.approx(1.0, abs=1e-9)


def test_orientations_are_unit_quaternions(geoms: dict[str, dict]) -> None:
    for geom in geoms.values():
        assert math.hypot(*geom["orientation"]) == pytest.approx(1.0, abs=1e-6)


def test_both_sides_mirror_each_other(geoms: dict[str, dict]) -> None:
    for kind in SIDE_LIMBS:
        left, right = geoms["Left" + kind], geoms["Right" + kind]
        x, y, z = left["position"]
        assert right["position"] == pytest.approx([-x, y, z])
        assert left["position"][0] > 0, "the character's left is +X"
        for key in ("radius", "length", "size", "mass_fraction"):
            assert left.get(key) == right.get(key)


def test_unconnected_limbs_do_not_overlap(geoms: dict[str, dict]) -> None:
    points = {bone: surface_points(geom, 400) for bone, geom in geoms.items()}
    for a, b in combinations(geoms.values(), 2):
        if not connected(a, b):
            assert not any(contains(b, p) for p in points[a["bone"]]), (a["bone"], b["bone"])
            assert not any(contains(a, p) for p in points[b["bone"]]), (a["bone"], b["bone"])


def test_anchors_are_the_joints_and_feet_stand_on_the_soles(
    geoms: dict[str, dict], model: limb_shapes.SkinnedModel
) -> None:
    for bone, geom in geoms.items():
        assert geom["anchor"] == pytest.approx(model.bones[bone].head, abs=1e-4)
    sole = min(vertex.position[1] for vertex in model.vertices)
    for side in ("Left", "Right"):
        foot = geoms[side + "Foot"]
        up = rotation_matrix(foot["orientation"])[1][1]
        assert up == pytest.approx(1.0, abs=1e-6), "the foot's box is level"
        assert foot["position"][1] - foot["size"][1] / 2 == pytest.approx(sole, abs=1e-4)
    assert sole == pytest.approx(0.0, abs=0.02)


def test_pills_run_along_their_bones(
    geoms: dict[str, dict], model: limb_shapes.SkinnedModel
) -> None:
    for bone, child in (("UpperArm", "LowerArm"), ("LowerLeg", "Foot"), ("UpperLeg", "LowerLeg")):
        geom = geoms["Left" + bone]
        head, tail = model.bones["Left" + bone].head, model.bones["Left" + child].head
        axis = [row[1] for row in rotation_matrix(geom["orientation"])]
        direction = v3.subtract(tail, head)
        assert v3.dot(tuple(axis), direction) == pytest.approx(v3.length(direction), rel=1e-3)


def test_repository_description_is_up_to_date(model: limb_shapes.SkinnedModel) -> None:
    fitted = limb_shapes.fit_limb_shapes(model)
    limb_shapes.shrink_until_apart(fitted)
    tree = limb_shapes.describe(model, limb_shapes.both_sides(fitted))
    assert tree == json.loads((AVATAR / "shapes" / "soldier.json").read_text())


def test_avatar_has_the_humanoid_skeleton(model: limb_shapes.SkinnedModel) -> None:
    assert len(model.bones) == 53
    assert {"Hips", "UpperChest", "Head", "LeftToes", "RightThumbMetacarpal"} <= set(model.bones)
    for vertex in model.vertices[::50]:
        assert sum(vertex.weights.values()) == pytest.approx(1.0, abs=1e-4)
        assert len(vertex.weights) <= 4


def test_fit_pill_recovers_a_cylinder() -> None:
    turn = v3.normalized((0.3, -0.2, 0.5, 0.7))
    origin = (0.4, 1.2, -0.1)
    points = []
    for i in range(81):
        for j in range(40):
            angle = math.tau * j / 40
            local = (0.02 + 0.06 * math.cos(angle), 0.005 * i, -0.01 + 0.06 * math.sin(angle))
            points.append(WeightedPoint(v3.add(origin, v3.rotate(turn, local)), 1.0))
    pill = shapes.fit_pill(points, origin, turn)
    assert pill.radius == pytest.approx(0.06, abs=0.002)
    assert pill.length + 2 * pill.radius == pytest.approx(0.4, abs=0.01)
    centre = v3.rotate(v3.conjugate(turn), v3.subtract(pill.position, origin))
    assert centre == pytest.approx((0.02, 0.2, -0.01), abs=0.003)


def test_fit_box_recovers_a_box() -> None:
    generator = random.Random(1)
    points = [
        WeightedPoint(tuple(generator.uniform(-h, h) for h in (0.1, 0.2, 0.3)), 1.0)
        for _ in range(4000)
    ]
    box = shapes.fit_box(points, (0.0, 0.0, 0.0), UPRIGHT, (0.0, 0.0, 0.0))
    assert box.size == pytest.approx((0.2, 0.4, 0.6), abs=0.005)
    assert box.position == pytest.approx((0, 0, 0), abs=0.005)


def test_percentile_weighs_by_area() -> None:
    assert shapes.weighted_percentile([3.0, 1.0, 2.0], [8.0, 1.0, 1.0], 0.5) == 3.0
    assert shapes.weighted_percentile([3.0, 1.0, 2.0], [1.0, 8.0, 1.0], 0.5) == 1.0


def test_separation_of_simple_pairs() -> None:
    quarter = v3.normalized((0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5)))
    upright = Pill((0.0, 0.0, 0.0), UPRIGHT, 0.1, 1.0)
    lying = Pill((0.0, 1.0, 0.0), quarter, 0.1, 1.0)
    assert shapes.separation(upright, lying) == pytest.approx(0.3)
    assert shapes.separation(upright, Pill((0.15, 0.2, 0.0), UPRIGHT, 0.1, 1.0)) < 0
    box = Box((0.5, 0.0, 0.0), UPRIGHT, (0.2, 0.2, 0.2))
    assert shapes.separation(upright, box) == pytest.approx(0.3)
    assert shapes.separation(box, upright) == pytest.approx(0.3)
    other = Box((0.0, 0.05, 0.0), UPRIGHT, (0.2, 0.2, 0.2))
    assert shapes.separation(box, other) == pytest.approx(0.3)
    diagonal = Box((0.5, 0.0, 0.24), v3.yaw(math.pi / 4), (0.2, 0.2, 0.2))
    assert shapes.separation(box, diagonal) == pytest.approx(0.14 - 0.1 * math.sqrt(2), abs=1e-9)


def test_shrinking_parts_thighs_that_touch() -> None:
    limbs = {
        "Hips": Box((0.0, 1.0, 0.0), UPRIGHT, (0.3, 0.1, 0.2)),
        "UpperLeg": Pill((0.09, 0.7, 0.0), UPRIGHT, 0.1, 0.3),
    }
    assert limb_shapes.shrink_until_apart(limbs) == ["UpperLeg"]
    assert limbs["UpperLeg"].radius < 0.09
    assert not limb_shapes.overlapping_pairs(limb_shapes.both_sides(limbs))


def test_every_bone_has_a_limb(model: limb_shapes.SkinnedModel) -> None:
    assert {limb_shapes.limb_of_bone(bone) for bone in model.bones} == LIMBS
    assert limb_shapes.limb_of_bone("LeftRingDistal") == "LeftHand"
    assert limb_shapes.limb_of_bone("RightToes") == "RightFoot"
    assert limb_shapes.parent_limb("LeftFoot") == "LeftLowerLeg"


def test_newton_meets_measures_of_a_nearly_linear_body() -> None:
    numpy = pytest.importorskip("numpy")
    fit = pytest.importorskip("avatar.fit")

    def measure(p):
        lengths = numpy.array([1.8, 0.28, 0.26])
        return p[0] * (lengths + numpy.array([0.0, 0.02 * p[1], 0.015 * p[2] + 0.002 * p[1] ** 2]))

    goal = numpy.array([1.65, 0.27, 0.225])
    solution = fit.solve_newton(measure, numpy.array([1.0, 0.0, 0.0]), goal)
    assert measure(solution) == pytest.approx(goal, abs=5e-4)
    with pytest.raises(ValueError, match="cannot be met"):
        fit.solve_newton(lambda p: numpy.zeros(1) * p[0], numpy.zeros(1), numpy.ones(1))


def test_blend_of_three_anchors_sums_to_one() -> None:
    pytest.importorskip("numpy")
    from avatar.makehuman import blend_three

    for value in (0.0, 0.25, 0.5, 0.68, 1.0):
        shares = blend_three(value, ("low", "middle", "high"))
        assert sum(shares.values()) == pytest.approx(1.0)
    assert blend_three(0.25, ("low", "middle", "high")) == {"low": 0.5, "middle": 0.5}


def test_subdivision_keeps_a_cube_closed_and_splits_its_quads() -> None:
    numpy = pytest.importorskip("numpy")
    from avatar.quad_mesh import QuadMesh, subdivide, unique_edges

    corners = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    cube = QuadMesh(corners, numpy.ones((8, 1)), faces)
    assert ((cube.vertices - 0.5) * cube.normals()).sum(1).min() > 0, "normals point outwards"
    finer = subdivide(cube)
    assert len(finer.faces) == 24
    assert len(finer.vertices) == 26
    assert set(unique_edges(finer.faces)[2]) == {2}
    assert finer.weights == pytest.approx(numpy.ones((26, 1)))


def test_mixamo_names_map_to_distinct_humanoid_bones() -> None:
    pytest.importorskip("numpy")
    from avatar.rig import mixamo_to_godot

    names = mixamo_to_godot()
    assert len(names) == len(set(names.values())) == 52
    humanoid = json.loads((REPOSITORY / "tools/assets/avatar/humanoid_rest.json").read_text())
    assert set(names.values()) <= set(humanoid)
