@tool
class_name EffectBinding
extends RefCounted
## What an input of an effect follows, read from a line such as [code]revs = rpm * 0.0004[/code]
## (a field of an entity, times a number) or [code]scale = 1.5[/code] (a number).

## The input that stands for the share of particles instead of one of the file's inputs.
const AMOUNT: StringName = &"amount"

## The input of the effect, or [constant AMOUNT].
var input: StringName = &""
## The field that it follows; empty where it is a number.
var field: StringName = &""
## What the field is multiplied by, or the number itself.
var factor: float = 1.0
## What is wrong with the line, for people; empty if nothing is.
var error: String = ""


## Reads a text with a line for each input; lines without any words are left out.
static func read(p_text: String) -> Array[EffectBinding]:
	var found: Array[EffectBinding] = []
	for line: String in p_text.replace(";", "\n").split("\n"):
		if line.strip_edges() != "":
			found.append(_read_line(line.strip_edges()))
	return found


## The value of the input where the field has one.
func value_of(p_field: float) -> float:
	return p_field * factor if field != &"" else factor


static func _read_line(p_line: String) -> EffectBinding:
	var binding: EffectBinding = EffectBinding.new()
	var sides: PackedStringArray = p_line.split("=")
	if sides.size() != 2 or not sides[0].strip_edges().is_valid_ascii_identifier():
		binding.error = "'%s' reads INPUT = FIELD * 0.5, or INPUT = 0.5" % p_line.left(40)
		return binding
	binding.input = StringName(sides[0].strip_edges())
	var parts: PackedStringArray = sides[1].split("*")
	var first: String = parts[0].strip_edges()
	if parts.size() == 1 and first.is_valid_float():
		binding.factor = first.to_float()
	elif parts.size() <= 2 and first.is_valid_ascii_identifier():
		binding.field = StringName(first)
		var last: String = parts[parts.size() - 1].strip_edges()
		if parts.size() == 2 and not last.is_valid_float():
			binding.error = "'%s' is no number to multiply '%s' by" % [last.left(40), first]
		elif parts.size() == 2:
			binding.factor = last.to_float()
	else:
		binding.error = "'%s' is neither a field, FIELD * NUMBER, nor a number" % sides[1].left(40)
	if not is_finite(binding.factor):
		binding.error = "'%s' is no number" % p_line.left(40)
	return binding
