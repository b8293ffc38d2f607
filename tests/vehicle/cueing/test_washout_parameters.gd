extends TestCase
## What the filter's parameters do, seen from a script.

const _STEP_S: float = 0.005
const _AT_REST: Vector3 = Vector3(0.0, 9.81, 0.0)


func test_braking_tilts_forwards_and_rest_leads_back() -> void:
	var cueing: MotionCueing = _cueing(WashoutParameters.new())
	_run(cueing, _AT_REST, 3.0)
	_run(cueing, _AT_REST + Vector3(0.0, 0.0, 3.0), 4.0)
	almost_equal(rad_to_deg(cueing.get_tilt().x), -8.8, 0.2, "tilt, degrees")
	is_true(cueing.get_position().z > 0.02, "it has gone back")
	_run(cueing, _AT_REST, 30.0)
	almost_equal(cueing.get_position().length() * 1000.0, 0.0, 1.0, "from neutral, mm")
	almost_equal(rad_to_deg(cueing.get_attitude().length()), 0.0, 0.05, "from neutral, degrees")


func test_without_news_and_in_a_pause_it_is_neutral_in_time() -> void:
	for is_pause: bool in [true, false]:
		var cueing: MotionCueing = _cueing(WashoutParameters.new())
		_run(cueing, _AT_REST + Vector3(2.0, 0.0, 0.0), 6.0)
		is_true(cueing.get_attitude().z > 0.05)
		cueing.set_paused(is_pause)
		for _step: int in int(2.25 / _STEP_S):
			cueing.step_without_news(_STEP_S)
		almost_equal(cueing.get_gain(), 0.0, 1e-6, "gain")
		almost_equal(cueing.get_attitude().length(), 0.0, 1e-4, "attitude, rad")


func test_parameters_without_sense_are_refused_by_name() -> void:
	var cueing: MotionCueing = _cueing(WashoutParameters.new())
	expect_error("third pole")
	cueing.set_translation(MotionCueing.DIRECTION_HORIZONTAL, 0.5, 10.0, 4.0, 1.0, 0.0)
	expect_error("order 1 or 2")
	cueing.set_rotation(0.5, 1.0, 1.0, 1.0, 3)
	expect_error("damping ratio")
	cueing.set_tilt(2.5, NAN, 0.05, 0.3)
	expect_error("ramp")
	cueing.set_ramps(0.2, -2.0, 2.0, 1.0)
	expect_error("travel, speed and acceleration")
	cueing.set_translation_limits(Vector3(INF, 0.0, 0.0), Vector3.ONE, Vector3.ONE)
	# The old ones hold on.
	_run(cueing, _AT_REST + Vector3(0.0, 0.0, 3.0), 6.0)
	almost_equal(rad_to_deg(cueing.get_tilt().x), -8.8, 0.2, "tilt, degrees")


func _cueing(p_parameters: WashoutParameters) -> MotionCueing:
	var cueing: MotionCueing = MotionCueing.new()
	MotionPlatform.preset("large_hexapod").apply(cueing)
	p_parameters.apply(cueing)
	return cueing


func _run(p_cueing: MotionCueing, p_force: Vector3, p_seconds: float) -> void:
	for _step: int in roundi(p_seconds / _STEP_S):
		p_cueing.step(p_force, Vector3.ZERO, _STEP_S)
