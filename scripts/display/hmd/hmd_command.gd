class_name HmdCommand
extends RefCounted
## The command that starts this program again, with the headset or without it.
##
## The engine begins with OpenXR at its start or never: whoever enters a headset starts again in the
## same process. What a user has given stays as it is, folders too; only a headset has its own
## renderer, and the user's comes back with the window.

## Set in the process that was started again for the headset: it doesn't try a second time.
const TRIED: String = "DISMOUNT_HMD_TRIED"
## Set in the process that was started again without it: why.
const LOST: String = "DISMOUNT_HMD_LOST"
## Set in the process that was started again for the headset: the renderer that the user had asked
## for.
const RENDERER: String = "DISMOUNT_HMD_RENDERER"
## Flags of the engine that we give ourselves, with the number of values that follow each.
const _OURS: Dictionary[String, int] = {"--xr-mode": 1, _METHOD: 1}
const _METHOD: String = "--rendering-method"
## Pictures of two layers cost least on it.
const _HEADSETS: String = "mobile"
## Flags of the engine that name a file or folder.
const _PATHS: PackedStringArray = ["--path", "--main-pack", "--log-file"]
## The argument by which a package's loader gets its libraries, and the number of arguments up to
## the program itself.
const _LOADER: String = "--library-path"
const _LOADED: int = 3

## The renderer that the user asks for; empty where the user leaves that to us.
var renderer: String = ""

## The program, behind the loader that a package starts it by.
var _program: PackedStringArray = []
var _engine: PackedStringArray = []
var _user: PackedStringArray = []


## The command of this process.
static func of_this_process() -> HmdCommand:
	var parts: PackedStringArray = []
	var file: FileAccess = FileAccess.open("/proc/self/cmdline", FileAccess.READ)
	if file != null:
		# The system says of it that it is empty: it is read, not measured.
		var bytes: PackedByteArray = file.get_buffer(1 << 20)
		while not bytes.is_empty():
			var end: int = bytes.find(0)
			end = bytes.size() if end < 0 else end
			parts.append(bytes.slice(0, end).get_string_from_utf8())
			bytes = bytes.slice(end + 1)
	var folder: String = OS.get_environment("PWD")
	var command: HmdCommand = of(OS.get_executable_path(), parts.slice(1), folder)
	if OS.has_environment(RENDERER):
		command.renderer = OS.get_environment(RENDERER)
	return command


## A command: the program, its arguments, and the folder in which relative paths begin.
static func of(p_program: String, p_arguments: PackedStringArray, p_folder: String) -> HmdCommand:
	var command: HmdCommand = HmdCommand.new()
	var end: int = p_arguments.find("--")
	end = p_arguments.size() if end < 0 else end
	command._user = p_arguments.slice(end)
	var i: int = _LOADED if p_arguments.slice(0, 1) == PackedStringArray([_LOADER]) else 0
	command._program = PackedStringArray([p_program]) + p_arguments.slice(0, i)
	while i < end:
		var part: String = p_arguments[i]
		if _OURS.has(part):
			if part == _METHOD and i + 1 < end:
				command.renderer = p_arguments[i + 1]
			i += 1 + _OURS[part]
			continue
		command._engine.append(part)
		if part in _PATHS and i + 1 < end:
			i += 1
			command._engine.append(_full(p_arguments[i], p_folder))
		i += 1
	return command


## Whether the program is still where it was started from.
func is_there() -> bool:
	return FileAccess.file_exists(_program[0])


## How this program is started, without arguments of its own: a package starts it by a loader.
func program() -> PackedStringArray:
	return _program.duplicate()


## With OpenXR, on the renderer whose pictures have two layers at the least cost.
func with_headset() -> PackedStringArray:
	return _made(["--xr-mode", "on", _METHOD, _HEADSETS])


## Without OpenXR: a plain window, on the user's own renderer.
func with_window() -> PackedStringArray:
	return _made(["--xr-mode", "off", _METHOD, renderer if renderer != "" else _HEADSETS])


func _made(p_ours: PackedStringArray) -> PackedStringArray:
	return _program + p_ours + _engine + _user


static func _full(p_path: String, p_folder: String) -> String:
	if p_path.is_absolute_path() or p_folder == "":
		return p_path
	return p_folder.path_join(p_path).simplify_path()
