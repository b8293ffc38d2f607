class_name PersonSkeleton
extends RefCounted
## How the limbs of one person hang together, for forward kinematics (thesis section 6.3).
##
## One entry for each of [constant Limbs.BONES]. A limb's frame has its origin in the middle of the
## limb's body and the world's axes in the reset pose: its orientation is the rotation from the
## reset pose, as in a [PoseSample].

## Joints further than this from the middle of a limb are no person's, m.
const MAX_M: float = 10.0

## Index of each limb's parent, -1 for the root.
var parents: PackedInt32Array = PackedInt32Array(Limbs.PARENTS)
## The joint that holds each limb, in its parent's frame, m. Not used for the root.
var joints_in_parent: PackedVector3Array = PackedVector3Array()
## The same joint in the limb's own frame, m. That of the root is where the motion puts it.
var joints_in_limb: PackedVector3Array = PackedVector3Array()
## Orientation of each limb's body in the reset pose (thesis 6.2: the i of q = r i).
var reset_orientations: Array[Quaternion] = []


## Adds a limb behind those that are there.
func add(p_joint_in_parent: Vector3, p_joint_in_limb: Vector3, p_reset: Quaternion) -> void:
	joints_in_parent.append(p_joint_in_parent)
	joints_in_limb.append(p_joint_in_limb)
	reset_orientations.append(p_reset)


## Whether this can be a person's.
func is_sound() -> bool:
	if joints_in_limb.size() != Limbs.COUNT:
		return false
	for limb: int in Limbs.COUNT:
		var outer: float = joints_in_parent[limb].length()
		var inner: float = joints_in_limb[limb].length()
		var norm: float = reset_orientations[limb].length()
		# A comparison that NaN fails, too.
		if not (outer < MAX_M and inner < MAX_M and norm > 0.99 and norm < 1.01):
			return false
	return true


## The transform of a limb's body, from the frame's position, m, and its turn from the reset pose.
func body_at(p_limb: int, p_position: Vector3, p_turn: Quaternion) -> Transform3D:
	return Transform3D(Basis(p_turn * reset_orientations[p_limb]), p_position)


## Number of limbs.
func count() -> int:
	return joints_in_limb.size()


## Position of the root's frame when the hips of a sample are at [param p_hips], m.
func root_of(p_sample: PoseSample, p_hips: Vector3) -> Vector3:
	return p_hips - p_sample.orientation(Limbs.ROOT) * joints_in_limb[Limbs.ROOT]
