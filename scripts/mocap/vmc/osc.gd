class_name Osc
extends RefCounted
## Messages of Open Sound Control 1.0 as VMC uses them: texts, numbers of 32 and 64 bits, bytes and
## bundles. Everything is big-endian and a multiple of 4 bytes.

## Greatest number of messages that are read from one datagram.
const MAX_MESSAGES: int = 512
## Greatest depth of bundles in bundles.
const MAX_DEPTH: int = 4
## Greatest number of arguments that are read from one message.
const MAX_ARGUMENTS: int = 64

## Why the last datagram cannot be read, or an empty text.
var fault: String = ""

var _bytes: PackedByteArray = PackedByteArray()
var _buffer: StreamPeerBuffer = StreamPeerBuffer.new()
var _end: int = 0
var _messages: Array[Array] = []


func _init() -> void:
	_buffer.big_endian = true


## The messages of a datagram, each its address and then its arguments (String, int, float, bool,
## null or PackedByteArray). What can't be read ends it; [member fault] says why.
func read(p_bytes: PackedByteArray) -> Array[Array]:
	fault = ""
	_messages = []
	_bytes = p_bytes
	_buffer.data_array = p_bytes
	_read_element(0, p_bytes.size(), 0)
	return _messages


## A message: the address, and arguments that are a String, an int or a float each.
static func message(p_address: String, p_arguments: Array) -> PackedByteArray:
	var buffer: StreamPeerBuffer = StreamPeerBuffer.new()
	buffer.big_endian = true
	var tags: String = ","
	for argument: Variant in p_arguments:
		tags += "s" if argument is String else ("i" if argument is int else "f")
	_put_text(buffer, p_address)
	_put_text(buffer, tags)
	for argument: Variant in p_arguments:
		if argument is String:
			_put_text(buffer, argument)
		elif argument is int:
			buffer.put_32(argument)
		else:
			buffer.put_float(argument)
	return buffer.data_array


## A bundle of messages, to be used at once (time tag 1).
static func bundle(p_messages: Array[PackedByteArray]) -> PackedByteArray:
	var buffer: StreamPeerBuffer = StreamPeerBuffer.new()
	buffer.big_endian = true
	_put_text(buffer, "#bundle")
	buffer.put_u64(1)
	for part: PackedByteArray in p_messages:
		buffer.put_32(part.size())
		buffer.put_data(part)
	return buffer.data_array


static func _put_text(r_buffer: StreamPeerBuffer, p_text: String) -> void:
	var bytes: PackedByteArray = p_text.to_utf8_buffer()
	bytes.resize((bytes.size() + 4) & ~3)
	r_buffer.put_data(bytes)


func _read_element(p_begin: int, p_end: int, p_depth: int) -> void:
	if p_end - p_begin < 4:
		fault = "%d bytes are no OSC message" % (p_end - p_begin)
		return
	_end = p_end
	_buffer.seek(p_begin)
	if _bytes[p_begin] == 0x2F:
		_read_message()
	elif _bytes[p_begin] == 0x23:
		_read_bundle(p_begin, p_end, p_depth)
	else:
		fault = "it begins with byte 0x%02X, an OSC message with '/' or '#bundle'" % _bytes[p_begin]


func _read_bundle(p_begin: int, p_end: int, p_depth: int) -> void:
	if p_depth >= MAX_DEPTH or _text() != "#bundle" or p_end - p_begin < 16:
		fault = "it begins like an OSC bundle and is none"
		return
	var at: int = p_begin + 16
	while at + 4 <= p_end and fault == "":
		_buffer.seek(at)
		var size: int = _buffer.get_u32()
		if size > p_end - at - 4 or size % 4 != 0:
			fault = "a part of %d bytes in an OSC bundle that has %d left" % [size, p_end - at - 4]
			return
		_read_element(at + 4, at + 4 + size, p_depth + 1)
		at += 4 + size
	if fault == "" and at != p_end:
		fault = "%d bytes behind an OSC bundle's last part" % (p_end - at)


func _read_message() -> void:
	if _messages.size() >= MAX_MESSAGES:
		fault = "more than %d OSC messages in a datagram" % MAX_MESSAGES
		return
	var found: Array = [_text()]
	# Types are read as bytes: each letter of a String would be a new String.
	var tag: int = _buffer.get_position()
	var count: int = _bytes.find(0, tag) - tag
	if fault == "":
		_text()
	if fault == "" and (_bytes[tag] != 0x2C or count > MAX_ARGUMENTS):
		fault = "'%s' has no types of OSC arguments" % ByteReader.clean(str(found[0])).left(40)
	for at: int in range(tag + 1, tag + count):
		if fault != "":
			return
		# Most are numbers.
		if _bytes[at] == 0x66 and _buffer.get_position() + 4 <= _end:
			found.append(_buffer.get_float())
		else:
			found.append(_argument(_bytes[at]))
	if fault == "":
		_messages.append(found)


func _argument(p_tag: int) -> Variant:
	var found: Variant = null
	match char(p_tag):
		"f":
			found = _buffer.get_float() if _has(4) else 0.0
		"i":
			found = _buffer.get_32() if _has(4) else 0
		"s", "S":
			found = _text()
		"d":
			found = _buffer.get_double() if _has(8) else 0.0
		"h", "t":
			found = _buffer.get_64() if _has(8) else 0
		"b":
			found = _raw()
		"T", "F":
			found = p_tag == 0x54
		"N":
			found = null
		"I":
			found = INF
		_:
			fault = "there is no type 0x%02X of OSC arguments" % p_tag
	return found


func _has(p_size: int) -> bool:
	if _buffer.get_position() + p_size <= _end:
		return true
	fault = "an OSC message ends before its last argument"
	return false


func _text() -> String:
	var begin: int = _buffer.get_position()
	var end: int = _bytes.find(0, begin)
	var next: int = (end + 4) & ~3
	if end < 0 or next > _end:
		fault = "a text in an OSC message has no end"
		return ""
	_buffer.seek(next)
	# Byte by byte: all names that are used are ASCII, and the engine reports an error for UTF-8
	# that is none.
	return _bytes.slice(begin, end).get_string_from_ascii()


func _raw() -> PackedByteArray:
	if not _has(4):
		return PackedByteArray()
	var size: int = _buffer.get_u32()
	if not _has(size):
		return PackedByteArray()
	var begin: int = _buffer.get_position()
	_buffer.seek(mini((begin + size + 3) & ~3, _bytes.size()))
	return _bytes.slice(begin, begin + size)
