class_name PhysicsFade
extends RefCounted
## Fades the physics world in at one time and out at another, for a demonstration.

## How long a fade takes, s.
const DURATION_S: float = 0.6

var _begin_s: float = -1.0
var _end_s: float = -1.0


## Reads the times from a text such as "1.5,4"; returns what is wrong with it, or an empty text. An
## empty text is no fade at all.
func set_from_text(p_text: String) -> String:
	if p_text == "":
		return ""
	var parts: PackedStringArray = p_text.split(",")
	var are_times: bool = parts.size() == 2
	for part: String in parts:
		are_times = are_times and part.is_valid_float() and is_finite(part.to_float())
	if not are_times or parts[0].to_float() < 0.0 or parts[1].to_float() < parts[0].to_float():
		return "--physics-at is two times, BEGIN,END, found '%s'" % p_text.left(40)
	_begin_s = parts[0].to_float()
	_end_s = parts[1].to_float()
	return ""


## Whether there is anything to do at a time, s after the start.
func is_due(p_time_s: float) -> bool:
	return _begin_s >= 0.0 and p_time_s >= _begin_s


## How much of the physics world is seen at a time, s after the start: 0 to 1.
func opacity_at(p_time_s: float) -> float:
	var rise: float = clampf((p_time_s - _begin_s) / DURATION_S, 0.0, 1.0)
	var fall: float = clampf((_end_s + DURATION_S - p_time_s) / DURATION_S, 0.0, 1.0)
	return minf(rise, fall)


## Nothing is left to do: the keys have the physics world again.
func end() -> void:
	_begin_s = -1.0
