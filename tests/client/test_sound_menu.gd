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
