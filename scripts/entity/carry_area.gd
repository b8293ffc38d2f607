@tool
@icon("res://scenes/entity/icons/carry_area.svg")
class_name CarryArea
extends Area3D
## Carries the people who stand in it along with a moving body: a turntable, a lift, a deck.
##
## Only the server carries, and everybody sees it: a person's pose is simulated, sent and shown in
## the frame of the body, so that nobody slides on it. Set the collision mask to the layer of
## people.

## The bone whose body counts as standing here.
const BONE: StringName = &"Hips"

## The entity whose body carries.
@export var entity: Entity:
	set(p_value):
		entity = p_value
		update_configuration_warnings()


func _ready() -> void:
	if not Engine.is_editor_hint():
		body_entered.connect(_on_body_entered)
		body_exited.connect(_on_body_exited)


func _get_configuration_warnings() -> PackedStringArray:
	if entity == null or entity.get_body() == null:
		return ["It needs the Entity whose body carries: choose one in the inspector."]
	return []


func _on_body_entered(p_body: Node3D) -> void:
	if _is_meant(p_body):
		entity.get_host().carry(p_body, entity.id)


func _on_body_exited(p_body: Node3D) -> void:
	if _is_meant(p_body):
		entity.get_host().put_down(p_body, entity.id)


func _is_meant(p_body: Node3D) -> bool:
	var bone: PhysicalBone3D = p_body as PhysicalBone3D
	return bone != null and bone.bone_name == BONE and entity != null and entity.is_authority()
