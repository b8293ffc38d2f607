"""Blender objects made of solids: parts, holes, copies, markers, joining, the file."""

import math

import bpy  # isort: skip  (brings bmesh)
import bmesh
from mathutils import Vector


def start():
    """An empty scene."""
    bpy.ops.wm.read_factory_settings(use_empty=True)


def new():
    """An empty bmesh."""
    return bmesh.new()


def add(
    name,
    bm,
    material,
    parent=None,
    bevel=0.0,
    segments=1,
    smooth_deg=40,
    at=(0, 0, 0),
    is_open=False,
):
    """Makes an object of a bmesh. Bevels are what makes edges catch the light."""
    mesh = bpy.data.meshes.new(name)
    if not is_open:
        bmesh.ops.recalc_face_normals(bm, faces=bm.faces)
    bm.to_mesh(mesh)
    bm.free()
    mesh.materials.append(material)
    part = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(part)
    part.parent = parent
    part.location = at
    if bevel:
        mod = part.modifiers.new("bevel", "BEVEL")
        mod.width, mod.segments = bevel, segments
        mod.limit_method, mod.angle_limit = "ANGLE", math.radians(28)
        mod.use_clamp_overlap = True
    for face in mesh.polygons:
        face.use_smooth = True
    mesh.set_sharp_from_angle(angle=math.radians(smooth_deg))
    return part


def text(name, words, material, parent, at, size, turn):
    """Stencilled characters just above a surface; `turn` are Euler angles in degrees."""
    curve = bpy.data.curves.new(name, "FONT")
    curve.body, curve.size, curve.align_x, curve.align_y = words, size, "CENTER", "CENTER"
    curve.resolution_u = 2
    letters = bpy.data.objects.new(name + "Curve", curve)
    bpy.context.scene.collection.objects.link(letters)
    bpy.context.view_layer.update()
    mesh = bpy.data.meshes.new_from_object(
        letters.evaluated_get(bpy.context.evaluated_depsgraph_get())
    )
    bpy.data.objects.remove(letters)
    mesh.materials.clear()
    mesh.materials.append(material)
    part = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(part)
    part.parent, part.location = parent, at
    part.rotation_euler = [math.radians(a) for a in turn]
    return part


def cut(part, bm):
    """Takes a solid out of a part, before its bevels."""
    tool = add("Cutter", bm, part.data.materials[0], part.parent, at=part.location)
    mod = part.modifiers.new("hole", "BOOLEAN")
    mod.operation, mod.solver, mod.object = "DIFFERENCE", "EXACT", tool
    bpy.context.view_layer.objects.active = part
    part.modifiers.move(len(part.modifiers) - 1, 0)
    bpy.ops.object.modifier_apply(modifier=mod.name)
    bpy.data.objects.remove(tool)
    part.data.set_sharp_from_angle(angle=math.radians(40))


def marker(name, parent, at):
    """An empty node: a place that others ask for."""
    spot = bpy.data.objects.new(name, None)
    bpy.context.scene.collection.objects.link(spot)
    spot.parent, spot.location = parent, at
    return spot


def copy(source, name, parent, at, turn_z_deg=0.0):
    """Another node that gets the source's mesh once that is whole: see share_copies()."""
    part = bpy.data.objects.new(name, None)
    part["copy_of"] = source.name
    bpy.context.scene.collection.objects.link(part)
    part.parent, part.location = parent, at
    part.rotation_euler[2] = math.radians(turn_z_deg)
    return part


def apply_modifiers():
    """Makes bevels and the like part of the meshes."""
    for part in list(bpy.context.scene.objects):
        if part.type != "MESH":
            continue
        bpy.context.view_layer.objects.active = part
        for mod in list(part.modifiers):
            bpy.ops.object.modifier_apply(modifier=mod.name)


def share_copies():
    """To be called before join(): empties that are copies become nodes with their source's mesh."""
    for part in list(bpy.context.scene.objects):
        if "copy_of" not in part:
            continue
        source = bpy.data.objects[part["copy_of"]]
        made = bpy.data.objects.new(part.name + "Copy", source.data)
        bpy.context.scene.collection.objects.link(made)
        made.parent, made.location = part.parent, part.location
        made.rotation_euler = part.rotation_euler
        name = part.name
        bpy.data.objects.remove(part)
        made.name = name


def join(own):
    """Joins what does not move by itself (its name is not in `own`) to the part that carries it."""
    for name in own:
        target = bpy.data.objects[name]
        if target.type != "MESH":
            continue
        still = [p for p in _below(target, own) if p.type == "MESH"]
        bpy.ops.object.select_all(action="DESELECT")
        for part in [*still, target]:
            part.select_set(True)
        bpy.context.view_layer.objects.active = target
        if still:
            bpy.ops.object.join()


def _below(part, own):
    found = []
    for child in part.children:
        if child.name not in own:
            found += [child, *_below(child, own)]
    return found


def triangles(meshes):
    """How many there are in meshes."""
    total = 0
    for mesh in meshes:
        mesh.calc_loop_triangles()
        total += len(mesh.loop_triangles)
    return total


def export(path):
    """Writes the file and says what is in it."""
    bpy.ops.export_scene.gltf(
        filepath=str(path), export_apply=True, export_image_format="NONE", export_materials="EXPORT"
    )
    meshes = {
        part.data.name: part.data for part in bpy.context.scene.objects if part.type == "MESH"
    }
    for name, mesh in sorted(meshes.items()):
        print(f"  {name}: {triangles([mesh])} triangles")
    print(f"{path}: {triangles(meshes.values())} triangles in {len(meshes)} meshes")


def vector(*numbers):
    """A vector of three numbers."""
    return Vector(numbers)
