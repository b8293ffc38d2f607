# SPDX-License-Identifier: MIT
extends Node
## Values in both directions: arguments, results, defaults, properties, signals, enums.


## Runs the checks.
func run(checks: Checks) -> void:
	var probe := BindingsProbe.new()
	_check_scalars(checks, probe)
	_check_builtins(checks, probe)
	_check_containers(checks, probe)
	_check_echo(checks, probe)
	_check_properties(checks, probe)
	_check_description(checks)
	_check_errors(checks, probe)


func _check_scalars(checks: Checks, probe: BindingsProbe) -> void:
	var untyped: Variant = probe
	checks.equal("integers, typed call", probe.add(2, 40), 42)
	checks.equal("integers, untyped call", untyped.add(2, 40), 42)
	checks.equal("64-bit integers", probe.add(0x7000_0000_0000_0000, 1), 0x7000_0000_0000_0001)
	checks.equal("default argument, typed call", probe.scale(2.0), 6.0)
	checks.equal("default argument, untyped call", untyped.scale(2.0), 6.0)
	checks.equal("integers for floats", untyped.scale(2, 4), 8.0)
	checks.equal("bool, typed call", probe.flip(false), true)
	checks.equal("bool, untyped call", untyped.flip(true), false)


func _check_builtins(checks: Checks, probe: BindingsProbe) -> void:
	var untyped: Variant = probe
	checks.equal("text beyond ASCII", probe.greet("Wörld ✓"), "Hello, Wörld ✓!")
	checks.equal("UTF-8", probe.utf8_length("ö✓"), 5)
	checks.equal("empty text", untyped.greet(""), "Hello, !")
	checks.equal("names", probe.echo_name(&"abc"), &"abc")
	checks.equal("text for a name", untyped.echo_name("abc"), &"abc")
	checks.equal("vector", probe.cross(Vector3.RIGHT, Vector3.UP), Vector3.BACK)
	var turn := Quaternion(Vector3.UP, 0.5)
	var twice := probe.multiply(turn, turn)
	checks.that("quaternion", twice.is_equal_approx(Quaternion(Vector3.UP, 1.0)), twice)


func _check_containers(checks: Checks, probe: BindingsProbe) -> void:
	var inverted := probe.invert(PackedByteArray([0, 1, 255]))
	checks.equal("packed bytes", inverted, PackedByteArray([255, 254, 0]))
	checks.equal("no packed bytes", probe.invert(PackedByteArray()), PackedByteArray())
	var sums := probe.prefix_sum(PackedFloat32Array([1, 2, 3]))
	checks.equal("packed floats", sums, PackedFloat32Array([1, 3, 6]))
	var reversed := probe.reversed([1, "a", Vector3.ONE, {"k": 1}])
	checks.equal("array", reversed, [{"k": 1}, Vector3.ONE, "a", 1])
	var description := probe.describe({"x": 4, "y": "b"})
	var expected := {"count": 2, "has_x": true, "twice_x": 8.0, "keys": ["x", "y"]}
	checks.equal("dictionary", description, expected)
	var rids: Array[RID] = [RID(), get_viewport().get_viewport_rid()]
	checks.equal("typed array as an argument", probe.count_valid(rids), 1)
	var corners: Array = probe.corners()
	checks.equal("typed array as a result", corners, [Vector3.ZERO, Vector3(1, 2, 3)])
	checks.equal("type of a typed array", corners.get_typed_builtin(), TYPE_VECTOR3)


func _check_echo(checks: Checks, probe: BindingsProbe) -> void:
	var values: Array[Variant] = [
		null,
		true,
		5,
		1.5,
		"x",
		&"y",
		^"a/b",
		Vector2(1, 2),
		Vector2i(1, 2),
		Rect2(1, 2, 3, 4),
		Rect2i(1, 2, 3, 4),
		Vector3(1, 2, 3),
		Vector3i(1, 2, 3),
		Transform2D(1, Vector2.ONE),
		Vector4(1, 2, 3, 4),
		Vector4i(1, 2, 3, 4),
		Plane(1, 2, 3, 4),
		Quaternion(0, 1, 0, 0),
		AABB(Vector3.ONE, Vector3.ONE),
		Basis(),
		Transform3D(Basis(), Vector3.ONE),
		Projection(),
		Color.RED,
		RID(),
		self,
		Callable(self, "run"),
		ready,
		{1: 2},
		[1],
		PackedByteArray([1]),
		PackedInt32Array([1]),
		PackedInt64Array([1]),
		PackedFloat32Array([1]),
		PackedFloat64Array([1]),
		PackedStringArray(["a"]),
		PackedVector2Array([Vector2.ONE]),
		PackedVector3Array([Vector3.ONE]),
		PackedColorArray([Color.RED]),
		PackedVector4Array([Vector4.ONE]),
	]
	var untyped: Variant = probe
	for value: Variant in values:
		var type := type_string(typeof(value))
		checks.equal("echo of %s, typed call" % type, probe.echo(value), value)
		checks.equal("echo of %s, untyped call" % type, untyped.echo(value), value)


func _check_properties(checks: Checks, probe: BindingsProbe) -> void:
	var heard: Array[Array] = []
	var listener := func(gain: float, vector: Vector3) -> void: heard.append([gain, vector])
	probe.gain_changed.connect(listener)
	probe.gain = 2.5
	checks.equal("property", probe.gain, 2.5)
	checks.that("signal", heard == [[2.5, Vector3(1, 2, 3)]], heard)
	probe.mode = BindingsProbe.MODE_RUN
	checks.equal("enum property", int(probe.mode), 5)
	checks.equal("enum result", int(probe.get_mode()), 5)
	checks.equal("static method", BindingsProbe.alive_count(), 1)


func _check_description(checks: Checks) -> void:
	var constant := ClassDB.class_get_integer_constant("BindingsProbe", "MODE_RUN")
	checks.equal("enum constant", constant, 5)
	var enums := ClassDB.class_get_enum_list("BindingsProbe", true)
	checks.that("enum", enums == PackedStringArray(["Mode"]), enums)
	var methods := {}
	for method: Dictionary in ClassDB.class_get_method_list("BindingsProbe", true):
		methods[method.name] = method
	# Release templates drop the names of arguments, but not their types.
	var arguments: Array = methods["cross"].args
	checks.equal("argument count", arguments.size(), 2)
	checks.equal("argument type", arguments[0].type, TYPE_VECTOR3)
	checks.equal("result type", methods["cross"]["return"].type, TYPE_VECTOR3)
	var held: Dictionary = methods["hold"].args[0]
	checks.equal("argument class", String(held.class_name), "BindingsProbe")
	checks.equal("method is const", methods["add"].flags & METHOD_FLAG_CONST, METHOD_FLAG_CONST)


func _check_errors(checks: Checks, probe: BindingsProbe) -> void:
	print("Errors are expected from here ...")
	checks.equal("failed guard", probe.guarded(true), false)
	checks.equal("passed guard", probe.guarded(false), true)
	checks.equal("too few arguments", probe.callv("add", [1]), null)
	checks.equal("too many arguments", probe.callv("add", [1, 2, 3]), null)
	checks.equal("argument of a wrong type", probe.callv("cross", [1, 2]), null)
	print("... to here")
