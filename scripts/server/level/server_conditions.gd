class_name ServerConditions
extends RefCounted
## Time of day, weather and other fields of the world that options and instructors have set: they
## outlive a change of level.

## Why the options are invalid, or an empty text.
var error: String = ""

var _level: ServerLevel = null
var _values: Dictionary[StringName, float] = {}


func _init(p_level: ServerLevel, p_time: String = "", p_weather: String = "") -> void:
	_level = p_level
	for option: PackedStringArray in [
		PackedStringArray(["time", p_time]), PackedStringArray(["weather", p_weather])
	]:
		var values: Dictionary[StringName, float] = WorldConditions.parse(option[0], option[1])
		if option[1] != "" and values.is_empty():
			var parts: Array = [option[0], option[1], WorldConditions.describe(option[0])]
			error = "--%s=%s: it must be one of %s" % parts
		_values.merge(values)


## Gives the present level what was set: where it has such fields.
func apply() -> void:
	WorldSky.set_fields(_level.level.world, _values)


## Sets fields, for an instructor. Returns why that is not possible, or an empty text.
func change(p_values: Dictionary[StringName, float]) -> String:
	if p_values.is_empty():
		return "no field and no number was understood"
	var missing: PackedStringArray = WorldSky.set_fields(_level.level.world, p_values)
	if not missing.is_empty():
		return "world '%s' has no %s" % [_level.level_name, ", ".join(missing)]
	_values.merge(p_values, true)
	return ""
