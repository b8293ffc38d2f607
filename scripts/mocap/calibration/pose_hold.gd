class_name PoseHold
extends RefCounted
## What sensors said while somebody held a pose: the mean of each, and how still it was.

## Movement within such a part of the hold is taken for noise: parts in all.
const PARTS: int = 12
## Distance at which a sample has half its weight in the mean, rad: shocks count for little.
const ROBUST_RAD: float = 0.03
## Samples that are kept of each sensor at most; beyond it every second one goes.
const MOST_SAMPLES: int = 600

var _samples: Array[Array] = []
var _frames: int = 0
var _step: int = 1


## Takes a frame.
func add(p_frame: SensorFrame) -> void:
	while _samples.size() < p_frame.count():
		_samples.append([])
	if _frames % _step == 0:
		for sensor: int in p_frame.count():
			if p_frame.present[sensor] != 0:
				_samples[sensor].append(p_frame.orientation(sensor).normalized())
	_frames += 1
	if _frames / _step >= MOST_SAMPLES:
		_thin()


## How many frames came.
func frames() -> int:
	return _frames


## How many samples of a sensor there are.
func samples(p_sensor: int) -> int:
	return _samples[p_sensor].size() if p_sensor < _samples.size() else 0


## Whether a sensor said enough: in at least half of the frames, and more than once.
func has(p_sensor: int) -> bool:
	return samples(p_sensor) >= maxi(2, _frames / _step / 2)


## The orientation of a sensor during the hold.
func mean(p_sensor: int) -> Quaternion:
	var list: Array[Quaternion] = []
	list.assign(_samples[p_sensor])
	return Rotations.mean(list, ROBUST_RAD)


## By how much a sensor moved during the hold, degrees: the largest angle between what it said in
## any two of its [constant PARTS] parts.
func movement_deg(p_sensor: int) -> float:
	var count: int = samples(p_sensor)
	if count < 2:
		return 0.0
	var parts: Array[Quaternion] = []
	var number: int = mini(PARTS, count)
	for part: int in number:
		var list: Array[Quaternion] = []
		list.assign(_samples[p_sensor].slice(part * count / number, (part + 1) * count / number))
		parts.append(Rotations.mean(list))
	var most: float = 0.0
	for first: int in number:
		for second: int in first:
			most = maxf(most, Rotations.between_deg(parts[first], parts[second]))
	return most


func _thin() -> void:
	_step *= 2
	for sensor: int in _samples.size():
		var kept: Array = []
		for at: int in range(0, _samples[sensor].size(), 2):
			kept.append(_samples[sensor][at])
		_samples[sensor] = kept
