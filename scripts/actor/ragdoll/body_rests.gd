class_name BodyRests
extends RefCounted
## Where the bodies of a [Ragdoll] are in the rest pose, and how they hang together.


## The bodies of a profile's limbs in the rest pose, in its order, in model space. A designer may
## have moved them.
static func find(
	p_skeleton: Skeleton3D, p_limbs: Array[RagdollLimb], p_bones: Array[PhysicalBone3D]
) -> Array[Transform3D]:
	var figure: RestSkeleton = RestSkeleton.new(p_skeleton)
	var rests: Array[Transform3D] = []
	for i: int in p_bones.size():
		var limb: RagdollLimb = p_limbs[i]
		var middle: Vector3 = (figure.scaled_rest(limb.bone) * p_bones[i].body_offset).origin
		rests.append(Transform3D(Basis(limb.rest_orientation), middle))
	return rests


## The joints between limbs, of which an order names those of [constant Limbs.BONES].
static func joints_of(
	p_limbs: Array[RagdollLimb], p_order: PackedInt32Array, p_rests: Array[Transform3D]
) -> PersonSkeleton:
	var joints: PersonSkeleton = PersonSkeleton.new()
	for slot: int in Limbs.COUNT:
		var limb: RagdollLimb = p_limbs[p_order[slot]]
		var inner: Vector3 = _joint_in(p_rests[p_order[slot]], limb, limb.anchor)
		var outer: Vector3 = Vector3.ZERO
		if slot > 0:
			var parent: int = p_order[Limbs.PARENTS[slot]]
			outer = _joint_in(p_rests[parent], p_limbs[parent], limb.anchor)
		joints.add(outer, inner, limb.reset_orientation)
	return joints


## A joint in a limb's frame: that of the body, with the world's axes in the reset pose.
static func _joint_in(p_rest: Transform3D, p_limb: RagdollLimb, p_joint: Vector3) -> Vector3:
	return p_limb.reset_orientation * (p_rest.affine_inverse() * p_joint)
