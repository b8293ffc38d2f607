@tool
class_name WorldConditions
extends RefCounted
## Time of day and weather of a world, as its fields have them and as people write them.

## What the weather can be. Numbers are those of the field.
enum Weather {
	## A blue sky with thin clouds.
	CLEAR,
	## Sight of some hundred metres, a white sky.
	HAZE,
	## A dust storm: sight of some ten metres, everything is yellow.
	DUST,
	## Rain from a closed cover of clouds; what is outdoors gets wet.
	RAIN,
}

## Field with the time of day, hours from 0 to 24.
const TIME: StringName = &"time_of_day"
## Field with the [enum Weather].
const WEATHER: StringName = &"weather"
## Field with the weather's strength, 0 to 1; of no meaning for [constant CLEAR].
const STRENGTH: StringName = &"weather_strength"
## What the weather is called in orders and options, in the order of [enum Weather].
const WEATHERS: PackedStringArray = ["clear", "haze", "dust", "rain"]
## Names for times of day, hours.
const TIMES: Dictionary[String, float] = {
	"dawn": 6.3, "morning": 8.0, "noon": 12.0, "evening": 16.5, "dusk": 17.7, "night": 23.0
}
## Hours of a day.
const DAY_H: float = 24.0


## Hours of a text such as 18.5, 18:30 or dusk; NAN if it is no time of day.
static func parse_time(p_text: String) -> float:
	var text: String = p_text.strip_edges().to_lower()
	if TIMES.has(text):
		return TIMES[text]
	var parts: PackedStringArray = text.split(":")
	if parts.size() == 2 and parts[0].is_valid_int() and parts[1].is_valid_int():
		var minutes: int = parts[1].to_int()
		if minutes < 0 or minutes >= 60:
			return NAN
		text = "%.6f" % (parts[0].left(3).to_int() + minutes / 60.0)
	# The engine complains about large exponents.
	if text.length() > 12 or text.contains("e") or not text.is_valid_float():
		return NAN
	var hours: float = text.to_float()
	return hours if hours >= 0.0 and hours <= DAY_H else NAN


## Values of the fields that a text such as "time 18:30" asks for, by name of the field: [param
## p_what] is time or weather, [param p_text] what follows it ("dust", "rain 0.5"). Empty if it
## cannot be understood.
static func parse(p_what: String, p_text: String) -> Dictionary[StringName, float]:
	var values: Dictionary[StringName, float] = {}
	if p_what == "time":
		var hours: float = parse_time(p_text)
		if not is_nan(hours):
			values[TIME] = fposmod(hours, DAY_H)
		return values
	var words: PackedStringArray = p_text.strip_edges().to_lower().split(" ", false)
	var weather: int = WEATHERS.find(words[0]) if not words.is_empty() else -1
	var strength: float = 1.0
	if words.size() == 2 and not words[1].contains("e") and words[1].is_valid_float():
		strength = words[1].left(8).to_float()
	elif words.size() > 1:
		return values
	if p_what != "weather" or weather < 0 or strength < 0.0 or strength > 1.0:
		return values
	values[WEATHER] = weather
	values[STRENGTH] = strength
	return values


## What can be said behind time or weather, for messages.
static func describe(p_what: String) -> String:
	if p_what == "time":
		return "hours from 0 to 24 such as 18.5 or 18:30, or %s" % ", ".join(TIMES.keys())
	return "%s; a strength from 0 to 1 may follow" % ", ".join(WEATHERS)
