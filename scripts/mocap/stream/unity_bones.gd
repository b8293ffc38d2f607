class_name UnityBones
extends RefCounted
## Joints by the names that Unity's HumanBodyBones have, as VMC sends them: Godot's humanoid names
## but for the thumbs.

## Unity's names of bones that differ from Godot's.
const _OTHER_NAMES: Dictionary[String, String] = {
	"LeftThumbProximal": "LeftThumbMetacarpal",
	"LeftThumbIntermediate": "LeftThumbProximal",
	"RightThumbProximal": "RightThumbMetacarpal",
	"RightThumbIntermediate": "RightThumbProximal",
}
static var _joints: Dictionary[String, int] = {}
static var _names: Dictionary[int, String] = {}
static var _mutex: Mutex = Mutex.new()


## The joint of a bone's name in Unity, or -1.
static func joint_of(p_name: String) -> int:
	_fill()
	return _joints.get(p_name, -1)


## Unity's name of a joint, or an empty text.
static func name_of(p_joint: int) -> String:
	_fill()
	return _names.get(p_joint, "")


static func _fill() -> void:
	_mutex.lock()
	if _joints.is_empty():
		_joints = _find_joints()
		for name: String in _joints:
			_names[_joints[name]] = name
	_mutex.unlock()


static func _find_joints() -> Dictionary[String, int]:
	var found: Dictionary[String, int] = {}
	for limb: int in Limbs.COUNT:
		found[str(Limbs.BONES[limb])] = HumanoidAxes.JOINTS[limb]
	for joint: int in HumanoidAxes.OTHERS:
		found[str(HumanoidAxes.OTHERS[joint])] = joint
	for hand: int in 2:
		for joint: int in FingerJoints.of_hand(hand):
			var bone: String = str(FingerJoints.bone_of(joint))
			var other: Variant = _OTHER_NAMES.find_key(bone)
			found[bone if other == null else str(other)] = joint
	return found
