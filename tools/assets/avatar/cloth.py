"""Folds in the uniform: Blender's cloth simulation, or a quick procedural stand-in."""

import numpy as np
from numpy.typing import NDArray

from .blender import bpy
from .noise import NoiseField
from .quad_mesh import QuadMesh
from .rig import SIDES, Rig

Array = NDArray[np.float64]

_FRAMES = 40
"""Simulated frames; the cloth has come to rest by then."""
_SHRINK = -0.09
"""Negative shrink: the cloth is 9 % larger than its shape and has to fold somewhere."""

_TORSO_BONES = ("Hips", "Spine", "Chest", "UpperChest", "Neck")

# Joint, reach of the folds in metres, their depth in metres.
_JOINT_FOLDS = (
    ("LowerArm", 0.11, 0.006),
    ("LowerLeg", 0.13, 0.008),
    ("UpperLeg", 0.16, 0.006),
    ("UpperArm", 0.12, 0.005),
)


def simulate(uniform: QuadMesh, body_form: QuadMesh, rig: Rig) -> None:
    """Let the uniform fall onto the body in Blender; moves its vertices."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    body = _blender_object("body", body_form)
    body.modifiers.new("collision", "COLLISION")
    body.collision.thickness_outer = 0.003
    body.collision.thickness_inner = 0.02
    body.collision.cloth_friction = 12

    cloth = _blender_object("cloth", uniform)
    pins = cloth.vertex_groups.new(name="pin")
    for vertex in np.nonzero(_pinned(uniform, rig))[0]:
        pins.add([int(vertex)], 1.0, "REPLACE")
    _add_cloth_modifier(cloth, pins.name)

    scene = bpy.context.scene
    scene.frame_start = 1
    scene.frame_end = _FRAMES
    for frame in range(1, _FRAMES + 1):
        scene.frame_set(frame)
    evaluated = cloth.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    draped = np.array([vertex.co[:] for vertex in evaluated.vertices])
    uniform.vertices = np.stack([draped[:, 0], draped[:, 2], -draped[:, 1]], 1)


def _blender_object(name: str, mesh: QuadMesh) -> bpy.types.Object:
    """Put a mesh into the scene; Blender's Z is up, ours is Y."""
    data = bpy.data.meshes.new(name)
    vertices = [(p[0], -p[2], p[1]) for p in mesh.vertices]
    data.from_pydata(vertices, [], [tuple(dict.fromkeys(face)) for face in mesh.faces.tolist()])
    thing = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(thing)
    return thing


def _add_cloth_modifier(cloth: bpy.types.Object, pin_group: str) -> None:
    """Set the cloth up as a light, soft weave. Blender's own units."""
    modifier = cloth.modifiers.new("cloth", "CLOTH")
    settings = modifier.settings
    settings.quality = 6
    settings.mass = 0.25
    settings.tension_stiffness = 20
    settings.compression_stiffness = 20
    settings.shear_stiffness = 8
    settings.bending_stiffness = 0.05
    settings.air_damping = 2
    settings.vertex_group_mass = pin_group
    settings.shrink_min = _SHRINK
    settings.shrink_max = _SHRINK
    settings.pin_stiffness = 5
    collision = modifier.collision_settings
    collision.distance_min = 0.004
    collision.collision_quality = 3
    collision.use_self_collision = False
    modifier.point_cache.frame_end = 60


def _pinned(uniform: QuadMesh, rig: Rig) -> NDArray[np.bool_]:
    """Choose the vertices that stay: cuffs, trouser ends, waist and collar."""
    points = uniform.vertices
    bones = rig.dominant(uniform.weights)
    on_leg = np.array(["LowerLeg" in bone or "Foot" in bone for bone in bones])
    on_arm = np.array(["LowerArm" in bone or bone.endswith("Hand") for bone in bones])
    on_torso = np.array(
        [bone in _TORSO_BONES or "UpperLeg" in bone or "Shoulder" in bone for bone in bones]
    )
    cuff = on_arm & (rig.along_forearm(points) > 0.93)
    trouser_end = on_leg & (rig.along_shin(points) > 0.755)
    waist = on_torso & (abs(points[:, 1] - rig.heads["Spine"][1]) < 0.025)
    collar = points[:, 1] > rig.heads["Neck"][1] + 0.02
    return cuff | trouser_end | waist | collar


def fold_procedurally(uniform: QuadMesh, rig: Rig, noise: NoiseField) -> None:
    """Press rings of folds into the cloth around the joints: no physics, but fast."""
    points, normals = uniform.vertices, uniform.normals()
    height = np.zeros(len(points))
    for side in SIDES:
        for joint, reach, depth in _JOINT_FOLDS:
            head = rig.heads[side + joint]
            axis = head - rig.heads[rig.parents[side + joint]]
            axis = axis / np.linalg.norm(axis)
            distance = np.linalg.norm(points - head, axis=1)
            phase = (points - head) @ axis / 0.042 + 2.2 * noise.layered(points * 9 + 3, 2)
            ridges = 1 - np.abs(np.sin(np.pi * phase)) * 1.4
            height += depth * np.exp(-((distance / reach) ** 2)) * ridges
    height += 0.006 * (noise.layered(points * 14, 3) - 0.5)
    uniform.vertices = points + normals * height[:, None]
