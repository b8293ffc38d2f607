class_name LatencyFile
extends RefCounted
## A CSV file with a line for each [LatencyMark], written while the session runs.

## Seconds after which a kill loses nothing that is older.
const PERIOD_S: float = 1.0

var _file: FileAccess = null
var _flushed_usec: int = 0


## Begins the file. Returns what is wrong, or an empty text.
func open(p_path: String) -> String:
	_file = FileAccess.open(p_path, FileAccess.WRITE)
	if _file == null:
		var why: String = error_string(FileAccess.get_open_error())
		return "the latency file %s cannot be written: %s" % [p_path, why]
	_file.store_csv_line(PackedStringArray(LatencyMark.COLUMNS))
	_flushed_usec = Time.get_ticks_usec()
	return ""


## Adds a line.
func add(p_mark: LatencyMark) -> void:
	if _file != null:
		_file.store_csv_line(p_mark.to_line())


## Sees to it that lines reach the disk now and then.
func keep() -> void:
	var now: int = Time.get_ticks_usec()
	if _file != null and now - _flushed_usec > int(PERIOD_S * 1e6):
		_file.flush()
		_flushed_usec = now


## Ends it.
func close() -> void:
	if _file != null:
		_file.close()
		_file = null
