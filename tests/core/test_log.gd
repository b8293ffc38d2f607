extends TestCase
## The log: the form of its lines, and that nobody can flood it.


## Keeps the lines that are printed.
class LineTrap:
	extends Logger
	var lines: PackedStringArray = []

	func _log_message(p_message: String, p_error: bool) -> void:
		lines.append(("error " if p_error else "") + p_message.strip_edges())


var _trap: LineTrap = LineTrap.new()


func before_each() -> void:
	OS.add_logger(_trap)


func after_each() -> void:
	OS.remove_logger(_trap)


func test_lines_have_time_level_and_tag() -> void:
	Log.info("test", "one")
	Log.warning("test", "two")
	Log.error("test", "three")
	var form: RegEx = RegEx.create_from_string(
		"^(error )?\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ (INFO |WARN |ERROR) test: (\\w+)$"
	)
	var seen: Array = []
	for line: String in _trap.lines:
		var found: RegExMatch = form.search(line)
		not_null(found, line)
		if found != null:
			seen.append([found.get_string(1), found.get_string(2), found.get_string(3)])
	equal(seen, [["", "INFO ", "one"], ["", "WARN ", "two"], ["error ", "ERROR", "three"]])


func test_limited_lines_of_a_key_come_once() -> void:
	for _line: int in 1000:
		Log.limited("test", "a", "text a")
		Log.limited("test", "b", "text b")
	equal(_trap.lines.size(), 2)


func test_memory_of_keys_is_bounded() -> void:
	for key: int in Log.MAX_KEYS + 20:
		Log.limited("test", "key %d" % key, "text")
	is_true(Log._last_usec.size() <= Log.MAX_KEYS)
	is_true(Log._left_out.size() <= Log.MAX_KEYS)


func test_says_how_many_were_left_out() -> void:
	for _line: int in 5:
		Log.limited("test", "late", "text")
	# As if the time had passed.
	Log._last_usec["test late"] -= int(Log.LIMIT_S * 1e6)
	Log.limited("test", "late", "text")
	contains(_trap.lines[-1], "text (and 4 more like it)")


func test_no_flood_of_any_kind() -> void:
	var room: int = int(Log.MAX_CHARACTERS)
	for line: int in room:
		Log.info("test", "line %d" % line)
	var written: int = 0
	for line: String in _trap.lines:
		written += line.length()
	is_true(written > room - 200, "%d characters" % written)
	# A busy machine takes a while for all these calls.
	is_true(written < 2 * room, "%d characters" % written)
	Log.error("test", "errors come")
	contains(_trap.lines[-1], "errors come")
	var kept: int = _trap.lines.size()
	Log._room_usec -= 10000000
	Log.info("test", "later")
	contains(_trap.lines[kept], "lines were left out")
	contains(_trap.lines[-1], "later")
