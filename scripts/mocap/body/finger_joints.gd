class_name FingerJoints
extends RefCounted
## The joints of the fingers in an [XRBodyTracker], their humanoid bones, and where they are on a
## hand in the reset pose.

## Joints of one hand, counted from the hand itself.
const PER_HAND: int = 27

const _FINGERS: PackedStringArray = ["Index", "Middle", "Ring", "Little"]

# Bone of each joint of the left hand, counted from the hand; empty where the profile has none.
static var _bones: PackedStringArray = PackedStringArray()
# Joint on which each hangs, counted from the hand, and where on it in the reset pose of the left
# hand, as part of the hand's length.
static var _parents: PackedInt32Array = PackedInt32Array()
static var _offsets: PackedVector3Array = PackedVector3Array()
static var _mutex: Mutex = Mutex.new()


## Whether a joint is one of the fingers'; -1 if not, else 0 for the left hand, 1 for the right one.
static func hand_of(p_joint: int) -> int:
	if p_joint > XRBodyTracker.JOINT_LEFT_WRIST:
		if p_joint < XRBodyTracker.JOINT_LEFT_HAND + PER_HAND:
			return 0
		if p_joint > XRBodyTracker.JOINT_RIGHT_WRIST:
			return 1 if p_joint < XRBodyTracker.JOINT_RIGHT_HAND + PER_HAND else -1
	return -1


## The joints of the fingers that have a bone, of a hand (0 left, 1 right), each after the one on
## which it hangs.
static func of_hand(p_hand: int) -> PackedInt32Array:
	_fill()
	var found: PackedInt32Array = []
	for at: int in PER_HAND:
		if _bones[at] != "":
			found.append(_first(p_hand) + at)
	return found


## The humanoid bone of a finger's joint.
static func bone_of(p_joint: int) -> StringName:
	_fill()
	var hand: int = hand_of(p_joint)
	var name: String = _bones[p_joint - _first(hand)]
	return StringName(("Right" if hand == 1 else "Left") + name)


## The joint on which a finger's joint hangs.
static func parent_of(p_joint: int) -> int:
	_fill()
	var first: int = _first(hand_of(p_joint))
	return first + _parents[p_joint - first]


## Where a joint is on its parent in the reset pose, m, for a hand of a length, m.
static func offset_of(p_joint: int, p_hand_length: float) -> Vector3:
	_fill()
	var hand: int = hand_of(p_joint)
	var offset: Vector3 = _offsets[p_joint - _first(hand)] * p_hand_length
	return offset * Vector3(-1.0, 1.0, 1.0) if hand == 1 else offset


static func _first(p_hand: int) -> int:
	return XRBodyTracker.JOINT_RIGHT_HAND if p_hand == 1 else XRBodyTracker.JOINT_LEFT_HAND


static func _fill() -> void:
	_mutex.lock()
	if _bones.is_empty():
		var bones: PackedStringArray = []
		bones.resize(PER_HAND)
		var parents: PackedInt32Array = []
		parents.resize(PER_HAND)
		var thumb: PackedStringArray = ["ThumbMetacarpal", "ThumbProximal", "ThumbDistal"]
		for part: int in 3:
			bones[3 + part] = thumb[part]
			parents[3 + part] = 2 + part if part > 0 else 0
		for finger: int in _FINGERS.size():
			# The profile has no bones for the metacarpals of these.
			for part: int in 3:
				var at: int = 8 + finger * 5 + part
				var names: PackedStringArray = ["Proximal", "Intermediate", "Distal"]
				bones[at] = _FINGERS[finger] + names[part]
				parents[at] = at - 1 if part > 0 else 0
		_parents = parents
		_offsets = _measure(bones, parents)
		_bones = bones
	_mutex.unlock()


## Offsets from the profile's own hand, as parts of its length.
static func _measure(p_bones: PackedStringArray, p_parents: PackedInt32Array) -> PackedVector3Array:
	var profile: SkeletonProfileHumanoid = SkeletonProfileHumanoid.new()
	var positions: PackedVector3Array = []
	positions.resize(PER_HAND)
	for at: int in PER_HAND:
		positions[at] = _position_of(
			profile, "LeftHand" if p_bones[at] == "" else "Left" + p_bones[at]
		)
	# From the wrist to the last joint of the middle finger is most of a hand.
	var length: float = maxf(positions[0].distance_to(positions[15]) / 0.85, 0.01)
	var offsets: PackedVector3Array = []
	for at: int in PER_HAND:
		offsets.append((positions[at] - positions[p_parents[at]]) / length)
	return offsets


static func _position_of(p_profile: SkeletonProfileHumanoid, p_bone: String) -> Vector3:
	var at: Transform3D = Transform3D.IDENTITY
	var bone: StringName = StringName(p_bone)
	while bone != &"":
		at = p_profile.get_reference_pose(p_profile.find_bone(bone)) * at
		bone = p_profile.get_bone_parent(p_profile.find_bone(bone))
	return at.origin
