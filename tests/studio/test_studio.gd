extends TestCase
## The studio without a picture: a text is shown when nothing is wrong with it, and what was shown
## goes on otherwise.

const FOLDER: String = "user://test_studio_scene"

var _studio: Studio = null


## A process that still starts.
class Starting:
	extends EffectSandbox
	var tried: String = ""
	var verdict: Verdict = Verdict.WAITING

	func is_there() -> bool:
		return true

	func try_text(p_text: String) -> void:
		tried = p_text

	func poll() -> Verdict:
		return verdict


func before_each() -> void:
	_studio = (load("res://scenes/studio/studio.tscn") as PackedScene).instantiate()
	_studio.file.folder = FOLDER
	add_child(_studio)


func after_each() -> void:
	_studio.free()
	for name: String in DirAccess.get_files_at(StudioFile.KEPT):
		# Only what these tests have made: names alone may be somebody's own.
		if name.contains(".%s." % ProjectSettings.globalize_path(FOLDER).md5_text().left(8)):
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


func test_a_slider_keeps_what_was_just_typed() -> void:
	await _type(EffectTexts.GOOD)
	# It is not shown, as something is missing.
	await _type(EffectTexts.GOOD.replace("CUSTOM = vec4(0.0);", "// mine\n("))
	_studio.panel.row("@count").slider().value = 120.0
	_studio.panel.row("drag").slider().value = 2.0
	await process_frames(1)
	contains(_studio.code.text, "// mine")
	contains(_studio.code.text, "// @count    120")
	contains(_studio.code.text, "hint_range(0, 4) = 2.0;")


func test_a_new_effect_takes_the_place_of_none() -> void:
	await _type(EffectTexts.GOOD)
	_studio.do("new")
	var first: String = _studio.file.name
	await _type(EffectTexts.GOOD + "// first\n")
	_studio.do("new")
	await _type(EffectTexts.GOOD + "// second\n")
	is_true(_studio.file.name != first, first)
	_studio.open_effect(first)
	contains(_studio.code.text, "// first")


func test_a_text_with_loops_waits_for_a_process_that_starts() -> void:
	await _type(EffectTexts.GOOD)
	var starting: Starting = Starting.new()
	_studio.sandbox = starting
	var loop: String = "for (int i = 0; i < 8; i++) { CUSTOM.x += 0.1; }"
	var text: String = EffectTexts.GOOD.replace("CUSTOM = vec4(0.0);", loop)
	await _type(text)
	await process_frames(2)
	equal([starting.tried, _studio.shown.text], [text, EffectTexts.GOOD])
	starting.verdict = EffectSandbox.Verdict.NONE
	await process_frames(2)
	equal(_studio.shown.text, text)


func test_one_thing_is_measured_or_filmed_at_a_time() -> void:
	await _type(EffectTexts.GOOD)
	_studio.do("measure")
	var first: StudioComparison = _studio._measure
	_studio.do("measure")
	_studio.do("film")
	is_true(first != null and _studio._measure == first)
	is_true(_studio._film == null)
	contains(_studio._notice, "measuring")


func test_send_goes_to_the_address_that_stands_there() -> void:
	var session: StudioSession = StudioSession.new()
	var told: PackedStringArray = []
	session.notified.connect(func(text: String) -> void: told.append(text))
	for port: int in [40001, 40001, 40002]:
		session.address = "127.0.0.1:%d" % port
		session.send("fountain", EffectTexts.GOOD)
	session.close()
	equal(told.size(), 2, str(told))
	contains(told[1], "40002")


func test_it_lays_out_in_a_small_window() -> void:
	for size: Vector2 in [Vector2(1280, 720), Vector2(640, 360)]:
		_studio.set_anchors_preset(Control.PRESET_TOP_LEFT)
		_studio.size = size
		await process_frames(2)
		var area: Rect2 = Rect2(Vector2.ZERO, size)
		for part: Control in [_studio.code, _studio.preview]:
			is_true(
				area.encloses(part.get_global_rect()), "%s in %s" % [part.get_global_rect(), area]
			)
			is_true(part.size.x > 200.0 and part.size.y > 150.0, "%s" % part.size)
		is_false(_studio.code.get_global_rect().intersects(_studio.preview.get_global_rect()))


func _type(p_text: String) -> void:
	_studio.code.replace_text(p_text)
	# A text tells of its change once a frame.
	await process_frames(1)
