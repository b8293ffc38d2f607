@tool
@icon("res://scenes/entity/icons/carry_area.svg")
class_name CarryArea
extends Area3D
## Carries the people who stand in it along with a moving body: a turntable, a lift, a deck.
##
## Only the server carries, and everybody sees it: a person's pose is simulated, sent and shown in
## the frame of the body, so that nobody slides on it. Set the collision mask to the layer of
## people.
##
## With [member holds] people move exactly with the body and cannot slide. Without it only friction
## carries them, and whoever cannot hold on is thrown off: for vehicles.

## A person stands here if the body of this bone does.
const BONE: StringName = &"Hips"
## Ticks between two searches for people who stand here and are not carried, such as somebody who
## has left a seat.
const _PERIOD_TICKS: int = 12

## The entity whose body carries.
@export var entity: Entity:
	set(p_value):
		entity = p_value
		update_configuration_warnings()
## Whether people go exactly with the body.
@export var holds: bool = true


func _ready() -> void:
	if not Engine.is_editor_hint():
		body_entered.connect(_on_body_entered)
		body_exited.connect(_on_body_exited)


func _physics_process(_delta: float) -> void:
	if Engine.is_editor_hint() or Engine.get_physics_frames() % _PERIOD_TICKS != 0:
		return
	if entity != null and entity.is_authority():
		for body: Node3D in get_overlapping_bodies():
			_on_body_entered(body)


func _get_configuration_warnings() -> PackedStringArray:
	if entity == null or entity.get_body() == null:
		return ["It needs the Entity whose body carries: choose one in the inspector."]
	return []


func _on_body_entered(p_body: Node3D) -> void:
	if _is_meant(p_body):
		entity.get_authority().carry(p_body, entity.id, holds)


func _on_body_exited(p_body: Node3D) -> void:
	if _is_meant(p_body):
		entity.get_authority().put_down(p_body, entity.id)


func _is_meant(p_body: Node3D) -> bool:
	var bone: PhysicalBone3D = p_body as PhysicalBone3D
	return bone != null and bone.bone_name == BONE and entity != null and entity.is_authority()
