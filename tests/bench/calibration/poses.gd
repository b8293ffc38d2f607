extends "part.gd"
## Full calibrations of wearers whose poses are off, T and N each in its own way: what is left.

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
	for off: float in numbers("poses"):
		for case: Array in _CASES:
			var hold: Callable = func(person: Person) -> void:
				person.hold_badly(off, case[2])
				person.motion.is_hinged = case[1]
			for spread: float in [0.0, 40.0]:
				var left: Statistics = calibrate_fully(spread, false, hold)
				var name: String = "poses off by %.0f deg%s, norths %.0f, full"
				name %= [off, case[0], spread]
				report.at_most(name, "mean of limbs", left.mean(), "deg", _GOAL_DEG)
