class_name BvhSkeleton
extends RefCounted
## Makes a [Skeleton3D] with humanoid bone names and the lengths of a clip's own skeleton.
##
## Each limb's bone lies along the limb with its Y axis, as Godot's humanoid bones do; a bone more
## marks where hands, feet and head end. The rest pose is that of the file.


## The skeleton of a rig; the hips are where the file's rest pose has them, the soles at height 0.
static func make(p_rig: BvhRig) -> Skeleton3D:
	var skeleton: Skeleton3D = Skeleton3D.new()
	var lift: Vector3 = Vector3(0.0, -p_rig.rest_floor(), 0.0)
	var rests: Array[Transform3D] = []
	for limb: int in Limbs.COUNT:
		var base: Vector3 = p_rig.rest_base(limb)
		var along: Vector3 = p_rig.rest_tail(limb) - base
		rests.append(Transform3D(_along(along), base + lift))
		var bone: int = skeleton.add_bone(Limbs.BONES[limb])
		var parent: int = Limbs.PARENTS[limb]
		_set_rest(skeleton, bone, parent, rests)
	for limb: int in Limbs.COUNT:
		if skeleton.find_bone(Limbs.TAILS[limb][0]) < 0:
			var tail: int = skeleton.add_bone(Limbs.TAILS[limb][0])
			rests.append(Transform3D(rests[limb].basis, p_rig.rest_tail(limb) + lift))
			_set_rest(skeleton, tail, limb, rests)
	skeleton.reset_bone_poses()
	return skeleton


static func _set_rest(
	p_skeleton: Skeleton3D, p_bone: int, p_parent: int, p_rests: Array[Transform3D]
) -> void:
	p_skeleton.set_bone_parent(p_bone, p_parent)
	var rest: Transform3D = p_rests[p_bone]
	if p_parent >= 0:
		rest = p_rests[p_parent].affine_inverse() * rest
	p_skeleton.set_bone_rest(p_bone, rest)


static func _along(p_direction: Vector3) -> Basis:
	var y: Vector3 = p_direction.normalized() if p_direction.length() > 1e-4 else Vector3.UP
	var front: Vector3 = Vector3.BACK if absf(y.z) < 0.9 else Vector3.UP
	var x: Vector3 = y.cross(front).normalized()
	return Basis(x, y, x.cross(y))
