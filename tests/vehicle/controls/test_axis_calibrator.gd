extends TestCase
## Finding the axis that somebody moves, among others that only tremble.

var _calibrator: AxisCalibrator = AxisCalibrator.new()


func test_a_wheel_is_found_by_turning_it_left_first() -> void:
	_calibrator.begin(AxisCalibrator.Kind.STEER)
	for raw: float in [0.02, -0.3, -0.95, -0.4, 0.5, 0.9, 0.3, 0.04]:
		_calibrator.take("Wheel", 0, raw)
		_calibrator.take("Wheel", 1, 0.99 + 0.01 * raw)
	equal(_calibrator.device, "Wheel")
	var found: AxisCalibration = _calibrator.result()
	equal(found.axis, 0)
	almost_equal(found.value_of(-0.95), 1.0, 1e-5)
	almost_equal(found.value_of(0.9), -1.0, 1e-5)
	equal(found.value_of(0.04), 0.0)


func test_a_pedal_that_rests_high_is_found() -> void:
	_calibrator.begin(AxisCalibrator.Kind.BRAKE)
	for raw: float in [1.0, 0.2, -0.98, -0.2, 0.99]:
		_calibrator.take("Pedals", 2, raw)
	var found: AxisCalibration = _calibrator.result()
	almost_equal(found.value_of(-0.98), 1.0, 1e-5)
	equal(found.value_of(0.99), 0.0)


func test_what_only_trembles_is_nothing() -> void:
	_calibrator.begin(AxisCalibrator.Kind.THROTTLE)
	is_null(_calibrator.result())
	for raw: float in [0.0, 0.05, -0.05, NAN, 0.02]:
		_calibrator.take("Pedals", 2, raw)
	is_null(_calibrator.result())
	equal(_calibrator.device, "")


func test_a_new_control_begins_without_the_last_one() -> void:
	for raw: float in [0.0, -1.0, 1.0, 0.0]:
		_calibrator.take("Wheel", 0, raw)
	not_null(_calibrator.result())
	_calibrator.begin(AxisCalibrator.Kind.BRAKE)
	is_null(_calibrator.result())
