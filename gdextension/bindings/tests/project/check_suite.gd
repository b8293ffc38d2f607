class_name CheckSuite
extends Node
## A set of checks. Subclasses override [method run].

## Emitted after each check; the problem is empty where there is none.
signal checked(check_name: String, problem: String)


## Makes all checks.
func run() -> void:
	pass


## Checks a condition.
func check(check_name: String, holds: bool, found: Variant = null) -> void:
	checked.emit(check_name, "" if holds else "does not hold; found %s" % [found])


## Checks for equality, including the type.
func equal(check_name: String, found: Variant, expected: Variant) -> void:
	var same: bool = typeof(found) == typeof(expected) and found == expected
	checked.emit(check_name, "" if same else "found %s, expected %s" % [found, expected])
