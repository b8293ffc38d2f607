extends TestCase
## Axes of wheels and pedals: rest, ends, dead zone, and what files may hold.


func test_a_wheel_goes_from_end_to_end() -> void:
	var wheel: AxisCalibration = _make(0.1, -0.9, 0.8)
	equal(wheel.value_of(0.1), 0.0)
	almost_equal(wheel.value_of(-0.9), 1.0, 1e-6)
	almost_equal(wheel.value_of(0.8), -1.0, 1e-6)
	almost_equal(wheel.value_of(2.0), -1.0, 1e-6, "beyond the end")
	almost_equal(wheel.value_of(-0.4), 0.4845, 1e-3)


func test_a_pedal_rests_at_either_end() -> void:
	for rest: float in [-1.0, 1.0]:
		var pedal: AxisCalibration = _make(rest, -rest, rest)
		equal(pedal.value_of(rest), 0.0)
		almost_equal(pedal.value_of(-rest), 1.0, 1e-6)
		equal(pedal.value_of(2.0 * rest), 0.0, "beyond rest")


func test_nothing_happens_in_the_dead_zone_and_nothing_jumps_behind_it() -> void:
	var wheel: AxisCalibration = _make(0.0, 1.0, -1.0)
	wheel.dead_zone = 0.2
	equal(wheel.value_of(0.19), 0.0)
	is_true(wheel.value_of(0.21) < 0.02)
	almost_equal(wheel.value_of(1.0), 1.0, 1e-6)
	equal(wheel.value_of(NAN), 0.0)
	equal(wheel.value_of(INF), 0.0)


func test_it_comes_back_from_a_file_and_damage_is_refused() -> void:
	var wheel: AxisCalibration = _make(0.1, -0.9, 0.8)
	wheel.axis = 3
	equal(AxisCalibration.from_array(wheel.to_array()).to_array(), wheel.to_array())
	for damaged: Variant in [
		null,
		"",
		[],
		[0, 0.0, 1.0, -1.0],
		[0, 0.0, "1", -1.0, 0.0],
		[-1, 0.0, 1.0, -1.0, 0.0],
		[99, 0.0, 1.0, -1.0, 0.0],
		[0, NAN, 1.0, -1.0, 0.0],
		[0, 0.0, 0.01, -1.0, 0.0],
		[0, 0.0, 1.0, -1.0, 0.9],
	]:
		is_null(AxisCalibration.from_array(damaged), str(damaged))


func _make(p_rest: float, p_high: float, p_low: float) -> AxisCalibration:
	var made: AxisCalibration = AxisCalibration.new()
	made.rest = p_rest
	made.high = p_high
	made.low = p_low
	return made
