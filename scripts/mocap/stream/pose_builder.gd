class_name PoseBuilder
extends RefCounted
## Makes a pose of what a stream says about joints: rotations from the reset pose in the world, in
## Godot's frame, and perhaps where they are. Joints are those of [enum XRBodyTracker.Joint]; limbs
## that the stream lacks are filled from their neighbours ([LimbFiller]).

## The joint on which each joint hangs, for those that people have; parents come first.
const PARENTS: Dictionary[int, int] = {
	XRBodyTracker.JOINT_HIPS: -1,
	XRBodyTracker.JOINT_SPINE: XRBodyTracker.JOINT_HIPS,
	XRBodyTracker.JOINT_CHEST: XRBodyTracker.JOINT_SPINE,
	XRBodyTracker.JOINT_UPPER_CHEST: XRBodyTracker.JOINT_CHEST,
	XRBodyTracker.JOINT_NECK: XRBodyTracker.JOINT_UPPER_CHEST,
	XRBodyTracker.JOINT_HEAD: XRBodyTracker.JOINT_NECK,
	XRBodyTracker.JOINT_LEFT_SHOULDER: XRBodyTracker.JOINT_UPPER_CHEST,
	XRBodyTracker.JOINT_LEFT_UPPER_ARM: XRBodyTracker.JOINT_LEFT_SHOULDER,
	XRBodyTracker.JOINT_LEFT_LOWER_ARM: XRBodyTracker.JOINT_LEFT_UPPER_ARM,
	XRBodyTracker.JOINT_LEFT_HAND: XRBodyTracker.JOINT_LEFT_LOWER_ARM,
	XRBodyTracker.JOINT_RIGHT_SHOULDER: XRBodyTracker.JOINT_UPPER_CHEST,
	XRBodyTracker.JOINT_RIGHT_UPPER_ARM: XRBodyTracker.JOINT_RIGHT_SHOULDER,
	XRBodyTracker.JOINT_RIGHT_LOWER_ARM: XRBodyTracker.JOINT_RIGHT_UPPER_ARM,
	XRBodyTracker.JOINT_RIGHT_HAND: XRBodyTracker.JOINT_RIGHT_LOWER_ARM,
	XRBodyTracker.JOINT_LEFT_UPPER_LEG: XRBodyTracker.JOINT_HIPS,
	XRBodyTracker.JOINT_LEFT_LOWER_LEG: XRBodyTracker.JOINT_LEFT_UPPER_LEG,
	XRBodyTracker.JOINT_LEFT_FOOT: XRBodyTracker.JOINT_LEFT_LOWER_LEG,
	XRBodyTracker.JOINT_LEFT_TOES: XRBodyTracker.JOINT_LEFT_FOOT,
	XRBodyTracker.JOINT_RIGHT_UPPER_LEG: XRBodyTracker.JOINT_HIPS,
	XRBodyTracker.JOINT_RIGHT_LOWER_LEG: XRBodyTracker.JOINT_RIGHT_UPPER_LEG,
	XRBodyTracker.JOINT_RIGHT_FOOT: XRBodyTracker.JOINT_RIGHT_LOWER_LEG,
	XRBodyTracker.JOINT_RIGHT_TOES: XRBodyTracker.JOINT_RIGHT_FOOT,
}
## Joints that give the mounts of [BodyMounts]. The chest is what the arms hang on.
const _MOUNTS: PackedInt32Array = [
	XRBodyTracker.JOINT_HIPS,
	XRBodyTracker.JOINT_UPPER_CHEST,
	XRBodyTracker.JOINT_HEAD,
	XRBodyTracker.JOINT_LEFT_SHOULDER,
	XRBodyTracker.JOINT_LEFT_UPPER_ARM,
	XRBodyTracker.JOINT_LEFT_LOWER_ARM,
	XRBodyTracker.JOINT_LEFT_HAND,
	XRBodyTracker.JOINT_RIGHT_SHOULDER,
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
## What the arms may hang on, the highest first.
const _TRUNK: PackedInt32Array = [
	XRBodyTracker.JOINT_UPPER_CHEST, XRBodyTracker.JOINT_CHEST, XRBodyTracker.JOINT_SPINE
]
## Fewer limbs than these make nobody.
const _MIN_LIMBS: int = 3

var _turns: Array[Quaternion] = []
var _positions: PackedVector3Array = PackedVector3Array()
var _has_turn: PackedByteArray = PackedByteArray()
var _has_position: PackedByteArray = PackedByteArray()
var _filler: LimbFiller = LimbFiller.new()
var _standing: StandingHeight = StandingHeight.new(BodySize.new())


func _init() -> void:
	_turns.resize(XRBodyTracker.JOINT_MAX)
	_positions.resize(XRBodyTracker.JOINT_MAX)
	_has_turn.resize(XRBodyTracker.JOINT_MAX)
	_has_position.resize(XRBodyTracker.JOINT_MAX)


## Forgets all joints.
func clear() -> void:
	_has_turn.fill(0)
	_has_position.fill(0)


## Sets the rotation of a joint in the world.
func set_turn(p_joint: int, p_turn: Quaternion) -> void:
	_turns[p_joint] = p_turn
	_has_turn[p_joint] = 1


## Sets where a joint is, m.
func set_position(p_joint: int, p_position: Vector3) -> void:
	_positions[p_joint] = p_position
	_has_position[p_joint] = 1


## Sets a joint by its rotation from, and its position on, the nearest joint above it that is set:
## joints nearer to the hips come first. Hips are set in the world.
func set_local(p_joint: int, p_turn: Quaternion, p_offset: Vector3) -> void:
	var above: int = parent_of(p_joint)
	while above >= 0 and _has_turn[above] == 0:
		above = parent_of(above)
	if above < 0:
		set_turn(p_joint, p_turn)
		set_position(p_joint, p_offset)
		return
	set_turn(p_joint, (_turns[above] * p_turn).normalized())
	set_position(p_joint, _positions[above] + _turns[above] * p_offset)


## The joint on which one hangs, -1 for the hips.
static func parent_of(p_joint: int) -> int:
	if FingerJoints.hand_of(p_joint) >= 0:
		return FingerJoints.parent_of(p_joint)
	return PARENTS.get(p_joint, -1)


## The pose, or null where too little is known for one. [param p_knows_places] says whether the
## stream has positions; without them the lower foot stands on the ground below the origin.
func build(p_knows_places: bool = true) -> PoseSample:
	_filler.clear()
	var count: int = 0
	for mount: int in BodyMounts.COUNT:
		var joint: int = _MOUNTS[mount]
		if mount == BodyMounts.STERNUM:
			joint = _top_of_trunk()
		if _has_turn[joint] != 0:
			_filler.set_mount(mount, _turns[joint])
			count += 1
	if count < _MIN_LIMBS:
		return null
	_filler.fill()
	var pose: PoseSample = _filler.pose()
	if _has_turn[XRBodyTracker.JOINT_SPINE] != 0:
		pose.set_orientation(Limbs.SPINE, _turns[XRBodyTracker.JOINT_SPINE])
		pose.details.measured[Limbs.SPINE] = 1
	for joint: int in XRBodyTracker.JOINT_MAX:
		if _has_turn[joint] != 0 and not HumanoidAxes.JOINTS.has(joint):
			pose.details.joints[joint] = _turns[joint]
	_place(pose, p_knows_places)
	return pose


## The joint on which the arms hang: of chest and spine the highest that is there.
func _top_of_trunk() -> int:
	for joint: int in _TRUNK:
		if _has_turn[joint] != 0:
			return joint
	return XRBodyTracker.JOINT_UPPER_CHEST


func _place(r_pose: PoseSample, p_knows_places: bool) -> void:
	if not p_knows_places or _has_position[XRBodyTracker.JOINT_HIPS] == 0:
		r_pose.root = Vector3(0.0, _standing.of(r_pose), 0.0)
		return
	r_pose.root = _positions[XRBodyTracker.JOINT_HIPS]
	var positions: PackedVector3Array = []
	for joint: int in HumanoidAxes.JOINTS:
		if _has_position[joint] == 0:
			return
		positions.append(_positions[joint])
	r_pose.details.positions = positions
