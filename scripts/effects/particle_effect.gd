@tool
class_name ParticleEffect
extends GPUParticles3D
## Draws one file of an effect ([EffectLayer]). [LayeredEffect] draws all files of one.

## Group of all that are in the tree, for [EffectBudget].
const GROUP: StringName = &"particle_effects"
## Steps of the particles in a second: pictures between two steps are interpolated. What lives less
## than [constant SHORT_S], or is a streak, needs more of them.
const STEPS_PER_SECOND: int = 30
const MANY_STEPS_PER_SECOND: int = 60
const SHORT_S: float = 1.0
## Least number of particles of a burst, whatever the budget.
const MIN_BURST: int = 5

## What it draws.
var layer: EffectLayer = null
## Share of the file's particles that is wanted now, 0 to 1.
var share: float = 1.0:
	set(p_value):
		share = clampf(p_value, 0.0, 1.0)
		_apply_share()
## Share of those that there is room for: [EffectBudget].
var room: float = 1.0:
	set(p_value):
		room = clampf(p_value, 0.0, 1.0)
		_apply_share()

## Takes the values of its inputs and uniforms: they are its own.
var _motion: ShaderMaterial = ShaderMaterial.new()


func _enter_tree() -> void:
	add_to_group(GROUP)


## Shows a layer. Where it already shows one that is drawn alike, its particles go on.
func show_layer(p_layer: EffectLayer) -> void:
	layer = p_layer
	_motion.shader = p_layer.shader
	process_material = _motion
	var settings: EffectSettings = p_layer.file.settings
	amount = settings.count
	lifetime = settings.life
	explosiveness = settings.burst
	one_shot = settings.once
	preprocess = settings.preprocess
	var is_quick: bool = settings.life < SHORT_S or settings.facing == "velocity"
	fixed_fps = MANY_STEPS_PER_SECOND if is_quick else STEPS_PER_SECOND
	interpolate = true
	draw_order = _order_of(settings)
	var reach: Vector3 = Vector3.ONE * settings.bounds
	visibility_aabb = AABB(-reach, reach * 2.0)
	# What is gone by its fade is not stepped either.
	visibility_range_end = settings.fade[1] + settings.bounds if settings.fade[1] > 0.0 else 0.0
	draw_pass_1 = EffectDrawing.mesh(settings.topology)
	material_override = p_layer.material
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	_apply_share()


## Shows a file without problems that is in no library, such as the one that the studio edits.
func show_file(p_file: EffectFile) -> void:
	if layer == null:
		show_layer(EffectLayer.make("", p_file))
	elif layer.take(p_file):
		show_layer(layer)


## Sets an input or another uniform of the file: a number, a vector, a colour (sRGB, as it is
## picked) or a texture. Inputs that the file declares stay within their bounds.
func set_input(p_name: StringName, p_value: Variant) -> void:
	var value: Variant = p_value
	if p_value is Color:
		var colour: Color = p_value
		value = Vector3(colour.r, colour.g, colour.b)
	elif p_value is float and layer != null:
		for input: EffectInput in layer.file.settings.inputs:
			if input.name == p_name:
				value = input.clamped(p_value)
	_motion.set_shader_parameter(p_name, value)


## How many times it fills the picture of a camera, all its particles counted, at full share.
func screens(p_camera: Camera3D) -> float:
	if layer == null or not (visible and emitting):
		return 0.0
	var settings: EffectSettings = layer.file.settings
	var sum: float = 0.0
	for size: float in settings.size:
		sum += size * size
	var area: float = settings.count * sum / settings.size.size()
	if settings.facing == "velocity":
		area *= 0.1
	# Particles are spread around the emitter: none counts as larger than a few metres away.
	var away: float = maxf(p_camera.global_position.distance_to(global_position), 3.0)
	var edge: float = 2.0 * away * tan(deg_to_rad(p_camera.fov) * 0.5)
	return area / (edge * edge * 1.78)


func _apply_share() -> void:
	var least: float = 0.0
	if one_shot and amount > 0:
		least = minf(float(MIN_BURST) / amount, 1.0)
	amount_ratio = clampf(share * room, least if share > 0.0 else 0.0, 1.0)


static func _order_of(p_settings: EffectSettings) -> DrawOrder:
	match p_settings.order:
		"depth":
			return DRAW_ORDER_VIEW_DEPTH
		"age":
			return DRAW_ORDER_LIFETIME
	return DRAW_ORDER_INDEX
