class_name Vignette
extends MeshInstance3D
## Darkens the edge of the wearer's view while the world moves and the wearer does not: most people
## feel sick of what passes at the edge of their eyes.

## Speeds at which the edge is darkest: m/s, rad/s.
const _FULL_MPS: float = 3.0
const _FULL_RPS: float = 1.5
## Half the angle of what stays clear, rad: while nothing moves, and at its narrowest.
const _WIDE: float = 1.2
const _NARROW: float = 0.35
## It comes and goes within this time, s.
const _TIME_S: float = 0.25
## Time in which the picture comes back after a step, s.
const _BLINK_S: float = 0.1

## How strongly, 0 (never) to 1 (a tunnel of 20 degrees).
var strength: float = 0.5

var _amount: float = 0.0
var _dark: float = 0.0
var _material: ShaderMaterial = ShaderMaterial.new()


func _init() -> void:
	var quad: QuadMesh = QuadMesh.new()
	quad.size = Vector2(2.0, 2.0)
	mesh = quad
	_material.shader = preload("res://assets/shaders/vignette.gdshader")
	_material.render_priority = Material.RENDER_PRIORITY_MAX
	material_override = _material
	# It covers the view wherever the view is.
	extra_cull_margin = 16384.0
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	visible = false


## A frame: how fast the wearer is moved (m/s) and turned (rad/s) by anything but own steps.
func advance(p_speed: float, p_turn: float, p_delta: float) -> void:
	var moved: float = maxf(absf(p_speed) / _FULL_MPS, absf(p_turn) / _FULL_RPS)
	var wanted: float = clampf(moved, 0.0, 1.0) * clampf(strength, 0.0, 1.0)
	wanted = wanted if is_finite(wanted) else 0.0
	_amount = move_toward(_amount, wanted, maxf(0.0, p_delta) / _TIME_S)
	visible = _amount > 0.0 or _dark > 0.0
	_material.set_shader_parameter("edge", lerpf(_WIDE, _NARROW, _amount))
	_material.set_shader_parameter("dark", _dark)
	_dark = move_toward(_dark, 0.0, maxf(0.0, p_delta) / _BLINK_S)


## The view has made a step: the picture comes back out of the dark. Without any strength it is
## there at once.
func blink() -> void:
	_dark = 1.0 if strength > 0.0 else 0.0


## How dark it is now, 0 to 1.
func amount() -> float:
	return _amount
