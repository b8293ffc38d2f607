class_name AxisCalibration
extends RefCounted
## Maps the readings of an axis of a steering wheel, stick or pedal to a value: position at rest,
## both ends, and dead zone.

## Least travel of an axis from rest to an end; less counts as noise.
const MIN_WAY: float = 0.15

## Number of the axis of its device.
var axis: int = 0
## Reading at rest.
var rest: float = 0.0
## Reading at the end that counts as 1: a wheel fully left, a pedal fully pressed.
var high: float = 1.0
## Reading at the end that counts as -1; the same as [member rest] for a pedal.
var low: float = -1.0
## Dead zone around rest, as a share of the travel, 0 to 0.5.
var dead_zone: float = 0.03


## The value of a reading: -1 to 1, of a pedal 0 to 1. A reading that is not a number counts as
## rest.
func value_of(p_raw: float) -> float:
	if not is_finite(p_raw):
		return 0.0
	var value: float = 0.0
	if signf(p_raw - rest) == signf(high - rest):
		value = (p_raw - rest) / (high - rest)
	elif absf(low - rest) >= MIN_WAY:
		value = -(p_raw - rest) / (low - rest)
	var beyond: float = clampf((absf(value) - dead_zone) / (1.0 - dead_zone), 0.0, 1.0)
	return signf(value) * beyond


## Whether it can be used: as it came from a file or from a calibration.
func is_sound() -> bool:
	var is_number: bool = is_finite(rest) and is_finite(high) and is_finite(low)
	return (
		is_number
		and axis >= 0
		and axis < JOY_AXIS_MAX
		and absf(high - rest) >= MIN_WAY
		and dead_zone >= 0.0
		and dead_zone <= 0.5
	)


## As kept in a file.
func to_array() -> Array:
	return [axis, rest, high, low, dead_zone]


## Of [method to_array]; null if it is damaged.
static func from_array(p_values: Variant) -> AxisCalibration:
	var values: Array = p_values as Array if p_values is Array else []
	if values.size() != 5 or values.any(func(each: Variant) -> bool: return not _is_number(each)):
		return null
	var made: AxisCalibration = AxisCalibration.new()
	made.axis = int(values[0])
	made.rest = values[1]
	made.high = values[2]
	made.low = values[3]
	made.dead_zone = values[4]
	return made if made.is_sound() else null


static func _is_number(p_value: Variant) -> bool:
	return p_value is float or p_value is int
