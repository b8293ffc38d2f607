extends Logger
## Counts what the engine prints as an error without reporting one, such as broken UTF-8.

var _lines: PackedStringArray = []
var _mutex: Mutex = Mutex.new()


## Returns the lines since the last call and forgets them.
func take() -> PackedStringArray:
	_mutex.lock()
	var lines: PackedStringArray = _lines
	_lines = []
	_mutex.unlock()
	return lines


func _log_message(p_message: String, p_error: bool) -> void:
	if p_error:
		_mutex.lock()
		_lines.append(p_message)
		_mutex.unlock()
