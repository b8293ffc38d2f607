extends TestCase
## What a user sees and reads before joining, and how joining begins.

const PERSON: PackedScene = preload("res://scenes/actor/person.tscn")
const CLIP: String = "res://assets/motion/01_01.bvh"

var _desk: MocapSetup = null
var _context: ClientContext = null
var _asked: Array[String] = []
var _now_s: float = 0.0


func before_each() -> void:
	_asked.clear()
	get_window().size = Vector2i(1280, 720)
	_context = ClientContext.new()
	_context.scene = ClientScene.new()
	_context.scene.person_scene = PERSON
	_context.link = ClientLink.new()
	_context.try_out = TryOut.new()
	_context.try_out.where = "10.0.0.5:7777"
	_context.try_out.join_wanted.connect(_asked.append.bind("join"))
	_context.leave_wanted.connect(func(_code: int) -> void: _asked.append("leave"))
	_desk = MocapSetup.new()
	add_child(_desk)


func after_each() -> void:
	_desk.close()
	_desk.free()
	_context.scene.free()


func goes_by_clock() -> bool:
	return true


func test_without_a_source_it_says_so_and_what_to_do_and_who_joins_walks() -> void:
	equal(_open(["--try"]), "")
	_look()
	is_true(_sheet().is_visible_in_tree())
	contains(_text("Trouble"), "you walk by keys")
	contains(_text("Trouble"), "--xbus")
	not_null(_body(), "somebody stands there nevertheless")
	equal(_context.people.count(), 0, "people before somebody joins")
	_press_join()
	equal(_asked, ["join"] as Array[String])
	equal(_context.people.count(), 1)
	is_true(_context.people.source_of(0) is WalkerSource)


func test_a_source_moves_the_body_and_is_told_of() -> void:
	equal(_open(["--try", "--bvh=" + CLIP]), "")
	var moves: Callable = func() -> bool:
		_look()
		return _body() != null and _body().view.node.visible and _rows()[0].get_text(1) == "moves"
	await until(moves)
	equal(_text("Trouble"), "")
	contains(_text("Wearer"), "m tall, hips at")
	contains(_text("Wearer"), "comes calibrated")
	contains(_rows()[0].get_text(2), "01_01.bvh")
	contains(_text("Session"), "10.0.0.5:7777")


func test_another_avatar_is_worn_and_sent() -> void:
	equal(_open(["--try", "--bvh=" + CLIP, "--avatar=raider"]), "")
	_look()
	var list: OptionButton = _sheet().find_child("Avatars", true, false)
	equal(list.get_item_text(list.selected), "raider")
	contains(_body().view.node.scene_file_path, "raider")
	var other: int = AvatarStore.NAMES.find("show") + 1
	list.item_selected.emit(other)
	_look()
	equal(_context.people.motions()[0].card.avatar, "show")
	contains(_body().view.node.scene_file_path, "show")


func test_the_session_takes_the_mirrors_place_and_words_of_a_refusal_are_in_it() -> void:
	equal(_open(["--try", "--bvh=" + CLIP]), "")
	_look()
	_press_join()
	_context.try_out.note(TryOut.Phase.LOOKING, "The server refused us: wrong password.")
	contains(_text("Session"), "wrong password")
	_press_join()
	equal(_asked, ["join", "join"] as Array[String])
	_context.try_out.note(TryOut.Phase.JOINED, "")
	is_false(_desk.is_panel_open())


func test_the_panel_is_not_closed_on_nothing() -> void:
	equal(_open(["--try", "--bvh=" + CLIP]), "")
	await _press(KEY_M)
	is_true(_desk.is_panel_open())
	var prompt: UiPrompt = _desk.find_children("*", "UiPrompt", true, false)[0]
	is_true(prompt.visible)
	await _press(KEY_ESCAPE)
	is_false(prompt.visible, "Esc stays")
	equal(_asked, [] as Array[String])
	await _press(KEY_M)
	(prompt.find_child("Leave", true, false) as Button).pressed.emit()
	equal(_asked, ["leave"] as Array[String])


func test_a_calibration_leaves_the_mirror() -> void:
	var feed: WornSensorFeed = WornSensorFeed.new()
	for mount: int in BodyMounts.COUNT:
		feed.add_sensor(mount)
	equal(_open(["--try"]), "")
	var suit: SuitSource = SuitSource.new(feed)
	_desk.inputs.wearers.append(suit)
	_desk.people.add(suit, "Ada")
	feed.measure(CalibrationMotion.new().pose_at(0.0), 1000000)
	suit.advance(1.0)
	_look()
	contains(_text("Wearer"), "Ada")
	contains(_text("Wearer"), "Not calibrated yet: press F4")
	_desk.find_children("*", "DevicePanel", true, false)[0].call(
		"start_calibration", CalibrationGuide.Kind.T_POSE
	)
	is_false(_sheet().visible)


func _open(p_arguments: PackedStringArray) -> String:
	_context.options = ProgramOptions.parse(p_arguments)
	equal(_context.options.error, "")
	return _desk.open(_context)


## A frame of the program, whenever the last one was.
func _look() -> void:
	_now_s += 1.0
	_desk.read_sources(_now_s)


func _press_join() -> void:
	(_sheet().find_child("Join", true, false) as Button).pressed.emit()


func _sheet() -> MirrorSheet:
	return _desk.find_children("*", "MirrorSheet", true, false)[0]


func _body() -> MirrorBody:
	var found: Array[Node] = _sheet().mirror.stage.get_children()
	return found[0] if not found.is_empty() else null


func _rows() -> Array[TreeItem]:
	return (_sheet().find_child("Devices", true, false) as Tree).get_root().get_children()


func _text(p_label: String) -> String:
	return (_sheet().find_child(p_label, true, false) as Label).text


func _press(p_key: Key) -> void:
	var event: InputEventKey = InputEventKey.new()
	event.keycode = p_key
	event.pressed = true
	get_window().push_input(event)
	await process_frames(2)
