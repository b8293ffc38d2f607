@tool
@icon("res://scenes/world/icons/observer_camera.svg")
class_name ObserverCamera
extends Camera3D
## A view of a level that observers can go to by a key: an overview, a doorway, a stage.
##
## It looks along its -Z; [i]Preview[/i] in the editor shows what it sees. It never takes over the
## screen by itself: the client's own camera takes its position.

## Group of all of them.
const GROUP: StringName = &"observer_cameras"

## What people call it; empty: the name of the node.
@export var title: String = ""


func _init() -> void:
	add_to_group(GROUP)


func _notification(p_what: int) -> void:
	# Before it enters the tree, where a current camera takes over.
	if p_what == NOTIFICATION_PARENTED and not Engine.is_editor_hint():
		current = false


func _get_configuration_warnings() -> PackedStringArray:
	if current:
		return ["Switch 'Current' off: observers go to it by a key."]
	return []


## What people call it.
func get_title() -> String:
	return title if title != "" else String(name).capitalize()
