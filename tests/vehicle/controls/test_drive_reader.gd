extends TestCase
## Hands and feet of a driver: keys steer gradually, gears go round.

var _reader: DriveReader = null
var _input: VehicleInput = VehicleInput.new()


func before_each() -> void:
	_reader = DriveReader.new(ControlSettings.new("user://no_such_controls.cfg"))


func after_each() -> void:
	for action: StringName in [&"drive_forward", &"steer_left", &"drive_brake"]:
		Input.action_release(action)


func test_keys_drive_brake_and_steer_gradually() -> void:
	Input.action_press(&"drive_forward")
	Input.action_press(&"steer_left")
	_reader.read(_input, 0.1)
	equal(_input.throttle, 1.0)
	almost_equal(_input.steer, 0.25, 1e-5)
	for _step: int in 10:
		_reader.read(_input, 0.1)
	equal(_input.steer, 1.0)
	Input.action_release(&"steer_left")
	_reader.read(_input, 0.1)
	almost_equal(_input.steer, 0.5, 1e-5, "it goes back by itself")
	Input.action_press(&"drive_brake")
	_reader.read(_input, 0.1)
	equal(_input.brake, 1.0)


func test_a_stick_steers_as_far_as_it_is_held() -> void:
	Input.action_press(&"steer_left", 0.4)
	_reader.read(_input, 0.001)
	almost_equal(_input.steer, 0.4, 1e-5)


func test_gears_go_round_and_leaving_forgets_them() -> void:
	var gears: Array[VehicleInput.Selector] = []
	for _press: int in VehicleInput.Selector.size():
		_reader.change_gear()
		gears.append(_reader.gear)
	equal(gears[0], VehicleInput.Selector.FORWARD)
	equal(gears[-1], VehicleInput.Selector.AUTOMATIC)
	_reader.change_gear()
	_reader.clear()
	equal(_reader.gear, VehicleInput.Selector.AUTOMATIC)
