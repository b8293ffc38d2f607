class_name Log
extends RefCounted
## The one logger: lines with time, level and tag on standard output, errors on standard error.
##
## Lines that an outsider can provoke go through [method limited]: one per key in a while, with the
## number of those left out, so that nobody can flood the log.

## Minimum seconds between two lines of one key of [method limited].
const LIMIT_S: float = 5.0
## Maximum of keys that are remembered; beyond it the oldest are dropped.
const MAX_KEYS: int = 256
## Maximum of lines of all kinds in a second; further ones are counted. Errors are always written.
const MAX_LINES: int = 100

static var _last_usec: Dictionary[String, int] = {}
static var _left_out: Dictionary[String, int] = {}
static var _second_usec: int = 0
static var _lines: int = 0


## Something that the operator may want to know.
static func info(p_tag: String, p_text: String) -> void:
	_write("INFO", p_tag, p_text)


## Something that is wrong, while the work goes on.
static func warning(p_tag: String, p_text: String) -> void:
	_write("WARN", p_tag, p_text)


## Something that ends the work.
static func error(p_tag: String, p_text: String) -> void:
	printerr(_line("ERROR", p_tag, p_text))


## A warning that is repeated at most every [constant LIMIT_S] seconds for the same key.
static func limited(p_tag: String, p_key: String, p_text: String) -> void:
	var key: String = p_tag + " " + p_key
	var now: int = Time.get_ticks_usec()
	if _last_usec.has(key) and now - _last_usec[key] < int(LIMIT_S * 1e6):
		_left_out[key] = _left_out.get(key, 0) + 1
		return
	if _last_usec.size() >= MAX_KEYS:
		var oldest: String = _last_usec.keys()[0]
		_last_usec.erase(oldest)
		_left_out.erase(oldest)
	var count: int = _left_out.get(key, 0)
	_last_usec.erase(key)
	_last_usec[key] = now
	_left_out[key] = 0
	warning(p_tag, p_text + (" (and %d more like it)" % count if count > 0 else ""))


## Nobody can fill the disk by something that makes a line each time, such as joining and leaving.
static func _write(p_level: String, p_tag: String, p_text: String) -> void:
	var now: int = Time.get_ticks_usec()
	if now - _second_usec > 1000000:
		if _lines > MAX_LINES:
			print(_line("WARN", "log", "%d lines were left out" % (_lines - MAX_LINES)))
		_second_usec = now
		_lines = 0
	_lines += 1
	if _lines <= MAX_LINES:
		print(_line(p_level, p_tag, p_text))


static func _line(p_level: String, p_tag: String, p_text: String) -> String:
	var time: String = Time.get_datetime_string_from_system(true)
	return "%sZ %-5s %s: %s" % [time, p_level, p_tag, p_text]
