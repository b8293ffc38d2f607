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
	Log._lines = 0
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
	# Begins a new second, so that none begins in between.
	Log._second_usec = Time.get_ticks_usec()
	for line: int in 3 * Log.MAX_LINES:
		Log.info("test", "line %d" % line)
	equal(_trap.lines.size(), Log.MAX_LINES)
	Log.error("test", "errors come")
	contains(_trap.lines[-1], "errors come")
	Log._second_usec -= 1100000
	Log.info("test", "a new second")
	contains(_trap.lines[-2], "%d lines were left out" % (2 * Log.MAX_LINES))
	contains(_trap.lines[-1], "a new second")
