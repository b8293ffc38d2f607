class_name MotionAxis
extends RefCounted
## About which axis sensors turned during a movement, each in its own global frame.
##
## Movements of a calibration turn a limb out of a pose and back about one known, horizontal axis of
## the body: then the axis shows which way the sensor's global frame is turned about the vertical.

## Frames whose mean is where a movement starts from, or where it ends.
const START_FRAMES: int = 8

var _first: Array[Quaternion] = []
# Of each sensor the last frames, in a ring.
var _last: Array[Quaternion] = []
var _heard: PackedInt32Array = PackedInt32Array()
var _sums: PackedVector3Array = PackedVector3Array()
var _cubes: PackedVector3Array = PackedVector3Array()
var _lengths: PackedFloat32Array = PackedFloat32Array()
var _most: PackedFloat32Array = PackedFloat32Array()


## Takes a frame; a sensor's first ones are where it starts from.
func add(p_frame: SensorFrame) -> void:
	_grow(p_frame.count())
	for sensor: int in p_frame.count():
		if p_frame.present[sensor] == 0:
			continue
		var turned: Quaternion = p_frame.orientation(sensor).normalized()
		_last[sensor * START_FRAMES + _heard[sensor] % START_FRAMES] = turned
		_heard[sensor] += 1
		if _heard[sensor] == 1:
			_first[sensor] = turned
		elif _heard[sensor] <= START_FRAMES:
			_first[sensor] = _first[sensor].slerp(turned, 1.0 / _heard[sensor])
		else:
			_add_turn(sensor, Rotations.vector(turned * _first[sensor].inverse()))


## Whether a sensor sent enough to judge it.
func was_heard(p_sensor: int) -> bool:
	return p_sensor < _heard.size() and _heard[p_sensor] > START_FRAMES


## How far a sensor turned out of its first pose at most, rad.
func turn(p_sensor: int) -> float:
	return _most[p_sensor] if p_sensor < _most.size() else 0.0


## How far a sensor turned about one axis, rad: as far as most of the movement went. Swaying to and
## fro is none.
func swing(p_sensor: int) -> float:
	if p_sensor >= _sums.size() or _lengths[p_sensor] <= 0.0:
		return 0.0
	return _cubes[p_sensor].length() / _lengths[p_sensor]


## What a sensor said before it turned.
func start(p_sensor: int) -> Quaternion:
	return _first[p_sensor]


## What a sensor said in the end.
func end(p_sensor: int) -> Quaternion:
	var count: int = mini(_heard[p_sensor], START_FRAMES)
	return Rotations.mean(_last.slice(p_sensor * START_FRAMES, p_sensor * START_FRAMES + count))


## The axis in the sensor's global frame, of length 1; zero if it hardly turned.
func axis(p_sensor: int) -> Vector3:
	return _sums[p_sensor].normalized() if p_sensor < _sums.size() else Vector3.ZERO


## How much the axis changed during the movement, rad: the standard deviation of its direction.
func scatter(p_sensor: int) -> float:
	if p_sensor >= _sums.size() or _lengths[p_sensor] <= 0.0:
		return PI / 2.0
	return acos(clampf(_sums[p_sensor].length() / _lengths[p_sensor], 0.0, 1.0))


func _add_turn(p_sensor: int, p_turn: Vector3) -> void:
	var angle: float = p_turn.length()
	_most[p_sensor] = maxf(_most[p_sensor], angle)
	# Far out the axis is known best: weight by the square of the angle.
	_sums[p_sensor] += p_turn * angle
	_cubes[p_sensor] += p_turn * angle * angle
	_lengths[p_sensor] += angle * angle


func _grow(p_count: int) -> void:
	while _first.size() < p_count:
		_first.append(Quaternion.IDENTITY)
		for _frame: int in START_FRAMES:
			_last.append(Quaternion.IDENTITY)
		_heard.append(0)
		_sums.append(Vector3.ZERO)
		_cubes.append(Vector3.ZERO)
		_lengths.append(0.0)
		_most.append(0.0)
