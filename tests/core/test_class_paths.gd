extends TestCase
## Classes are found by what they extend, directly or not.


func test_classes_that_extend_one_are_found_in_their_order() -> void:
	var parts: PackedStringArray = ClassPaths.extending(&"ProgramPart")
	for path: String in [
		"client/client_part.gd", "server/server_part.gd", "server/parts/port_part.gd"
	]:
		is_true(parts.has("res://scripts/" + path), path)
	is_false(parts.has("res://scripts/core/program_part.gd"), "not the class itself")
	var sorted: PackedStringArray = parts.duplicate()
	sorted.sort()
	equal(parts, sorted)
	equal(ClassPaths.extending(&"NoSuchClass"), PackedStringArray())
