class_name SlimeSensor
extends RefCounted
## One sensor of a SlimeVR tracker: what is known of it, and its last readings, to be asked for at
## any moment.

## What may be known of a magnetometer.
enum Magnetometer {
	## The tracker has not said.
	UNKNOWN,
	## There is none.
	NONE,
	## It is not used.
	OFF,
	## It is used.
	ON,
}

## The same for people; empty for what is not known.
const MAGNETOMETERS: PackedStringArray = [
	"", "no magnetometer", "magnetometer off", "magnetometer on"
]
## Readings that are kept.
const MAX_READINGS: int = 32
## A sensor that is silent for longer is not in a frame, µs.
const SILENT_USEC: int = 500000

## What is known of it, for the panel.
var info: SensorInfo = SensorInfo.new()
## What is known of its magnetometer.
var magnetometer: Magnetometer = Magnetometer.UNKNOWN
## When the newest reading came, µs of Unix time.
var heard_usec: int = 0

var _times: PackedInt64Array = PackedInt64Array()
var _turns: Array[Quaternion] = []
var _acceleration: Vector3 = Vector3.ZERO
var _has_acceleration: bool = false
var _rate: SampleRate = SampleRate.new()


## Takes a rotation (in Godot's frame) that came at a time, µs of Unix time.
func take_turn(p_turn: Quaternion, p_usec: int) -> void:
	if not _turns.is_empty() and p_turn.dot(_turns[-1]) < 0.0:
		p_turn = -p_turn
	if not _times.is_empty() and p_usec < _times[-1] - MAX_READINGS * 1000:
		# The clock was set back.
		_times.clear()
		_turns.clear()
		_rate.clear()
	# Of several that a radio gave out at once each was measured at its own time.
	_times.append(maxi(p_usec, _times[-1] + 1000 if not _times.is_empty() else 0))
	_turns.append(p_turn)
	if _turns.size() > MAX_READINGS:
		_times.remove_at(0)
		_turns.remove_at(0)
	heard_usec = p_usec
	info.state = SensorInfo.State.MEASURING
	_rate.add(p_usec)
	info.rate_hz = _rate.hz


## Takes an acceleration without gravity, m/s² in the sensor's axes (in Godot's frame).
func take_acceleration(p_acceleration: Vector3) -> void:
	_acceleration = p_acceleration
	_has_acceleration = true


## Whether it has said something lately.
func is_heard(p_usec: int) -> bool:
	return heard_usec > 0 and p_usec - heard_usec < SILENT_USEC


## Whether accelerations come.
func has_acceleration() -> bool:
	return _has_acceleration


## The rotation at a moment, µs of Unix time: between two readings, or the newest one.
func turn_at(p_usec: int) -> Quaternion:
	var later: int = _times.bsearch(p_usec)
	if later >= _times.size():
		return _turns[-1]
	if later == 0:
		return _turns[0]
	var span: float = _times[later] - _times[later - 1]
	var part: float = (p_usec - _times[later - 1]) / span
	return _turns[later - 1].slerp(_turns[later], part).normalized()


## The acceleration with gravity, as a sensor at rest feels it: m/s² in the sensor's axes.
func felt_acceleration(p_turn: Quaternion) -> Vector3:
	return _acceleration + p_turn.inverse() * Vector3(0.0, 9.80665, 0.0)
