class_name WorldViews
extends Node
## The three worlds of the thesis (section 4.2), which may be shown together or alone: the mesh
## world (people and props), the static world (what never moves) and the physics world (the server's
## bodies as wire frames). Keys 1, 2 and 3 switch them.

## A world was switched on or off.
signal changed

## Names of the worlds, in the order of their keys.
const NAMES: Array[StringName] = [&"mesh", &"static", &"physics"]

## Holds people.
@export var people: Node3D
## Holds props.
@export var props: Node3D
## Holds what never moves.
@export var static_world: Node3D
## Draws wire frames.
@export var physics_world: Node3D

var _shown: Dictionary[StringName, bool] = {&"mesh": true, &"static": true, &"physics": true}


func _unhandled_key_input(p_event: InputEvent) -> void:
	for world: StringName in NAMES:
		if p_event.is_action_pressed(&"view_" + world):
			toggle(world)
			get_viewport().set_input_as_handled()


## Whether a world is shown.
func is_shown(p_name: StringName) -> bool:
	return _shown[p_name]


## Shows or hides a world.
func set_shown(p_name: StringName, p_shown: bool) -> void:
	_shown[p_name] = p_shown
	refresh()
	changed.emit()


## Applies the visibility to the nodes: another level has other ones.
func refresh() -> void:
	for each: StringName in NAMES:
		for root: Node3D in _roots(each):
			if root != null:
				root.visible = _shown[each]


## Switches a world.
func toggle(p_name: StringName) -> void:
	set_shown(p_name, not is_shown(p_name))


## Shows exactly the worlds of a list such as "mesh,physics".
func show_only(p_list: String) -> void:
	var wanted: PackedStringArray = p_list.split(",", false)
	for each: StringName in NAMES:
		set_shown(each, wanted.has(each))


func _roots(p_name: StringName) -> Array[Node3D]:
	match p_name:
		&"mesh":
			return [people, props]
		&"static":
			return [static_world]
	return [physics_world]
