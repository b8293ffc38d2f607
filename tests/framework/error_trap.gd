extends Logger
## Collects what the engine and scripts report while tests run. Called from any thread.

## One reported error: its text with the script line that caused it, where there is one.
var _errors: PackedStringArray = PackedStringArray()
var _mutex: Mutex = Mutex.new()


## Returns the errors since the last call and forgets them.
func take() -> PackedStringArray:
	_mutex.lock()
	var errors: PackedStringArray = _errors
	_errors = PackedStringArray()
	_mutex.unlock()
	return errors


func _log_error(
	_p_function: String,
	p_file: String,
	p_line: int,
	p_code: String,
	p_rationale: String,
	_p_editor_notify: bool,
	p_error_type: int,
	p_backtraces: Array[ScriptBacktrace]
) -> void:
	if p_error_type == ERROR_TYPE_WARNING:
		return
	var text: String = p_code if p_rationale.is_empty() else p_rationale
	var place: String = "%s:%d" % [p_file.trim_prefix("res://"), p_line]
	for backtrace: ScriptBacktrace in p_backtraces:
		if p_error_type != ERROR_TYPE_SCRIPT and backtrace.get_frame_count() > 0:
			var file: String = backtrace.get_frame_file(0).trim_prefix("res://")
			place = "%s:%d" % [file, backtrace.get_frame_line(0)]
			break
	_mutex.lock()
	_errors.append("%s (%s)" % [text, place])
	_mutex.unlock()
