extends TestCase
## What reaches the hands. There is no gamepad and no wheel here: the engine's own record of what a
## gamepad was told is read, and the wheel says that it is missing. C++ tests play a wheel.

const _PAD: int = 3

var _seat: Node3D = null
var _forces: ForceFeedback = null


func before_each() -> void:
	_seat = Node3D.new()
	add_child(_seat)
	_forces = ForceFeedback.new()
	_forces.gamepad = _PAD
	_forces.seat = _seat
	_forces.state = VehicleState.new()


func test_an_engine_that_runs_is_felt_until_the_seat_is_left() -> void:
	add_child(_forces)
	await _rumble_is(func(told: Vector2) -> bool: return told == Vector2.ZERO)
	_forces.state.engine_on = true
	_forces.state.rpm = 1500.0
	is_true(await _rumble_is(func(told: Vector2) -> bool: return told.x > 0.05), "engine")
	_forces.kick(Vector3(0.0, 0.0, 60.0))
	is_true(await _rumble_is(func(told: Vector2) -> bool: return told.y > 0.5), "recoil")
	_forces.seat = null
	is_true(await _rumble_is(func(told: Vector2) -> bool: return told == Vector2.ZERO), "left")


func test_a_pause_is_still() -> void:
	_forces.state.engine_on = true
	add_child(_forces)
	is_true(await _rumble_is(func(told: Vector2) -> bool: return told.x > 0.0), "engine")
	get_tree().paused = true
	var is_still: bool = await _rumble_is(func(told: Vector2) -> bool: return told == Vector2.ZERO)
	get_tree().paused = false
	is_true(is_still)


func test_a_wheel_that_is_not_there_stops_nothing() -> void:
	_forces.wheel_path = "/dev/input/no_such_wheel"
	add_child(_forces)
	var wheel: ForceWheel = _forces.get_wheel()
	await until(func() -> bool: return wheel.get_trouble() != "")
	contains(wheel.get_trouble(), "no_such_wheel")
	is_false(wheel.can(ForceWheel.FORCE_SPRING))
	_forces.seat = null
	await process_frames(2)
	is_false(wheel.is_open())


func _rumble_is(p_holds: Callable) -> bool:
	return await Waiting.until(
		get_tree(), func() -> bool: return p_holds.call(Input.get_joy_vibration_strength(_PAD))
	)
