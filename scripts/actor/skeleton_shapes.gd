@tool
class_name SkeletonShapes
extends RefCounted
## Makes a [RagdollProfile] for any skeleton with humanoid bone names, from its bones' lengths.
##
## Thicknesses are those of an adult of average build, in shares of the body's height; lengths come
## from the skeleton's rest pose, so that joints are exactly where the skeleton has them.

## Half thickness of each limb across, as a share of the body's height. For boxes across and deep.
const _THICKNESS: Array[Vector2] = [
	Vector2(0.085, 0.055),
	Vector2(0.08, 0.05),
	Vector2(0.085, 0.062),
	Vector2(0.051, 0.051),
	Vector2(0.026, 0.026),
	Vector2(0.022, 0.022),
	Vector2(0.022, 0.012),
	Vector2(0.026, 0.026),
	Vector2(0.022, 0.022),
	Vector2(0.022, 0.012),
	Vector2(0.04, 0.04),
	Vector2(0.028, 0.028),
	Vector2(0.026, 0.02),
	Vector2(0.04, 0.04),
	Vector2(0.028, 0.028),
	Vector2(0.026, 0.02),
]
## Limbs that are boxes: trunk, hands, feet.
const _BOXES: Array[int] = [0, 1, 2, 6, 9, 12, 15]
## Height of the hips' box as a share of the body's height.
const _HIPS_HEIGHT: float = 0.1
## Shortest limb, m: where a skeleton does not tell.
const _SHORTEST: float = 0.06


## The profile of a skeleton, or null (and an error) where a limb's bone is missing.
static func describe(p_skeleton: Skeleton3D) -> RagdollProfile:
	var profile: RagdollProfile = RagdollProfile.new()
	var limbs: Array[RagdollLimb] = []
	var height: float = _height(p_skeleton)
	for limb: int in Limbs.COUNT:
		var bone: int = p_skeleton.find_bone(Limbs.BONES[limb])
		if bone < 0:
			push_error("The skeleton has no bone %s." % Limbs.BONES[limb])
			return null
		limbs.append(_shape(p_skeleton, limb, height))
	profile.limbs = limbs
	complete(profile, p_skeleton)
	return profile


## Fills in what follows from limb shapes and a skeleton: axes, reset pose, torques, groups, points
## of contact and ranges of the joints. Limbs that the skeleton lacks are left alone.
static func complete(p_profile: RagdollProfile, p_skeleton: Skeleton3D) -> void:
	for limb: RagdollLimb in p_profile.limbs:
		var at: int = Limbs.find(limb.bone)
		var bone: int = p_skeleton.find_bone(limb.bone)
		if at < 0 or bone < 0:
			continue
		var rest: Transform3D = p_skeleton.get_bone_global_rest(bone).orthonormalized()
		var along: Vector3 = _tail(p_skeleton, at) - rest.origin
		limb.rest_orientation = rest.basis.get_rotation_quaternion()
		limb.reset_orientation = Limbs.rest_to_reset(at, along) * limb.rest_orientation
		limb.max_torque = Limbs.TORQUES[at]
		limb.group = Limbs.GROUPS[at]
		limb.min_angles = JointRanges.least(limb.bone)
		limb.max_angles = JointRanges.greatest(limb.bone)
		ContactPoints.add(limb)


static func _shape(p_skeleton: Skeleton3D, p_limb: int, p_height: float) -> RagdollLimb:
	var bone: int = p_skeleton.find_bone(Limbs.BONES[p_limb])
	var rest: Transform3D = p_skeleton.get_bone_global_rest(bone).orthonormalized()
	var along: Vector3 = _tail(p_skeleton, p_limb) - rest.origin
	if along.length() < _SHORTEST:
		along = rest.basis.y * _SHORTEST
	var middle: Vector3 = rest.origin + along / 2.0
	if p_limb == Limbs.ROOT:
		# The hips lie around their joint, however near the skeleton has the next one.
		along = along.normalized() * p_height * _HIPS_HEIGHT
		middle = rest.origin
	var shape: RagdollLimb = RagdollLimb.new()
	shape.bone = Limbs.BONES[p_limb]
	shape.parent_bone = &"" if p_limb == 0 else Limbs.BONES[Limbs.PARENTS[p_limb]]
	shape.anchor = rest.origin
	shape.position = middle
	shape.mass_fraction = Limbs.MASS_FRACTIONS[p_limb]
	# The shape's Y axis lies along the limb, its Z axis stays as the bone's.
	var swing: Quaternion = Quaternion(rest.basis.y, along.normalized())
	shape.orientation = swing * rest.basis.get_rotation_quaternion()
	var thick: Vector2 = _THICKNESS[p_limb] * p_height
	if _BOXES.has(p_limb):
		shape.type = RagdollLimb.BOX
		shape.size = Vector3(thick.x * 2.0, along.length(), thick.y * 2.0)
	else:
		shape.radius = minf(thick.x, along.length() * 0.49)
		shape.length = maxf(along.length() - 2.0 * shape.radius, 0.0)
	return shape


static func _tail(p_skeleton: Skeleton3D, p_limb: int) -> Vector3:
	for tail: StringName in Limbs.TAILS[p_limb]:
		var bone: int = p_skeleton.find_bone(tail)
		if bone >= 0:
			return p_skeleton.get_bone_global_rest(bone).origin
	return p_skeleton.get_bone_global_rest(p_skeleton.find_bone(Limbs.BONES[p_limb])).origin


static func _height(p_skeleton: Skeleton3D) -> float:
	var lowest: float = INF
	var highest: float = -INF
	for bone: int in p_skeleton.get_bone_count():
		var y: float = p_skeleton.get_bone_global_rest(bone).origin.y
		lowest = minf(lowest, y)
		highest = maxf(highest, y)
	return clampf(highest - lowest, 0.5, 3.0)
