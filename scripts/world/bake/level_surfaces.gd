class_name LevelSurfaces
extends Node3D
## Shows the blocks of a level: one mesh for each part, with its baked light.

## The parts, in the order of the bake.
var parts: Array[SurfacePart] = []
## The mesh of each part.
var shown: Array[MeshInstance3D] = []
## What was baked, or null where nothing that fits was.
var bake: LevelBake = null
## Light in the air.
var air: LevelAir = null
## What hides parts that cannot be seen; null where nothing was baked of that.
var visibility: LevelVisibility = null


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
		add_child(instance)
		shown.append(instance)
	air = LevelAir.new()
	air.bake = bake
	add_child(air)
	if bake != null and not bake.seen_parts.is_empty():
		visibility = LevelVisibility.new()
		visibility.surfaces = self
		add_child(visibility)
