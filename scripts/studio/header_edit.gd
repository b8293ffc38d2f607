@tool
class_name HeaderEdit
extends RefCounted
## Changes one setting or one default in the text of an effect, and nothing else: what sliders do.


## The text with another value of a setting. One that is not there yet gets a line below the others.
static func set_setting(p_text: String, p_name: String, p_value: String) -> String:
	var lines: PackedStringArray = p_text.split("\n")
	var last: int = 0
	for i: int in lines.size():
		var line: String = lines[i].strip_edges()
		if line.begins_with("shader_type"):
			last = maxi(last, i)
		if not line.begins_with(EffectHeader.MARK):
			continue
		last = i
		var words: PackedStringArray = line.substr(EffectHeader.MARK.length()).split(" ", false)
		if not words.is_empty() and words[0] == p_name:
			lines[i] = _written(p_name, p_value)
			return "\n".join(lines)
	lines.insert(last + 1, _written(p_name, p_value))
	return "\n".join(lines)


## The text with another default of a uniform: what stands behind its = up to the semicolon.
static func set_default(p_text: String, p_name: String, p_value: String) -> String:
	var pattern: RegEx = RegEx.create_from_string(
		"(uniform\\s+\\w+\\s+%s\\b[^;=]*)(=[^;]*)?;" % p_name
	)
	var found: RegExMatch = pattern.search(p_text)
	if found == null:
		return p_text
	var before: String = found.get_string(1).strip_edges(false, true)
	var changed: String = "%s = %s;" % [before, p_value]
	return p_text.left(found.get_start()) + changed + p_text.substr(found.get_end())


## A number as the header has it.
static func number(p_value: float) -> String:
	return String.num(p_value, 3).trim_suffix(".0")


## A number as the code has it: with a point.
static func code_number(p_value: float) -> String:
	var text: String = String.num(p_value, 3)
	return text if text.contains(".") else text + ".0"


static func _written(p_name: String, p_value: String) -> String:
	return "// @%s %s" % [p_name.rpad(8), p_value]
