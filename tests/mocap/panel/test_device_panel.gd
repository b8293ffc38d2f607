extends TestCase
## The device panel by its keys alone, and whether everything fits.

var _panel: DevicePanel = null
var _feed: BvhSensorFeed = null
var _suit: SuitSource = null
var _motion: CalibrationMotion = null
var _now_usec: int = 1700000000000000


func before_each() -> void:
	get_window().size = Vector2i(1280, 720)
	_panel = (load("res://scenes/mocap/panel/device_panel.tscn") as PackedScene).instantiate()
	_panel.folder = "user://test-panel-%d" % OS.get_process_id()
	_panel.clock = func() -> float: return _now_usec / 1e6
	add_child(_panel)
	_feed = BvhSensorFeed.new()
	_feed.open("res://assets/motion/01_01.bvh", PackedInt32Array(range(17)))
	_motion = CalibrationMotion.new()
	_motion.kind = CalibrationGuide.Kind.T_TO_N
	_suit = SuitSource.new(_feed)
	_panel.show_suits([_suit] as Array[SuitSource])
	await process_frames(2)


func after_each() -> void:
	_panel.queue_free()
	await process_frames(2)
	if DirAccess.dir_exists_absolute(_panel_folder()):
		for file: String in DirAccess.get_files_at(_panel_folder()):
			DirAccess.remove_absolute(_panel_folder().path_join(file))
		DirAccess.remove_absolute(_panel_folder())


func test_nothing_overflows_at_1280_by_720_with_17_sensors() -> void:
	_panel.show_devices(_devices())
	_panel.choose_suit(0)
	for step: int in 2:
		await _go(0.2)
		_check_layout(_panel)
		await _press(KEY_F7)
	await _press(KEY_ESCAPE)
	await _press(KEY_F3)
	for step: int in 11:
		_check_layout(_panel)
		await _go(1.0)
	_check_layout(_panel)
	equal(_sensors().get_root().get_child_count(), 17)
	var last: TreeItem = _sensors().get_root().get_child(16)
	var area: Rect2 = _sensors().get_item_area_rect(last)
	is_true(area.end.y < _sensors().size.y, "the last sensor is seen without scrolling")


func test_every_text_of_a_calibration_fits() -> void:
	for movement: int in GuideMovements.TEXTS.size():
		_instruction().text = "Hold still: 3 s\n" + GuideMovements.TEXTS[movement]
		await process_frames(1)
		_check_instruction()
	for kind: int in 2:
		_instruction().text = "Hold still: 3 s\n" + ResetPose.instruction(kind as ResetPose.Kind)
		await process_frames(1)
		_check_instruction()


func test_calibration_by_keys() -> void:
	_use_prelude()
	await _press(KEY_F3)
	equal(_suit.process.phase, CalibrationProcess.Phase.COUNTDOWN)
	await _go(1.0)
	contains(_instruction().text, "Get ready: 2 s")
	await _go(3.0)
	contains(_instruction().text, "Hold still")
	await _go(2.0)
	contains(_instruction().text, "Bring both arms down")
	await _go(5.0)
	contains(_instruction().text, "Good: limbs are off by about")
	is_false(_suit.is_calibrated(), "not before it is accepted")
	var changed: Array[int] = []
	_panel.profile_changed.connect(changed.append)
	await _press(KEY_F9)
	is_true(_suit.is_calibrated())
	equal(changed, [0] as Array[int])
	var stored: PersonProfile = CalibrationStore.new(_panel_folder()).read("somebody")
	equal(stored.calibration.entries.size(), 17)


func test_movement_during_the_pose_is_named_and_it_is_done_again() -> void:
	_motion.sways_deg[5] = 2.0
	_use_prelude()
	await _press(KEY_F1)
	await _go(5.2)
	equal(_instruction().text, "Not as good as it could be.")
	contains(_advice(), "left forearm moved 4° during the pose: again?")
	await _press(KEY_F10)
	equal(_suit.process.phase, CalibrationProcess.Phase.COUNTDOWN)
	await _press(KEY_ESCAPE)
	equal(_suit.process.phase, CalibrationProcess.Phase.IDLE)
	is_false(_suit.is_calibrated())


func test_a_sensor_is_put_elsewhere_by_keys() -> void:
	await _go(0.3)
	is_true(_sensors().has_focus())
	await _press(KEY_DOWN)
	await _press(KEY_DOWN)
	var sensor: String = _sensors().selected_sensor()
	equal(sensor, "00300003")
	var map: SensorMap = _suit.get_profile().map
	equal(map.mounts[sensor], 2)
	var other: String = map.sensor_at(3)
	await _press(KEY_ENTER)
	# The menu opens where the sensor is: one down is the next mount.
	await _press(KEY_DOWN)
	await _press(KEY_ENTER)
	map = _suit.get_profile().map
	equal(map.mounts[sensor], 3)
	equal(map.mounts[other], 2, "exchanged, not thrown out")
	is_true(_sensors().has_focus())
	contains(_status(), "calibrate again")
	is_null(CalibrationStore.new(_panel_folder()).read("somebody"), "nothing is kept yet")
	await _press_ctrl_z()
	equal(_suit.get_profile().map.mounts[sensor], 2)
	await _press_ctrl_z()
	equal(_suit.get_profile().map.mounts[sensor], 2)


func test_changes_are_kept_by_a_key_or_with_the_calibration() -> void:
	await _go(0.3)
	_panel._move_sensor("00300003", 3)
	await process_frames(2)
	await _press(KEY_F9)
	var kept: PersonProfile = CalibrationStore.new(_panel_folder()).read("somebody")
	equal(kept.map.mounts["00300003"], 3)
	await _press_ctrl_z()
	equal(_suit.get_profile().map.mounts["00300003"], 3, "what is kept is not undone")


func test_before_calibration_a_figure_stands_and_the_key_is_named() -> void:
	await _go(0.3)
	contains(_status(), "Not calibrated yet: press F4")
	var view: PreviewView = _panel.get_node("Scroll/Margin/Rows/Middle/Right/Views/Calibrated/View")
	var boxes: Array[Node] = view.stage.get_child(0).get_children()
	var head: MeshInstance3D = boxes[Limbs.HEAD]
	var foot: MeshInstance3D = boxes[Limbs.LEFT_FOOT]
	is_true(head.position.y > 1.4 and foot.position.y < 0.2, "upright")


func test_somebody_alone_starts_by_a_gesture_and_reads_the_result() -> void:
	var alone: CheckBox = _panel.get_node(
		"Scroll/Margin/Rows/Middle/Right/Calibration/Margin/Rows/More/Alone"
	)
	alone.button_pressed = true
	await _go(1.0)
	equal(_suit.process.phase, CalibrationProcess.Phase.IDLE)
	_panel.start_calibration(CalibrationGuide.Kind.T_TO_N)
	almost_equal(_suit.process.seconds_left, CalibrationBox.ALONE_S, 0.01)
	_use_prelude()
	_motion.lead_s = CalibrationBox.ALONE_S - CalibrationGuide.COUNTDOWN_S
	await _go(1.0)
	contains(_guide().text(), "Get ready 7")
	await _go(14.2)
	contains(_guide().text(), "Accepted")
	await _go(DevicePanel.READ_S + 0.2)
	is_true(_suit.is_calibrated())
	is_false(_guide().visible)


func test_exchanged_sensors_are_offered_and_exchanged() -> void:
	await _go(0.1)
	var map: SensorMap = _suit.get_profile().map.duplicate()
	map.exchange(5, 9)
	_suit.set_map(map)
	_motion.kind = CalibrationGuide.Kind.FIT_CHECK
	_use_prelude()
	await _press(KEY_F6)
	await _go(CalibrationGuide.duration_s(CalibrationGuide.Kind.FIT_CHECK) + 0.2)
	contains(_advice(), "left forearm and right forearm look swapped")
	_check_layout(_panel)
	await _press(KEY_F8)
	equal(_suit.get_profile().map.sensor_at(5), "00300006")
	contains(_status(), "calibrate again")


func test_body_and_person() -> void:
	await _press(KEY_F7)
	var sheet: BodySheet = _panel.get_node("Center/Sheet")
	is_true(sheet.visible)
	var box: SpinBox = sheet.get_node("Rows/Grid").get_child(9 * 2 - 1)
	box.value = 44.0
	almost_equal(_suit.get_body().length(&"thigh"), 0.44, 1e-6)
	box.value = 9.0
	contains((sheet.get_node("Rows/Fault") as Label).text, "thigh is between")
	almost_equal(_suit.get_body().length(&"thigh"), 0.44, 1e-6)
	await _press(KEY_ESCAPE)
	is_false(sheet.visible)
	var closed: Array[bool] = []
	_panel.close_wanted.connect(func() -> void: closed.append(true))
	var name: LineEdit = _panel.get_node("Scroll/Margin/Rows/Person/Name")
	name.text_submitted.emit("../../etc/passwd")
	contains(_status(), "a name neither begins nor ends")
	name.text_submitted.emit("Anna")
	equal(_suit.get_profile().name, "Anna")
	equal(CalibrationStore.new(_panel_folder()).list(), PackedStringArray(["Anna", "somebody"]))
	equal(closed.size(), 0)
	await _press(KEY_ESCAPE)
	equal(closed.size(), 1)


func test_a_known_name_brings_the_known_person() -> void:
	var anna: PersonProfile = PersonProfile.new()
	anna.name = "Anna"
	anna.size.set_height(1.6)
	anna.map = _suit.get_profile().map
	is_true(CalibrationStore.new(_panel_folder()).write(anna))
	var name: LineEdit = _panel.get_node("Scroll/Margin/Rows/Person/Name")
	name.text_submitted.emit("Anna")
	equal(_suit.get_profile().size.height, 1.6)
	var known: OptionButton = _panel.get_node("Scroll/Margin/Rows/Person/Known")
	equal(known.get_item_text(known.selected), "Anna")
	var file: FileAccess = FileAccess.open(
		_panel_folder().path_join("Berta.json"), FileAccess.WRITE
	)
	file.store_string("{}")
	file.close()
	name.text_submitted.emit("Berta")
	contains(_status(), "Berta.json: version: expected a number")
	equal(_suit.get_profile().name, "Anna")


func test_tab_reaches_every_control() -> void:
	var reached: Dictionary[Node, bool] = {}
	for step: int in 60:
		await _press(KEY_TAB)
		var focus: Control = get_viewport().gui_get_focus_owner()
		if focus != null:
			reached[focus] = true
	for path: String in [
		"Person/Name",
		"Person/Known",
		"Person/Body",
		"Person/Close",
		"Middle/Left/Devices",
		"Middle/Left/Sensors",
		"Middle/Right/Calibration/Margin/Rows/Options/Facing",
		"Middle/Right/Calibration/Margin/Rows/Options/Pose"
	]:
		is_true(reached.has(_panel.get_node("Scroll/Margin/Rows/" + path)), path)
	for button: Node in (
		_panel
		. get_node("Scroll/Margin/Rows/Middle/Right/Calibration/Margin/Rows/Kinds/First")
		. get_children()
	):
		is_true(reached.has(button), (button as Button).text)


func test_without_a_suit() -> void:
	_panel.show_suits([])
	for key: Key in [KEY_F1, KEY_F6, KEY_F7, KEY_F8, KEY_F9, KEY_F10]:
		await _press(key)
	contains(_status(), "no suit")
	_panel.show_devices([])
	_panel.show_devices([{}, {"name": 5, "state": null}] as Array[Dictionary])
	_check_layout(_panel)


func test_two_suits() -> void:
	var other: SuitSource = SuitSource.new(WornSensorFeed.new())
	other.rename("Berta")
	_panel.show_suits([_suit, other] as Array[SuitSource])
	var list: OptionButton = _panel.get_node("Scroll/Margin/Rows/Person/Suit")
	is_true(list.visible)
	equal(list.get_item_text(1), "2: Berta")
	list.item_selected.emit(1)
	is_true(_panel.suit() == other)
	var suits: Array[SuitSource] = [_suit]
	_panel.show_suits(suits)
	is_false(list.visible)
	suits.append(other)
	await process_frames(2)
	is_true(list.visible)
	suits.clear()
	await process_frames(2)
	is_null(_panel.suit())
	contains(_status(), "no suit")
	suits.append_array([_suit, other])
	await process_frames(2)
	_panel.choose_suit(1)
	await _press(KEY_F1)
	contains(_status(), "there are no sensors to calibrate")
	_check_layout(_panel)


func _use_prelude() -> void:
	_feed.prelude = _motion
	_feed.prelude_s = 100.0
	_feed._start_usec = -1
	_feed._next = 0


func _devices() -> Array[Dictionary]:
	return [
		{"name": "Xbus Master 00100123", "state": "measuring", "detail": "17 sensors, 100 Hz"},
		{
			"name": "Xbus Master 00100124 with a very long name indeed",
			"state": "no permission",
			"advice": "copy 70-dismount-xsens.rules to /etc/udev/rules.d and plug it in again"
		},
	]


## Plays so long.
func _go(p_seconds: float) -> void:
	var end: int = _now_usec + roundi(p_seconds * 1e6)
	while _now_usec < end:
		_now_usec += 50000
		_feed.advance(_now_usec)
		_suit.advance(_now_usec / 1e6)
	await process_frames(2)


func _press(p_key: Key) -> void:
	for pressed: bool in [true, false]:
		var event: InputEventKey = InputEventKey.new()
		event.keycode = p_key
		event.physical_keycode = p_key
		event.pressed = pressed
		Input.parse_input_event(event)
		Input.flush_buffered_events()
		await process_frames(1)


func _press_ctrl_z() -> void:
	var event: InputEventKey = InputEventKey.new()
	event.keycode = KEY_Z
	event.ctrl_pressed = true
	event.pressed = true
	Input.parse_input_event(event)
	Input.flush_buffered_events()
	await process_frames(2)


func _sensors() -> SensorTable:
	return _panel.get_node("Scroll/Margin/Rows/Middle/Left/Sensors")


func _instruction() -> Label:
	return _panel.get_node("Scroll/Margin/Rows/Middle/Right/Calibration/Margin/Rows/Instruction")


func _guide() -> GuideView:
	return _panel.get_child(_panel.get_child_count() - 1)


func _advice() -> String:
	var label: RichTextLabel = _panel.get_node(
		"Scroll/Margin/Rows/Middle/Right/Calibration/Margin/Rows/Advice"
	)
	return label.text


func _status() -> String:
	return (_panel.get_node("Scroll/Margin/Rows/Person/Status") as Label).text


func _panel_folder() -> String:
	return "user://test-panel-%d" % OS.get_process_id()


func _check_instruction() -> void:
	var label: Label = _instruction()
	equal(label.get_visible_line_count(), label.get_line_count(), label.text)


## Everything that is shown lies within the window, and no control is cut by its parent.
func _check_layout(p_control: Control) -> void:
	var whole: Rect2 = Rect2(Vector2.ZERO, Vector2(1280, 720))
	var rect: Rect2 = p_control.get_global_rect()
	var path: String = str(_panel.get_path_to(p_control))
	is_true(whole.grow(1.0).encloses(rect), "%s is at %s" % [path, rect])
	var needed: Vector2 = p_control.get_combined_minimum_size()
	is_true(rect.size.x + 1.0 >= needed.x and rect.size.y + 1.0 >= needed.y, path)
	for child: Node in p_control.get_children():
		var control: Control = child as Control
		if control != null and control.is_visible_in_tree() and not p_control is SpinBox:
			_check_layout(control)
