extends "part.gd"
## Whether the error that a calibration forecasts is the one that it has, for wearers of all sorts:
## norths spread by 0 to 60 degrees, poses off by 0 to 10, soft tissue of 0 to 4, efforts.
##
## Beside it the one number that is nearest to most wearers: all that can be said where the data
## tell nothing.

## Poses of the whole clips are compared, each of which begins with somebody who stands: every so
## many seconds, nine of them.
const _STEPS_S: Dictionary[String, float] = {
	"01_01.bvh": 2.5, "01_03.bvh": 4.1, "Boxing_Toes.bvh": 3.4
}
const _WITHIN_DEG: float = 2.0
const _GOAL: float = 95.0
const _KINDS: Array[CalibrationGuide.Kind] = [
	CalibrationGuide.Kind.FULL,
	CalibrationGuide.Kind.QUICK,
	CalibrationGuide.Kind.T_TO_N,
	CalibrationGuide.Kind.T_POSE,
	CalibrationGuide.Kind.N_POSE,
]


func measure() -> void:
	var poses: Array[PoseSample] = []
	for clip: String in _STEPS_S:
		poses.append_array(Person.clip_poses(clip, _STEPS_S[clip], 9))
	for kind: CalibrationGuide.Kind in _KINDS:
		_measure_kind(kind, false, poses)
	for kind: CalibrationGuide.Kind in _KINDS.slice(2):
		_measure_kind(kind, true, poses)


func _measure_kind(
	p_kind: CalibrationGuide.Kind, p_common: bool, p_poses: Array[PoseSample]
) -> void:
	var offs: PackedFloat64Array = PackedFloat64Array()
	var errors: PackedFloat64Array = PackedFloat64Array()
	var forecast: Statistics = Statistics.new()
	var rounds: int = arguments.value("rounds")
	for number: int in rounds:
		var found: Vector2 = _calibrate(p_kind, _person(generator(number), p_common), p_poses)
		forecast.add(found.y)
		offs.append(found.y - found.x)
		errors.append(found.x)
	var name: String = "forecast, %s" % CalibrationGuide.NAMES[p_kind]
	# Else nothing shows most norths: the forecast is of what is usual.
	var has: bool = p_common or p_kind > CalibrationGuide.Kind.T_TO_N
	if p_common:
		name += ", norths told to be common"
	report.at_least(name, "within 2 deg", _within(offs, 0.0), "%", _GOAL, has)
	report.add(name, "within 2 deg, one number for all", _at_best(errors), "%")
	report.add(name, "error", Person.mean(errors), "deg")
	report.add(name, "error forecast", forecast.mean(), "deg")


## Calibrates; returns the error that there is, and its forecast, degrees.
func _calibrate(
	p_kind: CalibrationGuide.Kind, p_person: Person, p_poses: Array[PoseSample]
) -> Vector2:
	if p_kind < CalibrationGuide.Kind.T_TO_N:
		# Nothing shows the front: the wearer tells it.
		p_person.process.options.facing = CalibrationOptions.Facing.HEADING
		p_person.process.options.heading_deg = -rad_to_deg(p_person.front)
	if p_kind == CalibrationGuide.Kind.QUICK:
		p_person.calibration = p_person.calibrate(CalibrationGuide.Kind.FULL).calibration
		p_person.hold_badly(p_person.random.randf_range(0.0, 10.0), true)
	var result: CalibrationResult = p_person.calibrate(p_kind)
	return Vector2(Person.mean(p_person.errors_deg(result.calibration, p_poses)), result.error_deg)


func _person(p_random: RandomNumberGenerator, p_common: bool) -> Person:
	var person: Person = Person.new()
	person.random = p_random
	var spread: float = 0.0 if p_common else p_random.randf_range(0.0, 60.0)
	var mounts: PackedInt32Array = PackedInt32Array(range(BodyMounts.COUNT))
	if p_common:
		person.process.options.align = CalibrationOptions.Align.COMMON
	person.dress(mounts, spread, p_random.randf() < 0.5)
	person.feed.soft_tissue_deg = p_random.randf_range(0.0, 4.0)
	person.hold_badly(p_random.randf_range(0.0, 10.0), p_random.randf() < 0.5)
	person.askew_deg = p_random.randf_range(0.0, 3.0)
	person.move_badly(p_random.randf_range(0.0, 0.3))
	person.motion.is_hinged = p_random.randf() < 0.5
	return person


## The share of numbers that are near to another one, percent.
static func _within(p_numbers: PackedFloat64Array, p_other: float) -> float:
	var near: int = 0
	for number: float in p_numbers:
		near += 1 if absf(number - p_other) <= _WITHIN_DEG else 0
	return 100.0 * near / p_numbers.size()


## The largest share that is near to any number, percent.
static func _at_best(p_numbers: PackedFloat64Array) -> float:
	var best: float = 0.0
	for number: float in p_numbers:
		# The best one has a number just within its reach.
		best = maxf(best, _within(p_numbers, number + _WITHIN_DEG - 1e-6))
	return best
