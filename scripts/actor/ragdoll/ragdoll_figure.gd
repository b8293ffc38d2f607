@tool
class_name RagdollFigure
extends Node3D
## What of a [Ragdoll] has a size: its character with the skeleton, the profile of its body, and how
## strongly it is held. What measures or scales a body needs no more of it.

## What the body is made of.
@export var profile: RagdollProfile:
	set(value):
		profile = value
		update_configuration_warnings()
## Greatest force that pulls the hips along. 0 leaves them to gravity.
@export_range(0.0, 10000.0, 10.0, "suffix:N") var root_force: float = 2000.0
## Greatest torque that keeps the hips upright. Below about 100 the person falls over.
@export_range(0.0, 5000.0, 10.0, "suffix:Nm") var root_torque: float = 800.0


## The skeleton below this node, or null.
func get_skeleton() -> Skeleton3D:
	var found: Array[Node] = find_children("*", "Skeleton3D", true, false)
	return found[0] if not found.is_empty() else null


## The simulator that holds the physical bones, or null.
func get_simulator() -> PhysicalBoneSimulator3D:
	var skeleton: Skeleton3D = get_skeleton()
	if skeleton == null:
		return null
	# Not find_children(): every skeleton has an internal one of the engine's, which is of no use.
	for child: Node in skeleton.get_children():
		if child is PhysicalBoneSimulator3D:
			return child
	return null


## Height of the hips above the feet in the rest pose, m: scales the travel of taller wearers.
func get_hip_height() -> float:
	return profile.limbs[0].anchor.y


## Index of the body of each of [constant Limbs.BONES] in [method get_bodies]; -1 where the profile
## has no such limb.
func get_limb_order() -> PackedInt32Array:
	var order: PackedInt32Array = []
	for bone: StringName in Limbs.BONES:
		order.append(profile.find_index(bone))
	return order
