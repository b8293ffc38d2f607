class_name PropMesh
extends RefCounted
## Meshes of things that move, of the same faces and layers as blocks: their light comes from the
## grid of light of the place where they are (prop.gdshader), not from their vertices.

const MATERIAL: String = "res://assets/world/materials/prop.tres"


## A mesh of blocks. [param p_open] is the share of open sky that each vertex sees, 0 to 1, in the
## order of the vertices; empty: all of it.
static func make(p_blocks: BlockMesh, p_open: PackedFloat32Array = []) -> ArrayMesh:
	var arrays: Array = p_blocks.make_arrays()
	for custom: int in 4:
		arrays[Mesh.ARRAY_CUSTOM0 + custom] = null
	var colours: PackedColorArray = []
	colours.resize(p_blocks.get_vertex_count())
	colours.fill(Color.WHITE)
	for index: int in p_open.size():
		colours[index] = Color(p_open[index], p_open[index], p_open[index])
	arrays[Mesh.ARRAY_COLOR] = colours
	var mesh: ArrayMesh = ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	mesh.surface_set_material(0, load(MATERIAL))
	return mesh
