extends TestCase
## The studio without a picture: a text is shown when nothing is wrong with it, and what was shown
## goes on otherwise.

var _studio: Studio = null


func before_each() -> void:
	_studio = (load("res://scenes/studio/studio.tscn") as PackedScene).instantiate()
	_studio.file.folder = "user://test_studio_scene"
	add_child(_studio)


func after_each() -> void:
	_studio.free()
	for name: String in DirAccess.get_files_at(StudioFile.KEPT):
		if name.begins_with("fountain"):
			DirAccess.remove_absolute(StudioFile.KEPT.path_join(name))


func test_what_is_typed_is_shown_and_what_is_broken_is_not() -> void:
	for text: String in ["Shader compilation failed", "Unknown identifier", "Expected"]:
		allow_error(text)
	await _type(EffectTexts.GOOD)
	equal(_studio.shown.text, EffectTexts.GOOD)
	await _type(EffectTexts.GOOD.replace("CUSTOM = vec4(0.0);", "CUSTOM = vec4(nothing);"))
	equal(_studio.problems[0].line, 19)
	equal(_studio.shown.text, EffectTexts.GOOD)
	equal(_studio.code.get_line_background_color(18), StudioCode.COLOUR_PROBLEM)
	await _type(EffectTexts.GOOD.replace("@count 50", "@count 51"))
	equal(_studio.preview.effect.amount, 51)
	equal(_studio.code.get_line_background_color(18), Color(0.0, 0.0, 0.0, 0.0))


func test_a_slider_writes_into_the_text_and_undo_takes_it_back() -> void:
	await _type(EffectTexts.GOOD)
	_studio.panel.row("@count").slider().value = 120.0
	await process_frames(1)
	equal(_studio.shown.settings.count, 120)
	contains(_studio.code.text, "// @count    120")
	_studio.panel.row("drag").slider().value = 2.0
	await process_frames(1)
	contains(_studio.code.text, "hint_range(0, 4) = 2.0;")
	_studio.do("undo")
	_studio.do("undo")
	await process_frames(1)
	equal(_studio.code.text, EffectTexts.GOOD)


func test_an_endless_loop_is_never_shown() -> void:
	await _type(EffectTexts.GOOD)
	for loop: String in ["while (true) { }", "for (;;) { }", "for (int i = 0; i < 8; i--) { }"]:
		await _type(EffectTexts.GOOD.replace("CUSTOM = vec4(0.0);", loop))
		is_false(_studio.problems.is_empty(), loop)
		equal(_studio.shown.text, EffectTexts.GOOD)


func test_it_lays_out_in_a_small_window() -> void:
	for size: Vector2 in [Vector2(1280, 720), Vector2(640, 360)]:
		_studio.set_anchors_preset(Control.PRESET_TOP_LEFT)
		_studio.size = size
		await process_frames(2)
		var area: Rect2 = Rect2(Vector2.ZERO, size)
		for part: Control in [_studio.code, _studio.preview]:
			is_true(area.encloses(part.get_rect()), "%s in %s" % [part.get_rect(), area])
			is_true(part.size.x > 200.0 and part.size.y > 150.0, "%s" % part.size)
		is_false(_studio.code.get_rect().intersects(_studio.preview.get_rect()))


func _type(p_text: String) -> void:
	_studio.code.replace_text(p_text)
	# A text tells of its change once a frame.
	await process_frames(1)
