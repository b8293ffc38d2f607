extends TestCase
## Panels and questions stay on the screen, and are answered with keyboard and gamepad alone.

var _screen: SubViewport = null


func before_each() -> void:
	_screen = SubViewport.new()
	_screen.size = Vector2i(853, 480)
	add_child(_screen)


func after_each() -> void:
	_screen.free()


func test_a_panel_is_as_high_as_its_rows_and_in_the_middle() -> void:
	var panel: UiPanel = UiPanel.new("Title", 200.0)
	_screen.add_child(panel)
	panel.add_button("One", func() -> void: pass)
	await process_frames(2)
	var small: float = panel.size.y
	for row: int in 4:
		panel.add_button("More %d" % row, func() -> void: pass)
	await process_frames(2)
	is_true(panel.size.y > small + 100.0)
	var off: Vector2 = panel.get_rect().get_center() - Vector2(_screen.size) / 2.0
	is_true(off.length() < 2.0, str(off))


func test_a_panel_that_is_too_high_scrolls_to_what_has_the_keyboard() -> void:
	var panel: UiPanel = UiPanel.new("Title", 2000.0)
	_screen.add_child(panel)
	for row: int in 40:
		panel.add_button("Row %d" % row, func() -> void: pass)
	var done: Button = panel.add_answer("Done", func() -> void: pass)
	await process_frames(3)
	var area: Rect2 = _screen.get_visible_rect()
	is_true(area.encloses(panel.get_global_rect()), str(panel.get_global_rect()))
	is_true(area.encloses(done.get_global_rect()), "the answers stay")
	var last: Button = panel.find_child("Row39", true, false)
	last.grab_focus()
	await process_frames(2)
	is_true(panel.get_global_rect().encloses(last.get_global_rect()))


func test_from_the_first_button_the_keyboard_goes_up_to_the_last() -> void:
	var panel: UiPanel = UiPanel.new("Title", 200.0)
	_screen.add_child(panel)
	for row: int in 3:
		panel.add_button("Row %d" % row, func() -> void: pass)
	panel.rows.move_child(panel.find_child("Row2", true, false), 1)
	await process_frames(2)
	(panel.find_child("Row0", true, false) as Button).grab_focus()
	for expected: String in ["Row1", "Row2", "Row0"]:
		_press(&"ui_up")
		equal(str(_screen.gui_get_focus_owner().name), expected)
	_press(&"ui_up")
	_press(&"ui_down")
	equal(str(_screen.gui_get_focus_owner().name), "Row0")


func test_the_safe_answer_is_given_by_escape_and_has_the_keyboard() -> void:
	var given: Array[int] = []
	var prompt: UiPrompt = UiPrompt.new("Really?")
	prompt.set_answers(["No", "Yes"])
	prompt.answered.connect(func(answer: int) -> void: given.append(answer))
	_screen.add_child(prompt)
	is_false(prompt.visible)
	for action: StringName in [&"ui_cancel", &"ui_accept"]:
		prompt.ask("It cannot be undone.")
		_press(action)
		is_false(prompt.visible)
	equal(given, [0, 0] as Array[int])
	prompt.ask("Again?")
	_press(&"ui_right")
	_press(&"ui_accept")
	equal(given[-1], 1)


func test_notes_go_by_themselves_and_the_oldest_makes_room() -> void:
	var toasts: UiToasts = UiToasts.new()
	toasts.most = 2
	_screen.add_child(toasts)
	for text: String in ["one", "two", "three"]:
		toasts.show_note(text)
	equal(toasts.texts(), PackedStringArray(["two", "three"]))
	toasts._process(toasts.stay_s)
	equal(toasts.texts(), PackedStringArray())


func _press(p_action: StringName) -> void:
	for pressed: bool in [true, false]:
		var event: InputEventAction = InputEventAction.new()
		event.action = p_action
		event.pressed = pressed
		_screen.push_input(event)
