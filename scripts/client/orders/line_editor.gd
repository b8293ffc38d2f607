class_name LineEditor
extends RefCounted
## A line that is typed key by key in a terminal: editing, history and completion.
##
## Takes the bytes of a terminal, as [Terminal] reads them, and knows nothing of where they come
## from. [method shown] is what the terminal has to show.

## A line is complete.
signal entered(p_line: String)
## The Tab key: whoever completes sets [member line] and [member cursor].
signal completion_wanted
## Ctrl+D in an empty line.
signal ended

## Longest line, characters.
const MAX_LENGTH: int = 400
## Lines that are kept.
const MAX_HISTORY: int = 100

const _ESCAPE: int = 27

## What has been typed.
var line: String = ""
## Where the next character goes, from 0.
var cursor: int = 0

var _history: PackedStringArray = []
var _position: int = 0
var _draft: String = ""
# Bytes of a character or of an escape sequence that has not come whole.
var _pending: PackedByteArray = []


## Takes bytes of the terminal.
func take(p_bytes: PackedByteArray) -> void:
	for byte: int in p_bytes:
		_pending.append(byte)
		if _pending[0] == _ESCAPE:
			_take_escape()
		elif _pending[0] < 0x80:
			_pending.clear()
			_take_key(byte)
		elif _pending.size() >= _length_of(_pending[0]):
			_insert(_decode(_pending))
			_pending.clear()


## Replaces the line, with the cursor at its end.
func set_line(p_line: String) -> void:
	line = p_line.left(MAX_LENGTH)
	cursor = line.length()


## What a terminal has to show for the line, behind a prompt: it erases what was shown before and
## puts the terminal's cursor where it belongs.
func shown(p_prompt: String) -> String:
	var back: int = line.length() - cursor
	return "\r\u001b[K" + p_prompt + line + ("\u001b[%dD" % back if back > 0 else "")


func _take_key(p_key: int) -> void:
	match p_key:
		9:
			completion_wanted.emit()
		10, 13:
			_enter()
		8, 127:
			if cursor > 0:
				line = line.left(cursor - 1) + line.substr(cursor)
				cursor -= 1
		1:
			cursor = 0
		5:
			cursor = line.length()
		4:
			if line == "":
				ended.emit()
			else:
				_delete()
		11:
			line = line.left(cursor)
		21:
			line = line.substr(cursor)
			cursor = 0
		_:
			if p_key >= 32:
				_insert(String.chr(p_key))


## Cursor keys and the like: ESC, [ or O, digits, a letter or ~.
func _take_escape() -> void:
	var size: int = _pending.size()
	if size < 3:
		if size == 2 and not _pending[1] in [0x5B, 0x4F]:
			_pending.clear()
		return
	var last: int = _pending[size - 1]
	if (last < 0x40 or last > 0x7E) and size < 8:
		return
	var sequence: String = _pending.slice(2).get_string_from_ascii()
	_pending.clear()
	match sequence:
		"A":
			_recall(-1)
		"B":
			_recall(1)
		"C":
			cursor = mini(cursor + 1, line.length())
		"D":
			cursor = maxi(cursor - 1, 0)
		"H", "1~":
			cursor = 0
		"F", "4~":
			cursor = line.length()
		"3~":
			_delete()


func _insert(p_text: String) -> void:
	if line.length() + p_text.length() <= MAX_LENGTH:
		line = line.left(cursor) + p_text + line.substr(cursor)
		cursor += p_text.length()


func _delete() -> void:
	line = line.left(cursor) + line.substr(cursor + 1)


func _enter() -> void:
	var whole: String = line
	if whole.strip_edges() != "" and (_history.is_empty() or _history[-1] != whole):
		_history.append(whole)
		if _history.size() > MAX_HISTORY:
			_history.remove_at(0)
	_position = _history.size()
	set_line("")
	entered.emit(whole)


func _recall(p_step: int) -> void:
	if _position == _history.size():
		_draft = line
	_position = clampi(_position + p_step, 0, _history.size())
	set_line(_history[_position] if _position < _history.size() else _draft)


## Bytes of a UTF-8 character that begins with a byte; 1 for one that begins none.
static func _length_of(p_first: int) -> int:
	if p_first >= 0xF0:
		return 4
	if p_first >= 0xE0:
		return 3
	return 2 if p_first >= 0xC2 else 1


## A character, or nothing if the bytes are none: the engine would report an error.
static func _decode(p_bytes: PackedByteArray) -> String:
	var sized: PackedByteArray = [p_bytes.size(), 0]
	return ByteReader.new(sized + p_bytes).read_text(p_bytes.size())
