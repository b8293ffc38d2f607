class_name LevelTexts
extends RefCounted
## Texts of levels: a sound one with places for attacks, and one with a script that leaves marks
## when anything of it runs, see [HostileLevels].

## A level that is sound: attacks are put into it.
const SOUND: String = """[gd_scene load_steps=4 format=3 uid="uid://b1"]

[ext_resource type="Script" uid="uid://b2" path="res://scripts/world/level.gd" id="level"]
[ext_resource type="Script" path="res://scripts/world/kit/block.gd" id="block"]
[ext_resource type="Script" path="res://scripts/world/spawn_point.gd" id="spawn"]
[ext_resource type="PackedScene" path="res://scenes/world/props/crate.tscn" id="crate"]
@files@
[sub_resource type="StandardMaterial3D" id="stone"]
albedo_color = Color(0.5, 0.4, 0.3, 1)
@resources@
[node name="Sound" type="Node3D" node_paths=PackedStringArray("static_root", "props_root")]
script = ExtResource("level")
title = "Sound"
static_root = NodePath("Static")
props_root = NodePath("Props")
@root@
[node name="Static" type="Node3D" parent="." unique_id=12345]

[node name="Ground" type="StaticBody3D" parent="Static"]
transform = Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -0.25, 0)
collision_layer = 1
collision_mask = 0
script = ExtResource("block")
size = Vector3(40, 0.5, 40)
material = SubResource("stone")
metadata/_edit_lock_ = true
@ground@
[node name="Props" type="Node3D" parent="."]

[node name="Crate" parent="Props" instance=ExtResource("crate")]
transform = Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0.25, 0)
@crate@
[node name="Spawns" type="Node3D" parent="."]

[node name="Spawn1" type="Marker3D" parent="Spawns"]
script = ExtResource("spawn")
@end@
"""
const _CODE: String = """@tool
extends Node3D
static var x: int = _s()
static func _s() -> int:
	FileAccess.open("user://hostile_marks/%s_static", FileAccess.WRITE)
	return 1
static func _static_init() -> void:
	FileAccess.open("user://hostile_marks/%s_static_init", FileAccess.WRITE)
func _init() -> void:
	FileAccess.open("user://hostile_marks/%s_init", FileAccess.WRITE)
func _ready() -> void:
	FileAccess.open("user://hostile_marks/%s_ready", FileAccess.WRITE)
"""


## The text of a sound level with texts put at places, by the place's name.
static func level(p_parts: Dictionary[String, String] = {}) -> String:
	var text: String = SOUND
	for place: String in ["files", "resources", "root", "ground", "crate", "end"]:
		text = text.replace("@%s@" % place, p_parts.get(place, ""))
	return text


## A script that leaves marks named after it.
static func code(p_name: String) -> String:
	return _CODE.replace("%s", p_name)


## A scene with a script in it.
static func built_in(p_name: String) -> String:
	var source: String = code(p_name).replace("\\", "\\\\").replace('"', '\\"')
	var text: String = '[gd_scene load_steps=2 format=3]\n\n[sub_resource type="GDScript" id="s"]\n'
	text += 'script/source = "%s"\n\n' % source
	return text + '[node name="Root" type="Node3D"]\nscript = SubResource("s")\n'
