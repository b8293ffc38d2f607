extends TestCase
## A crew's keys: taking seats, driving, aiming, looking, changing seats; in the example's scene.

const EXAMPLE: PackedScene = preload("res://examples/05_tank/05_tank.tscn")

var _scene: Node3D = null
var _tank: Vehicle = null
var _controls: SeatControls = null


func before_each() -> void:
	_scene = EXAMPLE.instantiate()
	add_child(_scene)
	_tank = _scene.get_node(^"Tank")
	_controls = _scene.get_node(^"Controls")
	await physics_frames(20)


func after_each() -> void:
	for action: StringName in [&"drive_forward", &"steer_left", &"aim_left"]:
		Input.action_release(action)
	_scene.free()


func test_the_driver_drives_and_letting_go_stops_the_tank() -> void:
	await _take(^"DriverSeat")
	is_true(_controls.has_command(&"drive"))
	is_false(_controls.has_command(&"aim"))
	Input.action_press(&"drive_forward")
	await physics_frames(150)
	is_true(VehicleGround.speed_of(_tank) > 1.5, "%.2f m/s" % VehicleGround.speed_of(_tank))
	almost_equal(_tank.state.left_speed, VehicleGround.speed_of(_tank), 0.4)
	Input.action_release(&"drive_forward")
	(_scene.get_node(^"Tank/DriverSeat") as Seat).interact()
	await physics_frames(400)
	almost_equal(VehicleGround.speed_of(_tank), 0.0, 0.1)


func test_the_gunner_aims_and_only_the_gunner() -> void:
	await _take(^"DriverSeat")
	Input.action_press(&"aim_left")
	await physics_frames(40)
	almost_equal(_tank.state.turret_yaw, 0.0, 1e-4)
	Input.action_release(&"aim_left")
	await _take(^"Turret/GunnerSeat")
	Input.action_press(&"aim_left")
	await physics_frames(60)
	is_true(_tank.state.turret_yaw > 0.2, "%.2f rad" % _tank.state.turret_yaw)
	almost_equal((_tank.get_node(^"Turret") as Node3D).rotation.y, _tank.state.turret_yaw, 1e-4)


func test_q_goes_to_the_next_free_seat_and_v_to_its_views() -> void:
	await _take(^"DriverSeat")
	var seats: Array[int] = []
	for _press: int in 4:
		seats.append(_controls.seat.index)
		await physics_frames(Possession.SEAT_TICKS + 1)
		_controls.change_seat()
		await _settle()
	equal(seats, [0, 1, 2, 3] as Array[int])
	await _take(^"Turret/GunnerSeat")
	equal(_controls.view.kind, SeatView.Kind.SIGHT)
	almost_equal(_controls.view.magnification(), 3.0, 1e-6)
	_controls.view.change_magnification()
	almost_equal(_controls.view.magnification(), 12.0, 1e-6)
	var kinds: Array[SeatView.Kind] = []
	for _press: int in 3:
		_controls.change_view()
		kinds.append(_controls.view.kind)
	equal(
		kinds,
		[SeatView.Kind.PERISCOPE, SeatView.Kind.CHASE, SeatView.Kind.SIGHT] as Array[SeatView.Kind]
	)


func test_the_stabiliser_goes_off_and_on_again() -> void:
	await _take(^"Turret/GunnerSeat")
	for expected: bool in [false, true]:
		var press: InputEventAction = InputEventAction.new()
		press.action = &"toggle_stabiliser"
		press.pressed = true
		_controls._unhandled_input(press)
		await physics_frames(3)
		equal(_tank.state.stabilised, expected)


func test_whoever_has_a_body_looks_out_of_it_first() -> void:
	_controls.has_body = true
	await _take(^"Turret/CommanderSeat")
	is_null(_controls.view)
	_controls.change_view()
	equal(_controls.view.kind, SeatView.Kind.OPEN)
	_controls.change_view()
	_controls.change_view()
	equal(_controls.view.kind, SeatView.Kind.CHASE)
	_controls.change_view()
	is_null(_controls.view)


func test_a_driver_of_whom_nothing_comes_lets_go() -> void:
	await _take(^"DriverSeat")
	_controls.set_physics_process(false)
	Entity.find_in(_tank).send_command(&"drive", [1.0, 0.0, 0.0, 0.0, 0.0])
	await physics_frames(20)
	equal(_tank.input.throttle, 1.0)
	await physics_frames(30)
	equal([_tank.input.throttle, _tank.input.brake], [0.0, 1.0])


func test_who_sits_nowhere_changes_no_view() -> void:
	var views: Array[SeatView] = []
	_controls.view_changed.connect(func(view: SeatView) -> void: views.append(view))
	await process_frames(30)
	equal(views, [] as Array[SeatView])
	await _take(^"DriverSeat")
	await process_frames(30)
	equal(views.size(), 1)


func test_a_tank_that_goes_leaves_the_controls_without_one() -> void:
	await _take(^"DriverSeat")
	_tank.free()
	await process_frames(2)
	await physics_frames(2)
	is_false(is_instance_valid(_controls.vehicle))


func _take(p_path: NodePath) -> void:
	await physics_frames(Possession.SEAT_TICKS + 1)
	(_tank.get_node(p_path) as Seat).interact()
	await _settle()


## Controls look for their seat some times a second.
func _settle() -> void:
	for _frame: int in 200:
		await process_frames(1)
		if SeatControls.find_seat(get_tree()) == _controls.seat and _controls.seat != null:
			return
