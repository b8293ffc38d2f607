@tool
class_name Studio
extends Control
## The effects studio: the code of an effect on the left, the effect on the right, renewed at every
## key press. The thesis calls it Subatomic Studio (9.2).
##
## What is broken is named at its line, and what was shown before goes on. A text with loops is
## first tried in a process of its own ([EffectSandbox]).

## The smallest studio that has room for the sliders, px.
const WITH_PANEL: Vector2 = Vector2(600.0, 480.0)
## Time between two times that an unsaved text is kept, s.
const KEEP_S: float = 2.0
const FILM_RATE: int = 30
const FILM_S: float = 6.0
const COLOUR_FINE: Color = Color(0.75, 0.9, 0.75)
const COLOUR_PROBLEM: Color = Color(1.0, 0.62, 0.55)

## The code.
var code: StudioCode = StudioCode.new()
## The picture.
var preview: StudioPreview = StudioPreview.new()
## The sliders.
var panel: StudioPanel = StudioPanel.new()
## The file.
var file: StudioFile = StudioFile.new()
## The measured times.
var meter: StudioMeter = StudioMeter.new()
## Where texts with loops are tried first.
var sandbox: EffectSandbox = EffectSandbox.new()
## What is wrong with the text now.
var problems: Array[EffectProblem] = []
## The newest text without problems: it is shown.
var shown: EffectFile = null

var _bar: StudioBar = StudioBar.new()
var _status: Label = Label.new()
var _message: Label = Label.new()
var _help: TextEdit = TextEdit.new()
var _session: StudioSession = StudioSession.new()
var _film: FilmFile = null
var _film_begin_ms: int = 0
var _candidate: EffectFile = null
var _keep_s: float = 0.0
var _notice: String = ""
var _measure: StudioComparison = null


func _ready() -> void:
	set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	# In the editor it stands in a container.
	size_flags_vertical = Control.SIZE_EXPAND_FILL
	size_flags_horizontal = Control.SIZE_EXPAND_FILL
	var back: ColorRect = ColorRect.new()
	back.color = Color(0.13, 0.14, 0.17)
	back.set_anchors_preset(Control.PRESET_FULL_RECT)
	add_child(back)
	theme = load(UiStyle.DENSE)
	_help.editable = false
	_help.text = StudioWords.everything()
	_help.visible = false
	_help.wrap_mode = TextEdit.LINE_WRAPPING_BOUNDARY
	for label: Label in [_message, _status]:
		label.clip_text = true
	_put_together()
	_connect_parts()
	sandbox.start()
	RenderingServer.frame_post_draw.connect(_on_frame_drawn)
	resized.connect(_show_panel)
	_show_panel()
	var asked: String = _asked_effect()
	_bar.show_names(file.names(), asked)
	open_effect(asked)
	code.grab_focus()


func _process(p_delta: float) -> void:
	_session.advance()
	_poll_sandbox()
	_keep_s += p_delta
	if _keep_s > KEEP_S:
		_keep_s = 0.0
		file.keep(code.text)
	_show_status()


func _exit_tree() -> void:
	file.keep(code.text)
	sandbox.close()
	_session.close()
	if _film != null:
		_film.close()
		_film = null
	if RenderingServer.frame_post_draw.is_connected(_on_frame_drawn):
		RenderingServer.frame_post_draw.disconnect(_on_frame_drawn)


func _shortcut_input(p_event: InputEvent) -> void:
	var key: InputEventKey = p_event as InputEventKey
	if key == null or not key.pressed or key.echo or not is_visible_in_tree():
		return
	match key.keycode:
		KEY_S when key.ctrl_pressed:
			do("save")
		KEY_F1:
			do("help")
		KEY_F5:
			do("restart")
		KEY_F6:
			do("pause")
		KEY_F7:
			do("step")
		_:
			return
	get_viewport().set_input_as_handled()


## Opens an effect by its name.
func open_effect(p_name: String) -> void:
	if file.name != "":
		file.keep(code.text)
	var text: String = file.open(p_name)
	_notice = file.error
	code.text = text
	code.editable = not file.is_foreign
	code.clear_undo_history()
	code.tag_saved_version()
	preview.compare(null)
	_check()
	var saved: EffectFile = EffectFile.read(file.saved)
	if not problems.is_empty() and ShaderCheck.problems(saved).is_empty():
		# What was not saved the last time may be broken.
		_try(saved)


## Does what a button or key stands for: see [constant StudioBar.BUTTONS].
func do(p_what: String) -> void:
	match p_what:
		"save":
			_save()
		"undo":
			code.undo()
		"redo":
			code.redo()
		"restart":
			preview.restart()
		"pause":
			preview.paused = not preview.paused
		"step":
			preview.step()
		"compare":
			_compare()
		"picture":
			_take_picture()
		"film":
			_begin_film()
		"measure":
			if shown != null and not _is_busy():
				_measure = StudioComparison.new(preview)
		"send":
			_session.address = _bar.address()
			_session.send(file.name, code.text)
		"help":
			_help.visible = not _help.visible
			code.visible = not _help.visible
		"new":
			_make_new()


func _connect_parts() -> void:
	code.text_changed.connect(_on_typed)
	code.help_changed.connect(func(text: String) -> void: _notice = text)
	panel.setting_wanted.connect(
		func(name: String, value: String) -> void:
			code.replace_text(HeaderEdit.set_setting(code.text, name, value))
	)
	panel.default_wanted.connect(
		func(name: String, value: String) -> void:
			code.replace_text(HeaderEdit.set_default(code.text, name, value))
	)
	panel.input_wanted.connect(preview.effect.set_input)
	_session.notified.connect(func(text: String) -> void: _notice = text)
	_bar.asked.connect(do)
	_bar.effect_chosen.connect(open_effect)
	_bar.speed_changed.connect(func(value: float) -> void: preview.speed = value)
	_bar.wind_changed.connect(func(value: float) -> void: preview.wind = value)
	_bar.ground_changed.connect(preview.set_ground)
	_bar.travel_changed.connect(func(value: float) -> void: preview.travel = value)


## The effect that the command line names, or the thesis's own example.
func _asked_effect() -> String:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--effect="):
			return argument.trim_prefix("--effect=")
		if argument.begins_with("--effects="):
			file.folder = argument.trim_prefix("--effects=")
	var names: PackedStringArray = file.names()
	return "fountain" if names.has("fountain") or names.is_empty() else names[0]


func _on_typed() -> void:
	meter.note_key()
	_notice = ""
	_check()


## Checks the text and shows it, if nothing is wrong with it.
func _check() -> void:
	var begin: int = Time.get_ticks_usec()
	var read: EffectFile = EffectFile.read(code.text)
	problems = ShaderCheck.problems(read)
	meter.check_ms = (Time.get_ticks_usec() - begin) / 1000.0
	code.show_problems(problems)
	_candidate = null
	if problems.is_empty():
		_try(read)


## Shows a file without problems; one with loops only after the other process has drawn it.
func _try(p_file: EffectFile) -> void:
	if p_file.has_loops() and sandbox.is_there():
		_candidate = p_file
		sandbox.try_text(p_file.text)
	else:
		_show(p_file)


func _poll_sandbox() -> void:
	var verdict: EffectSandbox.Verdict = sandbox.poll()
	if _candidate == null or verdict == EffectSandbox.Verdict.WAITING:
		return
	var tried: EffectFile = _candidate
	_candidate = null
	if verdict == EffectSandbox.Verdict.TOO_SLOW:
		problems = [EffectProblem.new(1, "This takes too long to draw: it is not shown.")]
		code.show_problems(problems)
	else:
		_show(tried)


func _show(p_file: EffectFile) -> void:
	shown = p_file
	preview.show_file(p_file)
	var uniforms: Array = _uniforms()
	panel.show_file(p_file, uniforms)
	var names: PackedStringArray = []
	for uniform: Dictionary in uniforms:
		names.append(uniform["name"])
	for input: EffectInput in p_file.settings.inputs:
		names.append(input.name)
	code.own_names = names
	meter.note_shown()


## The uniforms of the shown effect with their defaults.
func _uniforms() -> Array:
	var shader: Shader = preview.effect.layer.shader
	var found: Array = shader.get_shader_uniform_list()
	for uniform: Dictionary in found:
		var value: Variant = RenderingServer.shader_get_parameter_default(
			shader.get_rid(), uniform["name"]
		)
		if value != null:
			uniform["value"] = value
	return found


func _save() -> void:
	if file.save(code.text):
		_notice = "saved: %s" % file.path() if file.error == "" else file.error
		_bar.show_names(file.names(), file.name)
	else:
		_notice = file.error


func _make_new() -> void:
	var number: int = 1
	while file.is_taken("effect_%d" % number):
		number += 1
	var text: String = code.text
	open_effect("effect_%d" % number)
	code.replace_text(text)
	_bar.show_names(file.names(), file.name)
	_notice = "a copy named effect_%d: Ctrl+S saves it" % number


func _compare() -> void:
	if preview.other != null:
		preview.compare(null)
		return
	var saved: EffectFile = EffectFile.read(file.saved)
	if ShaderCheck.problems(saved).is_empty():
		preview.compare(saved)
		_notice = "left: as it is now; right: as it is saved"


func _take_picture() -> void:
	var path: String = StudioFile.next_picture(file.name, "png")
	var error: Error = preview.view.get_texture().get_image().save_png(path)
	_notice = "picture: %s" % path if error == OK else "no picture: %s" % error_string(error)


func _begin_film() -> void:
	if _is_busy():
		return
	_film = FilmFile.new()
	var size: Vector2i = preview.view.size - preview.view.size % 2
	var path: String = StudioFile.next_picture(file.name, "avi")
	var error: String = _film.open(path, size, FILM_RATE)
	_film_begin_ms = Time.get_ticks_msec()
	_notice = "filming %s" % path if error == "" else error
	if error != "":
		_film = null


## Whether something is filmed or measured: one at a time, as measuring hides the effect.
func _is_busy() -> bool:
	if _film != null or _measure != null:
		_notice = "not yet: %s still runs" % ("the film" if _film != null else "measuring")
	return _film != null or _measure != null


func _on_frame_drawn() -> void:
	meter.note_frame()
	if _measure != null and _measure.note_frame():
		_notice = _measure.describe()
		_measure = null
	if _film == null:
		return
	# As many as the time asks for: on a slow machine some of them are the same.
	var due: int = int((Time.get_ticks_msec() - _film_begin_ms) / 1000.0 * FILM_RATE) + 1
	if _film.frames() < due:
		var picture: Image = preview.view.get_texture().get_image()
		while _film.frames() < mini(due, int(FILM_RATE * FILM_S)):
			_film.add(picture)
	if _film.frames() >= FILM_RATE * FILM_S:
		_film.close()
		_notice = "the film is there: %s" % _film.path
		_film = null


func _show_status() -> void:
	var text: String = ""
	if not problems.is_empty():
		text = "Line %d: %s" % [problems[0].line, problems[0].text]
	elif _candidate != null:
		text = "tried out in a process of its own ..."
	else:
		text = _notice if _notice != "" else "fine; F1 for help"
	_message.text = text
	_message.add_theme_color_override(
		"font_color", COLOUR_FINE if problems.is_empty() else COLOUR_PROBLEM
	)
	var parts: PackedStringArray = [meter.describe()]
	if preview.effect.layer != null:
		parts.append("%d particles" % preview.effect.amount)
		parts.append("fills the picture %.1f times" % preview.effect.screens(preview.camera()))
	if preview.paused:
		parts.append("paused")
	parts.append("not saved" if file.is_changed(code.text) else "saved")
	_status.text = "   ".join(parts)


## The bar, then code (or help) beside picture and sliders, and two lines at the foot.
func _put_together() -> void:
	var all: VBoxContainer = VBoxContainer.new()
	all.set_anchors_preset(Control.PRESET_FULL_RECT)
	add_child(all)
	var middle: HBoxContainer = HBoxContainer.new()
	var right: VBoxContainer = VBoxContainer.new()
	for part: Control in [_bar, middle, _message, _status]:
		all.add_child(part)
	for part: Control in [code, _help, right]:
		part.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		middle.add_child(part)
	for part: Control in [preview, panel]:
		part.size_flags_vertical = Control.SIZE_EXPAND_FILL
		right.add_child(part)
	middle.size_flags_vertical = Control.SIZE_EXPAND_FILL
	right.size_flags_stretch_ratio = 1.17
	preview.size_flags_stretch_ratio = 1.5


func _show_panel() -> void:
	panel.visible = size.x >= WITH_PANEL.x and size.y >= WITH_PANEL.y
