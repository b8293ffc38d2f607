class_name BvhText
extends RefCounted
## Turns the bytes of a BVH file into text, and says what counts as a number in it.

## Regular expression of one number: a decimal number with a point, up to 9 digits before it and, if
## it has one, an exponent from -499 to +9. So nothing can become infinite, here or in a sum or
## square later, and neither a decimal comma nor NaN passes. Godot's own conversion takes "1.2abc"
## for 1.2 silently.
const NUMBER: String = (
	"[+-]?(?:[0-9]{1,9}(?:\\.[0-9]*)?|\\.[0-9]+)" + "(?:[eE](?:-0*[0-4]?[0-9]{1,2}|\\+?0*[0-9]))?"
)

static var _number: RegEx = RegEx.create_from_string("^" + NUMBER + "$")
static var _odd_size: RegEx = RegEx.create_from_string("^[+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?$")
static var _comma: RegEx = RegEx.create_from_string("^[+-]?[0-9]*,[0-9]+")


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


## Whether [param p_word] is a number.
static func is_number(p_word: String) -> bool:
	return _number.search(p_word) != null


## A regular expression that matches a line of nothing but numbers and spaces.
static func number_line() -> RegEx:
	return RegEx.create_from_string("^(?: *+" + NUMBER + "(?= |$))*+ *$")


## A remark on why a word is no number, to end an error with; empty where there is nothing to say.
static func hint_at_number(p_word: String) -> String:
	if _comma.search(p_word) != null:
		return " (a decimal comma? numbers need a point)"
	if p_word.to_lower().contains("nan") or p_word.to_lower().contains("inf"):
		return " (numbers have to be finite)"
	if _odd_size.search(p_word) != null and not is_number(p_word):
		return " (too large or too small a number)"
	return ""
