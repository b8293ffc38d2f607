extends CheckSuite
## Values through bound methods, properties, signals and constants.


func run() -> void:
	_scalars_and_strings()
	_every_type()
	_containers()
	_properties()
	_class_information()
	_errors()


func _scalars_and_strings() -> void:
	var probe := ValueProbe.new()
	var untyped: Variant = probe
	equal("typed call", probe.add(2, 40), 42)
	equal("dynamic call", untyped.add(2, 40), 42)
	equal("large integers", probe.add(1 << 62, -1), (1 << 62) - 1)
	equal("narrow integers", probe.add_small(-5, 3), -2)
	equal("default of a typed call", probe.add_small(-5), 2)
	equal("default of a dynamic call", untyped.scale(2.0), 6.0)
	equal("integer as a real", untyped.scale(2, 4), 8.0)
	equal("bool", [probe.flip(true), probe.flip(false)], [false, true])
	equal("string", probe.greet("Wörld ✓"), "Hello, Wörld ✓!")
	equal("string name", untyped.echo_name("abc"), &"abc")
	equal(
		"callable from a script",
		probe.call_back(func(a: int, b: String) -> String: return b + str(a)),
		"a3"
	)
	equal("own callable", probe.own_callable().call(), 1.0)
	equal("vformat", probe.formatted("Probe", 3), "Probe has 3")
	equal("static call", ValueProbe.get_alive(), 1)


func _every_type() -> void:
	var probe := ValueProbe.new()
	var values: Array = [
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
		Transform2D(1.0, Vector2(1, 2)),
		Vector4(1, 2, 3, 4),
		Vector4i(1, 2, 3, 4),
		Plane(1, 2, 3, 4),
		Quaternion(1, 2, 3, 4),
		AABB(Vector3.ONE, Vector3.ONE),
		Basis.from_euler(Vector3.ONE),
		Transform3D(Basis(), Vector3.ONE),
		Projection.create_perspective(70.0, 1.0, 0.1, 10.0),
		Color.RED,
		RID(),
		self,
		Callable(self, "run"),
		checked,
		{1: 2},
		[1, "a"],
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
	for value in values:
		equal("echo of %s" % type_string(typeof(value)), probe.echo(value), value)
	equal("echo of every type", values.size(), TYPE_MAX)


func _containers() -> void:
	var probe := ValueProbe.new()
	equal("bytes", probe.invert(PackedByteArray([0, 1, 255])), PackedByteArray([255, 254, 0]))
	equal("no bytes", probe.invert(PackedByteArray()), PackedByteArray())
	equal("reals", probe.prefix_sum(PackedFloat32Array([1, 2, 3])), PackedFloat32Array([1, 3, 6]))
	var points := PackedVector3Array([Vector3(1, 2, 3), Vector3(8, 10, 12), Vector3(9, 12, 15)])
	equal("packed literals", probe.literals(), points)
	equal("array", probe.reversed([1, "a", Vector3.ONE, {"k": 1}]), [{"k": 1}, Vector3.ONE, "a", 1])
	equal(
		"dictionary",
		probe.describe({"x": 4, "y": "b"}),
		{"count": 2, "has_x": true, "x2": 8.0, "keys": ["x", "y"]}
	)
	var vectors: Array[Vector3] = [Vector3.ONE, Vector3.UP]
	var doubled := probe.doubled(vectors)
	equal("typed array", doubled, [Vector3(2, 2, 2), Vector3(0, 2, 0)] as Array[Vector3])
	equal("type of a typed array", doubled.get_typed_builtin(), TYPE_VECTOR3)
	var resources := probe.resources(3)
	equal("class of a typed array", resources.get_typed_class_name(), &"Resource")
	equal("objects in a typed array", resources[2].resource_name, "2")


func _properties() -> void:
	var probe := ValueProbe.new()
	var received := []
	probe.gain_changed.connect(
		func(gain: float, extra: Vector3) -> void: received.append([gain, extra])
	)
	probe.gain = 2.5
	equal("property", probe.gain, 2.5)
	equal("signal", received, [[2.5, Vector3(1, 2, 3)]])
	probe.mode = ValueProbe.MODE_RUN
	equal("enum property", probe.get_mode(), ValueProbe.MODE_RUN)
	equal("enum constant", ValueProbe.MODE_RUN as int, 5)
	probe.flags = ValueProbe.FLAG_A | ValueProbe.FLAG_B
	equal("flags", probe.get_flags() as int, 5)
	probe.set("gain", 4)
	equal("property by name", probe.get("gain"), 4.0)


func _class_information() -> void:
	var methods := {}
	for method in ClassDB.class_get_method_list(&"ValueProbe", true):
		methods[method.name] = method
	# Release templates keep no names of arguments.
	var arguments: Array = methods.add.args
	equal("types of arguments", [arguments[0].type, arguments[1].type], [TYPE_INT, TYPE_INT])
	var mode: Dictionary = methods.get_mode["return"]
	equal("enum in a signature", mode.class_name, &"ValueProbe.Mode")
	check("enum usage", mode.usage & PROPERTY_USAGE_CLASS_IS_ENUM != 0, mode.usage)
	var constants := ClassDB.class_get_enum_constants(&"ValueProbe", &"Mode")
	equal("constants of an enum", constants, PackedStringArray(["MODE_IDLE", "MODE_RUN"]))
	check("const method", methods.add.flags & METHOD_FLAG_CONST != 0)
	check("static method", methods.get_alive.flags & METHOD_FLAG_STATIC != 0)
	for property in ClassDB.class_get_property_list(&"ValueProbe", true):
		if property.name == "gain":
			equal("hint of a property", property.hint_string, "0,10,0.1,suffix:1/s")


func _errors() -> void:
	print("The errors from here to the next 'ok' lines are part of the test.")
	var probe: Variant = ValueProbe.new()
	equal("too few arguments", _call_wrongly(probe, &"add", [1]), null)
	equal("too many arguments", _call_wrongly(probe, &"add", [1, 2, 3]), null)
	equal("ERR_FAIL_INDEX_V_MSG", probe.guarded(3, self), -1)
	equal("ERR_FAIL_NULL_V_MSG", probe.guarded(0, null), -2)
	equal("ERR_FAIL_COND_V_MSG", probe.guarded(2, self), -3)
	equal("ERR_FAIL_COND_V", probe.guarded(1, self), -4)
	equal("no error", probe.guarded(0, self), 0)


## In a function of its own, because a wrong call ends the function.
func _call_wrongly(probe: Object, method: StringName, arguments: Array) -> Variant:
	return Callable(probe, method).callv(arguments)
