class_name PersonProfile
extends RefCounted
## The stored data of a person who wears sensors: name, body, mounts of sensors, calibration.

## Longest name.
const MAX_LETTERS: int = 60

## Name of the person, and of the file.
var name: String = "somebody"
## The person's size.
var size: BodySize = BodySize.new()
## Which sensor is worn where.
var map: SensorMap = SensorMap.new()
## The calibration, or null if there is none yet.
var calibration: Calibration = null


## Another one with the same data.
func duplicate() -> PersonProfile:
	var copy: PersonProfile = PersonProfile.new()
	copy.name = name
	copy.size = size
	copy.map = map
	copy.calibration = calibration
	return copy


## Why a name is not allowed, or an empty text.
static func find_name_fault(p_name: String) -> String:
	if p_name.strip_edges() == "":
		return "a person needs a name"
	if p_name != p_name.strip_edges() or p_name.begins_with(".") or p_name.ends_with("."):
		return "a name neither begins nor ends with a space or a full stop"
	if p_name.length() > MAX_LETTERS:
		return "a name has at most %d letters, found %d" % [MAX_LETTERS, p_name.length()]
	for at: int in p_name.length():
		if p_name.unicode_at(at) < 32 or p_name.unicode_at(at) == 127:
			return "a name has no control characters"
	if not p_name.is_valid_filename():
		return "a name has none of : / \\ ? * \" | %% < >, found '%s'" % p_name
	return ""
