@tool
@icon("res://scenes/entity/icons/interactable.svg")
class_name Interactable
extends Marker3D
## Something in a level that a person can use: a button, a lever, a seat.
##
## Whoever looks at it from within [member reach] reads [method get_prompt]; the key for using sends
## the command to the entity, and [signal used] to whatever listens.

## This machine's user has used it.
signal used

## Group of everything that can be used.
const GROUP: StringName = &"interactables"

## The entity that gets the command.
@export var entity: Entity:
	set(p_value):
		entity = p_value
		update_configuration_warnings()
## Name of the command, one of the entity's type, without values.
@export var command: StringName = &"":
	set(p_value):
		command = p_value
		update_configuration_warnings()
## What the key does, for people: "open the door".
@export var prompt: String = ""
## From how far away it can be used.
@export_range(0.5, 50.0, 0.1, "suffix:m") var reach: float = 8.0


func _enter_tree() -> void:
	add_to_group(GROUP)


func _get_configuration_warnings() -> PackedStringArray:
	if entity == null and not used.get_connections().is_empty():
		return []
	if entity == null or entity.type == null:
		return ["It needs the Entity that gets the command: choose one in the inspector."]
	if entity.type.find_command(command) < 0:
		return ["The type '%s' has no command '%s'." % [entity.type.name, command]]
	return []


## What the key does now, for people; empty while it does nothing.
func get_prompt() -> String:
	return prompt


## Uses it, in the name of this client's session.
func interact() -> void:
	if entity != null:
		entity.send_command(command)
	used.emit()


## Whether it can be used: its entity, if it has one, is part of a session.
func is_live() -> bool:
	return entity == null or entity.is_started()


## The interactable that somebody uses who looks from a position (m) in a direction: of all within
## reach and in front, the one nearest to that ray; null if there is none.
static func find(p_tree: SceneTree, p_from: Vector3, p_direction: Vector3) -> Interactable:
	var best: Interactable = null
	var best_angle: float = deg_to_rad(25.0)
	for node: Node in p_tree.get_nodes_in_group(GROUP):
		var each: Interactable = node as Interactable
		var offset: Vector3 = each.global_position - p_from
		if not each.is_live() or offset.length() > each.reach or each.get_prompt() == "":
			continue
		var angle: float = offset.angle_to(p_direction)
		if angle < best_angle:
			best = each
			best_angle = angle
	return best
