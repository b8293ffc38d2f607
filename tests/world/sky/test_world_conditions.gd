extends TestCase
## Times of day and weathers as people write them.


func test_times() -> void:
	_is_time("18.5", 18.5)
	_is_time(" 18:30 ", 18.5)
	_is_time("24", 0.0)
	_is_time("Noon", 12.0)


func test_weathers() -> void:
	for name: String in WorldConditions.WEATHERS:
		var values: Dictionary = WorldConditions.parse("weather", name.to_upper())
		equal(values[WorldConditions.WEATHER], float(WorldConditions.WEATHERS.find(name)))
		equal(values[WorldConditions.STRENGTH], 1.0)
	equal(WorldConditions.parse("weather", "rain 0.5")[WorldConditions.STRENGTH], 0.5)


func test_nonsense_is_nothing() -> void:
	for text: String in ["", "25", "-1", "12:60", "noonish", "1e9", "nan", "inf", "12:", ":"]:
		is_true(WorldConditions.parse("time", text).is_empty(), text)
	for text: String in ["", "snow", "rain 2", "rain -1", "rain nan", "rain 0.5 1", "3"]:
		is_true(WorldConditions.parse("weather", text).is_empty(), text)
	is_true(WorldConditions.parse("mood", "12").is_empty())


func _is_time(p_text: String, p_hours: float) -> void:
	equal(WorldConditions.parse("time", p_text)[WorldConditions.TIME], p_hours)
