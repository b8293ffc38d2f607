extends "part.gd"
## Sensors that were put on in any order: how many one fit check finds, of all permutations.

const _RIGHT: float = 99.0
const _ROUND_S: float = 45.0
## Cases: worn sensors, and others that lie about.
const _CASES: Array[Vector2i] = [
	Vector2i(17, 0), Vector2i(13, 0), Vector2i(10, 0), Vector2i(6, 0), Vector2i(17, 3)
]


func measure() -> void:
	for case: Vector2i in _CASES:
		var mounts: PackedInt32Array = SensorMap.layout(case.x)
		var right: int = 0
		var all: int = 0
		for order: int in arguments.value("orders"):
			var found: int = _find(mounts, case.y, generator(order))
			right += found
			all += case.x + case.y
		var name: String = "%d sensors in any order" % case.x
		if case.y > 0:
			name += " and %d that lie about" % case.y
		report.at_least(name, "sensors found", 100.0 * right / all, "%", _RIGHT)
		var seconds: float = CalibrationGuide.duration_s(CalibrationGuide.Kind.FIT_CHECK, mounts)
		report.at_most(name, "duration", seconds, "s", _ROUND_S)


## How many sensors are found where they are.
func _find(p_mounts: PackedInt32Array, p_spare: int, p_random: RandomNumberGenerator) -> int:
	var person: Person = Person.new()
	person.random = p_random
	var norths: PackedFloat64Array = numbers("norths")
	person.dress(p_mounts.duplicate(), norths[p_random.randi() % norths.size()], false)
	person.feed.soft_tissue_deg = arguments.value("soft")
	person.motion.mounts = p_mounts
	person.move_badly(arguments.value("efforts"))
	for mount: int in p_mounts:
		person.motion.sways_deg[mount] = 2.0
	var truth: PackedInt32Array = p_mounts.duplicate()
	var told: PackedInt32Array = p_mounts.duplicate()
	for spare: int in p_spare:
		var number: int = person.feed.add_sensor(BodyMounts.PELVIS, person.any_rotation())
		person.lie_about.append(number)
		truth.append(-1)
		told.append(-1)
	for at: int in range(told.size() - 1, 0, -1):
		var other: int = p_random.randi() % (at + 1)
		var mount: int = told[at]
		told[at] = told[other]
		told[other] = mount
	person.mounts = told
	var result: CalibrationResult = person.calibrate(CalibrationGuide.Kind.FIT_CHECK)
	var right: int = 0
	for sensor: int in truth.size():
		right += 1 if result.assignment[sensor] == truth[sensor] else 0
	return right
