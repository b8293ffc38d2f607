extends TestCase
## How a gamepad shakes.

var _feel: RumbleFeel = RumbleFeel.new()


func test_the_engine_is_in_the_weak_motor() -> void:
	var state: VehicleState = VehicleState.new()
	equal(_feel.weak(state), 0.0, "it is off")
	equal(_feel.weak(null), 0.0, "nothing is known")
	state.engine_on = true
	state.rpm = 800.0
	var idle: float = _feel.weak(state)
	is_true(idle > 0.0)
	state.rpm = 2600.0
	state.load = 1.0
	is_true(_feel.weak(state) > idle + 0.1)
	state.rpm = 1e9
	state.load = 1e9
	is_true(_feel.weak(state) <= 1.0)


func test_bumps_and_jolts_are_in_the_strong_motor() -> void:
	equal(_feel.strong(0.3, 0.0), 0.0, "level ground")
	is_true(_feel.strong(2.0, 0.0) > 0.0)
	is_true(_feel.strong(5.0, 0.0) > _feel.strong(2.0, 0.0))
	equal(_feel.strong(0.0, 100.0), 1.0, "a gun")
	equal(_feel.strong(1e6, -1e6), 1.0)
