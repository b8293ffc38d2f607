extends TestCase
## The menu that wearers of a headset see says how things are, and tells what was chosen.

var _menu: HeadsetMenu = null
var _chosen: Array[HeadsetMenu.Entry] = []


func before_each() -> void:
	_chosen.clear()
	_menu = HeadsetMenu.new()
	_menu.size = HmdMenu.SIZE_PX
	_menu.chosen.connect(func(entry: HeadsetMenu.Entry) -> void: _chosen.append(entry))
	add_child(_menu)
	await process_frames(2)


func after_each() -> void:
	_menu.free()


func test_every_entry_can_be_chosen_and_read() -> void:
	var bottom: float = 0.0
	for button: Button in _menu.find_children("*", "Button", true, false):
		var area: Rect2 = button.get_global_rect()
		is_true(area.position.y >= bottom, "%s lies over another" % button.text)
		is_true(area.size.y > 80.0 and Rect2(Vector2.ZERO, _menu.size).encloses(area))
		var wide: float = button.get_minimum_size().x
		is_true(wide <= area.size.x, "%s is cut" % button.text)
		bottom = area.end.y
		button.pressed.emit()
	equal(_chosen, HeadsetMenu.Entry.values())


func test_settings_say_what_they_are() -> void:
	_menu.describe(true, false, true)
	equal(_menu.text_of(HeadsetMenu.Entry.SEATED), "Seated: on")
	contains(_menu.text_of(HeadsetMenu.Entry.VIGNETTE), ": off")
	contains(_menu.text_of(HeadsetMenu.Entry.SNAP_TURN), ": on")
