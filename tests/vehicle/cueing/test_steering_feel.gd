extends TestCase
## What a steering wheel does as the vehicle goes.

var _feel: SteeringFeel = SteeringFeel.new()


func test_the_spring_grows_with_speed_and_the_damper_falls() -> void:
	var springs: PackedFloat64Array = []
	var dampers: PackedFloat64Array = []
	for speed: float in [0.0, 1.0, 3.0, 6.0, 20.0]:
		springs.append(_feel.spring(speed))
		dampers.append(_feel.damper(speed))
	for number: int in 4:
		is_true(springs[number] < springs[number + 1])
		is_true(dampers[number] > dampers[number + 1])
	almost_equal(springs[3], 0.5 * (_feel.spring_at_rest + _feel.spring_at_speed), 1e-6, "half way")
	almost_equal(_feel.spring(-6.0), springs[3], 1e-6, "backwards as well")


func test_cornering_pulls_back_and_the_end_stops_push_back() -> void:
	is_true(_feel.constant(0.0, 3.0, 0.0) < -0.05, "a turn to the right pulls to the left")
	almost_equal(_feel.constant(0.0, -3.0, 0.0), -_feel.constant(0.0, 3.0, 0.0), 1e-6)
	almost_equal(_feel.constant(0.9, 0.0, 0.0), 0.0, 1e-6, "before the stop")
	almost_equal(_feel.constant(1.0, 0.0, 0.0), -_feel.end_stop_force, 1e-6, "at its end")
	almost_equal(_feel.constant(-1.0, 0.0, 0.0), _feel.end_stop_force, 1e-6)
	is_true(_feel.constant(0.0, 0.0, 20.0) > 0.1, "a jolt to the right")
	for force: float in [-1e6, 1e6]:
		is_true(absf(_feel.constant(1.0, force, -force)) <= 1.0)


func test_bumps_are_felt_at_the_rhythm_of_the_links() -> void:
	almost_equal(_feel.frequency(4.0), 25.0, 1e-6, "Hz")
	almost_equal(_feel.frequency(0.0), _feel.frequencies.x, 1e-6, "Hz")
	almost_equal(_feel.frequency(100.0), _feel.frequencies.y, 1e-6, "Hz")
	almost_equal(_feel.vibration(0.0, false), 0.0, 1e-6)
	is_true(_feel.vibration(0.0, true) > 0.0)
	is_true(_feel.vibration(3.0, true) > _feel.vibration(1.0, true))
	almost_equal(_feel.vibration(1e3, true), 1.0, 1e-6)
