class_name DamageView
extends RefCounted
## A vehicle that is hit smokes and is scorched; one that is knocked out burns.

## Colour of its smoke, sRGB, and how much that hides.
const _SOOT: Color = Color(0.20, 0.19, 0.185)
const _THICKNESS: float = 0.85
## Size of its flames: 1 is 1 m wide.
const _FLAMES: float = 1.5
## How burnt the paint is at each state.
const SCORCH: Array[float] = [0.0, 0.42, 1.0]
## How fast it burns, 1/s.
const _SPREAD: float = 0.5

## How burnt the paint is now, 0 to 1.
var scorch: float = 0.0

var _model: Node3D = null
var _at: Node3D = null
var _level: int = 0
var _looks: Array[ShaderMaterial] = []
var _smoke: LayeredEffect = null
var _fire: LayeredEffect = null
var _glow: OmniLight3D = null
var _seconds: float = 0.0


## [param p_at] is the node of the model where it burns.
func configure(p_model: Node3D, p_at: Node3D) -> void:
	_model = p_model
	_at = p_at


## Follows the state.
func advance(p_damage: int, p_delta: float) -> void:
	var level: int = clampi(p_damage, 0, SCORCH.size() - 1)
	if level != _level:
		_set_level(level)
	if not is_equal_approx(scorch, SCORCH[level]):
		# It burns slowly; what is mended is mended at once.
		scorch = minf(scorch + _SPREAD * p_delta, SCORCH[level])
		for look: ShaderMaterial in _looks:
			look.set_shader_parameter(&"scorch", scorch)
	if _glow != null and _glow.visible:
		_seconds += p_delta
		_glow.light_energy = 1.6 + 0.5 * sin(_seconds * 11.0) * sin(_seconds * 7.3)


## Whether it smokes, and whether it burns.
func is_smoking() -> bool:
	return _smoke != null and _smoke.emitting


## Whether flames are seen.
func is_burning() -> bool:
	return _fire != null and _fire.emitting


func _set_level(p_level: int) -> void:
	_level = p_level
	if _looks.is_empty():
		_take_looks()
	if _smoke == null:
		_smoke = _add("smoke")
		_smoke.set_input(&"tint", _SOOT)
		_smoke.set_input(&"thickness", _THICKNESS)
		_fire = _add("fire")
		_fire.set_input(&"scale", _FLAMES)
		_glow = OmniLight3D.new()
		_glow.light_color = Color(1.0, 0.5, 0.16)
		_glow.light_specular = 0.0
		_glow.omni_range = 9.0
		_glow.position.y = 1.0
		_at.add_child(_glow)
	_smoke.emitting = p_level > 0
	_smoke.share = 0.35 if p_level == 1 else 1.0
	_fire.emitting = p_level > 1
	_glow.visible = p_level > 1
	scorch = minf(scorch, SCORCH[p_level])
	for look: ShaderMaterial in _looks:
		look.set_shader_parameter(&"scorch", scorch)


func _add(p_effect: String) -> LayeredEffect:
	var added: LayeredEffect = LayeredEffect.make(p_effect, false)
	_at.add_child(added)
	return added


## Materials of its own for what is burnt: other vehicles share the model's.
func _take_looks() -> void:
	var own: Dictionary[Material, ShaderMaterial] = {}
	for node: Node in _model.find_children("*", "GeometryInstance3D", true, false):
		var shown: GeometryInstance3D = node
		var material: Material = shown.material_override
		if material == null:
			var mesh: Mesh = null
			if shown is MeshInstance3D:
				mesh = (shown as MeshInstance3D).mesh
			elif shown is MultiMeshInstance3D:
				mesh = (shown as MultiMeshInstance3D).multimesh.mesh
			material = mesh.surface_get_material(0) if mesh != null else null
			if material is ShaderMaterial and not own.has(material):
				own[material] = material.duplicate()
			if own.has(material):
				shown.material_override = own[material]
	_looks.assign(own.values())
