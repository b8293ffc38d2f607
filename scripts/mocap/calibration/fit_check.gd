class_name FitCheck
extends RefCounted
## Finds on which mount each sensor is worn, from how far it turned in which movement: all at once,
## however they were put on.
##
## It needs no calibration and no common north: only how far a sensor turned counts. Each movement
## of [GuideMovements] turns some mounts much and others hardly; the mounts are given to the sensors
## so that all of them together fit best ([BestAssignment]). How large each movement was made is
## found on the way, from those that did it.

## Usual deviation of people from a movement: degrees, and share of the movement. The first share
## holds until it is known how large the movement was made.
const SPREAD_DEG: float = 4.0
const SPREAD_PART: float = 0.14
const FIRST_PART: float = 0.3
## Usual unrest of a person who stands still, degrees.
const STILL_DEG: float = 3.0
## Greatest cost of one movement: a wearer may get one wrong.
const WORST: float = 8.0
## Cost of not being worn: a sensor that moves like no mount counts as one that lies still.
const UNWORN: float = 9.0
## Least improvement over the present assignment.
const BETTER: float = 0.5
## Certainty below which a sensor is named, as a probability.
const SURE: float = 0.9
## Smallest and largest part of a movement that people make of it.
const MIN_EFFORT: float = 0.5
const MAX_EFFORT: float = 1.6
## What [method MotionAxis.swing] is of a turn that is made and taken back.
const SWING: float = 0.85
## Rounds of finding how large movements were made.
const ROUNDS: int = 3

var _mounts: PackedInt32Array = PackedInt32Array()
var _axes: Dictionary[GuideMovements.Movement, MotionAxis] = {}
var _better: float = BETTER
# Sensors that were heard, and mounts that are worn.
var _sensors: PackedInt32Array = PackedInt32Array()
var _places: PackedInt32Array = PackedInt32Array()
var _efforts: Dictionary[GuideMovements.Movement, float] = {}
var _costs: PackedFloat64Array = PackedFloat64Array()


## Takes the present mount of each sensor (-1: none), the movements, and by how much an assignment
## must fit better than the present one.
func _init(
	p_mounts: PackedInt32Array,
	p_axes: Dictionary[GuideMovements.Movement, MotionAxis],
	p_better: float = BETTER
) -> void:
	_mounts = p_mounts
	_axes = p_axes
	_better = p_better
	for sensor: int in p_mounts.size():
		if _was_heard(sensor):
			_sensors.append(sensor)
			if p_mounts[sensor] >= 0:
				_places.append(p_mounts[sensor])


## The result of the movements: the mount of each sensor, and advice.
static func judge(
	p_sensors: Array[SensorInfo],
	p_mounts: PackedInt32Array,
	p_axes: Dictionary[GuideMovements.Movement, MotionAxis]
) -> CalibrationResult:
	var result: CalibrationResult = CalibrationResult.new()
	var check: FitCheck = FitCheck.new(p_mounts, p_axes)
	for sensor: int in p_sensors.size():
		if p_mounts[sensor] < 0:
			continue
		var quality: CalibrationResult.PlaceQuality = CalibrationResult.PlaceQuality.new()
		quality.mount = p_mounts[sensor]
		quality.sensor = p_sensors[sensor].id
		quality.is_missing = not check._was_heard(sensor)
		result.mounts.append(quality)
	result.present = p_mounts
	result.assignment = check.assign()
	result.confidences = check.confidences(result.assignment)
	result.advice = advice(result)
	for sensor: int in p_mounts.size():
		var is_lost: bool = p_mounts[sensor] >= 0 and result.assignment[sensor] < 0
		if is_lost and not result.assignment.has(p_mounts[sensor]):
			var title: String = BodyMounts.title(p_mounts[sensor])
			result.advice.append("%s did not move as asked: is its sensor there?" % title)
		elif result.assignment[sensor] >= 0 and result.confidences[sensor] < SURE:
			var title: String = BodyMounts.title(result.assignment[sensor])
			result.advice.append("it is not sure that %s is there: check again" % title)
	result.judge()
	return result


## The advice on sensors that are worn elsewhere: exchanges of two by name, everything else as a
## list.
static func advice(p_result: CalibrationResult) -> PackedStringArray:
	var found: PackedStringArray = []
	var moved: PackedStringArray = []
	for sensor: int in p_result.present.size():
		var now: int = p_result.present[sensor]
		var wanted: int = p_result.assignment[sensor]
		if now == wanted or wanted < 0:
			continue
		var there: int = p_result.present.find(wanted)
		if there >= 0 and p_result.assignment[there] == now:
			if now < wanted:
				found.append(describe(Vector2i(now, wanted)))
		elif now >= 0:
			moved.append("%s (was %s)" % [BodyMounts.title(wanted), BodyMounts.title(now)])
		else:
			moved.append("%s (was not worn)" % BodyMounts.title(wanted))
	if not moved.is_empty():
		found.append("sensors are worn elsewhere: " + ", ".join(moved))
	return found


## The advice on an exchange of two mounts.
static func describe(p_swap: Vector2i) -> String:
	var names: Array = [BodyMounts.title(p_swap.x), BodyMounts.title(p_swap.y)]
	return "%s and %s look swapped" % names


## The mount of each sensor that fits best, -1 for those that do what no mount does. Sensors that
## were not heard keep theirs.
func assign() -> PackedInt32Array:
	var found: PackedInt32Array = _mounts.duplicate()
	if _sensors.is_empty():
		return found
	var columns: PackedInt32Array = PackedInt32Array()
	for pass_number: int in ROUNDS:
		_fill_costs(FIRST_PART if pass_number == 0 else SPREAD_PART)
		columns = BestAssignment.find(_costs, _sensors.size(), _columns())
		_learn_efforts(columns)
	for at: int in _sensors.size():
		found[_sensors[at]] = _places[columns[at]] if columns[at] < _places.size() else -1
	return found


## How sure an assignment of [method assign] is, for each sensor, 0 to 1: how much worse everything
## would fit if that sensor were elsewhere (the costs are half squares of normal deviations).
func confidences(p_assignment: PackedInt32Array) -> PackedFloat32Array:
	var found: PackedFloat32Array = PackedFloat32Array()
	found.resize(p_assignment.size())
	var best: PackedInt32Array = BestAssignment.find(_costs, _sensors.size(), _columns())
	var total: float = _total(best)
	for at: int in _sensors.size():
		var cell: int = at * _columns() + best[at]
		var cost: float = _costs[cell]
		_costs[cell] = 1e6
		if best[at] >= _places.size():
			for column: int in range(_places.size(), _columns()):
				_costs[at * _columns() + column] += 1e6
		var other: float = _total(BestAssignment.find(_costs, _sensors.size(), _columns()))
		if best[at] >= _places.size():
			for column: int in range(_places.size(), _columns()):
				_costs[at * _columns() + column] -= 1e6
		_costs[cell] = cost
		found[_sensors[at]] = 1.0 / (1.0 + exp(-(other - total)))
	return found


func _columns() -> int:
	return _places.size() + _sensors.size()


func _total(p_columns: PackedInt32Array) -> float:
	var sum: float = 0.0
	for at: int in p_columns.size():
		sum += _costs[at * _columns() + p_columns[at]]
	return sum


## The cost of each sensor on each mount, and of not being worn.
func _fill_costs(p_part: float) -> void:
	_costs.resize(_sensors.size() * _columns())
	for at: int in _sensors.size():
		var row: int = at * _columns()
		for place: int in _places.size():
			_costs[row + place] = _misfit(_sensors[at], _places[place], p_part)
			if _mounts[_sensors[at]] != _places[place]:
				_costs[row + place] += _better / 2.0
		var unworn: float = _misfit(_sensors[at], -1, p_part) + UNWORN
		for column: int in range(_places.size(), _columns()):
			_costs[row + column] = unworn


## How large movements were made, by those who made them.
func _learn_efforts(p_columns: PackedInt32Array) -> void:
	for movement: GuideMovements.Movement in _axes:
		var products: float = 0.0
		var squares: float = 0.0
		for at: int in _sensors.size():
			if p_columns[at] >= _places.size():
				continue
			var wanted: float = _wanted_deg(movement, _places[p_columns[at]])
			products += wanted * rad_to_deg(_axes[movement].swing(_sensors[at]))
			squares += wanted * wanted
		# As asked, as long as hardly anybody shows it.
		var prior: float = 15.0 ** 2
		var effort: float = (products + prior) / (squares + prior)
		_efforts[movement] = clampf(effort, MIN_EFFORT, MAX_EFFORT)


func _was_heard(p_sensor: int) -> bool:
	for movement: GuideMovements.Movement in _axes:
		if _axes[movement].was_heard(p_sensor):
			return true
	return false


static func _wanted_deg(p_movement: GuideMovements.Movement, p_mount: int) -> float:
	var part: float = 1.0 if GuideMovements.is_passage(p_movement) else SWING
	return part * GuideMovements.turn_deg(p_movement, p_mount).length() if p_mount >= 0 else 0.0


## How badly a sensor's turns fit those of a mount, or of one that lies still (-1): 0 is as asked.
func _misfit(p_sensor: int, p_mount: int, p_part: float) -> float:
	var sum: float = 0.0
	for movement: GuideMovements.Movement in _axes:
		var wanted: float = _wanted_deg(movement, p_mount) * _efforts.get(movement, 1.0)
		var got: float = rad_to_deg(_axes[movement].swing(p_sensor))
		var off: float = maxf(absf(got - wanted) - STILL_DEG, 0.0)
		off /= SPREAD_DEG + p_part * wanted
		sum += minf(off * off / 2.0, WORST)
	return sum
