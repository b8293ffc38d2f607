extends TestCase
## What counts as shaking and as a jolt.

const _STEP_S: float = 1.0 / 60.0
const _AT_REST: Vector3 = Vector3(0.0, 9.81, 0.0)


func test_bumps_shake_and_a_hill_does_not() -> void:
	var meter: ShakeMeter = ShakeMeter.new()
	for number: int in 120:
		meter.advance(_STEP_S, _AT_REST + Vector3(0.0, 3.0 * sin(number * 1.1), 0.0))
	almost_equal(meter.shaking, 2.1, 0.4, "m/s²")
	for number: int in 240:
		meter.advance(_STEP_S, _AT_REST.rotated(Vector3.RIGHT, number * 0.001))
	almost_equal(meter.shaking, 0.0, 0.05, "m/s²")
	equal(meter.jolt, Vector3.ZERO)


func test_a_hit_is_a_jolt_that_fades() -> void:
	var meter: ShakeMeter = ShakeMeter.new()
	for _number: int in 60:
		meter.advance(_STEP_S, _AT_REST)
	meter.advance(_STEP_S, _AT_REST + Vector3(0.0, 0.0, 40.0))
	is_true(meter.jolt.z > 30.0)
	for _number: int in 60:
		meter.advance(_STEP_S, _AT_REST)
	almost_equal(meter.jolt.length(), 0.0, 0.1, "m/s²")
	meter.kick(Vector3(5.0, 0.0, 0.0))
	almost_equal(meter.jolt.x, 5.0, 0.1, "m/s²")
	meter.kick(Vector3(NAN, 0.0, 0.0))
	meter.advance(_STEP_S, Vector3(INF, 0.0, 0.0))
	is_true(meter.jolt.is_finite() and is_finite(meter.shaking))
	meter.clear()
	equal(meter.jolt, Vector3.ZERO)
