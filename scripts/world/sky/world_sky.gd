@tool
@icon("res://scenes/world/icons/world_sky.svg")
class_name WorldSky
extends Node3D
## Sky, sun, air and weather of a world, by the fields of the world's own [Entity].
##
## Add [code]scenes/world/sky/world_sky.tscn[/code] to a level and choose its node
## [code]World[/code] for the level's [member Level.world]. On a server it gives the fields their
## first values; on clients it sets environment, sun, rain, dust and the strength of all baked light
## ([code]assets/shaders/light.gdshaderinc[/code]).

## Lamps are lit (1) or not (0), or something between, at dusk.
signal lamps_changed(p_strength: float)

## Seconds that a change of time or weather takes to be seen.
const CHANGE_S: float = 2.0
## Group of lights that follow dusk: each has [code]set_lamp_strength(p_strength: float)[/code].
const LAMPS: StringName = &"lamps"
## Group of this node.
const SKIES: StringName = &"skies"

## Time of day at which the world starts, hours.
@export_range(0.0, 24.0, 0.05, "suffix:h") var time_of_day: float = 10.0:
	set(p_value):
		time_of_day = p_value
		_aim_at_own()
## Weather with which it starts.
@export var weather: WorldConditions.Weather = WorldConditions.Weather.CLEAR:
	set(p_value):
		weather = p_value
		_aim_at_own()
## How strong that weather is.
@export_range(0.0, 1.0, 0.05) var weather_strength: float = 1.0:
	set(p_value):
		weather_strength = p_value
		_aim_at_own()
## Distance from the camera up to which things throw shadows of the sun or moon, m.
@export_range(10.0, 300.0, 1.0, "suffix:m") var shadow_distance: float = 60.0:
	set(p_value):
		shadow_distance = p_value
		if _sun != null:
			follow_quality()
## The world's own entity; empty: a preview that follows the settings above.
@export var entity: Entity = null:
	set(p_value):
		entity = p_value
		update_configuration_warnings()

## Time after a client has got the fields during which changes are shown at once, ms: what was set
## before it came arrives only now.
var settling_ms: int = 2500
## What is shown now.
var state: SkyState = SkyState.at(10.0)

# What is shown now and aimed at: hours, haze, dust, rain.
var _shown: Vector4 = Vector4(10.0, 0.0, 0.0, 0.0)
var _from: Vector4 = Vector4(10.0, 0.0, 0.0, 0.0)
var _aim: Vector4 = Vector4(10.0, 0.0, 0.0, 0.0)
var _changed_s: float = CHANGE_S
var _has_shown: bool = false
var _processed_ms: int = 0
var _started_ms: int = 0
var _lamps: float = -1.0
var _environment: Environment = null
var _sky: ShaderMaterial = null

@onready var _sun: DirectionalLight3D = $Sun
@onready var _view: WorldEnvironment = $Environment
@onready var _weather_view: WeatherView = $Weather


func _ready() -> void:
	add_to_group(SKIES)
	if entity != null and not Engine.is_editor_hint():
		entity.started.connect(_on_started)
		entity.field_changed.connect(_on_field_changed)
	if DisplayServer.get_name() == "headless":
		set_process(false)
		_weather_view.queue_free()
		return
	_environment = _view.environment
	_sky = _environment.sky.sky_material as ShaderMaterial
	# Compatibility adds light after the tone curve: there materials apply it themselves.
	_environment.tonemap_mode = Environment.TONE_MAPPER_FILMIC
	if is_compatible():
		_environment.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	add_to_group(Quality.FOLLOWERS)
	follow_quality()
	_aim_at_own()
	advance(CHANGE_S)


func _process(_p_delta: float) -> void:
	# Not the engine's step, which is cut where frames take long.
	var now: int = Time.get_ticks_msec()
	if _changed_s < CHANGE_S or not _has_shown:
		advance((now - _processed_ms) / 1000.0)
	_processed_ms = now


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if entity == null:
		warnings.append("Choose its node 'World' for 'Entity': time and weather stay as they are.")
	elif entity.type == null or entity.type.find_field(WorldConditions.TIME) < 0:
		warnings.append("The type of 'Entity' has no time_of_day: choose world_type.tres.")
	return warnings


## Shows as much as the tier of quality says: see [Quality].
func follow_quality() -> void:
	_sun.directional_shadow_max_distance = shadow_distance * Quality.tier.shadow_reach
	_has_shown = false


## Shows a time of day and a weather at once, without an entity: for pictures, tests, the editor.
func show_conditions(
	p_hours: float, p_weather: WorldConditions.Weather, p_strength: float = 1.0
) -> void:
	_aim = _aim_of(p_hours, p_weather, p_strength)
	_from = _aim
	_changed_s = CHANGE_S
	advance(0.0)


## Goes on with a change, by some seconds.
func advance(p_delta: float) -> void:
	_changed_s = minf(_changed_s + p_delta, CHANGE_S)
	var part: float = smoothstep(0.0, 1.0, _changed_s / CHANGE_S)
	_shown = _from.lerp(_aim, part)
	_shown.x = fposmod(_from.x + wrapf(_aim.x - _from.x, -12.0, 12.0) * part, WorldConditions.DAY_H)
	state = SkyState.at(_shown.x, _shown.y, _shown.z, _shown.w)
	_has_shown = true
	if _environment != null:
		_apply()


## A colour as the engine's filmic tone curve shows it: what is not lit needs it in Compatibility.
static func tone(p_color: Color) -> Color:
	return Color(_film(p_color.r), _film(p_color.g), _film(p_color.b))


## A linear colour for a source_color uniform of a shader that is not lit.
static func shown(p_color: Color) -> Color:
	return (tone(p_color) if is_compatible() else p_color).linear_to_srgb()


## Whether this is the renderer Compatibility, where materials apply the tone curve.
static func is_compatible() -> bool:
	return RenderingServer.get_current_rendering_method() == "gl_compatibility"


## Gives the fields of a world's entity values, on a server: those that the type has. Returns the
## names of fields that it has not.
static func set_fields(
	p_world: Entity, p_values: Dictionary[StringName, float]
) -> PackedStringArray:
	var missing: PackedStringArray = []
	for field: StringName in p_values:
		if p_world == null or p_world.type == null or p_world.type.find_field(field) < 0:
			missing.append(field)
		else:
			p_world.set_value(field, p_values[field])
	return missing


func _on_started() -> void:
	if not entity.is_authority():
		_started_ms = Time.get_ticks_msec()
		_aim_at_fields()
		_jump()
		return
	var first: Dictionary[StringName, float] = {
		WorldConditions.TIME: fposmod(time_of_day, WorldConditions.DAY_H),
		WorldConditions.WEATHER: weather,
		WorldConditions.STRENGTH: weather_strength,
	}
	set_fields(entity, first)


func _on_field_changed(_p_field: StringName, _p_value: float) -> void:
	_aim_at_fields()


func _aim_at_fields() -> void:
	var kind: int = roundi(entity.get_value(WorldConditions.WEATHER))
	_aim_at(
		_aim_of(
			entity.get_value(WorldConditions.TIME),
			clampi(kind, 0, WorldConditions.WEATHERS.size() - 1) as WorldConditions.Weather,
			entity.get_value(WorldConditions.STRENGTH)
		)
	)


func _aim_at_own() -> void:
	if not is_node_ready() or (entity != null and entity.is_started()):
		return
	_aim = _aim_of(time_of_day, weather, weather_strength)
	_jump()


func _aim_at(p_aim: Vector4) -> void:
	if p_aim.is_equal_approx(_aim):
		return
	_from = _shown
	_aim = p_aim
	_changed_s = 0.0
	if Time.get_ticks_msec() - _started_ms < settling_ms:
		_jump()


## Shows what is aimed at without delay.
func _jump() -> void:
	_from = _aim
	_changed_s = CHANGE_S
	_has_shown = false


static func _aim_of(
	p_hours: float, p_weather: WorldConditions.Weather, p_strength: float
) -> Vector4:
	var aim: Vector4 = Vector4(fposmod(p_hours, WorldConditions.DAY_H), 0.0, 0.0, 0.0)
	if p_weather != WorldConditions.Weather.CLEAR:
		aim[p_weather] = clampf(p_strength, 0.0, 1.0)
	return aim


func _apply() -> void:
	_apply_light()
	_apply_air()
	_weather_view.show_state(state)
	if absf(state.lamps - _lamps) > 0.004:
		_lamps = state.lamps
		get_tree().call_group(LAMPS, &"set_lamp_strength", _lamps)
		lamps_changed.emit(_lamps)


func _apply_light() -> void:
	_sun.visible = state.light_energy > 0.003
	var up: Vector3 = Vector3.UP if absf(state.light.y) < 0.99 else Vector3.BACK
	_sun.basis = Basis.looking_at(-state.light, up)
	_sun.light_color = state.light_color
	_sun.light_energy = state.light_energy
	_sun.shadow_opacity = state.shadow_opacity
	var strengths: PackedVector3Array = [
		state.sky_light,
		state.morning_light,
		state.noon_light,
		state.evening_light,
		state.lamp_light,
	]
	WorldLight.set_strengths(strengths)
	WorldLight.set_wetness(state.wetness)
	WorldLight.set_direction(state.light)
	RenderingServer.global_shader_parameter_set(&"wind", state.wind())


func _apply_air() -> void:
	var colors: Dictionary[StringName, Color] = {
		&"zenith": state.zenith,
		&"middle": state.middle,
		&"horizon": state.horizon,
		&"ground": state.ground,
		&"glow": state.glow,
		&"sun_color":
		state.light_color.srgb_to_linear() * clampf(state.sun.y * 8.0 + 0.6, 0.0, 1.0),
	}
	for part: StringName in colors:
		var color: Color = colors[part]
		_sky.set_shader_parameter(part, Vector3(color.r, color.g, color.b))
	_sky.set_shader_parameter(&"sun", state.sun)
	_sky.set_shader_parameter(&"moon", state.moon)
	_sky.set_shader_parameter(&"clearness", state.clearness)
	_sky.set_shader_parameter(&"stars", state.stars)
	_sky.set_shader_parameter(&"cloud_cover", state.cloud_cover)
	_sky.set_shader_parameter(&"cloud_shade", state.cloud_shade)
	_sky.set_shader_parameter(&"cloud_shift", Vector2(0.013, 0.005) * _shown.x)
	var air: Color = tone(state.fog_color) if is_compatible() else state.fog_color
	_environment.fog_light_color = air.linear_to_srgb()
	_environment.fog_density = state.fog_density
	WorldLight.set_fog(state.fog_density)


static func _film(p_value: float) -> float:
	var curve: Callable = func(x: float) -> float:
		return (x * (0.88 * x + 0.06) + 0.002) / (x * (0.88 * x + 0.6) + 0.06) - 0.0333333
	return clampf(curve.call(p_value) / curve.call(2.5), 0.0, 1.0)
