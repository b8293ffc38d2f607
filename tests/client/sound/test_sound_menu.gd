extends TestCase
## The menu of sound, captions on the screen, and what is kept of both.

const PATH: String = "user://test_sound_settings.cfg"

var _changes: Array[Array] = []


func after_each() -> void:
	DirAccess.remove_absolute(PATH)


func test_sliders_and_switches_say_what_has_changed() -> void:
	var menu: SoundMenu = SoundMenu.new()
	add_child(menu)
	menu.volume_changed.connect(_on_changed)
	menu.switched.connect(_on_changed)
	menu.show_volume(&"World", 0.3)
	menu.show_switch(&"captions", false)
	equal(_changes, [], "showing is no change")
	menu.open()
	is_true(menu.visible)
	for slider: Node in menu.find_children("*", "HSlider", true, false):
		(slider as HSlider).value = 50.0
	for check: Node in menu.find_children("*", "CheckButton", true, false):
		(check as CheckButton).button_pressed = true
	equal(_changes.size(), SoundBuses.SETTABLE.size() + SoundMenu.SWITCHES.size())
	equal(_changes[0], [&"Master", 0.5])
	menu.free()


func test_a_volume_settles_when_the_slider_is_let_go_or_the_menu_closed() -> void:
	var menu: SoundMenu = SoundMenu.new()
	add_child(menu)
	menu.volume_settled.connect(_on_changed)
	menu.open()
	var sliders: Array[Node] = menu.find_children("*", "HSlider", true, false)
	var first: HSlider = sliders[0] as HSlider
	for value: float in [80.0, 60.0, 40.0]:
		first.value = value
	equal(_changes, [], "nothing is kept at a step")
	first.drag_ended.emit(true)
	equal(_changes, [[&"Master", 0.4]])
	(sliders[1] as HSlider).value = 20.0
	menu.close()
	equal(_changes, [[&"Master", 0.4], [SoundBuses.WORLD, 0.2]], "by keys: on closing")
	menu.free()
	equal(_changes.size(), 2)


func test_choices_are_kept() -> void:
	var settings: UserSettings = UserSettings.new(PATH)
	equal(settings.volume(&"World"), 1.0)
	is_true(settings.is_sound_on(&"limiter"))
	is_false(settings.is_sound_on(&"captions"))
	settings.choose_volume(&"World", 0.25)
	settings.choose_sound(&"captions", true)
	var again: UserSettings = UserSettings.new(PATH)
	almost_equal(again.volume(&"World"), 0.25)
	is_true(again.is_sound_on(&"captions"))


func test_nonsense_in_the_file_counts_as_nothing() -> void:
	var file: FileAccess = FileAccess.open(PATH, FileAccess.WRITE)
	file.store_string('[sound]\nworld="loud"\nvoices=nan\nmaster=-4\ncaptions="yes"\n')
	file.close()
	var settings: UserSettings = UserSettings.new(PATH)
	equal(settings.volume(&"World"), 1.0)
	equal(settings.volume(&"Voices"), 1.0)
	equal(settings.volume(&"Master"), 0.0)
	is_false(settings.is_sound_on(&"captions"))


func _on_changed(p_what: StringName, p_value: Variant) -> void:
	_changes.append([p_what, p_value])
