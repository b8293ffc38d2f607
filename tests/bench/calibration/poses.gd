extends "part.gd"
## Full calibrations of wearers whose poses are off, T and N each in its own way: what is left.

const Person: GDScript = preload("person.gd")
const _GOAL_DEG: float = 3.0
## Cases: name, whether movements go about axes of the limbs, and whether a pose that is held again
## is off in another way.
const _CASES: Array[Array] = [
	["", false, false],
	[", limbs' own axes", true, false],
	[", off anew each time", false, true],
	[", limbs' own axes, off anew each time", true, true],
]


func measure() -> void:
	var poses: Array[PoseSample] = Person.clip_poses("01_01.bvh", 0.5, 6)
	for off: float in numbers("poses"):
		for case: Array in _CASES:
			for spread: float in [0.0, 40.0]:
				_measure_case(off, case, spread, poses)


func _measure_case(
	p_off_deg: float, p_case: Array, p_norths: float, p_poses: Array[PoseSample]
) -> void:
	var left: Statistics = Statistics.new()
	for number: int in arguments.value("rounds"):
		var person: Person = Person.new()
		person.random = generator(number)
		person.dress(PackedInt32Array(range(BodyMounts.COUNT)), p_norths, false)
		person.feed.soft_tissue_deg = arguments.value("soft")
		person.hold_badly(p_off_deg, p_case[2])
		person.move_badly(arguments.value("efforts"))
		person.motion.is_hinged = p_case[1]
		var result: CalibrationResult = person.calibrate(CalibrationGuide.Kind.FULL)
		left.add(Person.mean(person.errors_deg(result.calibration, p_poses)))
	var name: String = "poses off by %.0f deg%s, norths %.0f, full"
	name %= [p_off_deg, p_case[0], p_norths]
	report.at_most(name, "mean of limbs", left.mean(), "deg", _GOAL_DEG)
