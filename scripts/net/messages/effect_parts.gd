class_name EffectParts
extends RefCounted
## Joins the parts of an effect's file again ([EffectMessage]). A new file replaces an unfinished
## one, so that who is behind keeps at most one.

## The whole file, after [method take] has said so.
var bytes: PackedByteArray = []

var _number: int = -1
var _name: String = ""
var _parts: int = 0
var _next: int = 0


## Adds a part. Returns whether the file is whole now.
func take(p_message: EffectMessage) -> bool:
	if p_message.part == 0:
		_number = p_message.number
		_name = p_message.name
		_parts = p_message.parts
		_next = 0
		bytes = PackedByteArray()
	if p_message.number != _number or p_message.name != _name or p_message.part != _next:
		_number = -1
		return false
	if p_message.parts != _parts or bytes.size() + p_message.data.size() > EffectLimits.MAX_BYTES:
		_number = -1
		return false
	bytes.append_array(p_message.data)
	_next += 1
	return _next == _parts
