extends "part.gd"
## Full calibrations of sensors whose norths are apart, by any spread: what is left on each limb.

const Person: GDScript = preload("person.gd")
const _GOAL_DEG: float = 2.5


func measure() -> void:
	var poses: Array[PoseSample] = Person.clip_poses("01_01.bvh", 0.5, 6)
	for spread: float in numbers("norths"):
		for is_normal: bool in [false, true]:
			var left: Statistics = Statistics.new()
			for number: int in arguments.value("rounds"):
				var person: Person = Person.new()
				person.random = generator(number)
				person.dress(PackedInt32Array(range(BodyMounts.COUNT)), spread, is_normal)
				person.feed.soft_tissue_deg = arguments.value("soft")
				person.move_badly(arguments.value("efforts"))
				var result: CalibrationResult = person.calibrate(CalibrationGuide.Kind.FULL)
				left.add(Person.mean(person.errors_deg(result.calibration, poses)))
			var parts: Array = ["normally" if is_normal else "evenly", spread]
			var name: String = "norths spread %s by %.0f deg, full" % parts
			report.at_most(name, "mean of limbs", left.mean(), "deg", _GOAL_DEG)
			report.add(name, "worst wearer", left.percentile(1.0), "deg")
