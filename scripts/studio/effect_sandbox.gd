@tool
class_name EffectSandbox
extends RefCounted
## Tries an effect in a process of its own before it is shown: if that hangs, it is killed, and the
## studio goes on. The second fence behind [LoopRule] and [CodeCost]; kept warm, as a start takes
## seconds.

## What became of a text.
enum Verdict {
	## It has not been tried yet.
	WAITING,
	## It was drawn in time.
	FINE,
	## It took too long, or the process died of it.
	TOO_SLOW,
	## There is no process to try it in.
	NONE,
}

## Time that a text may take to compile and draw a few times, ms.
const LIMIT_MS: int = 4000
## Time that the process may take to start, ms.
const START_MS: int = 30000
## Starts in a row without an answer after which no more are tried.
const MAX_STARTS: int = 3
const SCENE: String = "res://scenes/studio/sandbox.tscn"

## How long the last text took there, ms.
var took_ms: float = 0.0

var _folder: String = ""
var _pid: int = -1
var _is_ready: bool = false
var _starts: int = 0
var _began_ms: int = 0
var _asked_ms: int = 0
var _number: int = 0
var _waits: bool = false


## Starts the process, if there is a display.
func start() -> void:
	if DisplayServer.get_name() == "headless" or _starts >= MAX_STARTS or _pid > 0:
		return
	_folder = "%s/effect_sandbox_%d" % [OS.get_temp_dir(), OS.get_process_id()]
	DirAccess.make_dir_recursive_absolute(_folder)
	_remove("ready")
	_remove("done")
	_starts += 1
	_is_ready = false
	_began_ms = Time.get_ticks_msec()
	var method: String = RenderingServer.get_current_rendering_method()
	var given: PackedStringArray = ["--path", ProjectSettings.globalize_path("res://")]
	given += PackedStringArray(["--rendering-method", method, "--audio-driver", "Dummy"])
	given += PackedStringArray(["--resolution", "64x64", "--position", "-4000,-4000"])
	given += PackedStringArray([SCENE, "--", "--folder=" + _folder])
	given.append("--parent=%d" % OS.get_process_id())
	_pid = OS.create_process(OS.get_executable_path(), given)


## Whether a text can be tried now.
func is_ready() -> bool:
	return _is_ready


## Whether there is a process, be it that it still starts: then texts wait for it.
func is_there() -> bool:
	return _pid > 0


## Begins to try a text; an older one that waits is forgotten.
func try_text(p_text: String) -> void:
	_number += 1
	_waits = true
	_asked_ms = Time.get_ticks_msec()
	_remove("done")
	var file: FileAccess = FileAccess.open(_folder + "/request.tmp", FileAccess.WRITE)
	if file == null:
		return
	file.store_line(str(_number))
	file.store_string(p_text)
	file.close()
	DirAccess.rename_absolute(_folder + "/request.tmp", _folder + "/request")


## What has become of the text that was tried last. Call it in every frame.
func poll() -> Verdict:
	_watch_start()
	if not _waits:
		return Verdict.WAITING
	if _pid <= 0:
		_waits = false
		return Verdict.NONE
	if not _is_ready:
		_asked_ms = Time.get_ticks_msec()
		return Verdict.WAITING
	var done: FileAccess = FileAccess.open(_folder + "/done", FileAccess.READ)
	if done != null:
		var words: PackedStringArray = done.get_line().split(" ")
		if words.size() == 2 and words[0].to_int() == _number:
			took_ms = words[1].to_float()
			_waits = false
			return Verdict.FINE
	if Time.get_ticks_msec() - _asked_ms < LIMIT_MS and OS.is_process_running(_pid):
		return Verdict.WAITING
	_waits = false
	_kill()
	# It may not have come to it yet: the next process must not find it.
	_remove("request")
	_starts = 0
	start()
	return Verdict.TOO_SLOW


## Ends the process.
func close() -> void:
	_kill()
	for file: String in ["ready", "done", "request", "request.tmp"]:
		_remove(file)
	if _folder != "":
		DirAccess.remove_absolute(_folder)


func _watch_start() -> void:
	if _pid <= 0 or _is_ready:
		return
	_is_ready = FileAccess.file_exists(_folder + "/ready")
	if _is_ready:
		_starts = 0
	elif Time.get_ticks_msec() - _began_ms > START_MS or not OS.is_process_running(_pid):
		_kill()
		start()


func _kill() -> void:
	if _pid > 0:
		OS.kill(_pid)
	_pid = -1
	_is_ready = false


func _remove(p_file: String) -> void:
	var path: String = _folder.path_join(p_file)
	if _folder != "" and FileAccess.file_exists(path):
		DirAccess.remove_absolute(path)
