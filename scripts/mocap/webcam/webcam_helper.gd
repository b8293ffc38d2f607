class_name WebcamHelper
extends RefCounted
## The process that looks through a camera's pictures ([code]tools/webcam[/code]): starts it, starts
## it anew when it has ended, and ends it. It sends its landmarks to a port of this machine.

## The environment's variable that names the helper's folder.
const FOLDER_VARIABLE: String = "DISMOUNT_WEBCAM"
## What the helper ends with where its environment was not made yet, and where it is broken.
const EXIT_NOT_READY: int = 3
const EXIT_BROKEN: int = 4
## Time until a helper that has ended is started again, s: the first time, and at most.
const AGAIN_S: float = 1.0
const AGAIN_AT_MOST_S: float = 20.0
## One that has run for this time has started well, s.
const WELL_S: float = 10.0

const _SET_UP: String = "run 'python3 %s setup' once: it fetches 140 MB from PyPI"

## Why there is no helper now, as a sentence for people; empty while it runs.
var fault: String = ""

var _pid: int = -1
var _arguments: PackedStringArray = PackedStringArray()
var _started_s: float = 0.0
var _due_s: float = -INF
var _pause_s: float = AGAIN_S


## Where helpers are on this machine: what the environment names, beside the program, or the
## project's own; an empty text where there is none.
static func find_folder() -> String:
	var named: String = OS.get_environment(FOLDER_VARIABLE)
	var beside: String = OS.get_executable_path().get_base_dir().path_join("webcam")
	for folder: String in [named, beside, ProjectSettings.globalize_path("res://tools/webcam")]:
		if folder != "" and FileAccess.file_exists(folder.path_join("__main__.py")):
			return folder
	return ""


## The full path of Python on this machine, or an empty text.
static func find_python() -> String:
	for folder: String in OS.get_environment("PATH").split(":", false):
		var program: String = folder.path_join("python3")
		if FileAccess.file_exists(program):
			return program
	return ""


## Wants a helper: pictures are a camera's number or a film's path, the port is this machine's.
func want(p_pictures: String, p_port: int, p_people: int) -> void:
	stop()
	_arguments = ["run", "--pictures=" + p_pictures, "--port=%d" % p_port]
	_arguments.append_array(["--people=%d" % p_people, "--parent=%d" % OS.get_process_id()])
	_due_s = -INF
	_pause_s = AGAIN_S


## Goes on at a time, s: starts it, or starts it anew.
func advance(p_now_s: float) -> void:
	if _arguments.is_empty():
		return
	if _pid > 0 and not OS.is_process_running(_pid):
		_note_end(p_now_s)
	if _pid <= 0 and p_now_s >= _due_s:
		_start(p_now_s)


## Whether it runs.
func is_running() -> bool:
	return _pid > 0 and OS.is_process_running(_pid)


## The process, or -1.
func get_pid() -> int:
	return _pid


## Ends it.
func stop() -> void:
	_arguments = []
	if _pid > 0 and OS.is_process_running(_pid):
		OS.kill(_pid)
	_pid = -1
	fault = ""


func _start(p_now_s: float) -> void:
	_due_s = p_now_s + _pause_s
	_pause_s = minf(_pause_s * 2.0, AGAIN_AT_MOST_S)
	var folder: String = find_folder()
	var python: String = find_python()
	if folder == "":
		_say("the helper is missing: the folder 'webcam' belongs beside the program")
	elif python == "":
		_say("it needs Python 3.10 or newer, and there is no python3: install it")
	else:
		_pid = OS.create_process(python, PackedStringArray([folder]) + _arguments)
		_started_s = p_now_s
		if _pid <= 0:
			_say("its helper cannot be started (%s)" % python)


func _note_end(p_now_s: float) -> void:
	var code: int = OS.get_process_exit_code(_pid)
	_pid = -1
	if p_now_s - _started_s > WELL_S:
		_pause_s = AGAIN_S
		_due_s = p_now_s
	match code:
		EXIT_NOT_READY:
			_say("not set up yet: " + _SET_UP % find_folder())
		EXIT_BROKEN:
			_say("its Python environment is broken: delete it, and " + _SET_UP % find_folder())
		_:
			_say("its helper has ended (code %d) and is started again" % code)


func _say(p_fault: String) -> void:
	if fault != p_fault:
		Log.warning("mocap", "Webcam: " + p_fault)
	fault = p_fault
