extends TestCase
## Rain and flying dust are effects around the camera.


func test_what_the_sky_says_is_shown_and_no_more() -> void:
	var view: WeatherView = WeatherView.new()
	add_child(view)
	view.show_state(SkyState.at(10.0))
	is_false(_shows(view, "rain") or _shows(view, "sandstorm"))
	is_false(view.is_physics_processing(), "without weather it looks for no roofs")
	view.show_state(SkyState.at(10.0, 0.0, 0.0, 0.6))
	is_true(_shows(view, "rain"))
	is_false(_shows(view, "sandstorm"))
	almost_equal(_find(view, "rain").share, 0.6, 1e-6)
	view.show_state(SkyState.at(10.0, 0.0, 1.0, 0.0))
	is_true(_shows(view, "sandstorm"))
	is_false(_shows(view, "rain"))
	view.free()


func test_wind_grows_with_the_weather() -> void:
	is_true(SkyState.at(10.0, 0.0, 1.0).wind().length() > 5.0)
	is_true(SkyState.at(10.0).wind().length() < 2.0)


static func _find(p_view: WeatherView, p_effect: String) -> LayeredEffect:
	for child: Node in p_view.get_children():
		var shown: LayeredEffect = child as LayeredEffect
		if shown != null and shown.effect == p_effect:
			return shown
	return null


static func _shows(p_view: WeatherView, p_effect: String) -> bool:
	return _find(p_view, p_effect).visible
