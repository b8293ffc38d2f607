extends TestCase
## What Esc and F1 lead to, and which keys are offered.

const MENU: PackedScene = preload("res://scenes/client/view/window_menu.tscn")

var _menu: WindowMenu = null


func before_each() -> void:
	_menu = MENU.instantiate()
	add_child(_menu)


func after_each() -> void:
	_menu.free()


func test_escape_opens_and_closes_the_menu() -> void:
	is_false(_menu.is_open())
	_press(KEY_ESCAPE)
	is_true(_menu.is_open())
	_press(KEY_ESCAPE)
	is_false(_menu.is_open())


func test_f1_shows_the_keys_and_escape_hides_them() -> void:
	_press(KEY_F1)
	is_true(_menu.shows_keys())
	_press(KEY_ESCAPE)
	is_false(_menu.shows_keys())
	is_false(_menu.is_open(), "it only closed the list")


func test_the_buttons_do_what_they_say() -> void:
	var left: Array[bool] = []
	_menu.leave_wanted.connect(func() -> void: left.append(true))
	_press(KEY_ESCAPE)
	_button("Keys").pressed.emit()
	is_true(_menu.shows_keys())
	is_false(_menu.is_open())
	_press(KEY_ESCAPE)
	_press(KEY_ESCAPE)
	_button("Continue").pressed.emit()
	is_false(_menu.is_open())
	equal(left.size(), 0)
	_button("Leave").pressed.emit()
	equal(left.size(), 1)


func test_parts_add_entries_and_pages() -> void:
	var chosen: Array[String] = []
	_menu.add_entry("Wheel", func() -> void: chosen.append("wheel"))
	_menu.add_entry("Quality", func() -> void: chosen.append("quality"), true)
	var page: SoundMenu = SoundMenu.new()
	_menu.add_page("Sound", page, page.open, page.closed)
	_press(KEY_ESCAPE)
	equal(_button("Leave").get_index(), _button("Sound").get_index() + 1, "leaving comes last")
	_button("Quality").pressed.emit()
	is_true(_menu.is_open(), "it may be chosen again")
	_button("Wheel").pressed.emit()
	is_false(_menu.is_open())
	equal(chosen, ["quality", "wheel"] as Array[String])
	_press(KEY_ESCAPE)
	_button("Sound").pressed.emit()
	is_true(page.visible and _menu.is_open(), "keys are still meant for it")
	page.close()
	is_true(_menu.is_open(), "back to the menu")
	_press(KEY_ESCAPE)
	is_false(_menu.is_open())


func test_only_keys_that_do_something_are_offered() -> void:
	var watching: String = KeyGuide.describe(false, true)
	var moving: String = KeyGuide.describe(true, true)
	var replaying: String = KeyGuide.describe(false, false)
	contains(moving, "M\tmotion capture")
	is_false("motion capture" in watching)
	is_false("motion capture" in KeyGuide.hint(false))
	contains(KeyGuide.hint(true), "M motion capture")
	contains(watching, "E\tuse")
	is_false("E\tuse" in replaying)
	is_false("steer" in replaying)
	for text: String in [watching, moving, replaying]:
		for key: String in ["Esc\t", "F1\t", "F11\t", "Tab\t", "N\t", "V\t", "L\t", "1\t"]:
			contains(text, key)


func test_every_offered_key_is_an_action_of_the_project() -> void:
	for action: StringName in KeyGuide.actions(true, true):
		is_true(InputMap.has_action(action), action)
		is_true(InputKeys.name_of(action) != "", action)


func _button(p_name: String) -> Button:
	return _menu.find_child(p_name, true, false)


func _press(p_key: Key) -> void:
	var event: InputEventKey = InputEventKey.new()
	event.keycode = p_key
	event.pressed = true
	_menu._unhandled_input(event)
