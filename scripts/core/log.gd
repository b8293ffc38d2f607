class_name Log
extends RefCounted
## The one logger: lines with time, level and tag on standard output, errors on standard error.
##
## Lines that an outsider can provoke go through [method limited]: one per key in a while, with the
## number of those left out, so that nobody can flood the log. Threads may use it.

## Minimum seconds between two lines of one key of [method limited].
const LIMIT_S: float = 5.0
## Maximum of keys that are remembered; beyond it the oldest are dropped.
const MAX_KEYS: int = 256
## Characters that may be written per second on the whole, and at once after silence. Further lines
## are counted. Errors are always written.
const CHARACTERS_PER_SECOND: float = 400.0
const MAX_CHARACTERS: float = 2400.0

## What --log-level can be, the most first.
const LEVELS: PackedStringArray = ["info", "warning", "error"]

## Takes the lines instead of standard output, where somebody types there meanwhile:
## [code]func(line: String) -> void[/code]. Errors still go to standard error.
static var sink: Callable = Callable()

static var _mutex: Mutex = Mutex.new()
static var _level: int = 0
static var _file: FileAccess = null
static var _last_usec: Dictionary[String, int] = {}
static var _left_out: Dictionary[String, int] = {}
static var _room: float = MAX_CHARACTERS
static var _room_usec: int = 0
static var _lines_left_out: int = 0


## Sets the lowest of [constant LEVELS] that is written, and the file that has the lines too; an
## empty path is none. Returns why the file cannot be written, or an empty text. Called again, it
## opens the file anew: it may have been moved away.
static func open(p_level: String, p_path: String) -> String:
	_level = maxi(LEVELS.find(p_level), 0)
	_file = null
	if p_path == "":
		return ""
	if FileAccess.file_exists(p_path):
		_file = FileAccess.open(p_path, FileAccess.READ_WRITE)
	else:
		_file = FileAccess.open(p_path, FileAccess.WRITE)
	if _file == null:
		var why: String = error_string(FileAccess.get_open_error())
		return "the log file %s cannot be written: %s" % [p_path, why]
	_file.seek_end()
	return ""


## Something that the operator may want to know.
static func info(p_tag: String, p_text: String) -> void:
	if _level == 0:
		_write("INFO", p_tag, p_text)


## Something that is wrong, while the work goes on.
static func warning(p_tag: String, p_text: String) -> void:
	if _level <= 1:
		_write("WARN", p_tag, p_text)


## Something that ends the work.
static func error(p_tag: String, p_text: String) -> void:
	var line: String = _line("ERROR", p_tag, p_text)
	_mutex.lock()
	_store(line)
	_mutex.unlock()
	printerr(line)


## A warning that is repeated at most every [constant LIMIT_S] seconds for the same key.
static func limited(p_tag: String, p_key: String, p_text: String) -> void:
	_mutex.lock()
	var left_out: int = _admit(p_tag + " " + p_key)
	_mutex.unlock()
	if left_out >= 0:
		warning(p_tag, p_text + (" (and %d more like it)" % left_out if left_out > 0 else ""))


## Forgets what has been written and left out, as if nothing had been yet: tests begin so.
static func forget() -> void:
	_mutex.lock()
	_last_usec.clear()
	_left_out.clear()
	_room = MAX_CHARACTERS
	_lines_left_out = 0
	_mutex.unlock()


## How many lines of a key were left out before the one that may be written now; -1 if it may not.
static func _admit(p_key: String) -> int:
	var now: int = Time.get_ticks_usec()
	if _last_usec.has(p_key) and now - _last_usec[p_key] < int(LIMIT_S * 1e6):
		_left_out[p_key] = _left_out.get(p_key, 0) + 1
		return -1
	if _last_usec.size() >= MAX_KEYS:
		var oldest: String = _last_usec.keys()[0]
		_last_usec.erase(oldest)
		_left_out.erase(oldest)
	var count: int = _left_out.get(p_key, 0)
	_last_usec.erase(p_key)
	_last_usec[p_key] = now
	_left_out[p_key] = 0
	return count


## No message that a stranger can cause, such as joining and leaving, can fill the disk.
static func _write(p_level: String, p_tag: String, p_text: String) -> void:
	_mutex.lock()
	_write_alone(p_level, p_tag, p_text)
	_mutex.unlock()


static func _write_alone(p_level: String, p_tag: String, p_text: String) -> void:
	var now: int = Time.get_ticks_usec()
	_room += (now - _room_usec) / 1e6 * CHARACTERS_PER_SECOND
	_room = minf(_room, MAX_CHARACTERS)
	_room_usec = now
	if _room <= 0.0:
		_lines_left_out += 1
		return
	if _lines_left_out > 0:
		_print(_line("WARN", "log", "%d lines were left out" % _lines_left_out))
		_lines_left_out = 0
	var line: String = _line(p_level, p_tag, p_text)
	_room -= line.length()
	_print(line)


static func _store(p_line: String) -> void:
	if _file != null:
		_file.store_line(p_line)
		# The lines of a program that is killed are all in the file.
		_file.flush()


static func _print(p_line: String) -> void:
	_store(p_line)
	if sink.is_valid():
		sink.call(p_line)
	else:
		print(p_line)


static func _line(p_level: String, p_tag: String, p_text: String) -> String:
	var time: String = Time.get_datetime_string_from_system(true)
	return "%sZ %-5s %s: %s" % [time, p_level, p_tag, p_text]
