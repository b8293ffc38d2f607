class_name LevelSurfaces
extends Node3D
## Shows the blocks of a level: one mesh for each part, with its baked light. Their shadows are
## thrown by few large meshes: each split of the sun's shadow draws what throws it once more, and
## what cannot be seen may still throw one that can.

## The parts, in the order of the bake.
var parts: Array[SurfacePart] = []
## The mesh of each part.
var shown: Array[MeshInstance3D] = []
## The meshes that throw the shadows.
var shadows: Array[MeshInstance3D] = []
## Which of them are needed.
var reach: ShadowReach = ShadowReach.new()
## What was baked, or null where nothing that fits was.
var bake: LevelBake = null
## Light in the air.
var air: LevelAir = null


## Makes the meshes of the blocks below a level's root, which need not be in the tree: a thread may
## do it. A bake that does not fit is not used.
func assemble(p_level: Node3D, p_bake: LevelBake) -> void:
	parts = SurfacePart.gather(p_level)
	bake = p_bake if p_bake != null and p_bake.error == "" and p_bake.fits(parts) else null
	for index: int in parts.size():
		var instance: MeshInstance3D = MeshInstance3D.new()
		var light: PackedByteArray = bake.light_of(index) if bake != null else PackedByteArray()
		instance.mesh = SurfaceMaterial.make_mesh(parts[index].mesh, light)
		instance.name = "Part%d" % index
		instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		add_child(instance)
		shown.append(instance)
	_add_shadows()
	air = LevelAir.new()
	air.bake = bake
	add_child(air)


func _add_shadows() -> void:
	for part: SurfacePart in parts:
		reach.add_part(part.mesh, part.key.ends_with("/" + House.INSIDE))
	reach.gather()
	for number: int in reach.get_caster_count():
		var arrays: Array = []
		arrays.resize(Mesh.ARRAY_MAX)
		arrays[Mesh.ARRAY_VERTEX] = reach.get_caster(number)
		var mesh: ArrayMesh = ArrayMesh.new()
		mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
		var instance: MeshInstance3D = MeshInstance3D.new()
		instance.name = "Shadow%d" % number
		instance.mesh = mesh
		instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_SHADOWS_ONLY
		add_child(instance)
		shadows.append(instance)
