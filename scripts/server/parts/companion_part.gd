class_name CompanionPart
extends ServerPart
## Ends the server when the process of --end-with has ended, such as the editor that started it.

## Frames between two looks.
const _FRAMES: int = 30


func frame() -> void:
	if Engine.get_process_frames() % _FRAMES == 0 and not _is_there():
		Log.info("server", "the process that it was to end with has ended")
		context.leave_wanted.emit(0)


func _is_there() -> bool:
	var number: int = context.options.number("end-with")
	if number == 0:
		return true
	var file: FileAccess = FileAccess.open("/proc/%d/stat" % number, FileAccess.READ)
	# One that has ended stays in the list until who started it asks, as the editor does not.
	return file != null and not file.get_line().get_slice(") ", 1).begins_with("Z")
