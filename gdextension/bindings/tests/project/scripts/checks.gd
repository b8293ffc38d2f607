# SPDX-License-Identifier: MIT
class_name Checks
extends RefCounted
## Counts checks and prints a line for each.

## Checks that held.
var passed: int = 0
## Checks that did not hold.
var failed: int = 0


## Notes whether [param condition] holds; [param found] explains a failure.
func that(name: String, condition: bool, found: Variant = "") -> void:
	if condition:
		passed += 1
		print("ok ", name)
	else:
		failed += 1
		print("FAIL ", name, ": found ", found)


## Notes whether two values are the same, in type as well.
func equal(name: String, found: Variant, expected: Variant) -> void:
	that(name, typeof(found) == typeof(expected) and found == expected, found)
