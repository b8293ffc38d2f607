@tool
class_name EffectProblem
extends RefCounted
## One thing that is wrong in the file of an effect: on which line, and what to do about it.

## Counted from 1.
var line: int = 1
## For people: what was found, what is expected.
var text: String = ""


func _init(p_line: int, p_text: String) -> void:
	line = p_line
	text = p_text


func _to_string() -> String:
	return "line %d: %s" % [line, text]
