class_name BvhNumber
extends RefCounted
## What counts as a number in a BVH file.
##
## A decimal number with a point, up to 9 digits before it and, if it has one, an exponent from
## -499 to +9. So nothing can become infinite, here or in a sum or square later, and neither a
## decimal comma nor NaN passes. Godot's own conversion takes "1.2abc" for 1.2 without a word.

## Regular expression of one number.
const PATTERN: String = (
	"[+-]?(?:[0-9]{1,9}(?:\\.[0-9]*)?|\\.[0-9]+)" + "(?:[eE](?:-0*[0-4]?[0-9]{1,2}|\\+?0*[0-9]))?"
)

static var _number: RegEx = RegEx.create_from_string("^" + PATTERN + "$")
static var _odd_size: RegEx = RegEx.create_from_string("^[+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?$")
static var _comma: RegEx = RegEx.create_from_string("^[+-]?[0-9]*,[0-9]+")


## Whether [param p_word] is a number.
static func is_number(p_word: String) -> bool:
	return _number.search(p_word) != null


## A regular expression that matches a line of nothing but numbers and spaces.
static func line_expression() -> RegEx:
	return RegEx.create_from_string("^(?: *+" + PATTERN + "(?= |$))*+ *$")


## A remark on why a word is no number, to end an error with; empty where there is nothing to say.
static func hint(p_word: String) -> String:
	if _comma.search(p_word) != null:
		return " (a decimal comma? numbers need a point)"
	if p_word.to_lower().contains("nan") or p_word.to_lower().contains("inf"):
		return " (numbers have to be finite)"
	if _odd_size.search(p_word) != null and not is_number(p_word):
		return " (too large or too small a number)"
	return ""
