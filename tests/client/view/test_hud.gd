extends TestCase
## What the screen tells its user, and for how long.

var _screen: SubViewport = null
var _hud: Hud = null


func before_each() -> void:
	_screen = SubViewport.new()
	_screen.size = Vector2i(640, 360)
	add_child(_screen)
	_hud = (load("res://scenes/client/view/hud.tscn") as PackedScene).instantiate()
	_screen.add_child(_hud)


func after_each() -> void:
	_screen.free()


func test_a_note_stays_whatever_other_topics_have_to_say() -> void:
	_hud.show_note("No headset", &"display")
	_hud.show_note("Another world", &"level")
	_hud.show_note("", &"level")
	equal(_note().text, "No headset")
	is_true(_note().visible)
	_hud.show_note("Stand still", &"told")
	equal(_note().text, "No headset\nStand still")
	_hud.show_note("Headset lost", &"display")
	equal(_note().text, "Headset lost\nStand still")
	_hud.show_note("", &"display")
	_hud.show_note("", &"told")
	is_false(_note().visible)


func test_long_notes_and_news_stay_on_the_screen() -> void:
	var long: String = "Something has happened. ".repeat(20)
	_hud.show_note(long, &"level")
	_hud.show_news(long)
	await process_frames(2)
	var news: Label = _hud.find_child("News").get_child(0)
	for label: Label in [_note(), news]:
		is_true(
			_screen.get_visible_rect().encloses(label.get_global_rect()),
			"%s: %s" % [label.get_path(), label.get_global_rect()]
		)
		is_true(label.get_line_count() > 1, label.text)
		equal(label.get_visible_line_count(), label.get_line_count())


func _note() -> Label:
	return _hud.find_child("Note")
