class_name InstructorTerminal
extends RefCounted
## Connects a terminal with an [InstructorConsole]: keys, completion, answers and log lines. Where
## the input is a pipe or a file, its lines are carried out without a prompt.

## The instructor wants to leave.
signal quit_wanted

const _PROMPT: String = "instructor> "

var _console: InstructorConsole = null
var _terminal: Terminal = Terminal.new()
var _editor: LineEditor = LineEditor.new()
var _is_raw: bool = false
var _waiting: PackedStringArray = []


## Opens the terminal for a console.
func open(p_console: InstructorConsole) -> void:
	_console = p_console
	_console.said.connect(_say)
	_console.quit_wanted.connect(quit_wanted.emit)
	_editor.entered.connect(_on_entered)
	_editor.completion_wanted.connect(_complete)
	_editor.ended.connect(quit_wanted.emit)
	_is_raw = _terminal.open()
	if _is_raw:
		Log.sink = _say
		_say("Type help for the commands, Tab completes names.")


## Reads what was typed; call it in every frame with the time, s, and whether orders can be given:
## what comes before waits.
func advance(p_now_s: float, p_is_joined: bool) -> void:
	_console.advance(p_now_s)
	var bytes: PackedByteArray = _terminal.read()
	if not bytes.is_empty():
		_editor.take(bytes)
		_show()
	while p_is_joined and not _waiting.is_empty():
		var line: String = _waiting[0]
		_waiting.remove_at(0)
		_console.submit(line)


## Gives the terminal back.
func close() -> void:
	if _is_raw:
		_is_raw = false
		Log.sink = Callable()
		_terminal.write("\r\u001b[K")
	_terminal.close()


func _on_entered(p_line: String) -> void:
	if _is_raw:
		_terminal.write("\r\u001b[K%s%s\n" % [_PROMPT, p_line])
	_waiting.append(p_line)


func _complete() -> void:
	var found: PackedStringArray = _console.completions(_editor.line)
	if found.is_empty():
		return
	var common: String = found[0]
	for line: String in found:
		while not line.to_lower().begins_with(common.to_lower()):
			common = common.left(-1)
	if found.size() > 1 and common.length() <= _editor.line.length():
		var words: PackedStringArray = []
		for line: String in found:
			words.append(line.substr(line.find(" ") + 1) if line.contains(" ") else line)
		_say("  ".join(words))
	if common.length() >= _editor.line.length():
		_editor.set_line(common)


func _say(p_line: String) -> void:
	if not _is_raw:
		print(p_line)
		return
	_terminal.write("\r\u001b[K%s\n" % p_line)
	_show()


func _show() -> void:
	if _is_raw:
		_terminal.write(_editor.shown(_PROMPT))
