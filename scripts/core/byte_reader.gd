class_name ByteReader
extends RefCounted
## Reads the fields of a packet from an untrusted sender, one after the other, little-endian.
##
## What cannot be read, or is not finite, sets [member failed] and gives zero. Unlike Godot's
## own decoders of Variants and UTF-8 it reports no engine errors, so nobody can fill the log.

## First and last of the ranges of Unicode that are controls, formats, fillers or private: its
## categories Cc, Cf, Co, Zl, Zp, every space but the usual one, selectors and blank letters.
const _UNSEEN: Array[int] = [
	0x00,
	0x1F,
	0x7F,
	0xA0,
	0xAD,
	0xAD,
	0x34F,
	0x34F,
	0x600,
	0x605,
	0x61C,
	0x61C,
	0x6DD,
	0x6DD,
	0x70F,
	0x70F,
	0x115F,
	0x1160,
	0x1680,
	0x1680,
	0x17B4,
	0x17B5,
	0x180B,
	0x180F,
	0x2000,
	0x200F,
	0x2028,
	0x202F,
	0x205F,
	0x206F,
	0x2800,
	0x2800,
	0x3000,
	0x3000,
	0x3164,
	0x3164,
	0xE000,
	0xF8FF,
	0xFE00,
	0xFE0F,
	0xFEFF,
	0xFEFF,
	0xFFA0,
	0xFFA0,
	0xFFF0,
	0xFFFB,
	0x1D173,
	0x1D17A,
	0xE0000,
	0x10FFFF,
]

## The least code that UTF-8 writes with so many more bytes.
const _MIN_CODES: Array[int] = [0, 0x80, 0x800, 0x10000]

## Whether a field was missing or invalid.
var failed: bool = false

var _bytes: PackedByteArray = PackedByteArray()
var _at: int = 0


func _init(p_bytes: PackedByteArray, p_begin: int = 0) -> void:
	_bytes = p_bytes
	_at = p_begin


## Whether every byte was read, and all were valid.
func is_complete() -> bool:
	return not failed and _at == _bytes.size()


## Bytes that are left.
func left() -> int:
	return _bytes.size() - _at


## An unsigned byte.
func read_u8() -> int:
	return _bytes.decode_u8(_at - 1) if _take(1) else 0


## An unsigned number of 2 bytes.
func read_u16() -> int:
	return _bytes.decode_u16(_at - 2) if _take(2) else 0


## An unsigned number of 4 bytes.
func read_u32() -> int:
	return _bytes.decode_u32(_at - 4) if _take(4) else 0


## A signed number of 4 bytes.
func read_s32() -> int:
	return _bytes.decode_s32(_at - 4) if _take(4) else 0


## A finite number of 4 bytes.
func read_float() -> float:
	return _finite(_bytes.decode_float(_at - 4)) if _take(4) else 0.0


## A list of finite numbers of 4 bytes; its length is given.
func read_floats(p_count: int) -> PackedFloat32Array:
	var floats: PackedFloat32Array = PackedFloat32Array()
	if _take(4 * p_count):
		floats = _bytes.slice(_at - 4 * p_count, _at).to_float32_array()
	for number: float in floats:
		_finite(number)
	return floats if not failed else PackedFloat32Array()


## A finite number of 8 bytes.
func read_double() -> float:
	return _finite(_bytes.decode_double(_at - 8)) if _take(8) else 0.0


## Three finite numbers of 4 bytes.
func read_vector() -> Vector3:
	var x: float = read_float()
	var y: float = read_float()
	return Vector3(x, y, read_float())


## x, y, z, w of a quaternion, whatever its length.
func read_rotation() -> Quaternion:
	var vector: Vector3 = read_vector()
	return Quaternion(vector.x, vector.y, vector.z, read_float())


## The basis' columns and the origin.
func read_transform() -> Transform3D:
	var x: Vector3 = read_vector()
	var y: Vector3 = read_vector()
	var z: Vector3 = read_vector()
	return Transform3D(x, y, z, read_vector())


## This many bytes.
func read_bytes(p_size: int) -> PackedByteArray:
	return _bytes.slice(_at - p_size, _at) if _take(p_size) else PackedByteArray()


## Leaves out this many bytes.
func skip(p_size: int) -> void:
	_take(p_size)


## A text: its length in bytes as u16, and UTF-8 without control characters.
func read_text(p_most_bytes: int) -> String:
	var size: int = read_u16()
	failed = failed or size > p_most_bytes
	if not _take(size):
		return ""
	return _decode(_bytes.slice(_at - size, _at))


## What [method read_text] reads. Control characters are left out.
static func text_bytes(p_text: String) -> PackedByteArray:
	var text: PackedByteArray = clean(p_text).to_utf8_buffer()
	var bytes: PackedByteArray = PackedByteArray([0, 0])
	bytes.encode_u16(0, text.size())
	bytes.append_array(text)
	return bytes


## A text without the characters that would garble a log line.
static func clean(p_text: String) -> String:
	if _is_plain(p_text.to_utf8_buffer()):
		return p_text
	var kept: String = ""
	for letter: String in p_text:
		if _is_printable(letter.unicode_at(0)):
			kept += letter
	return kept


## What [method read_transform] reads.
static func transform_bytes(p_transform: Transform3D) -> PackedByteArray:
	var basis: Basis = p_transform.basis
	var rows: PackedVector3Array = [basis.x, basis.y, basis.z, p_transform.origin]
	var numbers: PackedFloat32Array = []
	for row: Vector3 in rows:
		numbers.append_array([row.x, row.y, row.z])
	return numbers.to_byte_array()


func _take(p_size: int) -> bool:
	if failed or p_size > left():
		failed = true
		return false
	_at += p_size
	return true


func _finite(p_value: float) -> float:
	failed = failed or not is_finite(p_value)
	return 0.0 if failed else p_value


## Strict UTF-8: no overlong forms, no surrogates, no control characters.
func _decode(p_bytes: PackedByteArray) -> String:
	if _is_plain(p_bytes):
		return p_bytes.get_string_from_ascii()
	var codes: PackedInt32Array = PackedInt32Array()
	var index: int = 0
	while index < p_bytes.size():
		var byte: int = p_bytes[index]
		var more: int = 0 if byte < 0x80 else (1 if byte < 0xE0 else (2 if byte < 0xF0 else 3))
		if index + more >= p_bytes.size() or (byte >= 0x80 and byte < 0xC2) or byte > 0xF4:
			failed = true
			return ""
		var code: int = byte if more == 0 else byte & (0x3F >> more)
		for step: int in more:
			failed = failed or p_bytes[index + 1 + step] & 0xC0 != 0x80
			code = (code << 6) | (p_bytes[index + 1 + step] & 0x3F)
		if failed or code < _MIN_CODES[more] or not _is_printable(code):
			failed = true
			return ""
		codes.append(code)
		index += 1 + more
	return codes.to_byte_array().get_string_from_utf32()


## Whether all are printable ASCII characters. Sorting gives the least and the greatest without a
## loop in a script: a table of thousands of entities has as many texts.
static func _is_plain(p_bytes: PackedByteArray) -> bool:
	var sorted: PackedByteArray = p_bytes.duplicate()
	sorted.sort()
	return sorted.is_empty() or (sorted[0] >= 0x20 and sorted[-1] < 0x7F)


## Whether a character may be in a name: not those that garble a log line or cannot be seen. Line
## separators, marks that turn the direction of writing, joiners, fillers and tags would let
## somebody look like somebody else.
static func _is_printable(p_code: int) -> bool:
	if p_code > 0x10FFFF or (p_code >= 0xD800 and p_code <= 0xDFFF) or p_code & 0xFFFE == 0xFFFE:
		return false
	var next: int = _UNSEEN.bsearch(p_code)
	# After a range's first comes its last.
	return next % 2 == 0 and (next == _UNSEEN.size() or _UNSEEN[next] != p_code)
