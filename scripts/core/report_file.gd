class_name ReportFile
extends RefCounted
## Stats of a session in a JSON file, written anew every second, so that a kill loses at most one.

## Default of the seconds between two writings.
const PERIOD_S: float = 1.0

var _path: String = ""
var _period_usec: int = 0
var _written_usec: int = 0


func _init(p_path: String, p_period_s: float = PERIOD_S) -> void:
	_path = p_path
	_period_usec = int(p_period_s * 1e6)


## Whether it is time to write again. Always false without a path.
func is_due() -> bool:
	return _path != "" and Time.get_ticks_usec() - _written_usec > _period_usec


## Writes the stats; the file is replaced as a whole.
func write(p_stats: Dictionary) -> void:
	if _path == "":
		return
	_written_usec = Time.get_ticks_usec()
	var file: FileAccess = FileAccess.open(_path + ".part", FileAccess.WRITE)
	if file == null:
		var why: String = error_string(FileAccess.get_open_error())
		Log.limited("app", "report", "cannot write the report %s: %s" % [_path, why])
		return
	file.store_string(JSON.stringify(p_stats, "\t") + "\n")
	file.close()
	DirAccess.rename_absolute(_path + ".part", _path)
