extends "part.gd"
## Full calibrations of sensors whose norths are apart, by any spread: what is left on each limb.

const _GOAL_DEG: float = 2.5


func measure() -> void:
	for spread: float in numbers("norths"):
		for is_normal: bool in [false, true]:
			var left: Statistics = calibrate_fully(spread, is_normal)
			var parts: Array = ["normally" if is_normal else "evenly", spread]
			var name: String = "norths spread %s by %.0f deg, full" % parts
			report.at_most(name, "mean of limbs", left.mean(), "deg", _GOAL_DEG)
