@tool
class_name WeatherView
extends Node3D
## Rain and flying dust around the camera: one mesh each, moved by its shader, so that it costs one
## draw and looks alike in all renderers.

## Streaks of rain, and pieces of flying dust.
const DROPS: int = 2400
const PIECES: int = 1400

## Shader of the rain, and of flying dust.
@export var rain_shader: Shader = null
@export var dust_shader: Shader = null
## Picture that swaths of dust are made from.
@export var clouds: Texture2D = null

var _rain: MeshInstance3D = null
var _dust: MeshInstance3D = null
var _roofs: RoofProbe = RoofProbe.new()


func _ready() -> void:
	_rain = _make(DROPS, rain_shader, Vector2(-1.0, 0.0))
	_dust = _make(PIECES, dust_shader, Vector2(-1.0, -1.0))
	for shown: MeshInstance3D in [_rain, _dust]:
		_material(shown).set_shader_parameter(&"roofs", _roofs.texture)
		_material(shown).set_shader_parameter(&"roofs_edge_m", RoofProbe.EDGE_M)
	_material(_dust).set_shader_parameter(&"clouds", clouds)


func _physics_process(_p_delta: float) -> void:
	var camera: Camera3D = get_viewport().get_camera_3d()
	if (_rain.visible or _dust.visible) and camera != null:
		_roofs.advance(get_world_3d().direct_space_state, camera.global_position)


## Shows what falls and flies in a state of the sky.
func show_state(p_state: SkyState) -> void:
	_rain.visible = p_state.rain > 0.01
	_dust.visible = p_state.dust > 0.01
	set_physics_process(_rain.visible or _dust.visible)
	var air: Color = p_state.horizon
	_set_look(_rain, p_state.rain, air.lerp(Color(0.5, 0.55, 0.6), 0.08) * 1.15, 0.30)
	_set_look(_dust, p_state.dust, air * 1.04, 0.34)


func _set_look(p_mesh: MeshInstance3D, p_amount: float, p_color: Color, p_alpha: float) -> void:
	_material(p_mesh).set_shader_parameter(&"amount", p_amount * Quality.tier.weather)
	var color: Color = WorldSky.shown(p_color)
	color.a = p_alpha
	_material(p_mesh).set_shader_parameter(&"colour", color)


static func _material(p_mesh: MeshInstance3D) -> ShaderMaterial:
	return p_mesh.material_override as ShaderMaterial


## Quads that know random numbers; the shader places them.
func _make(p_count: int, p_shader: Shader, p_from: Vector2) -> MeshInstance3D:
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = p_count
	var points: PackedVector3Array = []
	var corners: PackedVector2Array = []
	var places: PackedVector2Array = []
	var colors: PackedColorArray = []
	var index: PackedInt32Array = []
	for piece: int in p_count:
		var place: Vector2 = Vector2(dice.randf(), dice.randf())
		var color: Color = Color(dice.randf(), dice.randf(), dice.randf())
		for corner: int in 4:
			points.append(Vector3.ZERO)
			corners.append(
				Vector2(lerpf(p_from.x, 1.0, corner % 2), lerpf(p_from.y, 1.0, corner / 2))
			)
			places.append(place)
			colors.append(color)
		var first: int = piece * 4
		index.append_array([first, first + 1, first + 2, first + 1, first + 3, first + 2])
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = points
	arrays[Mesh.ARRAY_TEX_UV] = corners
	arrays[Mesh.ARRAY_TEX_UV2] = places
	arrays[Mesh.ARRAY_COLOR] = colors
	arrays[Mesh.ARRAY_INDEX] = index
	var mesh: ArrayMesh = ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	var material: ShaderMaterial = ShaderMaterial.new()
	material.shader = p_shader
	var instance: MeshInstance3D = MeshInstance3D.new()
	instance.mesh = mesh
	instance.material_override = material
	instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	# It is wherever the eye is.
	instance.custom_aabb = AABB(Vector3.ONE * -1e4, Vector3.ONE * 2e4)
	instance.visible = false
	add_child(instance)
	return instance
