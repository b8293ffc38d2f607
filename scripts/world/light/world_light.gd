class_name WorldLight
extends RefCounted
## How strong the sources of a world's light are now, for everything that is shown: the one place
## that sets the global uniforms of [code]assets/shaders/light.gdshaderinc[/code].

## Sources, in the order in which they are baked.
enum Source { SKY, MORNING, NOON, EVENING, LAMPS }
const _UNIFORMS: Array[StringName] = [
	&"light_sky", &"light_morning", &"light_noon", &"light_evening", &"light_lamps"
]
## Strengths where no sky says otherwise: a clear noon.
const _AT_FIRST: Array[Vector3] = [
	Vector3(0.66, 0.74, 0.9), Vector3.ZERO, Vector3(1.6, 1.5, 1.33), Vector3.ZERO, Vector3.ZERO
]

## Strength and colour of each source, linear.
static var strengths: PackedVector3Array = PackedVector3Array(_AT_FIRST)
## Grows with every change.
static var version: int = 0


## Sets the strengths of all five sources.
static func set_strengths(p_strengths: PackedVector3Array) -> void:
	if p_strengths.size() != _UNIFORMS.size() or p_strengths == strengths:
		return
	strengths = p_strengths.duplicate()
	version += 1
	for source: int in _UNIFORMS.size():
		RenderingServer.global_shader_parameter_set(_UNIFORMS[source], strengths[source])


## Sets how wet everything is, 0 to 1.
static func set_wetness(p_wetness: float) -> void:
	RenderingServer.global_shader_parameter_set(&"light_wetness", clampf(p_wetness, 0.0, 1.0))


## Sets where the light of sun or moon comes from: a unit vector towards it, in the world.
static func set_direction(p_towards: Vector3) -> void:
	RenderingServer.global_shader_parameter_set(&"light_direction", p_towards)


## Sets the share of light that the air takes, per m.
static func set_fog(p_density: float) -> void:
	RenderingServer.global_shader_parameter_set(&"light_fog", p_density)


## Sets whether the sun throws shadows; where it does not, it shines where the sky is seen.
static func set_shadows(p_has_shadows: bool) -> void:
	RenderingServer.global_shader_parameter_set(&"light_shadows", 1.0 if p_has_shadows else 0.0)


## Sets how far the eye has opened: 1 outdoors at noon, more where it is dark.
static func set_exposure(p_exposure: float) -> void:
	RenderingServer.global_shader_parameter_set(&"light_exposure", p_exposure)


## Sets the grid of light in the air: its texture, its corner with the least coordinates and its
## edges, m, in the world. Null for none.
static func set_grid(p_texture: Texture3D, p_from: Vector3, p_size: Vector3) -> void:
	RenderingServer.global_shader_parameter_set(&"light_grid", p_texture)
	RenderingServer.global_shader_parameter_set(&"light_grid_from", p_from)
	var size: Vector3 = p_size if p_texture != null else Vector3.ZERO
	RenderingServer.global_shader_parameter_set(&"light_grid_size", size)
