extends TestCase
## What a client makes of options and of what has been chosen of sound.

const PATH: String = "user://test_client_sound.cfg"


func after_each() -> void:
	DirAccess.remove_absolute(PATH)


func test_the_menu_shows_what_is_on_and_volumes_are_kept_once_they_settle() -> void:
	var menu: SoundMenu = SoundMenu.new()
	add_child(menu)
	var sound: ClientSound = ClientSound.new()
	sound._settings = UserSettings.new(PATH)
	sound._menu = menu
	sound.voices = SoundVoices.new()
	add_child(sound.voices)
	sound._tick = AudioStreamPlayer.new()
	sound.add_child(sound._tick)
	sound._apply_settings(ProgramOptions.parse(["--captions"]))
	is_true(menu._checks[&"captions"].button_pressed, "they are on by the option")
	is_false(menu._checks[&"binaural"].button_pressed)
	is_false(UserSettings.new(PATH).is_sound_on(&"captions"), "an option is no choice")
	menu._sliders[SoundBuses.WORLD].slider.value = 45.0
	almost_equal(SoundBuses.volume(SoundBuses.WORLD), 0.45, 0.001)
	equal(UserSettings.new(PATH).volume(SoundBuses.WORLD), 1.0, "it may still move")
	menu.close()
	almost_equal(UserSettings.new(PATH).volume(SoundBuses.WORLD), 0.45, 0.001)
	menu._checks[&"captions"].button_pressed = false
	is_false(UserSettings.new(PATH).is_sound_on(&"captions"))
	SoundBuses.set_volume(SoundBuses.WORLD, 1.0)
	sound.voices.free()
	sound.free()
	menu.free()
