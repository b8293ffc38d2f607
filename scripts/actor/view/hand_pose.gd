class_name HandPose
extends RefCounted
## How fingers are bent: poses by name, as data. They hold until another is set; motion capture has
## no fingers of ours.

## For each pose by how much each joint of each finger is bent, from the root to the tip, degrees.
const POSES: Dictionary[String, Dictionary] = {
	"relaxed":
	{
		"Thumb": [8, 10, 12],
		"Index": [14, 20, 12],
		"Middle": [18, 24, 14],
		"Ring": [22, 28, 16],
		"Little": [26, 30, 18],
	},
	"open":
	{
		"Thumb": [0, 0, 0],
		"Index": [0, 0, 0],
		"Middle": [0, 0, 0],
		"Ring": [0, 0, 0],
		"Little": [0, 0, 0],
	},
	"fist":
	{
		"Thumb": [30, 35, 40],
		"Index": [78, 92, 60],
		"Middle": [80, 95, 60],
		"Ring": [82, 95, 60],
		"Little": [84, 92, 60],
	},
	"grip":
	{
		"Thumb": [24, 26, 24],
		"Index": [50, 58, 34],
		"Middle": [54, 62, 36],
		"Ring": [58, 64, 38],
		"Little": [62, 64, 40],
	},
	"point":
	{
		"Thumb": [28, 32, 34],
		"Index": [4, 4, 2],
		"Middle": [78, 92, 58],
		"Ring": [80, 92, 58],
		"Little": [82, 90, 58],
	},
}

const _SIDES: PackedStringArray = ["Left", "Right"]
const _JOINTS: PackedStringArray = ["Proximal", "Intermediate", "Distal"]
const _THUMB: PackedStringArray = ["Metacarpal", "Proximal", "Distal"]


## Bends the fingers of both hands of a skeleton with humanoid bone names, or of one side (0 left, 1
## right). Returns whether there is a pose of that name.
static func apply(p_skeleton: Skeleton3D, p_name: String, p_side: int = -1) -> bool:
	if not POSES.has(p_name):
		return false
	for side: int in _SIDES.size():
		if p_side < 0 or p_side == side:
			_bend(p_skeleton, _SIDES[side], POSES[p_name])
	return true


static func _bend(p_skeleton: Skeleton3D, p_side: String, p_pose: Dictionary) -> void:
	for finger: String in p_pose:
		var names: PackedStringArray = _THUMB if finger == "Thumb" else _JOINTS
		var degrees: Array = p_pose[finger]
		for joint: int in names.size():
			var bone: int = p_skeleton.find_bone(p_side + finger + names[joint])
			if bone >= 0:
				_turn(p_skeleton, bone, deg_to_rad(degrees[joint]), finger == "Thumb", p_side)


## Turns a bone of a finger about the axis that bends it: across the finger, level with the palm.
static func _turn(
	p_skeleton: Skeleton3D, p_bone: int, p_angle: float, p_is_thumb: bool, p_side: String
) -> void:
	var rest: Transform3D = p_skeleton.get_bone_global_rest(p_bone)
	var axis: Vector3 = _palm_axis(p_skeleton, p_side)
	if p_is_thumb:
		# The thumb closes towards the palm, aslant.
		axis = (axis + _finger_axis(p_skeleton, p_side) * (1.2 if p_side == "Left" else -1.2))
	var local: Vector3 = (rest.basis.orthonormalized().inverse() * axis).normalized()
	var turn: Quaternion = Quaternion(local, p_angle)
	var own: Quaternion = p_skeleton.get_bone_rest(p_bone).basis.get_rotation_quaternion()
	p_skeleton.set_bone_pose_rotation(p_bone, own * turn)


## From the index to the little finger's root, in the rest pose, so that a positive angle bends
## fingers of either side towards the palm.
static func _palm_axis(p_skeleton: Skeleton3D, p_side: String) -> Vector3:
	var index: int = p_skeleton.find_bone(p_side + "IndexProximal")
	var little: int = p_skeleton.find_bone(p_side + "LittleProximal")
	if index < 0 or little < 0:
		return Vector3.RIGHT
	var across: Vector3 = (
		p_skeleton.get_bone_global_rest(little).origin
		- p_skeleton.get_bone_global_rest(index).origin
	)
	return across.normalized() * (1.0 if p_side == "Left" else -1.0)


## Along the hand, from the wrist to the middle finger's root.
static func _finger_axis(p_skeleton: Skeleton3D, p_side: String) -> Vector3:
	var hand: int = p_skeleton.find_bone(p_side + "Hand")
	var middle: int = p_skeleton.find_bone(p_side + "MiddleProximal")
	if hand < 0 or middle < 0:
		return Vector3.UP
	return (
		(
			p_skeleton.get_bone_global_rest(middle).origin
			- p_skeleton.get_bone_global_rest(hand).origin
		)
		. normalized()
	)
