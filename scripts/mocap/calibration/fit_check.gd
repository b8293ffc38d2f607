class_name FitCheck
extends RefCounted
## Finds sensors that are not where they should be, from how far each turned in which movement.
##
## It needs no calibration and no common north: only angles count. Each movement of
## [GuideMovements] turns some mounts much and others hardly; two sensors look exchanged if what
## they did fits much better when they are.

## Usual deviation of people from a movement: degrees, and share of the movement.
const SPREAD_DEG: float = 5.0
const SPREAD_PART: float = 0.3
## Nobody stands quite still, degrees.
const STILL_DEG: float = 6.0
## Maximum that one movement counts: somebody may get one wrong.
const MAX: float = 6.0
## Minimum by which an exchange must fit better.
const BETTER: float = 2.0
## Mounts that do nothing of what they should fit by less than this.
const ODD: float = 8.0


## The result of the movements: swaps and advice.
static func judge(
	p_sensors: Array[SensorInfo],
	p_mounts: PackedInt32Array,
	p_axes: Dictionary[GuideMovements.Movement, MotionAxis]
) -> CalibrationResult:
	var result: CalibrationResult = CalibrationResult.new()
	for sensor: int in p_sensors.size():
		if p_mounts[sensor] < 0:
			continue
		var quality: CalibrationResult.PlaceQuality = CalibrationResult.PlaceQuality.new()
		quality.mount = p_mounts[sensor]
		quality.sensor = p_sensors[sensor].id
		quality.is_missing = not _was_heard(sensor, p_axes)
		result.mounts.append(quality)
	result.judge()
	result.swaps = find_swaps(p_mounts, p_axes)
	var named: PackedInt32Array = []
	for swap: Vector2i in result.swaps:
		result.advice.insert(0, describe(swap))
		named.append_array([swap.x, swap.y])
	for sensor: int in p_mounts.size():
		var mount: int = p_mounts[sensor]
		if mount >= 0 and not named.has(mount) and _was_heard(sensor, p_axes):
			var misfit: float = _misfit(sensor, mount, p_axes)
			if misfit > ODD:
				var title: String = BodyMounts.title(mount)
				result.advice.append("%s did not move as asked: is its sensor there?" % title)
	return result


## The advice on an exchange.
static func describe(p_swap: Vector2i) -> String:
	var names: Array = [BodyMounts.title(p_swap.x), BodyMounts.title(p_swap.y)]
	return "%s and %s look swapped" % names


## Pairs of mounts whose sensors did what the other one should, and fit better by so much when they
## are exchanged; those that are surest first, and each mount in one at most.
static func find_swaps(
	p_mounts: PackedInt32Array,
	p_axes: Dictionary[GuideMovements.Movement, MotionAxis],
	p_better: float = BETTER
) -> Array[Vector2i]:
	var gains: Array[Vector3] = []
	for first: int in p_mounts.size():
		for second: int in first:
			if p_mounts[first] < 0 or p_mounts[second] < 0:
				continue
			if not (_was_heard(first, p_axes) and _was_heard(second, p_axes)):
				continue
			var now: float = _misfit(first, p_mounts[first], p_axes)
			now += _misfit(second, p_mounts[second], p_axes)
			# Movements that turn both mounts alike weigh the same before and after.
			var other: float = _misfit(first, p_mounts[second], p_axes)
			other += _misfit(second, p_mounts[first], p_axes)
			if now - other > p_better:
				gains.append(Vector3(now - other, p_mounts[second], p_mounts[first]))
	gains.sort_custom(func(a: Vector3, b: Vector3) -> bool: return a.x > b.x)
	var swaps: Array[Vector2i] = []
	var taken: PackedInt32Array = []
	for gain: Vector3 in gains:
		var pair: Vector2i = Vector2i(
			mini(int(gain.y), int(gain.z)), maxi(int(gain.y), int(gain.z))
		)
		if not taken.has(pair.x) and not taken.has(pair.y):
			swaps.append(pair)
			taken.append_array([pair.x, pair.y])
	return swaps


static func _was_heard(
	p_sensor: int, p_axes: Dictionary[GuideMovements.Movement, MotionAxis]
) -> bool:
	for movement: GuideMovements.Movement in p_axes:
		if p_axes[movement].was_heard(p_sensor):
			return true
	return false


## How badly a sensor's turns fit those of a mount: 0 is as asked.
static func _misfit(
	p_sensor: int, p_mount: int, p_axes: Dictionary[GuideMovements.Movement, MotionAxis]
) -> float:
	var sum: float = 0.0
	for movement: GuideMovements.Movement in p_axes:
		var wanted: float = GuideMovements.turn_deg(movement, p_mount).length()
		var got: float = rad_to_deg(p_axes[movement].turn(p_sensor))
		var off: float = maxf(absf(got - wanted) - STILL_DEG, 0.0)
		off /= SPREAD_DEG + SPREAD_PART * wanted
		sum += minf(off * off, MAX)
	return sum
