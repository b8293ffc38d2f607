extends TestCase
## The body turns slowly enough to be unseen and quickly enough to be right.

const STEP_S: float = 1.0 / 60.0

var _heading: HeadingCorrection = HeadingCorrection.new()


func test_rates_go_by_what_the_wearer_does() -> void:
	# Speed m/s, turn rad/s: greatest rate, deg/s.
	for case: Array in [[0.0, 0.0, 0.5], [1.3, 0.0, 2.0], [0.0, 1.0, 5.0], [1.3, 0.35, 2.0]]:
		_heading = HeadingCorrection.new()
		_heading.advance(0.0, STEP_S)
		var last: float = _heading.angle
		var fastest: float = 0.0
		for _step: int in 600:
			_heading.note_motion(case[0], case[1], STEP_S)
			_heading.advance(2.0, STEP_S)
			fastest = maxf(fastest, (_heading.angle - last) / STEP_S)
			last = _heading.angle
		almost_equal(rad_to_deg(fastest), case[2], 0.05, str(case))


func test_it_does_not_overshoot_whatever_the_error() -> void:
	for error_deg: float in [1.0, 30.0, -90.0, 179.0]:
		_heading = HeadingCorrection.new()
		_heading.advance(0.0, STEP_S)
		for _step: int in 60 * 400:
			_heading.advance(deg_to_rad(error_deg), STEP_S)
			is_true(absf(_heading.angle) <= deg_to_rad(absf(error_deg)) + 1e-4)
		almost_equal(_heading.angle, deg_to_rad(error_deg), 1e-3)


func test_steady_drift_lags_by_less_than_a_degree() -> void:
	_heading.advance(0.0, STEP_S)
	for step: int in 60 * 600:
		_heading.advance(wrapf(deg_to_rad(0.05) * step * STEP_S, -PI, PI), STEP_S)
	almost_equal(angle_difference(_heading.angle, deg_to_rad(30.0)), 0.0, deg_to_rad(0.8))


func test_looking_at_the_ground_keeps_it() -> void:
	_heading.advance(0.5, STEP_S)
	for _step: int in 600:
		_heading.advance(NAN, STEP_S)
	almost_equal(_heading.angle, 0.5, 1e-6)
	is_true(_heading.is_known())
	_heading.restart()
	is_false(_heading.is_known())
	_heading.advance(-1.0, STEP_S)
	almost_equal(_heading.angle, -1.0, 1e-6)
