class_name EffectFolder
extends RefCounted
## Watches the files of effects in a folder and says which have changed. It reads them in a thread:
## the folder may be on a network.

## Time between two looks, s.
const PERIOD_S: float = 0.5
## Files of a folder that are looked at.
const MAX_FILES: int = 128

## The folder; empty for none.
var path: String = ""

var _known: Dictionary[String, int] = {}
var _read: Dictionary[String, PackedByteArray] = {}
var _task: int = -1
var _wait_s: float = 0.0


func _init(p_path: String) -> void:
	path = p_path


## Why the folder cannot be watched, or an empty text.
func find_fault() -> String:
	if path == "" or DirAccess.dir_exists_absolute(path):
		return ""
	return "--effects: there is no folder %s" % path


## The files that are new or have changed since the last time, by name; call it once a tick.
func advance(p_delta_s: float) -> Dictionary[String, PackedByteArray]:
	var changed: Dictionary[String, PackedByteArray] = {}
	_wait_s -= p_delta_s
	if path == "":
		return changed
	if _task >= 0:
		if not WorkerThreadPool.is_task_completed(_task):
			return changed
		WorkerThreadPool.wait_for_task_completion(_task)
		_task = -1
		for name: String in _read:
			var hash_read: int = hash(_read[name])
			if _known.get(name) != hash_read:
				_known[name] = hash_read
				changed[name] = _read[name]
	elif _wait_s <= 0.0:
		_wait_s = PERIOD_S
		_task = WorkerThreadPool.add_task(_look)
	return changed


## Ends: waits for what is being read.
func close() -> void:
	if _task >= 0:
		WorkerThreadPool.wait_for_task_completion(_task)
		_task = -1


func _look() -> void:
	_read = {}
	for file: String in DirAccess.get_files_at(path):
		if file.get_extension() != EffectFile.EXTENSION or _read.size() >= MAX_FILES:
			continue
		var access: FileAccess = FileAccess.open(path.path_join(file), FileAccess.READ)
		# One that an editor is just replacing is there at the next look.
		if access != null:
			_read[file.get_basename()] = access.get_buffer(EffectFile.MAX_BYTES + 1)
