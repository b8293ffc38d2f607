extends SceneTree
## Types into the studio in a window and tells, a JSON object a line, how long it takes until the
## picture shows it; and gives the sandbox an endless loop.
##
## Options: --keys=20.

## One particle that fills the picture, of a colour with a digit that is typed over.
const TEXT: String = """shader_type particles;
// @effect Square
// @count 1
// @life 60
// @blend alpha
// @bounds 50
void start() {
	TRANSFORM = at(vec3(0.0, 1.0, 0.0), 60.0);
}
void process() {
	float c = 0.0;
	COLOR = vec4(1.0, c, c, 1.0);
}
"""
const LINE: int = 10
const LOOP: String = "\tfor (int i = 0; i < 20; i++) { CUSTOM.x += 0.01; }\n"
const ENDLESS: String = "\twhile (CUSTOM.x < 1e30) { CUSTOM.x = sin(CUSTOM.x + 0.01); }\n"
## How long something may take here before it counts as missing, ms.
const PATIENCE_MS: int = 60000

var _studio: Studio = null


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var keys: int = 20
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--keys="):
			keys = argument.trim_prefix("--keys=").to_int()
	_studio = (load("res://scenes/studio/studio.tscn") as PackedScene).instantiate()
	_studio.file.folder = "user://bench_studio"
	root.add_child(_studio)
	_studio.preview.set_ground(false)
	_studio.code.replace_text(TEXT)
	await _frames(30)
	await _type_keys(keys)
	await _check_shipped()
	await _try_loops()
	_studio.queue_free()
	await process_frame
	quit(0)


func _type_keys(p_keys: int) -> void:
	_studio.code.grab_focus()
	for i: int in p_keys:
		var before: float = _green()
		var code: StudioCode = _studio.code
		var column: int = code.get_line(LINE).find(".") + 1
		code.select(LINE, column, LINE, column + 1)
		var key: InputEventKey = InputEventKey.new()
		key.pressed = true
		key.keycode = KEY_9 if i % 2 == 0 else KEY_0
		key.unicode = key.keycode
		var begin: int = Time.get_ticks_usec()
		root.push_input(key)
		var frames: int = 0
		while absf(_green() - before) < 0.1 and Time.get_ticks_usec() - begin < PATIENCE_MS * 1000:
			await RenderingServer.frame_post_draw
			frames += 1
		_tell(
			{
				"what": "key",
				"ms": (Time.get_ticks_usec() - begin) / 1000.0,
				"frames": frames,
				"frame_ms": _studio.meter.frame_ms,
				"check_ms": _studio.meter.check_ms,
			}
		)
		await _frames(12)


## How long the check of each shipped effect takes here.
func _check_shipped() -> void:
	for name: String in DirAccess.get_files_at(EffectFile.FOLDER):
		if name.get_extension() != EffectFile.EXTENSION:
			continue
		var text: String = FileAccess.get_file_as_string(EffectFile.FOLDER.path_join(name))
		var times: PackedFloat64Array = []
		for i: int in 7:
			var begin: int = Time.get_ticks_usec()
			ShaderCheck.problems(EffectFile.read(text))
			times.append((Time.get_ticks_usec() - begin) / 1000.0)
		times.sort()
		_tell({"what": "check", "effect": name.get_basename(), "ms": times[3]})
		await process_frame


func _try_loops() -> void:
	await Waiting.until(self, func() -> bool: return _studio.sandbox.is_ready())
	_tell({"what": "sandbox", "ready": _studio.sandbox.is_ready()})
	var looped: String = TEXT.replace("\tfloat c", LOOP + "\tfloat c")
	_studio.code.replace_text(looped)
	var begin: int = Time.get_ticks_msec()
	await Waiting.until(self, func() -> bool: return _studio.shown.text == looped)
	var shown: bool = _studio.shown.text == looped
	_tell({"what": "loop", "shown": shown, "ms": Time.get_ticks_msec() - begin})
	# Past the static rule, to see that the second fence holds without it. A driver may leave a plain
	# while (true) out.
	var endless: String = TEXT.replace("\tfloat c", ENDLESS + "\tfloat c")
	var sandbox: EffectSandbox = _studio.sandbox
	_studio.set_process(false)
	sandbox.try_text(endless)
	var longest: int = 0
	var last: int = Time.get_ticks_msec()
	begin = last
	var verdict: EffectSandbox.Verdict = EffectSandbox.Verdict.WAITING
	while verdict == EffectSandbox.Verdict.WAITING and last - begin < PATIENCE_MS:
		await process_frame
		longest = maxi(longest, Time.get_ticks_msec() - last)
		last = Time.get_ticks_msec()
		verdict = sandbox.poll()
	_studio.set_process(true)
	var killed: bool = verdict == EffectSandbox.Verdict.TOO_SLOW
	_tell({"what": "endless", "killed": killed, "ms": last - begin, "longest_frame_ms": longest})
	await Waiting.until(self, func() -> bool: return sandbox.is_ready())
	_tell({"what": "again", "ready": sandbox.is_ready()})


func _frames(p_count: int) -> void:
	for i: int in p_count:
		await process_frame


func _green() -> float:
	var image: Image = _studio.preview.view.get_texture().get_image()
	return image.get_pixel(image.get_width() / 2, image.get_height() / 2).g


func _tell(p_row: Dictionary) -> void:
	print(JSON.stringify(p_row))
