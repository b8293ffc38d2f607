class_name BodyFit
extends RefCounted
## Gives a humanoid skeleton the size of a person: its bones become as long as the person's limbs.
##
## Bones keep their directions and their rotations; what hangs on a bone moves out or in along it,
## so that the mesh stretches with it. Thickness stays.

## Bones that hold the next joint of a limb, by limb of [Limbs] whose length it is.
const _ENDS: Dictionary[int, Array] = {
	4: [&"LeftLowerArm"],
	5: [&"LeftHand"],
	7: [&"RightLowerArm"],
	8: [&"RightHand"],
	10: [&"LeftLowerLeg"],
	11: [&"LeftFoot"],
	13: [&"RightLowerLeg"],
	14: [&"RightFoot"],
}


## Sets the poses of the bones' places; the rests stay, so that it can be done again.
## Returns by how much each limb was stretched, by [Limbs]; 1 where it was left.
static func apply(p_skeleton: Skeleton3D, p_size: BodySize) -> PackedFloat32Array:
	var stretched: PackedFloat32Array = PackedFloat32Array()
	stretched.resize(Limbs.COUNT)
	stretched.fill(1.0)
	for limb: int in _ENDS:
		var bone: int = p_skeleton.find_bone(_ENDS[limb][0])
		if bone >= 0:
			stretched[limb] = _stretch(p_skeleton, bone, p_size.limb_length(limb))
	_stretch_trunk(p_skeleton, p_size, stretched)
	_stretch_across(p_skeleton, &"UpperArm", p_size.length(&"shoulder_width"))
	_stretch_across(p_skeleton, &"UpperLeg", p_size.length(&"hip_width") * 0.9)
	_stand(p_skeleton, p_size)
	return stretched


## Makes a bone so far from its parent.
static func _stretch(p_skeleton: Skeleton3D, p_bone: int, p_length: float) -> float:
	var rest: Vector3 = p_skeleton.get_bone_rest(p_bone).origin
	if rest.length() < 1e-4:
		return 1.0
	p_skeleton.set_bone_pose_position(p_bone, rest.normalized() * p_length)
	return p_length / rest.length()


## The chain from the hips to where the arms begin, all by one factor.
static func _stretch_trunk(
	p_skeleton: Skeleton3D, p_size: BodySize, r_stretched: PackedFloat32Array
) -> void:
	var hips: int = p_skeleton.find_bone(&"Hips")
	var arm: int = p_skeleton.find_bone(&"LeftUpperArm")
	var leg: int = p_skeleton.find_bone(&"LeftUpperLeg")
	if hips < 0 or arm < 0 or leg < 0:
		return
	var shoulder: float = p_skeleton.get_bone_global_rest(arm).origin.y
	var now: float = shoulder - p_skeleton.get_bone_global_rest(leg).origin.y
	if now < 0.05:
		return
	var factor: float = p_size.length(&"trunk") / now
	for name: StringName in [&"Spine", &"Chest", &"UpperChest", &"Neck"]:
		var bone: int = p_skeleton.find_bone(name)
		if bone >= 0:
			var rest: Vector3 = p_skeleton.get_bone_rest(bone).origin
			p_skeleton.set_bone_pose_position(bone, rest * factor)
	for limb: int in 3:
		r_stretched[limb] = factor


## Moves the bones of both sides apart, in the first joint that is off the middle.
static func _stretch_across(p_skeleton: Skeleton3D, p_name: StringName, p_width: float) -> void:
	for side: String in ["Left", "Right"]:
		var bone: int = p_skeleton.find_bone(side + p_name)
		if bone < 0:
			continue
		var own: float = absf(p_skeleton.get_bone_global_rest(bone).origin.x)
		var parent: int = p_skeleton.get_bone_parent(bone)
		var at: Vector3 = p_skeleton.get_bone_global_rest(bone).origin
		if parent < 0 or own < 1e-3:
			continue
		at.x *= p_width / 2.0 / own
		var above: Transform3D = p_skeleton.get_bone_global_rest(parent)
		p_skeleton.set_bone_pose_position(bone, above.affine_inverse() * at)


## Lifts or lowers the hips so that the soles stay on the ground.
static func _stand(p_skeleton: Skeleton3D, p_size: BodySize) -> void:
	var hips: int = p_skeleton.find_bone(&"Hips")
	if hips < 0:
		return
	var place: Vector3 = p_skeleton.get_bone_rest(hips).origin
	var leg: int = p_skeleton.find_bone(&"LeftUpperLeg")
	if leg >= 0:
		place.y += p_size.length(&"hip_height") - p_skeleton.get_bone_global_rest(leg).origin.y
	p_skeleton.set_bone_pose_position(hips, place)
