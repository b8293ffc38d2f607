class_name AntennaView
extends RefCounted
## Antennas bend and sway when the vehicle accelerates.

## Natural frequency, Hz, and damping ratio of a whip of two metres.
const _HZ: float = 1.7
const _DAMPING: float = 0.07
## Bend per square metre of height for each m/s^2, and the most, 1/m.
const _BEND: float = 0.012
const _MAX_BEND: float = 0.14

## How much they are bent now, in the antennas' frame: x to the right, y to the rear, 1/m.
var sway: Vector2 = Vector2.ZERO

var _speed: Vector2 = Vector2.ZERO
var _look: ShaderMaterial = null


## Takes over the antennas of a model.
func configure(p_model: Node3D) -> void:
	for name: String in ["AntennaLeft", "AntennaRight"]:
		var antenna: MeshInstance3D = p_model.find_child(name, true, false) as MeshInstance3D
		if antenna == null:
			continue
		if _look == null:
			_look = antenna.mesh.surface_get_material(0).duplicate() as ShaderMaterial
		antenna.material_override = _look
		antenna.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		antenna.extra_cull_margin = 0.6


## Moves them on; [param p_acceleration] is that of the vehicle in the antennas' frame, m/s^2.
func advance(p_acceleration: Vector3, p_delta: float) -> void:
	if _look == null:
		return
	var omega: float = TAU * _HZ
	# In small steps: a slow picture must not make it swing up.
	var steps: int = clampi(ceili(p_delta * 90.0), 1, 12)
	var step: float = minf(p_delta, 0.13) / steps
	var push: Vector2 = -Vector2(p_acceleration.x, p_acceleration.z) * _BEND
	for _count: int in steps:
		var pull: Vector2 = omega * omega * (push - sway) - 2.0 * _DAMPING * omega * _speed
		_speed += pull * step
		sway += _speed * step
	sway = sway.limit_length(_MAX_BEND)
	_look.set_shader_parameter(&"sway", sway)
