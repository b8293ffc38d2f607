class_name PoseHold
extends RefCounted
## The sensors' orientations while somebody held a pose: the mean of each, and how still it was.

## Number of parts of the hold; movement within one counts as noise.
const PARTS: int = 12
## Parts of the hold whose means make the mean.
const CHUNKS: int = 48
## Distance at which a part has half its weight in the mean, rad: shocks count for little.
const ROBUST_RAD: float = 0.03
## Maximum of samples kept of each sensor; beyond it every second one is dropped.
const MAX_SAMPLES: int = 600

## The pose that was held.
var pose: ResetPose.Kind = ResetPose.Kind.T

var _samples: Array[Array] = []
var _frames: int = 0
var _step: int = 1
var _means: Dictionary[int, Quaternion] = {}


func _init(p_pose: ResetPose.Kind) -> void:
	pose = p_pose


## Takes a frame.
func add(p_frame: SensorFrame) -> void:
	_means.clear()
	while _samples.size() < p_frame.count():
		_samples.append([])
	if _frames % _step == 0:
		for sensor: int in p_frame.count():
			if p_frame.present[sensor] != 0:
				_samples[sensor].append(p_frame.orientation(sensor).normalized())
	_frames += 1
	if _frames / _step >= MAX_SAMPLES:
		_thin()


## How many frames came.
func frames() -> int:
	return _frames


## How many samples of a sensor there are.
func samples(p_sensor: int) -> int:
	return _samples[p_sensor].size() if p_sensor < _samples.size() else 0


## Whether there is enough of a sensor: in at least half of the frames, and more than once.
func has(p_sensor: int) -> bool:
	return samples(p_sensor) >= maxi(2, _frames / _step / 2)


## The orientation of a sensor during the hold.
func mean(p_sensor: int) -> Quaternion:
	if not _means.has(p_sensor):
		_means[p_sensor] = Rotations.mean(_chunks(p_sensor, CHUNKS), ROBUST_RAD)
	return _means[p_sensor]


## By how much a sensor moved during the hold, degrees: the largest angle between what it said in
## any two of its [constant PARTS] parts.
func movement_deg(p_sensor: int) -> float:
	var parts: Array[Quaternion] = _chunks(p_sensor, PARTS)
	var most: float = 0.0
	for first: int in parts.size():
		for second: int in first:
			most = maxf(most, Rotations.between_deg(parts[first], parts[second]))
	return most


## The samples of a sensor in so many parts, each replaced by its mean: within one they are so near
## to each other that the mean of the components does.
func _chunks(p_sensor: int, p_number: int) -> Array[Quaternion]:
	var list: Array = _samples[p_sensor] if p_sensor < _samples.size() else []
	var number: int = mini(p_number, list.size())
	var found: Array[Quaternion] = []
	for part: int in number:
		var start: int = part * list.size() / number
		var first: Quaternion = list[start]
		var sum: Quaternion = first
		for at: int in range(start + 1, (part + 1) * list.size() / number):
			var sample: Quaternion = list[at]
			sum = sum + sample if sample.dot(first) > 0.0 else sum - sample
		found.append(sum.normalized() if sum.length_squared() > 1e-6 else first)
	return found


func _thin() -> void:
	_step *= 2
	for sensor: int in _samples.size():
		var kept: Array = []
		for at: int in range(0, _samples[sensor].size(), 2):
			kept.append(_samples[sensor][at])
		_samples[sensor] = kept
