class_name ShakeGesture
extends RefCounted
## Notices that a wearer who is alone shakes one hand: it turns to and fro several times while most
## of the body stands still.
##
## Only orientations are used, and which sensor is where does not matter: it works before anything
## is calibrated.

## Number of changes of direction, and the time in which they must happen, s.
const TURNS: int = 6
const WITHIN_S: float = 2.5
## Least rate of turn of a shaken sensor in each direction, rad/s.
const FAST: float = 3.0
## Greatest rate of a sensor that stands still, rad/s, for how long, s, and least share of such
## sensors.
const STILL: float = 1.0
const STILL_S: float = 1.2
const STILL_PART: float = 0.6
## Least time over which rates are measured, s.
const _STEP_S: float = 0.03

var _last: SensorFrame = null
# Of each sensor: the direction in which it turned last, and when it changed that.
var _last_rates: PackedVector3Array = PackedVector3Array()
var _changes: Array[PackedFloat64Array] = []
# When each was last not still, s.
var _moved_s: PackedFloat64Array = PackedFloat64Array()


## Forgets what came before.
func clear() -> void:
	_last = null
	_last_rates.clear()
	_changes.clear()
	_moved_s.clear()


## Takes a frame; returns whether a hand has been shaken now.
func add(p_frame: SensorFrame) -> bool:
	if _last == null or p_frame.count() != _last.count():
		clear()
		_last = p_frame
		_last_rates.resize(p_frame.count())
		_moved_s.resize(p_frame.count())
		for _sensor: int in p_frame.count():
			_changes.append(PackedFloat64Array())
		return false
	var step_s: float = (p_frame.time_usec - _last.time_usec) / 1e6
	if step_s >= 0.0 and step_s < _STEP_S:
		return false
	var rates: Array[Vector3] = _rates(p_frame, step_s)
	_last = p_frame
	if step_s < 0.0 or step_s > 0.5:
		return false
	var still: int = 0
	var shaken: bool = false
	var now_s: float = p_frame.time_usec / 1e6
	for sensor: int in rates.size():
		if rates[sensor].length() > STILL:
			_moved_s[sensor] = now_s
		var is_still: bool = p_frame.present[sensor] != 0 and _moved_s[sensor] < now_s - STILL_S
		still += 1 if is_still else 0
		shaken = _note(sensor, rates[sensor], now_s) or shaken
	if not shaken or still < STILL_PART * p_frame.present.count(1):
		return false
	clear()
	return true


func _rates(p_frame: SensorFrame, p_step_s: float) -> Array[Vector3]:
	var found: Array[Vector3] = []
	for sensor: int in p_frame.count():
		var is_known: bool = p_frame.present[sensor] != 0 and _last.present[sensor] != 0
		if not is_known or p_step_s <= 0.0:
			found.append(Vector3.ZERO)
			continue
		var turned: Quaternion = p_frame.orientation(sensor) * _last.orientation(sensor).inverse()
		found.append(Rotations.vector(turned) / p_step_s)
	return found


## Notes whether a sensor turns another way than before; returns whether it did so often enough.
func _note(p_sensor: int, p_rate: Vector3, p_now_s: float) -> bool:
	if p_rate.length() < FAST:
		return false
	var changes: PackedFloat64Array = _changes[p_sensor]
	if _last_rates[p_sensor].dot(p_rate) < 0.0:
		changes.append(p_now_s)
	_last_rates[p_sensor] = p_rate
	while not changes.is_empty() and changes[0] < p_now_s - WITHIN_S:
		changes.remove_at(0)
	_changes[p_sensor] = changes
	return changes.size() >= TURNS
