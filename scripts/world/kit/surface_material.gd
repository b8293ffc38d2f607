class_name SurfaceMaterial
extends RefCounted
## The one material of everything that levels are built of.

const SHADER: String = "res://assets/shaders/surface.gdshader"

static var _shared: ShaderMaterial = null


## The material, the same for all.
static func shared() -> ShaderMaterial:
	if _shared == null:
		_shared = ShaderMaterial.new()
		_shared.shader = load(SHADER)
		_shared.set_shader_parameter("albedo_layers", load(SurfaceLayers.ALBEDO))
		_shared.set_shader_parameter("normal_layers", load(SurfaceLayers.NORMAL))
		_shared.set_shader_parameter("orm_layers", load(SurfaceLayers.ORM))
		_shared.set_shader_parameter("tints", SurfaceTints.srgb())
		_shared.set_shader_parameter("dust_layer", float(SurfaceLayers.Layer.SAND))
		_shared.set_shader_parameter("dust_edge_m", SurfaceLayers.EDGE_M[SurfaceLayers.Layer.SAND])
	return _shared


## A mesh with the material, of blocks and the light of their vertices; without light, with light
## as in the open.
static func make_mesh(p_blocks: BlockMesh, p_light: PackedByteArray = []) -> ArrayMesh:
	var mesh: ArrayMesh = ArrayMesh.new()
	# Compatibility reads one component only of a custom array of bytes, and all bits of one of floats.
	var arrays: Array = p_blocks.make_arrays(p_light)
	var format: int = 0
	for custom: int in 4:
		var index: int = Mesh.ARRAY_CUSTOM0 + custom
		var bytes: PackedByteArray = arrays[index]
		arrays[index] = bytes.to_float32_array()
		var shift: int = Mesh.ARRAY_FORMAT_CUSTOM_BASE + Mesh.ARRAY_FORMAT_CUSTOM_BITS * custom
		format |= Mesh.ARRAY_CUSTOM_R_FLOAT << shift
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [], {}, format)
	mesh.surface_set_material(0, shared())
	return mesh
