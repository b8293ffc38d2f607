class_name BvhText
extends RefCounted
## Turns the bytes of a BVH file into text.


## Decodes UTF-8, or Latin-1 where the bytes are not UTF-8, as in names that old programs wrote.
## The bytes may not hold a zero.
static func decode(p_bytes: PackedByteArray) -> String:
	if is_ascii(p_bytes) or is_utf8(p_bytes):
		return p_bytes.get_string_from_utf8()
	var utf8: PackedByteArray = PackedByteArray()
	var from: int = 0
	for index: int in p_bytes.size():
		var byte: int = p_bytes[index]
		if byte >= 0x80:
			utf8.append_array(p_bytes.slice(from, index))
			utf8.append(0xC0 | (byte >> 6))
			utf8.append(0x80 | (byte & 0x3F))
			from = index + 1
	utf8.append_array(p_bytes.slice(from))
	return utf8.get_string_from_utf8()


## Whether no byte is above 127. Looks at eight bytes at a time.
static func is_ascii(p_bytes: PackedByteArray) -> bool:
	var padded: PackedByteArray = p_bytes.duplicate()
	padded.resize((p_bytes.size() + 7) / 8 * 8)
	for index: int in range(p_bytes.size(), padded.size()):
		padded[index] = 0
	for word: int in padded.to_int64_array():
		# The highest bit of each byte: 0x8080808080808080.
		if word & -0x7F7F7F7F7F7F7F80 != 0:
			return false
	return true


## Whether the bytes are UTF-8, without overlong forms, surrogates and code points above U+10FFFF.
## Godot's own decoder reports an engine error instead.
static func is_utf8(p_bytes: PackedByteArray) -> bool:
	var index: int = 0
	var size: int = p_bytes.size()
	while index < size:
		var byte: int = p_bytes[index]
		index += 1
		if byte < 0x80:
			continue
		var following: int = 1 if byte < 0xE0 else (2 if byte < 0xF0 else 3)
		if byte < 0xC2 or byte > 0xF4 or index + following > size:
			return false
		var code: int = byte & (0x3F >> following)
		for _step: int in following:
			if p_bytes[index] & 0xC0 != 0x80:
				return false
			code = (code << 6) | (p_bytes[index] & 0x3F)
			index += 1
		var smallest: int = [0x80, 0x800, 0x10000][following - 1]
		if code < smallest or code > 0x10FFFF or (code >= 0xD800 and code <= 0xDFFF):
			return false
	return true
