extends TestCase
## Motion capture at a client: sources become people, the panel opens and closes by its key, and an
## instructor's orders reach whom they are meant for.

var _desk: MocapSetup = null


func before_each() -> void:
	_desk = MocapSetup.new()
	add_child(_desk)


func after_each() -> void:
	_desk.close()
	_desk.free()


func test_sources_become_people() -> void:
	var files: String = "res://assets/motion/01_01.bvh,res://assets/motion/Boxing_Toes.bvh"
	equal(_open(["--bvh=" + files]), "")
	_desk.read_sources(1.0)
	equal(_desk.people.count(), 2)
	equal(_desk.guide(1.0), "")


func test_who_has_nothing_to_move_by_walks() -> void:
	equal(_open([]), "")
	equal(_desk.people.count(), 1)
	is_true(_desk.people.source_of(0) is WalkerSource)


func test_a_walker_s_legs_carry_the_first_source() -> void:
	var clip: String = "--bvh=res://assets/motion/01_01.bvh"
	equal(_open([clip, "--source=walker", "--fuse=legs:2"]), "")
	equal(_desk.people.count(), 1)
	var legs: WalkedLegs = _desk.people.source_of(0) as WalkedLegs
	not_null(legs)
	is_true(ClientMotion.innermost(legs) is BvhSource)
	is_true(legs.is_sent())
	equal(_desk.inputs.people.choose(LimbFusion.Group.LEGS, 1), "")
	equal(_desk.people.count(), 2)
	is_true(_desk.people.source_of(0) is BvhSource)
	equal(_desk.inputs.people.choose(LimbFusion.Group.LEGS, 2), "")
	equal(_desk.people.count(), 1)
	is_true(_desk.people.source_of(0) is WalkedLegs)


func test_a_walker_gives_no_arms() -> void:
	var clip: String = "--bvh=res://assets/motion/01_01.bvh"
	contains(_open([clip, "--source=walker", "--fuse=arms:2"]), "legs, feet and root")


func test_the_panel_s_key() -> void:
	equal(_open(["--bvh=res://assets/motion/01_01.bvh"]), "")
	is_false(_desk.is_panel_open())
	await _press()
	is_true(_desk.is_panel_open())
	_desk.read_sources(1.0)
	_desk.read_sources(2.0)
	await _press()
	is_false(_desk.is_panel_open())


func test_what_is_heard_is_taken_and_gives_limbs_at_the_panel() -> void:
	equal(_open(["--bvh=res://assets/motion/01_01.bvh", "--panel=1"]), "")
	var other: BvhSource = BvhSource.new()
	other.open("res://assets/motion/Boxing_Toes.bvh")
	var tracker: TrackerPublisher = TrackerPublisher.new(other.get_body(), &"/test/panel_tracker")
	tracker.publish(other.pose_at(1.0))
	var sheet: SourceSheet = _desk.get_node(^"Layer/DevicePanel/Center/Sources")
	sheet.visible = true
	_desk.read_sources(1.0)
	var heard: Tree = sheet.get_node(^"Rows/Heard")
	var row: TreeItem = null
	for item: TreeItem in heard.get_root().get_children():
		if item.get_text(0).contains("/test/panel_tracker"):
			row = item
	not_null(row, "the other program's tracker is listed")
	row.select(0)
	heard.item_activated.emit()
	_desk.read_sources(1.3)
	equal(_desk.inputs.list_sources().size(), 2)
	equal((sheet.get_node(^"Rows/Fault") as Label).text, "")
	sheet.group_chosen.emit(LimbFusion.Group.ARMS, 2)
	_desk.read_sources(1.6)
	equal(_desk.people.count(), 1, "one person of two sources")
	sheet.group_chosen.emit(LimbFusion.Group.ARMS, 9)
	contains((sheet.get_node(^"Rows/Fault") as Label).text, "there is no source 9")
	sheet.source_wanted.emit("nonsense:1")
	contains((sheet.get_node(^"Rows/Fault") as Label).text, "found 'nonsense'")
	sheet.visible = false
	tracker.retire()


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


func test_headings_are_reset_by_order() -> void:
	equal(_open(["--bvh=res://assets/motion/01_01.bvh"]), "")
	var feed: WornSensorFeed = WornSensorFeed.new()
	var calibration: Calibration = Calibration.new()
	for mount: int in BodyMounts.COUNT:
		feed.add_sensor(mount, Quaternion.IDENTITY, 0.3, BodyMounts.NAMES[mount])
		calibration.set_entry(BodyMounts.NAMES[mount], mount, 0.0, Quaternion.IDENTITY)
	var suit: SuitSource = SuitSource.new(feed)
	_desk.people.add(suit, "Ada")
	var answers: Array[String] = []
	var answer: Callable = func(accepted: bool, text: String) -> void:
		answers.append("%s: %s" % [accepted, text])
	_desk.calibrate(1, ClientCalibration.orders()["heading"], 1.0, answer)
	suit.set_calibration(calibration)
	feed.measure(CalibrationMotion.new().pose_at(0.0), 1000000)
	suit.advance(1.0)
	almost_equal(Rotations.yaw_of(suit.newest_pose.orientation(0)), 0.3, 0.01)
	_desk.calibrate(1, ClientCalibration.orders()["heading"], 1.0, answer)
	feed.measure(CalibrationMotion.new().pose_at(0.0), 1050000)
	suit.advance(1.1)
	almost_equal(Rotations.yaw_of(suit.newest_pose.orientation(0)), 0.0, 0.01)
	contains(answers[0], "false: Headings not reset: the suit says nothing")
	equal(answers[1], "true: Headings reset")
	contains(_desk.guide(1.2), "Headings reset")


func _open(p_arguments: PackedStringArray) -> String:
	var context: ClientContext = ClientContext.new()
	context.options = ProgramOptions.parse(p_arguments)
	context.link = ClientLink.new()
	equal(context.options.error, "")
	return _desk.open(context)


func _press() -> void:
	var event: InputEventKey = InputEventKey.new()
	event.keycode = KEY_M
	event.pressed = true
	get_window().push_input(event)
	await process_frames(2)
