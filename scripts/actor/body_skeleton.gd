class_name BodySkeleton
extends RefCounted
## How the bodies of a person hang together: what forward kinematics needs.
##
## A limb's frame is that of its body: the origin is the middle of its shape, the axes are its
## bone's. One entry for each limb of the profile, parents first.

## Place of each limb's parent, -1 for the first.
var parents: PackedInt32Array = PackedInt32Array()
## The joint to the parent in the parent's frame, m. The first limb has none.
var joints_in_parent: PackedVector3Array = PackedVector3Array()
## The same joint in the limb's own frame, m. That of the first limb is where the motion puts it.
var joints_in_limb: PackedVector3Array = PackedVector3Array()
## Orientation of each limb in the reset pose (thesis 6.2: the i of q = r i).
var reset_orientations: Array[Quaternion] = []
## Place of each limb in a [PoseSample].
var slots: PackedInt32Array = PackedInt32Array()


## The skeleton of a profile. [param p_bodies] are the bodies in the rest pose, in model space,
## where they are not where the profile has its shapes.
static func from_profile(
	p_profile: RagdollProfile, p_bodies: Array[Transform3D] = []
) -> BodySkeleton:
	var result: BodySkeleton = BodySkeleton.new()
	var bodies: Array[Transform3D] = p_bodies
	if bodies.is_empty():
		for limb: RagdollLimb in p_profile.limbs:
			bodies.append(RagdollFigure.body_of(limb))
	var places: Dictionary[StringName, int] = {}
	for i: int in p_profile.limbs.size():
		var limb: RagdollLimb = p_profile.limbs[i]
		var parent: int = places.get(limb.parent_bone, -1)
		var outer: Transform3D = bodies[parent] if parent >= 0 else Transform3D.IDENTITY
		places[limb.bone] = i
		result.parents.append(parent)
		result.joints_in_parent.append(outer.affine_inverse() * limb.anchor)
		result.joints_in_limb.append(bodies[i].affine_inverse() * limb.anchor)
		result.reset_orientations.append(limb.reset_orientation)
		result.slots.append(Limbs.find(limb.bone))
	return result


## Number of limbs.
func count() -> int:
	return parents.size()


## Orientations of the bodies that a sample asks for, four floats (x, y, z, w) a limb.
func orientations_of(p_sample: PoseSample) -> PackedFloat32Array:
	var result: PackedFloat32Array = PackedFloat32Array()
	result.resize(count() * 4)
	for i: int in count():
		var turn: Quaternion = p_sample.orientation(slots[i]) * reset_orientations[i]
		result[i * 4] = turn.x
		result[i * 4 + 1] = turn.y
		result[i * 4 + 2] = turn.z
		result[i * 4 + 3] = turn.w
	return result


## Where the body of the first limb is when the hips are at a place, m.
func root_of(p_sample: PoseSample, p_hips: Vector3) -> Vector3:
	return p_hips - p_sample.orientation(slots[0]) * reset_orientations[0] * joints_in_limb[0]
