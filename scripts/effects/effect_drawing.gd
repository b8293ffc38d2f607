@tool
class_name EffectDrawing
extends RefCounted
## How the particles of an effect's file are drawn: mesh and material by its [EffectSettings].
##
## Files that are drawn alike share a shader, as compiling one takes long: up to 100 ms.

const FOLDER: String = "res://assets/effects/textures/"
## Pictures in a texture, across and down.
const GRIDS: Dictionary[String, Vector2i] = {
	"puff": Vector2i(8, 8), "flash": Vector2i(2, 2), "chunks": Vector2i(2, 2)
}
const _PUFF: String = "puff"
const _HEAD: String = (
	"shader_type spatial;\nrender_mode unshaded, blend_premul_alpha, depth_draw_never, "
	+ "cull_disabled, shadows_disabled, fog_disabled;\n"
)
const _INCLUDE: String = '#include "res://assets/shaders/effect.gdshaderinc"\n'
## Corners of a triangle that holds the circle of diameter 1 which a round picture fills.
const _TRIANGLE: Array[Vector2] = [
	Vector2(0.0, 1.0), Vector2(0.8660254, -0.5), Vector2(-0.8660254, -0.5)
]
const _QUAD: Array[Vector2] = [
	Vector2(-0.5, 0.5), Vector2(0.5, 0.5), Vector2(0.5, -0.5), Vector2(-0.5, -0.5)
]

static var _shaders: Dictionary[String, Shader] = {}
static var _meshes: Dictionary[String, ArrayMesh] = {}


## A material of its own for a file with these settings.
static func make_material(p_settings: EffectSettings) -> ShaderMaterial:
	var material: ShaderMaterial = ShaderMaterial.new()
	material.shader = shader_of(p_settings)
	if p_settings.texture == _PUFF:
		material.set_shader_parameter(&"picture", texture("puff_a"))
		material.set_shader_parameter(&"picture_behind", texture("puff_b"))
	else:
		material.set_shader_parameter(&"picture", texture(p_settings.texture))
	material.set_shader_parameter(&"grid", GRIDS.get(p_settings.texture, Vector2i.ONE))
	material.set_shader_parameter(&"soft_m", maxf(p_settings.soft, 0.001))
	material.set_shader_parameter(&"fade_m", Vector2(p_settings.fade[0], p_settings.fade[1]))
	material.set_shader_parameter(&"glow", p_settings.glow)
	return material


## The shader that draws files with these settings.
static func shader_of(p_settings: EffectSettings) -> Shader:
	var code: String = code_of(p_settings)
	if not _shaders.has(code):
		var shader: Shader = Shader.new()
		shader.code = code
		_shaders[code] = shader
	return _shaders[code]


## The code of that shader.
static func code_of(p_settings: EffectSettings) -> String:
	var defines: PackedStringArray = ["BLEND_%s" % p_settings.blend.to_upper()]
	if p_settings.texture == _PUFF:
		defines.append("PUFF")
	if p_settings.light == "sun":
		defines.append("LIT")
	elif p_settings.texture != _PUFF and p_settings.blend != "fire":
		defines.append("SIMPLE")
	if not GRIDS.has(p_settings.texture):
		defines.append("ONE_PICTURE")
	if p_settings.soft > 0.0:
		defines.append("SOFT")
	if p_settings.topology == "triangle":
		defines.append("TRIANGLE")
	match p_settings.facing:
		"viewer":
			defines.append("FACES_VIEWER")
		"velocity":
			defines.append("ALONG_VELOCITY")
	var code: String = _HEAD
	for define: String in defines:
		code += "#define %s\n" % define
	return code + _INCLUDE


## The mesh of a particle: "quad" or "triangle", 1 m large.
static func mesh(p_topology: String) -> ArrayMesh:
	if not _meshes.has(p_topology):
		_meshes[p_topology] = _make_mesh(_TRIANGLE if p_topology == "triangle" else _QUAD)
	return _meshes[p_topology]


## A picture by its name.
static func texture(p_name: String) -> Texture2D:
	return load("%s%s.png" % [FOLDER, p_name]) as Texture2D


## Lets go what is shared; what is shown keeps it. For the end of a program and for tests.
static func forget() -> void:
	_shaders.clear()
	_meshes.clear()


static func _make_mesh(p_corners: Array[Vector2]) -> ArrayMesh:
	var places: PackedVector3Array = []
	var uvs: PackedVector2Array = []
	var indices: PackedInt32Array = []
	for corner: Vector2 in p_corners:
		places.append(Vector3(corner.x, corner.y, 0.0))
		uvs.append(Vector2(corner.x + 0.5, 0.5 - corner.y))
	for index: int in range(2, p_corners.size()):
		indices.append_array([0, index - 1, index])
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = places
	arrays[Mesh.ARRAY_TEX_UV] = uvs
	arrays[Mesh.ARRAY_INDEX] = indices
	var made: ArrayMesh = ArrayMesh.new()
	made.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return made
