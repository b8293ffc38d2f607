class_name HostileLevels
extends RefCounted
## Levels that somebody could send who means harm, each with one kind of attack, and what is to be
## said of it. Their scripts leave a mark in [constant MARKS] when anything of them runs.

## Folder of the marks.
const MARKS: String = "user://hostile_marks"


## Each kind of attack: the bytes of its scene, and a part of what is to be said of it.
static func all() -> Dictionary[String, Array]:
	var found: Dictionary[String, Array] = {}
	_add_scripts(found)
	_add_actions(found)
	_add_paths(found)
	_add_shapes(found)
	_add_numbers(found)
	_add_sizes(found)
	_add_broken(found)
	_add_late(found)
	return found


## Files that the attacks name, so that they would act if anything loaded them.
static func write_bait() -> void:
	DirAccess.make_dir_recursive_absolute(MARKS)
	var script: FileAccess = FileAccess.open("user://evil.gd", FileAccess.WRITE)
	script.store_string(LevelTexts.code("external"))
	script.close()
	var scene: FileAccess = FileAccess.open("user://evil.tscn", FileAccess.WRITE)
	scene.store_string(LevelTexts.built_in("scene"))
	scene.close()


## What has acted: names of the marks that are there.
static func marks() -> PackedStringArray:
	var is_there: bool = DirAccess.dir_exists_absolute(MARKS)
	return DirAccess.get_files_at(MARKS) if is_there else PackedStringArray()


## Takes bait and marks away.
static func clean_up() -> void:
	for mark: String in marks():
		DirAccess.remove_absolute(MARKS.path_join(mark))
	for file: String in ["user://evil.gd", "user://evil.tscn", MARKS]:
		if FileAccess.file_exists(file) or DirAccess.dir_exists_absolute(file):
			DirAccess.remove_absolute(file)


static func _put(
	r_found: Dictionary[String, Array],
	p_name: String,
	p_place: String,
	p_text: String,
	p_why: String
) -> void:
	r_found[p_name] = [LevelTexts.level({p_place: "\n%s\n" % p_text}).to_utf8_buffer(), p_why]


static func _whole(
	r_found: Dictionary[String, Array], p_name: String, p_text: String, p_why: String
) -> void:
	r_found[p_name] = [p_text.to_utf8_buffer(), p_why]


static func _add_scripts(r: Dictionary[String, Array]) -> void:
	_whole(r, "script in the scene", LevelTexts.built_in("built_in"), "it holds a GDScript")
	var file: String = '[ext_resource type="Script" path="%s" id="evil"]'
	var why: String = "none of the level kit's"
	_put(r, "script of the user's folder", "files", file % "user://evil.gd", why)
	_put(r, "script of the program", "files", file % "res://scripts/app/main.gd", why)
	_put(r, "script of the machine", "files", file % "/tmp/evil.gd", why)
	_put(r, "script by way of ..", "files", file % "res://scripts/world/../app/main.gd", why)
	var by_uid: String = '[ext_resource type="Script" uid="uid://evil" path="user://evil.gd" id="e"]'
	_put(r, "script by its uid", "files", by_uid, why)
	_put(r, "script on a node", "ground", 'script = SubResource("stone")', "'script' is set twice")
	_put(
		r,
		"script of another class",
		"end",
		'[node name="N" type="Node3D" parent="."]\nscript = ExtResource("block")',
		"class Node3D with the script res://scripts/world/kit/block.gd"
	)
	_put(
		r,
		"script in a resource",
		"resources",
		'[sub_resource type="Resource" id="r"]\nscript = ExtResource("block")',
		"which the level kit does not know"
	)
	_put(
		r,
		"object as a value",
		"root",
		'metadata/x = Object(GDScript,"script/source":"extends Node")',
		"'Object' is no value"
	)
	_put(
		r,
		"resource as a value",
		"root",
		'metadata/x = Resource("user://evil.gd")',
		"'Resource' is no value"
	)
	_put(r, "callable as a value", "root", "metadata/x = Callable()", "'Callable' is no value")
	_put(r, "signal as a value", "root", "metadata/x = Signal()", "'Signal' is no value")
	_put(r, "expression", "root", "world = 1 + 1", "is no finite number")
	var csharp: String = '[ext_resource type="Script" path="res://Evil.cs" id="cs"]'
	_put(r, "script of another language", "files", csharp, why)
	var extension: String = '[ext_resource type="GDExtension" path="user://e.gdextension" id="e"]'
	_put(r, "native library", "files", extension, why)


static func _add_actions(r: Dictionary[String, Array]) -> void:
	_put(
		r,
		"signal connection",
		"end",
		'[connection signal="ready" from="." to="." method="queue_free"]',
		"it has a [connection]"
	)
	_put(r, "opened instance", "end", '[editable path="Props/Crate"]', "it has a [editable]")
	_put(
		r,
		"method track",
		"resources",
		'[sub_resource type="Animation" id="a"]\ntracks/0/type = "method"',
		"it holds a Animation"
	)
	for type: String in [
		"AnimationPlayer",
		"Timer",
		"HTTPRequest",
		"MultiplayerSpawner",
		"Window",
		"SubViewport",
		"CanvasLayer",
		"VideoStreamPlayer",
		"AudioStreamPlayer",
		"CharacterBody3D",
		"PhysicalBone3D",
		"GPUParticles3D",
		"CSGBox3D",
		"Node",
		"NoSuchClass",
	]:
		var text: String = '[node name="N" type="%s" parent="."]' % type
		_put(r, "node of class " + type, "end", text, "class %s, which" % type)
	_put(
		r,
		"shader without an end",
		"resources",
		'[sub_resource type="Shader" id="sh"]\ncode = "void fragment(){while(true){}}"',
		"it holds a Shader"
	)
	_put(
		r,
		"expression of a shader graph",
		"resources",
		'[sub_resource type="VisualShaderNodeExpression" id="v"]\nexpression = "x"',
		"it holds a VisualShaderNodeExpression"
	)
	_put(r, "always processed", "ground", "process_mode = 3", "'process_mode' of a Block")
	_put(r, "authority", "ground", "multiplayer_authority = 2", "'multiplayer_authority'")
	_put(r, "other metadata", "ground", 'metadata/evil = "x"', "'metadata/evil'")
	_put(
		r,
		"group of the program",
		"end",
		'[node name="B" type="RigidBody3D" parent="Props" groups=["secret"]]',
		"is in the group 'secret'"
	)


static func _add_paths(r: Dictionary[String, Array]) -> void:
	var scene: String = '[ext_resource type="PackedScene" path="%s" id="evil"]'
	var why: String = "none of the level kit's"
	for path: String in [
		"user://evil.tscn",
		"res://scenes/app/main.tscn",
		"user://levels/self/self.tscn",
		"/etc/passwd"
	]:
		_put(r, "instance of " + path, "files", scene % path, why)
	var picture: String = '[ext_resource type="Texture2D" path="%s" id="evil"]'
	_put(r, "picture of the user's folder", "files", picture % "user://evil.png", why)
	_put(r, "picture by way of ..", "files", picture % "res://assets/world/../../x.png", why)
	_put(
		r,
		"other name for a scene",
		"files",
		'[ext_resource type="Texture2D" path="res://scenes/app/main.tscn" id="evil"]',
		why
	)
	var path: String = 'world = NodePath("%s")'
	_put(r, "path of the whole tree", "root", path % "/root", "is no path to a node of the level")
	_put(r, "path out of the level", "root", path % "../..", "is no path to a node of the level")
	_put(r, "path into an instance", "root", path % "Props/Crate/Mesh", "is no path to a node")
	_put(r, "path of a property", "root", path % "Static:script", "is no path to a node")
	_put(r, "path to another class", "root", path % "Static", "has to name a Entity")
	var node: String = '[node name="N" type="Node3D" parent="%s"]'
	_put(r, "parent outside", "end", node % "..", "the parent '..' is missing")
	_put(r, "parent of the whole tree", "end", node % "/root", "the parent '/root' is missing")
	_put(r, "child of an instance", "end", node % "Props/Crate", "an instance of the level kit")
	var script: String = '[node name="C" parent="Props" instance=ExtResource("crate")]\n'
	script += 'script = ExtResource("block")'
	_put(r, "script of an instance", "end", script, "'script' of a res://scenes/world/props/crate")
	var typed: String = '[node name="C" type="Node3D" parent="Props" instance=ExtResource("crate")]'
	_put(r, "instance of another class", "end", typed, "it takes a RigidBody3D for a Node3D")
	var inner: String = '[node name="Mesh" parent="Props/Crate" index="0"]\nvisible = false'
	_put(r, "node of an instance", "end", inner, "changes the node 'Mesh' of an instance")


static func _add_shapes(r: Dictionary[String, Array]) -> void:
	_put(
		r,
		"two nodes of a name",
		"end",
		'[node name="Static" type="Node3D" parent="."]',
		"there are two nodes 'Static'"
	)
	var named: String = '[node name="%s" type="Node3D" parent="."]'
	_put(r, "path as a name", "end", named % "a/b", "a node is called")
	_put(r, "name that garbles the log", "end", named % "a\u202eb", "a node is called")
	_put(r, "endless name", "end", named % "n".repeat(100), "a node is called")
	_put(
		r,
		"another root",
		"end",
		'[node name="N" type="Node3D"]\nscript = ExtResource("level")',
		"nothing else can be one"
	)
	var deep: String = ""
	for depth: int in 40:
		var names: PackedStringArray = []
		for each: int in depth:
			names.append("N%d" % each)
		var parent: String = "/".join(names) if depth > 0 else "."
		deep += '\n[node name="N%d" type="Node3D" parent="%s"]\n' % [depth, parent]
	_put(r, "nodes in nodes in nodes", "end", deep, "more than 16 deep")
	_whole(
		r,
		"root of the kit's scenes",
		LevelTexts.level().replace(
			'[node name="Sound" type="Node3D"', '[node name="Sound" type="Node"'
		),
		"class Node, which"
	)


static func _add_numbers(r: Dictionary[String, Array]) -> void:
	var block: String = '[node name="B" type="StaticBody3D" parent="Static"]\n'
	block += 'script = ExtResource("block")\n'
	var turned: String = block + "transform = Transform3D(%s)"
	var plain: String = "1, 0, 0, 0, 1, 0, 0, 0, 1, "
	for number: String in ["nan", "inf", "-inf", "1e999", "1e99", "0x10", "1_000"]:
		var why: String = "no finite number" if number != "1e99" else "too large"
		_put(r, "number " + number, "end", block + "size = Vector3(%s, 1, 1)" % number, why)
	_put(r, "size that is none", "end", block + "size = Vector3(-1, 0, 1)", "are allowed")
	_put(r, "size without an end", "end", block + "size = Vector3(1e8, 1, 1)", "are allowed")
	_put(r, "flat body", "end", turned % "1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0", "scales by")
	_put(r, "scaled body", "end", turned % "2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0", "is scaled")
	_put(r, "far away", "end", turned % (plain + "9999, 0, 0"), "stands 9999 m away")
	_put(r, "layer of others", "ground", "collision_priority = 1.0", "'collision_priority'")
	var mass: String = '[node name="C2" parent="Props" instance=ExtResource("crate")]\nmass = %s'
	_put(r, "mass that is none", "end", mass % "-1.0", "'mass' is -1")
	_put(r, "mass of another kind", "end", mass % '"x"', "has to be a number")
	_put(
		r,
		"huge picture",
		"resources",
		'[sub_resource type="NoiseTexture2D" id="n"]\nwidth = 16384',
		"'width' is 16384"
	)
	_put(
		r,
		"map without an end",
		"resources",
		'[sub_resource type="HeightMapShape3D" id="h"]\nmap_width = 30000',
		"it holds a HeightMapShape3D"
	)
	_put(
		r,
		"points that are none",
		"resources",
		'[sub_resource type="ConvexPolygonShape3D" id="c"]\npoints = PackedVector3Array(1, 2)',
		"needs numbers by 3"
	)


static func _add_sizes(r: Dictionary[String, Array]) -> void:
	var many: PackedStringArray = []
	for index: int in 300:
		many.append('[node name="L%d" type="OmniLight3D" parent="."]\n' % index)
	_put(r, "too many lamps", "end", "\n".join(many), "more than 256 of OmniLight3D")
	var zeros: PackedStringArray = []
	zeros.resize(SceneValues.MAX_NUMBERS + 1)
	zeros.fill("0")
	var shape: String = '[sub_resource type="ConcavePolygonShape3D" id="c"]\ndata = '
	shape += "PackedVector3Array(%s)" % ",".join(zeros)
	_put(r, "array without an end", "resources", shape, "has more than 300000 numbers")
	var lines: String = "\n".repeat(SceneText.MAX_LINES + 1)
	_put(r, "lines without an end", "end", lines, "has more than 120000 lines")
	_put(r, "too large", "end", ";".repeat(SceneText.MAX_BYTES), "4194304 are the most")
	_put(r, "endless text", "root", 'world = "%s"' % "x".repeat(5000), "more than 400 characters")
	_put(r, "endless number", "root", "world = 1" + "0".repeat(500), "is no finite number")


static func _add_broken(r: Dictionary[String, Array]) -> void:
	r["nothing"] = [PackedByteArray(), "it is no text scene"]
	_whole(r, "no scene", "hello\n", "is no property")
	r["binary scene"] = ["RSRC....".to_ascii_buffer(), "it is a binary scene"]
	r["packed scene"] = ["RSCC....".to_ascii_buffer(), "it is a binary scene"]
	r["zero bytes"] = [
		LevelTexts.level().to_utf8_buffer() + PackedByteArray([0]), "no text in UTF-8"
	]
	r["no UTF-8"] = [
		LevelTexts.level().to_utf8_buffer() + PackedByteArray([0xC0, 0x80]), "no text in UTF-8"
	]
	_whole(r, "cut off", LevelTexts.level().get_slice('type="Node3D" parent', 0), "a tag is broken")
	_whole(
		r, "another version", LevelTexts.level().replace("format=3", "format=4"), "it has format 4"
	)
	_whole(r, "no version", LevelTexts.level().replace(" format=3", ""), "it has format <null>")
	_whole(r, "without a root", "[gd_scene format=3]\n", "it has no node")
	_put(r, "text over lines", "root", 'world = "a\nb"', "goes over several lines")
	_put(r, "dictionary", "root", 'world = {\n"a": 1\n}', "'{' is no value")
	_put(r, "unknown resource", "root", 'spawnable = [SubResource("no")]', "'spawnable' has to be")


## What comes after so much that is sound that to read it all would take long.
static func _add_late(r: Dictionary[String, Array]) -> void:
	var lines: PackedStringArray = []
	for index: int in 2000:
		lines.append('[node name="B%d" type="StaticBody3D" parent="Static"]' % index)
		lines.append('script = ExtResource("block")\nsize = Vector3(1, 2, 0.3)\n')
	var sound: String = "\n".join(lines) + "\n"
	var file: String = '[ext_resource type="Script" path="user://evil.gd" id="evil"]'
	var shader: String = '[sub_resource type="Shader" id="s"]\ncode = "x"'
	var joined: String = '[connection signal="ready" from="." to="." method="queue_free"]'
	_put(r, "late script", "end", sound + file, "none of the level kit's")
	_put(r, "late shader", "end", sound + shader, "it holds a Shader")
	_put(r, "late connection", "end", sound + joined, "it has a [connection]")
	_put(r, "late timer", "end", sound + '[node name="T" type="Timer" parent="."]', "class Timer")
	_put(r, "late object", "end", sound + "metadata/x = Object(Node)", "'Object' is no value")
