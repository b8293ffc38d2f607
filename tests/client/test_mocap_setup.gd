extends TestCase
## Motion capture at a client: sources become people, the panel opens and closes by its key, and an
## instructor's orders reach whom they are meant for.

const CLIENT: PackedScene = preload("res://scenes/client/client.tscn")

var _client: Node = null
var _desk: MocapSetup = null


func before_each() -> void:
	# Only the desk: the client's own node would connect to a server.
	_client = CLIENT.instantiate()
	_desk = _client.get_node(^"Mocap")
	_client.remove_child(_desk)
	_desk.owner = null
	add_child(_desk)


func after_each() -> void:
	_desk.close()
	_desk.free()
	_client.free()


func test_sources_become_people() -> void:
	var files: String = "res://assets/motion/01_01.bvh,res://assets/motion/Boxing_Toes.bvh"
	equal(_open(["--bvh=" + files]), "")
	_desk.advance(1.0)
	equal(_desk.people.count(), 2)
	equal(_desk.guide(1.0), "")


func test_nothing_to_move_by_is_told() -> void:
	contains(_open([]), "--bvh")
	equal(_desk.people.count(), 0)


func test_the_panel_s_key() -> void:
	equal(_open(["--bvh=res://assets/motion/01_01.bvh"]), "")
	is_false(_desk.is_panel_open())
	await _press()
	is_true(_desk.is_panel_open())
	_desk.advance(1.0)
	_desk.advance(2.0)
	await _press()
	is_false(_desk.is_panel_open())


func test_the_panel_is_open_at_the_start_if_asked_for() -> void:
	equal(_open(["--bvh=res://assets/motion/01_01.bvh", "--panel=1"]), "")
	is_true(_desk.is_panel_open())
	equal(_desk.guide(1.0), "", "the panel says it")


func test_orders_for_nobody_and_of_no_kind_do_nothing() -> void:
	equal(_open(["--bvh=res://assets/motion/01_01.bvh"]), "")
	for order: Vector2i in [Vector2i(7, 0), Vector2i(0, 250), Vector2i(-1, -1), Vector2i(255, 255)]:
		_desk.calibrate(order.x, order.y, 1.0)
		equal(_desk.guide(1.5), "")


func test_an_order_for_motion_that_comes_calibrated_is_answered() -> void:
	equal(_open(["--bvh=res://assets/motion/01_01.bvh"]), "")
	_desk.calibrate(0, ClientCalibration.KINDS["full"], 1.0)
	contains(_desk.guide(1.5), "comes calibrated")


func test_an_order_reaches_the_one_who_wears_sensors() -> void:
	equal(_open(["--bvh=res://assets/motion/01_01.bvh"]), "")
	var feed: WornSensorFeed = WornSensorFeed.new()
	for mount: int in BodyMounts.COUNT:
		feed.add_sensor(mount)
	var suit: SuitSource = SuitSource.new(feed)
	_desk.people.add(suit, "Ada")
	feed.measure(CalibrationMotion.new().pose_at(0.0), 1000000)
	suit.advance(1.0)
	_desk.calibrate(1, ClientCalibration.KINDS["t_pose"], 1.0)
	is_true(_desk.inputs.calibration.is_running())
	contains(_desk.guide(1.1), "arms straight out")


func _open(p_arguments: PackedStringArray) -> String:
	var options: Options = ProgramOptions.parse(p_arguments)
	equal(options.error, "")
	return _desk.open(options, ClientLink.new())


func _press() -> void:
	var event: InputEventKey = InputEventKey.new()
	event.keycode = KEY_M
	event.pressed = true
	get_window().push_input(event)
	await process_frames(2)
