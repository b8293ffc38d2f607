extends TestCase
## The grammar of text scenes: which values there are, what stands where, and which bytes are text.


func test_values_are_what_they_say() -> void:
	var values: SceneValues = SceneValues.new()
	var sound: Dictionary[String, Variant] = {
		"1": 1,
		"-2.5": -2.5,
		".5": 0.5,
		"1e-05": 0.00001,
		"true": true,
		"null": null,
		'"a \\"b\\" ä"': 'a "b" ä',
		'&"name"': &"name",
		"Vector3(1, -2, 0.5)": Vector3(1.0, -2.0, 0.5),
		"Color(1, 0, 0, 0.5)": Color(1.0, 0.0, 0.0, 0.5),
		'NodePath("A/B")': ^"A/B",
		"PackedFloat32Array()": PackedFloat32Array(),
		"PackedVector3Array(1, 2, 3)": PackedVector3Array([Vector3(1.0, 2.0, 3.0)]),
		'PackedStringArray("a", "b")': PackedStringArray(["a", "b"]),
		'["props"]': PackedStringArray(["props"]),
	}
	for text: String in sound:
		equal(values.read(text), sound[text], text)
		equal(values.fault, "", text)
	var sub: SceneReference = values.read('SubResource("a_1")')
	equal([sub.kind, sub.id], [SceneReference.Kind.SUB, "a_1"])
	var list: SceneReference = values.read(
		'Array[PackedScene]([ExtResource("1"), ExtResource("2")])'
	)
	equal([list.items.size(), list.items[1].id], [2, "2"])
	var turned: Transform3D = values.read("Transform3D(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12)")
	equal([turned.basis.x, turned.origin], [Vector3(1.0, 4.0, 7.0), Vector3(10.0, 11.0, 12.0)])


func test_what_is_no_value_is_refused() -> void:
	var values: SceneValues = SceneValues.new()
	for text: String in [
		"",
		"1.2.3",
		"--1",
		"1e",
		"0x1F",
		"Vector3(1, 2)",
		"Vector3(1, 2, 3, 4)",
		"Vector3(1, 2, x)",
		"Vector3(1,, 2)",
		'"open',
		'"a" + "b"',
		'"\\u202e"',
		"{}",
		'{"a": 1}',
		"[1, 2]",
		"Object(Node)",
		'Resource("res://x.gd")',
		'SubResource("../x")',
		"Array[Node]([NodePath()])",
		"PackedByteArray(1, 2)",
		"RID()",
		"os.exit()",
	]:
		is_null(values.read(text), text)
		is_true(values.fault != "", text)


func test_sections_have_attributes_properties_and_lines() -> void:
	var text: String = "[gd_scene format=3]\n; a note\n\n"
	text += '[node name="A" type="Node3D"]\nvisible = false\n'
	var scene: SceneText = SceneText.new()
	is_true(scene.read(text.to_utf8_buffer()), scene.fault)
	equal(scene.sections.size(), 2)
	var node: SceneSection = scene.sections[1]
	equal([node.tag, node.line, node.text("name"), node.text("none")], ["node", 4, "A", ""])
	equal(
		[node.names, node.lines, node.value_of("visible")],
		[PackedStringArray(["visible"]), PackedInt32Array([5]), false]
	)


func test_bytes_are_text_or_not() -> void:
	for text: String in ["", "plain", "Übung – 試験 😀", "x".repeat(1001) + "é"]:
		is_true(SceneText.is_utf8(text.to_utf8_buffer()), text.left(20))
	for bytes: PackedByteArray in [
		PackedByteArray([0xC0, 0x80]),
		PackedByteArray([0xE0, 0x80, 0x80]),
		PackedByteArray([0xED, 0xA0, 0x80]),
		PackedByteArray([0xF4, 0x90, 0x80, 0x80]),
		PackedByteArray([0xFF]),
		PackedByteArray([0x41, 0xC3]),
		PackedByteArray([0x80]),
	]:
		is_false(SceneText.is_utf8(bytes), bytes.hex_encode())
