@tool
class_name EffectInput
extends RefCounted
## A number that the emitter of an effect sets while it runs, such as the revolutions of an engine.
##
## In the file: [code]// @input NAME FROM TO DEFAULT what it is[/code]. The code reads it by its
## name.

## The name in the code.
var name: String = ""
## Lowest value; lower ones are raised to it.
var minimum: float = 0.0
## Highest value; higher ones are lowered to it.
var maximum: float = 1.0
## The value until an emitter sets another.
var default: float = 0.0
## What it is, with its unit, for people.
var meaning: String = ""


## The declaration in the shading language.
func declaration() -> String:
	return (
		"uniform float %s : hint_range(%s, %s) = %s; "
		% [name, _number(minimum), _number(maximum), _number(default)]
	)


## A value within the bounds.
func clamped(p_value: float) -> float:
	return clampf(p_value, minimum, maximum)


static func _number(p_value: float) -> String:
	return "%.6f" % p_value
