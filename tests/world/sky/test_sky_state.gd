extends TestCase
## How light and air change with the time of day and the weather.


func test_sun_goes_from_east_over_south_to_west() -> void:
	is_true(SkyState.at(6.0).sun.is_equal_approx(Vector3.RIGHT), "at 6 in the east")
	var noon: SkyState = SkyState.at(12.0)
	almost_equal(noon.sun.y, sin(SkyState.NOON_HEIGHT), 1e-5)
	is_true(noon.sun.z > 0.0 and absf(noon.sun.x) < 1e-5, "at noon in the south")
	is_true(SkyState.at(18.0).sun.is_equal_approx(Vector3.LEFT), "at 18 in the west")
	is_true(SkyState.at(0.0).sun.y < -0.8, "at midnight below")


func test_each_hour_has_light_from_above() -> void:
	for quarter: int in 96:
		var state: SkyState = SkyState.at(quarter / 4.0)
		var is_low: bool = state.light_energy > 0.02 and state.light.y < -0.03
		is_false(is_low, "light from below at quarter %d" % quarter)
		is_true(state.sky_light.length() > 0.004, "no light at quarter %d" % quarter)


func test_noon_is_brighter_than_dusk_and_dusk_than_night() -> void:
	var lights: PackedFloat32Array = []
	for hours: float in [12.0, 17.7, 18.4, 22.0]:
		var state: SkyState = SkyState.at(hours)
		lights.append(state.sky_light.length())
	for index: int in lights.size() - 1:
		is_true(lights[index] > 1.15 * lights[index + 1], "light does not fall: %s" % lights)


func test_baked_sources_follow_the_sun() -> void:
	var morning: SkyState = SkyState.at(7.0)
	is_true(morning.morning_light.length() > 0.1, "morning light in the morning")
	equal(morning.evening_light, Vector3.ZERO)
	var noon: SkyState = SkyState.at(12.0)
	is_true(noon.noon_light.length() > 1.0, "noon light at noon")
	equal(noon.morning_light + noon.evening_light, Vector3.ZERO)
	is_true(SkyState.at(17.0).evening_light.length() > 0.1, "evening light in the evening")


func test_lamps_are_lit_at_night_and_in_dust_only() -> void:
	equal(SkyState.at(12.0).lamps, 0.0)
	equal(SkyState.at(23.0).lamps, 1.0)
	is_true(SkyState.at(12.0, 0.0, 1.0).lamps > 0.3, "lamps in a dust storm")
	equal(SkyState.at(12.0).lamp_light, Vector3.ZERO)
	is_true(SkyState.at(23.0).lamp_light.x > 1.0, "lamps give light")


func test_nothing_jumps_over_the_day() -> void:
	var last: SkyState = SkyState.at(0.0)
	for step: int in range(1, 24 * 50 + 1):
		var now: SkyState = SkyState.at(fposmod(step / 50.0, 24.0))
		var jump: float = (now.sky_light - last.sky_light).length()
		jump = maxf(jump, absf(now.fog_color.get_luminance() - last.fog_color.get_luminance()))
		jump = maxf(jump, absf(now.light_energy - last.light_energy))
		is_true(jump < 0.06, "a jump of %.3f at %.2f h" % [jump, step / 50.0])
		last = now


func test_sun_and_moon_change_places_in_the_dark() -> void:
	var last: SkyState = SkyState.at(12.0)
	var changes: int = 0
	for step: int in range(1, 24 * 200 + 1):
		var now: SkyState = SkyState.at(fposmod(12.0 + step / 200.0, 24.0))
		if now.light.dot(last.light) < 0.9:
			changes += 1
			is_true(maxf(now.light_energy, last.light_energy) < 0.02, "a shadow jumps")
		last = now
	equal(changes, 2)


func test_weather_takes_sight_and_sun() -> void:
	var clear: SkyState = SkyState.at(12.0)
	for weather: int in 3:
		var amounts: Vector3 = Vector3.ZERO
		amounts[weather] = 1.0
		var state: SkyState = SkyState.at(12.0, amounts.x, amounts.y, amounts.z)
		is_true(state.fog_density > 2.0 * clear.fog_density, "weather %d takes sight" % weather)
		is_true(state.light_energy < 0.7 * clear.light_energy, "weather %d takes sun" % weather)
	equal(SkyState.at(12.0, 0.0, 0.0, 1.0).wetness, 1.0)
	equal(clear.wetness, 0.0)
