extends "part.gd"
## Whether the error that a calibration forecasts is the one that it has, for wearers of all sorts:
## norths spread by 0 to 60 degrees, poses off by 0 to 10, soft tissue of 0 to 4, efforts.

const Person: GDScript = preload("person.gd")
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
	for clip: String in ["01_01.bvh", "01_03.bvh", "Boxing_Toes.bvh"]:
		poses.append_array(Person.clip_poses(clip, 0.9, 3))
	for kind: CalibrationGuide.Kind in _KINDS:
		_measure_kind(kind, false, poses)
	for kind: CalibrationGuide.Kind in _KINDS.slice(2):
		_measure_kind(kind, true, poses)


func _measure_kind(
	p_kind: CalibrationGuide.Kind, p_common: bool, p_poses: Array[PoseSample]
) -> void:
	var off: Statistics = Statistics.new()
	var truth: Statistics = Statistics.new()
	var forecast: Statistics = Statistics.new()
	var within: int = 0
	var rounds: int = arguments.value("rounds")
	for number: int in rounds:
		var person: Person = _person(generator(number), p_common)
		if p_kind < CalibrationGuide.Kind.T_TO_N:
			# Nothing shows the front: the wearer tells it.
			person.process.options.facing = CalibrationOptions.Facing.HEADING
			person.process.options.heading_deg = -rad_to_deg(person.front)
		if p_kind == CalibrationGuide.Kind.QUICK:
			person.calibration = person.calibrate(CalibrationGuide.Kind.FULL).calibration
			person.hold_badly(person.random.randf_range(0.0, 10.0), true)
		var result: CalibrationResult = person.calibrate(p_kind)
		var error: float = Person.mean(person.errors_deg(result.calibration, p_poses))
		if arguments.value("details"):
			var parts: Array = [number, person.norths_deg, error, result.error_deg]
			print("%d, norths spread by %.0f deg: %.2f deg, forecast %.2f" % parts)
		truth.add(error)
		forecast.add(result.error_deg)
		off.add(result.error_deg - error)
		within += 1 if absf(result.error_deg - error) <= _WITHIN_DEG else 0
	var name: String = "forecast, %s" % CalibrationGuide.NAMES[p_kind]
	var goal: BenchReport.Goal = BenchReport.Goal.AT_LEAST
	if p_common:
		name += ", norths told to be common"
	elif p_kind <= CalibrationGuide.Kind.T_TO_N:
		# Nothing shows most norths: the forecast is of what is usual.
		goal = BenchReport.Goal.NONE
	report.add(name, "within 2 deg", 100.0 * within / rounds, "%", goal, _GOAL)
	report.add(name, "error", truth.mean(), "deg")
	report.add(name, "error forecast", forecast.mean(), "deg")
	report.add(name, "forecast off, p5", off.percentile(0.05), "deg")
	report.add(name, "forecast off, p95", off.percentile(0.95), "deg")


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
