class_name BvhHierarchyReader
extends RefCounted
## Reads the HIERARCHY part of a BVH file into joints.

## Maximum of channels of one joint.
const MAX_CHANNELS: int = 64

## The joints, each after its parent; the root is the first.
var joints: Array[BvhJoint] = []
## Numbers in a row: the sum of all channels.
var channel_count: int = 0

var _lexer: BvhLexer = null
var _options: BvhOptions = null
## Indices of the joints whose brace is open, the innermost last.
var _open: PackedInt32Array = PackedInt32Array()
## Per joint: the line index where it starts, and whether OFFSET and CHANNELS were seen.
var _start_lines: PackedInt32Array = PackedInt32Array()
var _has_offset: PackedByteArray = PackedByteArray()
var _has_channels: PackedByteArray = PackedByteArray()


## Prepares to read from [param p_lexer].
func _init(p_lexer: BvhLexer, p_options: BvhOptions) -> void:
	_lexer = p_lexer
	_options = p_options


## Reads up to and including the word MOTION. Returns false after an error, which the lexer keeps.
func read() -> bool:
	if not _lexer.take_keyword("HIERARCHY"):
		return _lexer.fail_at_next("'HIERARCHY'")
	if not _lexer.take_keyword("ROOT"):
		return _lexer.fail_at_next("'ROOT'")
	if not _read_joint("ROOT"):
		return false
	while not _open.is_empty():
		if not _read_statement():
			return false
	return _read_end()


func _read_end() -> bool:
	if _lexer.peek().to_upper() == "ROOT":
		return _lexer.fail_at_next("'MOTION' (one skeleton a file; export each person on its own)")
	if not _lexer.take_keyword("MOTION"):
		return _lexer.fail_at_next("'MOTION'")
	if not _lexer.is_line_done():
		return _lexer.fail_at_next("the line to end after 'MOTION'")
	return true


func _read_statement() -> bool:
	var index: int = _open[-1]
	var joint: BvhJoint = joints[index]
	var keyword: String = _lexer.peek().to_upper()
	if keyword in ["JOINT", "END", "CHANNELS"] and joint.is_end_site:
		return _lexer.fail_at_next("'OFFSET' or '}' in an End Site")
	match keyword:
		"OFFSET":
			return _read_offset(index)
		"CHANNELS":
			return _read_channels(index)
		"JOINT", "END":
			_lexer.take()
			return _read_joint(keyword)
		"}":
			return _close(index)
	var wanted: String = "OFFSET, CHANNELS, JOINT, End Site or '}' in %s" % _title(index)
	if keyword.is_empty():
		wanted = "'}' to close %s of line %d" % [_title(index), _start_lines[index] + 1]
	return _lexer.fail_at_next(wanted)


func _close(p_index: int) -> bool:
	if _has_offset[p_index] == 0:
		return _lexer.fail_at_next("'OFFSET' in %s" % _title(p_index))
	_lexer.take()
	_open.remove_at(_open.size() - 1)
	return true


func _read_joint(p_keyword: String) -> bool:
	var joint: BvhJoint = BvhJoint.new()
	joint.is_end_site = p_keyword == "END"
	joint.parent = -1 if _open.is_empty() else _open[-1]
	joint.first_channel = channel_count
	var line: int = _lexer.line_index()
	joint.name = _lexer.take_name()
	if joint.is_end_site:
		joint.name = _end_site_name(joint.name)
	elif joint.name.is_empty():
		return _lexer.fail_at_next("a name after '%s'" % p_keyword)
	if joints.size() >= _options.max_joints:
		return _lexer.fail_at(line, "expected at most %d joints, found more" % _options.max_joints)
	if _open.size() >= _options.max_depth:
		return _lexer.fail_at(
			line, "expected at most %d joints below one another, found more" % _options.max_depth
		)
	_open.append(joints.size())
	joints.append(joint)
	_start_lines.append(line)
	_has_offset.append(0)
	_has_channels.append(0)
	if _lexer.peek() != "{":
		return _lexer.fail_at_next("'{' after %s" % _title(joints.size() - 1))
	_lexer.take()
	return true


func _end_site_name(p_words: String) -> String:
	var words: PackedStringArray = p_words.split(" ", false)
	if words.size() > 0 and words[0].to_lower() == "site":
		words.remove_at(0)
	return " ".join(words)


func _read_offset(p_index: int) -> bool:
	if _has_offset[p_index] != 0:
		return _lexer.fail_at_next("one OFFSET in %s" % _title(p_index))
	_has_offset[p_index] = 1
	_lexer.take()
	var line: int = _lexer.line_index()
	var offset: Vector3 = Vector3.ZERO
	for axis: int in 3:
		var word: String = _lexer.peek()
		if not BvhText.is_number(word):
			return _fail_offset(line, word)
		offset[axis] = _lexer.take().to_float()
	joints[p_index].offset = offset
	if not _lexer.is_line_done() and BvhText.is_number(_lexer.peek()):
		return _fail_offset(line, "")
	return true


func _fail_offset(p_line: int, p_word: String) -> bool:
	var found: String = BvhLexer.quote(_lexer.clean_line(p_line))
	if _lexer.line_index() != p_line:
		found += " and then %s" % BvhLexer.quote(p_word)
	return _lexer.fail_at(
		p_line,
		"expected 'OFFSET' with 3 numbers, found %s%s" % [found, BvhText.hint_at_number(p_word)]
	)


func _read_channels(p_index: int) -> bool:
	if _has_channels[p_index] != 0:
		return _lexer.fail_at_next("one CHANNELS in %s" % _title(p_index))
	_has_channels[p_index] = 1
	_lexer.take()
	var line: int = _lexer.line_index()
	var count_word: String = _lexer.peek()
	if not count_word.is_valid_int() or count_word.length() > 9 or count_word.to_int() < 0:
		return _lexer.fail_at_next("the number of channels after 'CHANNELS'")
	_lexer.take()
	var channels: PackedInt32Array = PackedInt32Array()
	while BvhJoint.channel_from(_lexer.peek()) >= 0 and channels.size() <= MAX_CHANNELS:
		var channel: int = BvhJoint.channel_from(_lexer.peek())
		if BvhJoint.is_position(channel) and channel in channels:
			return _lexer.fail_at_next("each position channel once in %s" % _title(p_index))
		channels.append(channel)
		_lexer.take()
	if channels.size() > MAX_CHANNELS:
		return _lexer.fail_at(line, "expected at most %d channels, found more" % MAX_CHANNELS)
	if channels.size() != count_word.to_int():
		return _fail_channel_count(line, count_word.to_int(), channels.size())
	joints[p_index].channels = channels
	channel_count += channels.size()
	return true


func _fail_channel_count(p_line: int, p_wanted: int, p_found: int) -> bool:
	var next: String = _lexer.peek()
	var is_keyword: bool = next.to_upper() in ["", "OFFSET", "JOINT", "END", "{", "}", "CHANNELS"]
	if p_found < p_wanted and not is_keyword:
		return _lexer.fail_at_next("a channel such as 'Xrotation'")
	return _lexer.fail_at(
		p_line,
		(
			"expected %d channels, found %d in %s"
			% [p_wanted, p_found, BvhLexer.quote(_lexer.clean_line(p_line))]
		)
	)


func _title(p_index: int) -> String:
	var joint: BvhJoint = joints[p_index]
	if joint.is_end_site:
		return "the End Site of '%s'" % joints[joint.parent].name.left(BvhLexer.MAX_QUOTE)
	return "joint '%s'" % joint.name.left(BvhLexer.MAX_QUOTE)
