class_name SkeletonMotion
extends RefCounted
## Reads the pose of a skeleton that something else moves ([AnimationPlayer], [AnimationTree],
## inverse kinematics) as [PoseSample]s: a [Ragdoll] follows an animated copy of its character.
##
## The copy may be anywhere in the world and turned; the body is to do there what the copy does. Its
## skeleton has the bones of the ragdoll's own, with the same rest pose.

var _skeleton: Skeleton3D = null
var _bones: PackedInt32Array = []
## For each limb the inverse of its bone's orientation in the reset pose, in the model's space.
var _from_reset: Array[Quaternion] = []


## Reads [param p_skeleton] for the character of [param p_ragdoll].
func _init(p_skeleton: Skeleton3D, p_ragdoll: Ragdoll) -> void:
	_skeleton = p_skeleton
	var figure: RestSkeleton = RestSkeleton.new(p_ragdoll.get_skeleton())
	for limb: int in Limbs.COUNT:
		var rest: Quaternion = figure.rest(Limbs.BONES[limb]).basis.get_rotation_quaternion()
		var reset: Quaternion = Limbs.rest_to_reset(limb, figure.direction(limb)) * rest
		_from_reset.append(reset.inverse())
		_bones.append(p_skeleton.find_bone(Limbs.BONES[limb]))


## Why there is no motion to be read, or an empty text.
func find_fault() -> String:
	for limb: int in Limbs.COUNT:
		if _bones[limb] < 0:
			return "%s has no bone %s" % [_skeleton.name, Limbs.BONES[limb]]
	return ""


## The pose as it is now. The root is where the hips are in the world, m.
func sample() -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	var transform: Transform3D = _skeleton.global_transform
	for limb: int in Limbs.COUNT:
		var bone: Transform3D = transform * _skeleton.get_bone_global_pose(_bones[limb])
		var turn: Quaternion = bone.basis.get_rotation_quaternion()
		pose.set_orientation(limb, (turn * _from_reset[limb]).normalized())
		if limb == Limbs.ROOT:
			pose.root = bone.origin
	return pose
