extends TestCase
## Feet stand until the weight has moved, and do not cross.

const STEP_S: float = 1.0 / 60.0

var _steps: StepPlanner = StepPlanner.new(0.09)


func test_nobody_steps_who_sways() -> void:
	_steps.restart(Vector3.ZERO, 0.0)
	var places: PackedVector3Array = _steps.places.duplicate()
	for step: int in 600:
		var sway: Vector3 = Vector3(sin(step * 0.05), 0.9, cos(step * 0.03)) * 0.04
		_steps.advance(sway, sin(step * 0.02) * 0.1, Vector3(0.02, 0, 0), STEP_S)
	equal(_steps.places, places)


func test_a_walk_at_any_speed_and_to_any_side() -> void:
	for speed: float in [0.4, 0.9, 1.4, 2.0]:
		for way: Vector3 in [Vector3.BACK, Vector3.FORWARD, Vector3.RIGHT, Vector3(1, 0, 1)]:
			_walk(way.normalized() * speed)


func test_turning_on_the_spot_turns_the_feet() -> void:
	_steps = StepPlanner.new(0.09)
	_steps.restart(Vector3.ZERO, 0.0)
	for step: int in 600:
		_steps.advance(Vector3.ZERO, minf(step * 0.01, 3.0), Vector3.ZERO, STEP_S)
	for side: int in 2:
		is_true(absf(angle_difference(_steps.yaws[side], 3.0)) < 0.3, str(_steps.yaws))
		is_true(_steps.places[side].length() < 0.2)


func test_after_a_walk_the_feet_close() -> void:
	_steps.restart(Vector3.ZERO, 0.0)
	for step: int in 120:
		_steps.advance(Vector3(0, 0, step * 0.02), 0.0, Vector3(0, 0, 1.2), STEP_S)
	for _step: int in 300:
		_steps.advance(Vector3(0, 0, 2.4), 0.0, Vector3.ZERO, STEP_S)
	for side: int in 2:
		var off: float = _steps.places[side].distance_to(_steps.home(side, Vector3(0, 0, 2.4), 0.0))
		is_true(off < 0.08, "%f m" % off)


func _walk(p_velocity: Vector3) -> void:
	_steps = StepPlanner.new(0.09)
	_steps.restart(Vector3.ZERO, 0.0)
	var counts: PackedInt32Array = [0, 0]
	var stood: Array[bool] = [true, true]
	var note: String = str(p_velocity)
	for step: int in 600:
		var before: PackedVector3Array = _steps.places.duplicate()
		var hips: Vector3 = p_velocity * step * STEP_S
		_steps.advance(hips, 0.0, p_velocity, STEP_S)
		is_true(_steps.stands(0) or _steps.stands(1), note + ": never both in the air")
		for side: int in 2:
			if stood[side] and _steps.stands(side):
				equal(_steps.places[side], before[side], note + ": no sliding")
			counts[side] += 1 if stood[side] and not _steps.stands(side) else 0
			stood[side] = _steps.stands(side)
			var off: float = _steps.places[side].distance_to(Vector3(hips.x, 0, hips.z))
			is_true(off < 0.35 + 0.35 * p_velocity.length(), "%s: %f m away" % [note, off])
		var apart: float = _steps.places[0].x - _steps.places[1].x
		is_true(apart > 0.0, "%s: crossed by %f" % [note, apart])
	is_true(absi(counts[0] - counts[1]) <= 1 or p_velocity.x != 0.0, "feet take turns")
	is_true(counts[0] > 4, "%s: %d steps" % [note, counts[0]])
