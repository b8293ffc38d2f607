class_name NatnetBytes
extends RefCounted
## Fields of NatNet's messages, one after the other, and what is passed over of them. Whatever
## cannot be read sets [member fault] and gives zero.

## Bytes of a rigid body in a frame, from version 3 on, and of a marker with a label.
const BODY_BYTES: int = 38
const LABELED_BYTES: int = 26
const _MAX_COUNT: int = 65536

## Why the message can't be read, or an empty text.
var fault: String = ""

var _bytes: PackedByteArray = PackedByteArray()
var _at: int = 0


## A message of a kind with a text.
static func message(p_kind: int, p_text: String = "") -> PackedByteArray:
	var text: PackedByteArray = p_text.to_ascii_buffer()
	text.append(0)
	var bytes: PackedByteArray = [0, 0, 0, 0]
	bytes.encode_u16(0, p_kind)
	bytes.encode_u16(2, text.size())
	bytes.append_array(text)
	return bytes


## Begins to read a message.
func begin(p_bytes: PackedByteArray, p_at: int) -> void:
	_bytes = p_bytes
	_at = p_at
	fault = ""


## Where the next field is.
func position() -> int:
	return _at


## Goes on somewhere, which is not before this.
func seek(p_at: int) -> void:
	if p_at < _at or p_at > _bytes.size():
		fault = "a part ends at byte %d, before its content or behind the message" % p_at
	else:
		_at = p_at


## Passes over so many bytes.
func skip(p_size: int) -> void:
	_take(p_size)


## An unsigned byte.
func read_u8() -> int:
	return _bytes[_at - 1] if _take(1) else 0


## An unsigned number of 4 bytes.
func read_u32() -> int:
	return _bytes.decode_u32(_at - 4) if _take(4) else 0


## A count of what follows, at most so many.
func read_count(p_most: int) -> int:
	var count: int = read_u32()
	if count > p_most:
		fault = "%d parts where at most %d are" % [count, p_most]
		return 0
	return count


## A number of 8 bytes.
func read_double() -> float:
	return _bytes.decode_double(_at - 8) if _take(8) else NAN


## Three numbers of 4 bytes.
func read_vector() -> Vector3:
	if not _take(12):
		return Vector3.ZERO
	return Vector3(
		_bytes.decode_float(_at - 12), _bytes.decode_float(_at - 8), _bytes.decode_float(_at - 4)
	)


## x, y, z, w of a rotation, whatever its length.
func read_turn() -> Quaternion:
	if not _take(16):
		return Quaternion.IDENTITY
	return Quaternion(
		_bytes.decode_float(_at - 16),
		_bytes.decode_float(_at - 12),
		_bytes.decode_float(_at - 8),
		_bytes.decode_float(_at - 4)
	)


## A text that ends with a zero, at most so long; one of fixed length has that many bytes.
func read_text(p_most: int, p_is_fixed: bool = false) -> String:
	if fault != "":
		return ""
	var end: int = _bytes.find(0, _at)
	if end < 0 or end - _at > p_most:
		fault = "a text has no end within %d bytes" % p_most
		return ""
	var text: String = _bytes.slice(_at, end).get_string_from_ascii()
	skip(p_most if p_is_fixed else end + 1 - _at)
	return ByteReader.clean(text)


## Passes over the markers that a rigid body's description has.
static func skip_markers(r_bytes: NatnetBytes, p_version: int) -> void:
	var count: int = r_bytes.read_count(_MAX_COUNT)
	r_bytes.skip(count * 16)
	if p_version >= 400:
		for _marker: int in count:
			if r_bytes.fault != "":
				return
			r_bytes.read_text(256)


## Passes over a description that is no skeleton, of a version without sizes.
static func skip_model(r_bytes: NatnetBytes, p_type: int, p_version: int) -> void:
	match p_type:
		0:
			r_bytes.read_text(256)
			_skip_texts(r_bytes)
		1:
			r_bytes.read_text(256)
			r_bytes.skip(20)
			skip_markers(r_bytes, p_version)
		3:
			r_bytes.skip(4)
			r_bytes.read_text(256)
			r_bytes.skip(20 + 4 * 144 + 4 * 12 + 8)
			_skip_texts(r_bytes)
		4:
			r_bytes.skip(4)
			r_bytes.read_text(256)
			r_bytes.read_text(256)
			r_bytes.skip(8)
			_skip_texts(r_bytes)
		5:
			r_bytes.read_text(256)
			r_bytes.skip(28)
		_:
			r_bytes.fault = "a description of type %d is not known" % p_type


## Passes over marker sets, markers and rigid bodies of a frame.
static func skip_before_skeletons(r_bytes: NatnetBytes, p_version: int) -> void:
	if p_version >= 401:
		for _part: int in 3:
			_skip_sized(r_bytes)
		return
	for _set: int in r_bytes.read_count(_MAX_COUNT):
		r_bytes.read_text(256)
		r_bytes.skip(12 * r_bytes.read_count(_MAX_COUNT))
		if r_bytes.fault != "":
			return
	r_bytes.skip(12 * r_bytes.read_count(_MAX_COUNT))
	r_bytes.skip(BODY_BYTES * r_bytes.read_count(_MAX_COUNT))


## Passes over assets, markers with labels, force plates and devices of a frame.
static func skip_after_skeletons(r_bytes: NatnetBytes, p_version: int) -> void:
	if p_version >= 401:
		for _part: int in 4:
			_skip_sized(r_bytes)
		return
	r_bytes.skip(LABELED_BYTES * r_bytes.read_count(_MAX_COUNT))
	for _part: int in 2:
		for _device: int in r_bytes.read_count(_MAX_COUNT):
			r_bytes.skip(4)
			for _channel: int in r_bytes.read_count(_MAX_COUNT):
				r_bytes.skip(4 * r_bytes.read_count(_MAX_COUNT))
				if r_bytes.fault != "":
					return
			if r_bytes.fault != "":
				return


static func _skip_sized(r_bytes: NatnetBytes) -> void:
	r_bytes.skip(4)
	r_bytes.skip(r_bytes.read_u32())


static func _skip_texts(r_bytes: NatnetBytes) -> void:
	for _text: int in r_bytes.read_count(_MAX_COUNT):
		r_bytes.read_text(256)
		if r_bytes.fault != "":
			return


func _take(p_size: int) -> bool:
	if fault != "":
		return false
	if p_size < 0 or p_size > _bytes.size() - _at:
		fault = "%d bytes are needed and %d left" % [p_size, _bytes.size() - _at]
		return false
	_at += p_size
	return true
