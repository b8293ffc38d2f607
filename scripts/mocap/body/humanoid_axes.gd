class_name HumanoidAxes
extends RefCounted
## How the bones of Godot's humanoid profile lie in the reset pose, and which joint of an
## [XRBodyTracker] is which limb of [Limbs].

## Joint of each limb.
const JOINTS: Array[XRBodyTracker.Joint] = [
	XRBodyTracker.JOINT_HIPS,
	XRBodyTracker.JOINT_SPINE,
	XRBodyTracker.JOINT_CHEST,
	XRBodyTracker.JOINT_HEAD,
	XRBodyTracker.JOINT_LEFT_UPPER_ARM,
	XRBodyTracker.JOINT_LEFT_LOWER_ARM,
	XRBodyTracker.JOINT_LEFT_HAND,
	XRBodyTracker.JOINT_RIGHT_UPPER_ARM,
	XRBodyTracker.JOINT_RIGHT_LOWER_ARM,
	XRBodyTracker.JOINT_RIGHT_HAND,
	XRBodyTracker.JOINT_LEFT_UPPER_LEG,
	XRBodyTracker.JOINT_LEFT_LOWER_LEG,
	XRBodyTracker.JOINT_LEFT_FOOT,
	XRBodyTracker.JOINT_RIGHT_UPPER_LEG,
	XRBodyTracker.JOINT_RIGHT_LOWER_LEG,
	XRBodyTracker.JOINT_RIGHT_FOOT,
]

## Humanoid bones of joints that are no limb.
const OTHERS: Dictionary[int, StringName] = {
	XRBodyTracker.JOINT_UPPER_CHEST: &"UpperChest",
	XRBodyTracker.JOINT_NECK: &"Neck",
	XRBodyTracker.JOINT_LEFT_SHOULDER: &"LeftShoulder",
	XRBodyTracker.JOINT_RIGHT_SHOULDER: &"RightShoulder",
	XRBodyTracker.JOINT_LEFT_TOES: &"LeftToes",
	XRBodyTracker.JOINT_RIGHT_TOES: &"RightToes",
}

static var _axes: Dictionary[StringName, Quaternion] = {}
static var _mutex: Mutex = Mutex.new()


## Axes of a humanoid bone in the profile's T-pose, in which the person faces +Z.
static func of_bone(p_bone: StringName) -> Quaternion:
	_mutex.lock()
	if _axes.is_empty():
		_fill()
	var found: Quaternion = _axes.get(p_bone, Quaternion.IDENTITY)
	_mutex.unlock()
	return found


## Axes of the bone of a limb of [Limbs].
static func of_limb(p_limb: int) -> Quaternion:
	return of_bone(Limbs.BONES[p_limb])


static func _fill() -> void:
	var profile: SkeletonProfileHumanoid = SkeletonProfileHumanoid.new()
	for bone: int in profile.bone_size:
		var turn: Quaternion = profile.get_reference_pose(bone).basis.get_rotation_quaternion()
		var parent: StringName = profile.get_bone_parent(bone)
		if parent != &"":
			turn = _axes.get(parent, Quaternion.IDENTITY) * turn
		_axes[profile.get_bone_name(bone)] = turn.normalized()
