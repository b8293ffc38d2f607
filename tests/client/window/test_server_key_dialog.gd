extends TestCase
## What a user sees and can choose where a server shows another key.

const DIALOG: PackedScene = preload("res://scenes/client/window/server_key_dialog.tscn")

var _window: SubViewport = null
var _dialog: ServerKeyDialog = null
var _left: Array[bool] = []
var _trusted: Array[OtherServerKey] = []
var _other: OtherServerKey = null


func before_each() -> void:
	_left.clear()
	_trusted.clear()
	# Without a screen the window has no room for it.
	_window = SubViewport.new()
	_window.size = Vector2i(1280, 720)
	add_child(_window)
	_dialog = DIALOG.instantiate()
	_window.add_child(_dialog)
	_dialog.leave_wanted.connect(func() -> void: _left.append(true))
	_dialog.trusted.connect(_trusted.append)
	_other = OtherServerKey.new()
	_other.address = "there:7777"
	_other.known = "SHA256:before"
	_other.shown = Crypto.new().generate_random_bytes(KeyFingerprint.KEY_SIZE)


func after_each() -> void:
	_window.free()


func test_it_shows_the_server_and_both_keys() -> void:
	is_false(_dialog.is_open())
	_dialog.ask(_other)
	is_true(_dialog.is_open())
	var text: String = (_dialog.find_child("Text", true, false) as Label).text
	for part: String in ["there:7777", "SHA256:before", KeyFingerprint.of(_other.shown)]:
		contains(text, part)


func test_enter_and_escape_leave() -> void:
	for key: Key in [KEY_ENTER, KEY_ESCAPE]:
		_left.clear()
		_dialog.ask(_other)
		_press(key)
		is_false(_dialog.is_open())
		equal(_left.size(), 1)
	equal(_trusted.size(), 0)
	_press(KEY_ESCAPE)
	equal(_left.size(), 1, "nothing is asked any more")


func test_the_other_button_trusts_by_keyboard_and_mouse() -> void:
	_dialog.ask(_other)
	_press(KEY_RIGHT)
	_press(KEY_ENTER)
	equal(_trusted, [_other] as Array[OtherServerKey])
	is_false(_dialog.is_open())
	_dialog.ask(_other)
	await process_frames(2)
	_click(_dialog.find_child("TrustIt", true, false))
	equal(_trusted.size(), 2)
	equal(_left.size(), 0)


func _press(p_key: Key) -> void:
	for pressed: bool in [true, false]:
		var event: InputEventKey = InputEventKey.new()
		event.keycode = p_key
		event.physical_keycode = p_key
		event.pressed = pressed
		_window.push_input(event)


func _click(p_control: Control) -> void:
	for pressed: bool in [true, false]:
		var event: InputEventMouseButton = InputEventMouseButton.new()
		event.button_index = MOUSE_BUTTON_LEFT
		event.position = p_control.get_global_rect().get_center()
		event.global_position = event.position
		event.pressed = pressed
		_window.push_input(event, true)
