extends TestCase
## The mirror's sheet by keyboard alone, in windows of all sizes: what it says and what it asks for.

## Of 16:9 at the least scale, 16:9, 21:9, 4:3, and upright.
const SIZES: Array[Vector2i] = [
	Vector2i(853, 480),
	Vector2i(1280, 720),
	Vector2i(1680, 720),
	Vector2i(960, 720),
	Vector2i(520, 900),
]

var _panel: DevicePanel = null
var _sheet: MirrorSheet = null


func before_each() -> void:
	get_window().size = Vector2i(1280, 720)
	_panel = (load("res://scenes/mocap/panel/device_panel.tscn") as PackedScene).instantiate()
	_panel.folder = "user://test-mirror-%d" % OS.get_process_id()
	add_child(_panel)
	_sheet = _panel.mirror()
	await process_frames(1)


func after_each() -> void:
	_panel.queue_free()
	get_window().size = Vector2i(1280, 720)
	await process_frames(2)


func test_its_key_opens_and_closes_it() -> void:
	await _press(KEY_M, true)
	is_true(_sheet.is_visible_in_tree())
	is_false((_panel.get_node(^"Scroll") as Control).visible, "it fills the screen")
	await _press(KEY_ESCAPE)
	is_false(_sheet.visible)
	is_true((_panel.get_node(^"Scroll") as Control).visible)


func test_sources_that_were_opened_from_it_lead_back_to_it() -> void:
	_panel.show_mirror()
	await _press(KEY_F12)
	is_true(_panel.sources().visible)
	is_false(_sheet.visible)
	await _press(KEY_ESCAPE)
	is_true(_sheet.visible)
	is_false(_panel.sources().visible)


func test_all_of_it_fits_at_every_size() -> void:
	_panel.show_mirror()
	_fill()
	for size: Vector2i in SIZES:
		get_window().size = size
		await process_frames(3)
		_check_layout(_sheet, Rect2(Vector2.ZERO, Vector2(size)))
		is_true(_sheet.mirror.size.x > 190.0 and _sheet.mirror.size.y > 190.0, str(size))


func test_every_control_is_reached_by_keyboard_alone() -> void:
	_panel.show_mirror()
	_fill()
	await process_frames(2)
	var wanted: Dictionary[Control, bool] = {}
	for type: String in ["BaseButton", "Tree", "TextureRect"]:
		for node: Node in _sheet.find_children("*", type, true, false):
			if (node as Control).is_visible_in_tree():
				wanted[node as Control] = true
	equal(wanted.size(), 10)
	for turn: int in 2 * wanted.size():
		var focus: Control = get_viewport().gui_get_focus_owner()
		not_null(focus)
		is_true(_sheet.is_ancestor_of(focus), "the keyboard stays in it")
		wanted.erase(focus)
		await _press(KEY_TAB)
	equal(wanted.keys(), [])


func test_keys_turn_it() -> void:
	_panel.show_mirror()
	_sheet.mirror.grab_focus()
	_sheet.mirror.follow(Vector3(0.0, 1.0, 0.0), 0.0, 0.0, 0.1)
	var ahead: Vector3 = Vector3(0.0, 1.0, 0.3)
	var before: Vector2 = _sheet.mirror.seen_at(ahead)
	await _press(KEY_RIGHT)
	var after: Vector2 = _sheet.mirror.seen_at(ahead)
	is_true(after.x > before.x + 5.0, "what is in front goes to the right: %s" % after)
	is_true(_sheet.mirror.has_focus())
	await _press(KEY_DOWN)
	is_false(_sheet.mirror.has_focus(), "up and down leave it")
	for from: MirrorView.Direction in MirrorView.Direction.values() as Array[MirrorView.Direction]:
		var name: String = (MirrorView.Direction.find_key(from) as String).capitalize()
		(_sheet.find_child(name, true, false) as Button).pressed.emit()
		equal(_sheet.mirror.direction, from)
		equal(_sheet.mirror.flip_h, from != MirrorView.Direction.BACK)


func test_join_and_stop_are_one_button() -> void:
	var asked: Array[String] = []
	_sheet.join_wanted.connect(asked.append.bind("join"))
	_sheet.stop_wanted.connect(asked.append.bind("stop"))
	_panel.show_mirror()
	await process_frames(1)
	var join: Button = _sheet.find_child("Join", true, false)
	is_false(join.visible, "there is nothing to join")
	_sheet.offer_session("10.0.0.5:7777")
	_sheet.focus_first()
	await _press(KEY_ENTER)
	_sheet.show_session("Joining 10.0.0.5:7777 ...", true)
	contains(_said(), "Joining 10.0.0.5")
	await _press(KEY_ENTER)
	_sheet.show_session("The server refused us: wrong password.", false)
	contains(_said(), "wrong password")
	equal(join.text, "Join")
	equal(asked, ["join", "stop"] as Array[String])


func test_its_picture_is_made_only_while_it_is_seen() -> void:
	var picture: SubViewport = _sheet.mirror.get_child(0)
	await process_frames(3)
	equal(picture.render_target_update_mode, SubViewport.UPDATE_DISABLED)
	_panel.show_mirror()
	await process_frames(3)
	not_equal(picture.render_target_update_mode, SubViewport.UPDATE_ALWAYS)
	is_true(picture.size.x > 100)


func _fill() -> void:
	_sheet.show_people(["1: 01_01.bvh, 22.9 s at 120 Hz", "2: somebody"], 1)
	_sheet.show_avatars(["as the world says", "civilian_woman"], 0)
	_sheet.show_wearer("Ada, 1.73 m tall, hips at 0.92 m. Not calibrated yet: press F4 and follow")
	_sheet.show_trouble(
		"Xbus Master 00100123 was unplugged: plug it in again, it goes on by itself"
	)
	_sheet.offer_session("a-server-with-a-long-name.example.org:7777")
	_sheet.show_session("No server answers at 10.0.0.5:7777.\nTrying again ...", true)
	var rows: Array[Dictionary] = []
	for number: int in 6:
		rows.append(
			{"name": "Xbus Master %d" % number, "state": "measuring", "detail": "17 sensors"}
		)
	rows[2]["advice"] = "copy 70-dismount-xsens.rules to /etc/udev/rules.d and plug it in again"
	_sheet.show_devices(rows)


func _said() -> String:
	return (_sheet.find_child("Session", true, false) as Label).text


func _press(p_key: Key, p_ctrl: bool = false) -> void:
	for is_pressed: bool in [true, false]:
		var event: InputEventKey = InputEventKey.new()
		event.keycode = p_key
		event.ctrl_pressed = p_ctrl
		event.pressed = is_pressed
		Input.parse_input_event(event)
		Input.flush_buffered_events()
	await process_frames(2)


func _check_layout(p_control: Control, p_whole: Rect2) -> void:
	var rect: Rect2 = p_control.get_global_rect()
	var path: String = "%s at %s" % [_panel.get_path_to(p_control), p_whole.size]
	is_true(p_whole.grow(1.0).encloses(rect), "%s is at %s" % [path, rect])
	var needed: Vector2 = p_control.get_combined_minimum_size()
	is_true(rect.size.x + 1.0 >= needed.x and rect.size.y + 1.0 >= needed.y, path)
	for child: Node in p_control.get_children():
		var control: Control = child as Control
		if control != null and control.is_visible_in_tree():
			_check_layout(control, p_whole)
