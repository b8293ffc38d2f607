class_name BvhMotionReader
extends RefCounted
## Reads the MOTION part of a BVH file: the number of frames, their time and the rows of numbers.
##
## A line is a frame. If the lines do not have as many numbers as there are channels, but all
## numbers together are as many as frames times channels, then the rows are assumed to be wrapped.
## One row more than declared is left out of a long clip, with a note: some exporters declare the
## number of steps between the frames. Nothing is allocated for frames that are only announced.

## Smallest and largest believable frame time, s.
const MIN_FRAME_TIME: float = 1e-6
const MAX_FRAME_TIME: float = 3600.0
## Least number of declared frames at which one row too many is tolerated: it is below 1 % of them.
const MIN_SURPLUS_FRAMES: int = 100
## Maximum of frames.
const MAX_FRAMES: int = 100_000_000

## Time from one frame to the next, s.
var frame_time: float = 0.0
## Number of frames.
var frame_count: int = 0
## All rows, one after the other: positions in file units, rotations in degrees.
var values: PackedFloat64Array = PackedFloat64Array()
## An oddity that could be corrected, or an empty text.
var note: String = ""

var _lexer: BvhLexer = null
var _channel_count: int = 0
var _frames_line: int = 0
## The first line whose count of numbers is not that of the channels, or -1; its count, and how
## many rows came before it.
var _odd_line: int = -1
var _odd_count: int = 0
var _odd_row: int = 0
var _row_count: int = 0


## Prepares to read rows of [param p_channel_count] numbers from [param p_lexer].
func _init(p_lexer: BvhLexer, p_channel_count: int) -> void:
	_lexer = p_lexer
	_channel_count = p_channel_count


## Reads the rest of the file. Returns false after an error, which the lexer keeps.
func read() -> bool:
	return _read_frame_count() and _read_frame_time() and _read_rows() and _check_counts()


func _read_header(p_expression: String, p_wanted: String) -> String:
	if _lexer.peek().is_empty():
		_lexer.fail_at_next(p_wanted)
		return ""
	var line: String = _lexer.clean_line(_lexer.line_index())
	var found: RegExMatch = RegEx.create_from_string(p_expression).search(line)
	if found == null:
		_lexer.fail_at(
			_lexer.line_index(), "expected %s, found %s" % [p_wanted, BvhLexer.quote(line)]
		)
		return ""
	return found.get_string(1)


func _read_frame_count() -> bool:
	var count: String = _read_header("^(?i)frames(?:\\s*:\\s*|\\s+)([0-9]+)$", "'Frames: <number>'")
	if count.is_empty():
		return false
	_frames_line = _lexer.line_index()
	frame_count = count.to_int() if count.length() < 10 else MAX_FRAMES + 1
	if frame_count > MAX_FRAMES:
		return _lexer.fail_at(
			_frames_line, "expected at most %d frames, found %s" % [MAX_FRAMES, count.left(40)]
		)
	if _channel_count == 0 and frame_count > 0:
		return _lexer.fail_at(
			_frames_line, "expected no frames as no joint has CHANNELS, found %d" % frame_count
		)
	_lexer.next_line()
	return true


func _read_frame_time() -> bool:
	var wanted: String = "'Frame Time: <seconds>'"
	var time: String = _read_header("^(?i)frame\\s*time(?:\\s*:\\s*|\\s+)(\\S.*)$", wanted)
	if time.is_empty():
		return false
	frame_time = time.to_float() if BvhText.is_number(time) else -1.0
	if frame_time < MIN_FRAME_TIME or frame_time > MAX_FRAME_TIME:
		return _lexer.fail_at(
			_lexer.line_index(),
			(
				"expected %s from %s to %d, found %s%s"
				% [
					wanted,
					MIN_FRAME_TIME,
					int(MAX_FRAME_TIME),
					BvhLexer.quote(time),
					BvhText.hint_at_number(time)
				]
			)
		)
	return true


func _read_rows() -> bool:
	var only_numbers: RegEx = BvhText.number_line()
	for index: int in range(_lexer.line_index() + 1, _lexer.line_count()):
		var line: String = _lexer.raw_line(index)
		if only_numbers.search(line) == null:
			line = _lexer.clean_line(index)
			if not _check_words(index, line):
				return false
		var numbers: PackedFloat64Array = line.split_floats(" ", false)
		if numbers.is_empty():
			continue
		if numbers.size() != _channel_count and _odd_line < 0:
			_odd_line = index
			_odd_count = numbers.size()
			_odd_row = _row_count
		_row_count += 1
		values.append_array(numbers)
	return true


func _check_words(p_index: int, p_line: String) -> bool:
	var words: PackedStringArray = p_line.split(" ", false)
	for position: int in words.size():
		var word: String = words[position]
		if not BvhText.is_number(word):
			return _lexer.fail_at(
				p_index,
				(
					"expected a number, found %s as number %d of frame %d%s"
					% [
						BvhLexer.quote(word),
						position + 1,
						_row_count + 1,
						BvhText.hint_at_number(word)
					]
				)
			)
	return true


func _check_counts() -> bool:
	if values.size() == frame_count * _channel_count:
		return true
	if _odd_line >= 0:
		return _lexer.fail_at(
			_odd_line,
			"expected %d numbers in frame %d, found %d" % [_channel_count, _odd_row + 1, _odd_count]
		)
	if _row_count == frame_count + 1 and frame_count >= MIN_SURPLUS_FRAMES:
		values.resize(frame_count * _channel_count)
		note = _lexer.locate(
			_frames_line,
			"%d frames declared, %d found; the last one is left out" % [frame_count, _row_count]
		)
		return true
	return _lexer.fail_at(
		_frames_line, "expected %d frames as declared, found %d" % [frame_count, _row_count]
	)
