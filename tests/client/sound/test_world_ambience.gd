extends TestCase
## What is heard all around, by world, weather, hour and roof.


func test_rain_is_heard_outside_and_on_the_roof_inside() -> void:
	var rainy: SkyState = SkyState.at(12.0, 0.0, 0.0, 1.0)
	var outside: Dictionary[StringName, float] = WorldAmbience.mix_of("town", rainy, 0.2)
	var inside: Dictionary[StringName, float] = WorldAmbience.mix_of("town", rainy, 0.95)
	is_true(outside[&"rain_loop"] > -30.0)
	is_true(outside[&"rain_roof_loop"] < -60.0)
	is_true(inside[&"rain_loop"] < outside[&"rain_loop"] - 12.0)
	is_true(inside[&"rain_roof_loop"] > -30.0)


func test_the_night_has_crickets_and_the_day_birds() -> void:
	var day: Dictionary[StringName, float] = WorldAmbience.mix_of("town", SkyState.at(12.0), 0.1)
	var night: Dictionary[StringName, float] = WorldAmbience.mix_of("town", SkyState.at(0.5), 0.1)
	is_true(day[&"birds_loop"] > -50.0 and day[&"crickets_loop"] < -60.0)
	is_true(night[&"crickets_loop"] > -50.0 and night[&"birds_loop"] < -60.0)


func test_a_sandstorm_is_louder_than_the_wind() -> void:
	var storm: SkyState = SkyState.at(12.0, 0.0, 1.0, 0.0)
	var mix: Dictionary[StringName, float] = WorldAmbience.mix_of("desert", storm, 0.1)
	is_true(mix[&"sand_wind_loop"] > -24.0)
	is_true(
		mix[&"wind_loop"] > WorldAmbience.mix_of("desert", SkyState.at(12.0), 0.1)[&"wind_loop"]
	)


func test_every_loop_of_a_mix_is_there() -> void:
	for name: StringName in WorldAmbience.mix_of("x", null, 0.0):
		not_null(SoundBank.find(name), name)
	SoundBank.clear()
