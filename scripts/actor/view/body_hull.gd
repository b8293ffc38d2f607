class_name BodyHull
extends RefCounted
## Where a visible person's mesh is, roughly: capsules around the bones. Keeps cameras out of it.

## From bone to bone, and how far the mesh with its kit reaches around the line between, m. A bone
## alone is followed along its own direction for [constant _TIP_M].
const _PARTS: Array[Array] = [
	[&"Hips", &"Neck", 0.34],
	[&"Head", &"", 0.2],
	[&"LeftUpperArm", &"LeftLowerArm", 0.13],
	[&"RightUpperArm", &"RightLowerArm", 0.13],
	[&"LeftLowerArm", &"LeftHand", 0.11],
	[&"RightLowerArm", &"RightHand", 0.11],
	[&"LeftHand", &"", 0.12],
	[&"RightHand", &"", 0.12],
	[&"LeftUpperLeg", &"LeftLowerLeg", 0.2],
	[&"RightUpperLeg", &"RightLowerLeg", 0.2],
	[&"LeftLowerLeg", &"LeftFoot", 0.15],
	[&"RightLowerLeg", &"RightFoot", 0.15],
	[&"LeftFoot", &"LeftToes", 0.14],
	[&"RightFoot", &"RightToes", 0.14],
]
const _TIP_M: float = 0.12

var _skeleton: Skeleton3D = null
# Bones of each part, the second one -1 where there is none; and its radius.
var _from: PackedInt32Array = []
var _to: PackedInt32Array = []
var _radii: PackedFloat32Array = []


## Takes the skeleton that is shown; parts whose bones it lacks are left out.
func _init(p_skeleton: Skeleton3D) -> void:
	_skeleton = p_skeleton
	for part: Array in _PARTS:
		var from: int = p_skeleton.find_bone(part[0])
		var end: StringName = part[1]
		var to: int = p_skeleton.find_bone(end) if end != &"" else -1
		if from >= 0 and (to >= 0 or end == &""):
			_from.append(from)
			_to.append(to)
			_radii.append(part[2])


## Adds the capsules as they are now: two ends in the world for each, m, and its radius, m.
func append_to(r_ends: PackedVector3Array, r_radii: PackedFloat32Array) -> void:
	var world: Transform3D = _skeleton.global_transform
	for part: int in _from.size():
		var begin: Transform3D = world * _skeleton.get_bone_global_pose(_from[part])
		var end: Vector3 = begin.origin + begin.basis.y.normalized() * _TIP_M
		if _to[part] >= 0:
			end = world * _skeleton.get_bone_global_pose(_to[part]).origin
		r_ends.append(begin.origin)
		r_ends.append(end)
		r_radii.append(_radii[part])
