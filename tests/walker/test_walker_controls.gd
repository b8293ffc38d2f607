extends TestCase
## What hands wish who walk, by the events of a gamepad and of keys.

const STEP_S: float = 1.0 / 60.0
const PAD: int = 0

var _controls: WalkerControls = null


func before_each() -> void:
	_controls = WalkerControls.new()
	add_child(_controls)


func after_each() -> void:
	for axis: JoyAxis in [JOY_AXIS_LEFT_X, JOY_AXIS_LEFT_Y, JOY_AXIS_RIGHT_X, JOY_AXIS_RIGHT_Y]:
		_move(axis, 0.0)
	for button: JoyButton in [JOY_BUTTON_Y, JOY_BUTTON_B, JOY_BUTTON_LEFT_STICK]:
		_press(button, false)
	_key(KEY_W, false)
	_key(KEY_D, false)
	_controls.free()


func test_the_full_stick_jogs_half_of_it_walks_and_pressed_it_runs() -> void:
	_move(JOY_AXIS_LEFT_Y, -1.0)
	almost_equal(_wish(), Vector2(0.0, WalkerControls.JOG), 1e-3)
	_move(JOY_AXIS_LEFT_Y, -0.575)
	almost_equal(_wish(), Vector2(0.0, 0.5 * WalkerControls.JOG), 1e-3)
	_move(JOY_AXIS_LEFT_Y, -1.0)
	_press(JOY_BUTTON_LEFT_STICK, true)
	almost_equal(_wish(), Vector2(0.0, WalkerControls.RUN), 1e-3)


func test_aslant_is_no_faster_and_a_stick_that_rests_stands() -> void:
	_move(JOY_AXIS_LEFT_X, 1.0)
	_move(JOY_AXIS_LEFT_Y, -1.0)
	almost_equal(_wish().length(), WalkerControls.JOG, 1e-3)
	# To the right of +Z is -X.
	is_true(_wish().x < 0.0 and _wish().y > 0.0)
	_move(JOY_AXIS_LEFT_X, 0.1)
	_move(JOY_AXIS_LEFT_Y, -0.1)
	equal(_wish(), Vector2.ZERO)


func test_keys_walk_at_their_own_speed_beside_a_stick_that_rests() -> void:
	_move(JOY_AXIS_LEFT_X, 0.08)
	_key(KEY_W, true)
	almost_equal(_wish(), Vector2(0.0, WalkerControls.WALK), 1e-3)
	_key(KEY_D, true)
	almost_equal(_wish().length(), WalkerControls.WALK, 1e-3)


func test_the_right_stick_turns_and_looks() -> void:
	_move(JOY_AXIS_RIGHT_X, -1.0)
	_move(JOY_AXIS_RIGHT_Y, -0.0)
	var input: WalkerInput = _controls.read(0.5)
	almost_equal(input.heading, 0.5 * WalkerControls.TURN_RATE, 1e-3, "to the left")
	_move(JOY_AXIS_RIGHT_X, 0.0)
	_move(JOY_AXIS_RIGHT_Y, -1.0)
	almost_equal(_controls.read(0.2).look, 0.2 * WalkerControls.TURN_RATE, 1e-3, "up")
	almost_equal(_controls.read(5.0).look, WalkerControls.MAX_LOOK, 1e-6)


func test_buttons_jump_crouch_lie_and_use() -> void:
	_press(JOY_BUTTON_Y, true)
	is_true(_controls.read(STEP_S).jumps)
	_press(JOY_BUTTON_Y, false)
	_press(JOY_BUTTON_B, true)
	equal(_controls.read(STEP_S).stance, WalkerMover.CROUCH)
	_press(JOY_BUTTON_B, false)
	equal(_controls.read(STEP_S).stance, WalkerMover.STAND)
	for stance: WalkerMover.Stance in [WalkerMover.PRONE, WalkerMover.STAND]:
		_press(JOY_BUTTON_DPAD_DOWN, true)
		_press(JOY_BUTTON_DPAD_DOWN, false)
		equal(_controls.read(STEP_S).stance, stance)
	_press(JOY_BUTTON_A, true)
	is_true(Input.is_action_pressed(&"interact"))
	_press(JOY_BUTTON_A, false)


func test_a_gamepad_that_is_unplugged_lets_go() -> void:
	_move(JOY_AXIS_LEFT_Y, -1.0)
	_move(JOY_AXIS_RIGHT_X, 1.0)
	Input.joy_connection_changed.emit(PAD, false)
	equal(_wish(), Vector2.ZERO)
	equal(_controls.read(1.0).heading, 0.0)


func _wish() -> Vector2:
	return _controls.read(STEP_S).wish


func _move(p_axis: JoyAxis, p_value: float) -> void:
	var event: InputEventJoypadMotion = InputEventJoypadMotion.new()
	event.device = PAD
	event.axis = p_axis
	event.axis_value = p_value
	_send(event)


func _press(p_button: JoyButton, p_is_pressed: bool) -> void:
	var event: InputEventJoypadButton = InputEventJoypadButton.new()
	event.device = PAD
	event.button_index = p_button
	event.pressed = p_is_pressed
	_send(event)


func _key(p_key: Key, p_is_pressed: bool) -> void:
	var event: InputEventKey = InputEventKey.new()
	event.physical_keycode = p_key
	event.pressed = p_is_pressed
	_send(event)


func _send(p_event: InputEvent) -> void:
	Input.parse_input_event(p_event)
	Input.flush_buffered_events()
