class_name SandboxProcess
extends Node
## The process behind [EffectSandbox]: draws every text that it is given a few times into a small
## picture and says so. It ends with the process that started it.

## Pictures that a text is drawn into.
const PICTURES: int = 4

var _folder: String = ""
var _parent: int = 0
var _view: SubViewport = SubViewport.new()
var _effect: ParticleEffect = ParticleEffect.new()
var _busy: bool = false
var _looks: int = 0


func _ready() -> void:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--folder="):
			_folder = argument.trim_prefix("--folder=")
		elif argument.begins_with("--parent="):
			_parent = argument.trim_prefix("--parent=").to_int()
	# While there is nothing to try, it costs nothing.
	Engine.max_fps = 60
	OS.low_processor_usage_mode = true
	# Nobody is to see it. A minimised window would not draw.
	get_window().unfocusable = true
	get_window().borderless = true
	get_window().position = Vector2i(-4000, -4000)
	_view.size = Vector2i(64, 64)
	_view.own_world_3d = true
	_view.render_target_update_mode = SubViewport.UPDATE_DISABLED
	var camera: Camera3D = Camera3D.new()
	camera.position = Vector3(0.0, 1.0, 5.0)
	_view.add_child(camera)
	_view.add_child(_effect)
	add_child(_view)
	_write("ready", "")


func _process(_delta: float) -> void:
	_looks += 1
	if _looks % 60 == 0 and not FileAccess.file_exists("/proc/%d/stat" % _parent):
		get_tree().quit()
	var path: String = _folder.path_join("request")
	if _busy or not FileAccess.file_exists(path):
		return
	var file: FileAccess = FileAccess.open(path, FileAccess.READ)
	var number: int = file.get_line().to_int()
	var text: String = file.get_as_text()
	text = text.substr(text.find("\n") + 1)
	file.close()
	DirAccess.remove_absolute(path)
	_try(number, text)


func _try(p_number: int, p_text: String) -> void:
	_busy = true
	var begin: int = Time.get_ticks_usec()
	var effect_file: EffectFile = EffectFile.read(p_text)
	# Whatever it is: what must not be drawn at all does not come here.
	if effect_file.code() != "":
		OS.low_processor_usage_mode = false
		_view.render_target_update_mode = SubViewport.UPDATE_ALWAYS
		_effect.show_file(effect_file)
		_effect.restart()
		for i: int in PICTURES:
			await RenderingServer.frame_post_draw
			# Waits until the card has drawn it.
			_view.get_texture().get_image()
	_view.render_target_update_mode = SubViewport.UPDATE_DISABLED
	OS.low_processor_usage_mode = true
	_write("done", "%d %.1f" % [p_number, (Time.get_ticks_usec() - begin) / 1000.0])
	_busy = false


func _write(p_name: String, p_text: String) -> void:
	var path: String = _folder.path_join(p_name)
	var file: FileAccess = FileAccess.open(path + ".tmp", FileAccess.WRITE)
	if file != null:
		file.store_string(p_text)
		file.close()
		DirAccess.rename_absolute(path + ".tmp", path)
