@tool
class_name EffectText
extends RefCounted
## Bytes that came from a file or over the network as text. The engine's own decoder writes every
## bad byte into the log, so that anybody could fill it; this one only says no.

const _TAB: int = 9
const _LINE: int = 10
const _RETURN: int = 13

## The text; empty where [member failed].
var text: String = ""
## Whether the bytes are no text in UTF-8, or have characters that cannot be seen.
var failed: bool = false


func _init(p_bytes: PackedByteArray) -> void:
	if _is_ascii(p_bytes):
		text = p_bytes.get_string_from_ascii()
	else:
		_decode(p_bytes)


## Whether all is printable ASCII, tabs and ends of lines. Sorting looks at all bytes without a loop
## in a script.
static func _is_ascii(p_bytes: PackedByteArray) -> bool:
	if p_bytes.is_empty():
		return true
	var sorted: PackedByteArray = p_bytes.duplicate()
	sorted.sort()
	var spaces: int = p_bytes.count(_TAB) + p_bytes.count(_LINE) + p_bytes.count(_RETURN)
	return sorted[-1] < 0x7F and sorted.bsearch(0x20) == spaces


func _decode(p_bytes: PackedByteArray) -> void:
	var parts: PackedStringArray = []
	var from: int = 0
	for i: int in p_bytes.size() + 1:
		var byte: int = p_bytes[i] if i < p_bytes.size() else _LINE
		if byte != _TAB and byte != _LINE and byte != _RETURN:
			continue
		var piece: PackedByteArray = [0, 0]
		piece.encode_u16(0, mini(i - from, 0xFFFF))
		piece.append_array(p_bytes.slice(from, i))
		var reader: ByteReader = ByteReader.new(piece)
		parts.append(reader.read_text(EffectLimits.MAX_BYTES))
		if i < p_bytes.size():
			parts.append(String.chr(byte))
		failed = failed or reader.failed
		from = i + 1
	text = "" if failed else "".join(parts)
