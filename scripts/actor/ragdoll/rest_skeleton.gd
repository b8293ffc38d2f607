@tool
class_name RestSkeleton
extends RefCounted
## A skeleton's rest pose in the model space of its ragdoll: upright, facing +Z, metres.
##
## The skeleton, or a node above it, may be turned and scaled, as imported characters are (0.01 for
## centimetres): positions come out in metres, orientations without scale.

## The skeleton.
var skeleton: Skeleton3D = null
## From the skeleton's space to the model's; it may scale.
var to_model: Transform3D = Transform3D.IDENTITY


func _init(p_skeleton: Skeleton3D) -> void:
	skeleton = p_skeleton
	to_model = transform_of(p_skeleton)


## Where a node is in the model: relative to the [Ragdoll] above it, or to the topmost node.
static func transform_of(p_node: Node3D) -> Transform3D:
	var transform: Transform3D = Transform3D.IDENTITY
	var node: Node3D = p_node
	while node != null and node is not RagdollFigure:
		transform = node.transform * transform
		node = node.get_parent() as Node3D
	return transform


## Why no ragdoll can be made of the skeleton and how to change that, or an empty text.
func find_fault() -> String:
	var missing: PackedStringArray = []
	for bone: StringName in Limbs.BONES:
		if not has(bone):
			missing.append(bone)
	if not missing.is_empty():
		return (
			(
				"The skeleton has no bone %s: rename its bones to Godot's humanoid profile "
				+ "(import settings of the character, Skeleton3D, Retarget, BoneMap)"
			)
			% ", ".join(missing)
		)
	var basis: Basis = to_model.basis
	if not to_model.is_finite() or not (basis.determinant() > 1e-12):
		return "The skeleton is mirrored or scaled to nothing: set its scale above 0"
	var scale: Vector3 = basis.get_scale()
	if scale[scale.max_axis_index()] / scale[scale.min_axis_index()] > 1.01:
		return "The skeleton is scaled unevenly: scale it equally along all axes"
	var side: Vector3 = rest(&"LeftUpperLeg").origin - rest(&"RightUpperLeg").origin
	if side.x <= 0.5 * side.length():
		return "The figure does not face +Z: turn the character below the Ragdoll"
	if rest(&"Head").origin.y <= rest(&"LeftFoot").origin.y + 0.2:
		return "The figure is not upright or smaller than 0.2 m: turn or scale the character"
	return ""


## Whether there is a bone.
func has(p_bone: StringName) -> bool:
	return skeleton.find_bone(p_bone) >= 0


## The rest pose of a bone in metres, without scale.
func rest(p_bone: StringName) -> Transform3D:
	return scaled_rest(p_bone).orthonormalized()


## The rest pose of a bone in model space, with the skeleton's scale in its axes.
func scaled_rest(p_bone: StringName) -> Transform3D:
	return to_model * skeleton.get_bone_global_rest(skeleton.find_bone(p_bone))


## From the end of a limb at its joint to the other; zero where the skeleton has no end.
func direction(p_limb: int) -> Vector3:
	for tail: StringName in Limbs.TAILS[p_limb]:
		if has(tail):
			return rest(tail).origin - rest(Limbs.BONES[p_limb]).origin
	return Vector3.ZERO


## Where a foot points, level, of length 1.
func forward(p_foot: int) -> Vector3:
	var ahead: Vector3 = direction(p_foot) * Vector3(1.0, 0.0, 1.0)
	return ahead.normalized() if ahead.length() > 0.02 else Vector3.BACK


## Height of the figure by its bones, m.
func height() -> float:
	var lowest: float = INF
	var highest: float = -INF
	for bone: int in skeleton.get_bone_count():
		var y: float = (to_model * skeleton.get_bone_global_rest(bone)).origin.y
		lowest = minf(lowest, y)
		highest = maxf(highest, y)
	return clampf(highest - lowest, 0.5, 3.0)


## Gives the limbs of a profile their bones' orientations at rest and in the reset pose.
func fill_pose(p_profile: RagdollProfile) -> void:
	for limb: RagdollLimb in p_profile.limbs:
		if limb == null or not has(limb.bone):
			continue
		var number: int = Limbs.find(limb.bone)
		var orientation: Quaternion = rest(limb.bone).basis.get_rotation_quaternion()
		var turn: Quaternion = Quaternion.IDENTITY
		if number >= 0:
			turn = Limbs.rest_to_reset(number, direction(number))
		limb.rest_orientation = orientation
		limb.reset_orientation = (turn * orientation).normalized()


## The body of a limb in the rest pose: at the middle of its shape, with the axes of its bone.
static func body_of(p_limb: RagdollLimb) -> Transform3D:
	return Transform3D(Basis(p_limb.rest_orientation), p_limb.position)
