extends TestCase
## The sky of a world: fields, first values, smooth changes.

const ClientHost: GDScript = preload("res://tests/entity/client_host.gd")
const SKY: PackedScene = preload("res://scenes/world/sky/world_sky.tscn")

var _sky: WorldSky = null
var _host: EntityHost = null


func before_each() -> void:
	_sky = SKY.instantiate()
	_sky.settling_ms = 0
	_host = LocalSession.Host.new()


func after_each() -> void:
	_sky.free()


func test_scene_has_no_warnings() -> void:
	add_child(_sky)
	equal(_sky._get_configuration_warnings(), PackedStringArray())
	equal(_sky.entity.type.find_fault(), "")


func test_a_sky_without_entity_warns() -> void:
	_sky.entity = null
	add_child(_sky)
	equal(_sky._get_configuration_warnings().size(), 1)


func test_a_server_starts_with_the_settings_of_the_level() -> void:
	_sky.time_of_day = 17.5
	_sky.weather = WorldConditions.Weather.DUST
	_sky.weather_strength = 0.5
	add_child(_sky)
	_start([10.0, 0.0, 1.0])
	almost_equal(_sky.entity.get_value(WorldConditions.TIME), 17.5, 0.006)
	equal(_sky.entity.get_value(WorldConditions.WEATHER), 2.0)
	equal(_sky.entity.get_value(WorldConditions.STRENGTH), 0.5)


func test_a_client_shows_at_once_what_is_when_it_joins() -> void:
	_host = ClientHost.new()
	add_child(_sky)
	_start([22.0, 3.0, 1.0])
	_sky.advance(0.0)
	equal(_sky.state.rain, 1.0)
	equal(_sky.state.lamps, 1.0)


func test_what_arrives_just_after_the_start_is_shown_at_once() -> void:
	_host = ClientHost.new()
	_sky.settling_ms = 60_000
	add_child(_sky)
	_start([12.0, 0.0, 1.0])
	_sky.advance(0.0)
	_sky.entity.take_value(1, 3.0)
	_sky.advance(0.0)
	equal(_sky.state.rain, 1.0)


func test_a_client_changes_smoothly() -> void:
	_host = ClientHost.new()
	add_child(_sky)
	_start([12.0, 0.0, 1.0])
	_sky.advance(0.0)
	_sky.entity.take_value(1, 3.0)
	_sky.advance(WorldSky.CHANGE_S / 2.0)
	almost_equal(_sky.state.rain, 0.5, 1e-5)
	_sky.advance(WorldSky.CHANGE_S)
	equal(_sky.state.rain, 1.0)


func test_time_goes_the_short_way_over_midnight() -> void:
	_host = ClientHost.new()
	add_child(_sky)
	_start([23.0, 0.0, 1.0])
	_sky.advance(0.0)
	_sky.entity.take_value(0, 1.0)
	_sky.advance(WorldSky.CHANGE_S / 2.0)
	is_true(_sky.state.sun.y < -0.85, "the sun rose on the way from 23 to 1: %s" % _sky.state.sun)


func test_fields_that_a_world_has_not_are_named() -> void:
	add_child(_sky)
	_start([12.0, 0.0, 1.0])
	var wanted: Dictionary[StringName, float] = {&"gravity": 1.0, WorldConditions.TIME: 3.0}
	equal(WorldSky.set_fields(_sky.entity, wanted), PackedStringArray(["gravity"]))
	equal(_sky.entity.get_value(WorldConditions.TIME), 3.0)
	equal(WorldSky.set_fields(null, wanted).size(), 2)


func _start(p_values: PackedFloat32Array) -> void:
	_sky.entity.start(_host, 0, p_values)
