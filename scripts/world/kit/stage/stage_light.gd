@tool
@icon("res://scenes/world/icons/stage_light.svg")
class_name StageLight
extends KitBlock
## A spotlight of a stage with a beam that is seen: it hangs at its origin, below a tube, and shines
## along -Z. It burns by day too, less than when the lamps of the world are lit; haze, dust and rain
## make its beam stronger.
##
## A mesh gets at most eight lights in Compatibility: let some only show their beam
## ([member is_lighting]).

const _SHADER: String = "res://assets/shaders/beam.gdshader"
const _SIDES: int = 24
const _LENS_M: float = 0.1
# How far before the origin its tube ends.
const _TUBE_M: float = 0.2

## Colour of its light.
@export var colour: Color = Color(1.0, 0.95, 0.86):
	set(p_value):
		colour = p_value
		_apply()
## Light on what it hits, as a part of the noon's sun.
@export_range(0.0, 16.0, 0.05) var strength: float = 1.5:
	set(p_value):
		strength = clampf(p_value, 0.0, 16.0)
		_apply()
## Share of its strength by day.
@export_range(0.0, 1.0, 0.05) var by_day: float = 0.6:
	set(p_value):
		by_day = clampf(p_value, 0.0, 1.0)
		_apply()
## Half the angle of its cone.
@export_range(2.0, 60.0, 0.5, "suffix:°") var angle: float = 14.0:
	set(p_value):
		angle = clampf(p_value, 2.0, 60.0)
		queue_rebuild()
## Where its light ends.
@export_range(1.0, 60.0, 0.5, "suffix:m") var reach: float = 14.0:
	set(p_value):
		reach = clampf(p_value, 1.0, 60.0)
		queue_rebuild()
## How much is seen of its beam.
@export_range(0.0, 4.0, 0.05) var beam: float = 1.0:
	set(p_value):
		beam = clampf(p_value, 0.0, 4.0)
		_apply()
## Whether it lights anything; else only its beam is seen.
@export var is_lighting: bool = true:
	set(p_value):
		is_lighting = p_value
		queue_rebuild()
## Whether what it lights throws shadows: for few.
@export var has_shadow: bool = false:
	set(p_value):
		has_shadow = p_value
		queue_rebuild()
@export_group("Movement")
## How far it swings to either side; 0 for not at all.
@export_range(0.0, 60.0, 1.0, "suffix:°") var swing: float = 0.0:
	set(p_value):
		swing = clampf(p_value, 0.0, 60.0)
		set_process(swing > 0.0 and _head != null)
## How long it swings there and back.
@export_range(1.0, 60.0, 0.5, "suffix:s") var period: float = 9.0:
	set(p_value):
		period = clampf(p_value, 1.0, 60.0)

var _lamps: float = 0.0
var _seconds: float = 0.0
var _head: Node3D = null
var _light: SpotLight3D = null
var _material: ShaderMaterial = null


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(StageLight, 64, {"colour": PropertyRule.colour()})
	entry.offered("Stage light", "spot beam lamp", {}, 4.0)
	return entry


func _init() -> void:
	super()
	add_to_group(WorldSky.LAMPS)
	add_to_group(Quality.FOLLOWERS)


func _ready() -> void:
	super()
	for sky: Node in get_tree().get_nodes_in_group(WorldSky.SKIES):
		set_lamp_strength((sky as WorldSky).state.lamps)


func _process(p_delta: float) -> void:
	_seconds = fposmod(_seconds + p_delta, period)
	if _head != null:
		var turn: float = TAU * (_seconds / period + float(seed_of_place() % 1000) / 1000.0)
		var wide: float = deg_to_rad(swing)
		_head.rotation = Vector3(cos(turn) * wide * 0.4, sin(turn) * wide, 0.0)


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var paint: int = Steelwork.PAINT
	var black: int = SurfaceTints.Tint.BLACK
	var iron: int = SurfaceTints.Tint.IRON
	p_mesh.rod(Vector3(0, 0, 0.16), Vector3(0, 0, -_TUBE_M), 0.1, 0.12, paint, black, 14)
	p_mesh.rod(Vector3(0, 0, 0.26), Vector3(0, 0, 0.16), 0.06, 0.1, paint, black, 14)
	for ring: float in [-0.02, 0.06, 0.14]:
		p_mesh.rod(Vector3(0, 0, ring), Vector3(0, 0, ring - 0.02), 0.125, 0.125, paint, iron, 14)
	for side: float in [-0.16, 0.14]:
		p_mesh.box(Vector3(side, -0.03, -0.02), Vector3(side + 0.02, 0.24, 0.02), paint, iron)
	p_mesh.box(Vector3(-0.16, 0.22, -0.02), Vector3(0.16, 0.24, 0.02), paint, iron)
	p_mesh.rod(Vector3(0, 0.22, 0), Vector3(0, 0.36, 0), 0.02, 0.02, paint, iron, 8)


func rebuild() -> void:
	super()
	_head = null
	_light = null
	_material = null
	if not is_inside_tree() or DisplayServer.get_name() == "headless":
		set_process(false)
		return
	_head = Node3D.new()
	add_child(_head, false, Node.INTERNAL_MODE_BACK)
	_material = ShaderMaterial.new()
	_material.shader = load(_SHADER)
	var shown: MeshInstance3D = MeshInstance3D.new()
	shown.mesh = make_beam(deg_to_rad(angle), reach)
	shown.material_override = _material
	shown.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	_head.add_child(shown)
	if is_lighting:
		_light = make_light()
		_head.add_child(_light)
	set_process(swing > 0.0)
	follow_quality()
	_apply()


## Burns at dusk by a share, 0 to 1: [WorldSky] says so.
func set_lamp_strength(p_strength: float) -> void:
	_lamps = clampf(p_strength, 0.0, 1.0)
	_apply()


## Throws no shadows in tiers of quality without them: see [Quality].
func follow_quality() -> void:
	if _light == null:
		return
	var is_on: bool = has_shadow and Quality.tier.shadow_pixels > 0
	_light.shadow_enabled = is_on
	# The shaders tell by it that Compatibility adds this light after the tone curve.
	_light.light_specular = 1.0 if is_on else 0.0


## How strong its light is now, as a part of the noon's sun.
func get_strength_now() -> float:
	return strength * lerpf(by_day, 1.0, _lamps)


## What lights, before the end of the tube: in Compatibility the tube would throw its own shadow on
## all that is lit.
func make_light() -> SpotLight3D:
	var light: SpotLight3D = SpotLight3D.new()
	light.position = Vector3.FORWARD * (_TUBE_M + 0.01)
	light.spot_range = reach
	light.spot_angle = angle
	light.spot_angle_attenuation = 0.6
	# Its lens keeps the light together.
	light.spot_attenuation = 0.0
	light.shadow_bias = 0.04
	light.shadow_blur = 1.5
	return light


## A cone that opens by an angle (rad) to a length (m) along -Z, and a lens at its beginning. UV.y
## is the share of the length, below 0 for the lens.
static func make_beam(p_angle: float, p_length: float) -> ArrayMesh:
	var points: PackedVector3Array = []
	var normals: PackedVector3Array = []
	var uvs: PackedVector2Array = []
	var indices: PackedInt32Array = []
	var wide: float = _LENS_M + tan(p_angle) * p_length
	for side: int in _SIDES + 1:
		var out: Vector3 = Vector3.RIGHT.rotated(Vector3.FORWARD, TAU * side / _SIDES)
		var normal: Vector3 = (out * cos(p_angle) + Vector3.BACK * sin(p_angle)).normalized()
		for end: int in 2:
			points.append(
				out * lerpf(_LENS_M, wide, end) + Vector3.FORWARD * (_TUBE_M + p_length * end)
			)
			normals.append(normal)
			uvs.append(Vector2(float(side) / _SIDES, end))
		if side < _SIDES:
			var at: int = side * 2
			indices.append_array([at, at + 2, at + 1, at + 1, at + 2, at + 3])
	var first: int = points.size()
	for side: int in _SIDES:
		var out: Vector3 = Vector3.RIGHT.rotated(Vector3.FORWARD, TAU * side / _SIDES)
		points.append(out * _LENS_M + Vector3.FORWARD * (_TUBE_M + 0.005))
		normals.append(Vector3.FORWARD)
		uvs.append(Vector2(0.0, -1.0))
		if side > 1:
			indices.append_array([first, first + side - 1, first + side])
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = points
	arrays[Mesh.ARRAY_NORMAL] = normals
	arrays[Mesh.ARRAY_TEX_UV] = uvs
	arrays[Mesh.ARRAY_INDEX] = indices
	var mesh: ArrayMesh = ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh


func _apply() -> void:
	if _material == null:
		return
	var now: float = get_strength_now()
	var linear: Color = colour.srgb_to_linear()
	_material.set_shader_parameter(&"colour", Vector3(linear.r, linear.g, linear.b))
	_material.set_shader_parameter(&"strength", beam * lerpf(by_day, 1.0, _lamps))
	if _light != null:
		_light.light_color = colour
		_light.light_energy = now
		_light.visible = now > 0.001
