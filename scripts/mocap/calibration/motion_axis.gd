class_name MotionAxis
extends RefCounted
## About which axis sensors turned during a movement, each in its own global frame.
##
## Movements of a calibration turn a limb out of a pose and back about one known, horizontal axis of
## the body: then the axis shows which way the sensor's global frame is turned about the vertical.
## Only horizontal axes count, since a heading that drifts adds a turn about the vertical.

## Frames whose mean is where a movement starts from.
const START_FRAMES: int = 8
## Turns out of the first pose by less than this show nothing, rad.
const MIN_TURN: float = 0.15

var _first: Array[Quaternion] = []
var _heard: PackedInt32Array = PackedInt32Array()
var _sums: PackedVector3Array = PackedVector3Array()
var _lengths: PackedFloat32Array = PackedFloat32Array()
var _most: PackedFloat32Array = PackedFloat32Array()


## Takes a frame; a sensor's first ones are where it starts from.
func add(p_frame: SensorFrame) -> void:
	_grow(p_frame.count())
	for sensor: int in p_frame.count():
		if p_frame.present[sensor] == 0:
			continue
		var turned: Quaternion = p_frame.orientation(sensor).normalized()
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


## The axis in the sensor's global frame, horizontal and of length 1; zero if it hardly turned.
func axis(p_sensor: int) -> Vector3:
	if p_sensor >= _sums.size():
		return Vector3.ZERO
	return Vector3(_sums[p_sensor].x, 0.0, _sums[p_sensor].z).normalized()


## How much it was a turn about one horizontal axis, 0 to 1.
func purity(p_sensor: int) -> float:
	if p_sensor >= _sums.size() or _lengths[p_sensor] <= 0.0:
		return 0.0
	return Vector2(_sums[p_sensor].x, _sums[p_sensor].z).length() / _lengths[p_sensor]


func _add_turn(p_sensor: int, p_turn: Vector3) -> void:
	var angle: float = p_turn.length()
	_most[p_sensor] = maxf(_most[p_sensor], angle)
	if angle > MIN_TURN:
		# Far out the axis is known best: weight by the square of the angle.
		_sums[p_sensor] += p_turn * angle
		_lengths[p_sensor] += angle * angle


func _grow(p_count: int) -> void:
	while _first.size() < p_count:
		_first.append(Quaternion.IDENTITY)
		_heard.append(0)
		_sums.append(Vector3.ZERO)
		_lengths.append(0.0)
		_most.append(0.0)
