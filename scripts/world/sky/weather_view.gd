@tool
class_name WeatherView
extends Node3D
## Rain and flying dust around the camera: the effects [code]rain[/code] and [code]sandstorm[/code],
## which fall through no roof.

## Least amounts of rain and dust that are shown.
const _LEAST: float = 0.01
## Colour of drops, linear: they have some of it, the rest is that of the air at the horizon.
const _DROPS: Color = Color(0.75, 0.8, 0.85)

var _rain: LayeredEffect = null
var _dust: LayeredEffect = null
var _roofs: RoofProbe = RoofProbe.new()


func _ready() -> void:
	_rain = _make("rain")
	_dust = _make("sandstorm")


func _process(_p_delta: float) -> void:
	var camera: Camera3D = get_viewport().get_camera_3d()
	if camera != null:
		_rain.global_position = camera.global_position
		_dust.global_position = camera.global_position


func _physics_process(_p_delta: float) -> void:
	var camera: Camera3D = get_viewport().get_camera_3d()
	if camera != null:
		_roofs.advance(get_world_3d().direct_space_state, camera.global_position)


## Shows what falls and flies in a state of the sky.
func show_state(p_state: SkyState) -> void:
	var air: Color = p_state.horizon
	_show(_rain, p_state.rain, air.lerp(_DROPS, 0.3) * 1.25)
	_show(_dust, p_state.dust, air * 1.04)
	set_process(_rain.visible or _dust.visible)
	set_physics_process(_rain.visible or _dust.visible)
	if is_processing() and not Engine.is_editor_hint():
		# It sees to it that all effects together don't fill the picture too often.
		EffectPlayer.of(self)


func _show(p_effect: LayeredEffect, p_amount: float, p_colour: Color) -> void:
	p_effect.visible = p_amount > _LEAST
	p_effect.emitting = p_effect.visible
	p_effect.share = p_amount
	p_effect.set_input(&"tint", p_colour.linear_to_srgb().clamp())


func _make(p_effect: String) -> LayeredEffect:
	var made: LayeredEffect = LayeredEffect.make(p_effect, false)
	made.top_level = true
	made.visible = false
	made.set_input(&"roofs", _roofs.texture)
	made.set_input(&"roofs_edge_m", RoofProbe.EDGE_M)
	add_child(made)
	return made
