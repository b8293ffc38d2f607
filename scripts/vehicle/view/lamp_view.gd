class_name LampView
extends RefCounted
## Headlights and rear lamps: they shine by themselves and throw a beam.

## How bright lenses shine, before and behind.
const _GLOW: Vector2 = Vector2(5.0, 3.0)

var _front: ShaderMaterial = null
var _rear: ShaderMaterial = null
var _beams: Array[SpotLight3D] = []
var _is_lit: bool = false
var _braking: float = 0.0


## Takes over the lamps of a model.
func configure(p_model: Node3D) -> void:
	_front = _own_look(p_model.find_child("LampsFront", true, false) as MeshInstance3D)
	_rear = _own_look(p_model.find_child("LampsRear", true, false) as MeshInstance3D)
	for name: String in ["HeadlightSpotLeft", "HeadlightSpotRight"]:
		var spot: Node3D = p_model.find_child(name, true, false) as Node3D
		if spot != null:
			_beams.append(_make_beam(spot))


## Follows the state.
func advance(p_state: VehicleState) -> void:
	var braking: float = 1.0 if p_state.brake > 0.05 and p_state.engine_on else 0.0
	if p_state.lamps == _is_lit and braking == _braking:
		return
	_is_lit = p_state.lamps
	_braking = braking
	var lit: float = 1.0 if _is_lit else 0.0
	if _front != null:
		_front.set_shader_parameter(&"glow", _GLOW.x * lit)
	if _rear != null:
		_rear.set_shader_parameter(&"glow", _GLOW.y * maxf(lit * 0.5, braking))
	for beam: SpotLight3D in _beams:
		beam.visible = _is_lit


## Whether the headlights shine.
func is_lit() -> bool:
	return _is_lit


static func _own_look(p_part: MeshInstance3D) -> ShaderMaterial:
	if p_part == null:
		return null
	var look: ShaderMaterial = p_part.mesh.surface_get_material(0).duplicate()
	p_part.material_override = look
	p_part.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	return look


static func _make_beam(p_spot: Node3D) -> SpotLight3D:
	var beam: SpotLight3D = SpotLight3D.new()
	beam.light_color = Color(1.0, 0.92, 0.78)
	beam.light_energy = 6.0
	beam.light_specular = 0.0
	beam.spot_range = 45.0
	beam.spot_angle = 24.0
	beam.spot_attenuation = 0.8
	beam.rotation.x = deg_to_rad(-4.0)
	beam.visible = false
	beam.distance_fade_enabled = true
	beam.distance_fade_begin = 120.0
	p_spot.add_child(beam)
	return beam
