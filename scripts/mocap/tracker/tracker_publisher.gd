class_name TrackerPublisher
extends RefCounted
## Publishes somebody's motion as an [XRBodyTracker], the way Godot's mocap plugins do, so that any
## avatar with an [XRBodyModifier3D] can wear it. For the main thread.
##
## Joints are in the tracking space, metres, with the axes of Godot's humanoid bones. The root is on
## the ground below the hips; its -Z points where they face, as in Godot's own plugins (OpenXR, VMC,
## Rokoko). What is not known of a person has no flags; a joint that was known and is not any more
## loses them.

## The tracker's name by default; further people get a number behind it.
const NAME: StringName = &"/dismount/body_tracker"

const _VALID: int = (
	XRBodyTracker.JOINT_FLAG_ORIENTATION_VALID
	| XRBodyTracker.JOINT_FLAG_ORIENTATION_TRACKED
	| XRBodyTracker.JOINT_FLAG_POSITION_VALID
	| XRBodyTracker.JOINT_FLAG_POSITION_TRACKED
)
# Filled from neighbours: there, but not tracked.
const _FILLED: int = (
	XRBodyTracker.JOINT_FLAG_ORIENTATION_VALID | XRBodyTracker.JOINT_FLAG_POSITION_VALID
)
# One joint of each hand that has flags as soon as any finger of it is known.
const _THUMBS: Array[XRBodyTracker.Joint] = [
	XRBodyTracker.JOINT_LEFT_THUMB_PHALANX_PROXIMAL,
	XRBodyTracker.JOINT_RIGHT_THUMB_PHALANX_PROXIMAL,
]

## The tracker.
var tracker: XRBodyTracker = XRBodyTracker.new()

var _figure: BodySegments = null
var _is_added: bool = false


## Begins to publish under a name. [param p_size] is for the joints' positions.
func _init(p_size: BodySize, p_name: StringName = NAME, p_title: String = "") -> void:
	_figure = BodySegments.new(p_size)
	tracker.name = p_name
	tracker.description = p_title if p_title != "" else "Dismount motion capture"
	tracker.has_tracking_data = false
	var flags: int = XRBodyTracker.BODY_FLAG_UPPER_BODY_SUPPORTED
	tracker.body_flags = flags | XRBodyTracker.BODY_FLAG_LOWER_BODY_SUPPORTED
	# The engine leaves the flags of a new tracker's joints uninitialised.
	for joint: int in XRBodyTracker.JOINT_MAX:
		_clear_joint(joint as XRBodyTracker.Joint)
	XRServer.add_tracker(tracker)
	_is_added = true


## The name for the person with a number, counted from 0.
static func name_for(p_person: int) -> StringName:
	return NAME if p_person == 0 else StringName("%s_%d" % [NAME, p_person + 1])


## Shows a pose.
func publish(p_pose: PoseSample) -> void:
	_figure.solve(p_pose)
	for limb: int in Limbs.COUNT:
		_set_joint(HumanoidAxes.JOINTS[limb], limb, p_pose.orientation(limb), p_pose)
		_set_joint_position(HumanoidAxes.JOINTS[limb], _figure.bases[limb])
	for joint: int in HumanoidAxes.OTHERS:
		_publish_other(joint as XRBodyTracker.Joint, p_pose)
	for hand: int in 2:
		_publish_fingers(hand, p_pose)
	_tell_of_hands()
	_set_joint(XRBodyTracker.JOINT_HEAD_TIP, 3, p_pose.orientation(3), p_pose)
	_set_joint_position(XRBodyTracker.JOINT_HEAD_TIP, _figure.tails[3])
	var facing: Quaternion = Rotations.yaw(Rotations.yaw_of(p_pose.orientation(Limbs.ROOT)) + PI)
	var ground: Vector3 = Vector3(_figure.bases[0].x, 0.0, _figure.bases[0].z)
	var root: Transform3D = Transform3D(Basis(facing), ground)
	tracker.set_joint_transform(XRBodyTracker.JOINT_ROOT, root)
	tracker.set_joint_flags(XRBodyTracker.JOINT_ROOT, _VALID)
	tracker.has_tracking_data = true
	tracker.set_pose(
		&"default", root, Vector3.ZERO, Vector3.ZERO, XRPose.XR_TRACKING_CONFIDENCE_HIGH
	)


## Says that nothing comes at the moment; the pose stays.
func pause() -> void:
	tracker.has_tracking_data = false


## Ends it: the tracker is taken away.
func retire() -> void:
	tracker.has_tracking_data = false
	if _is_added:
		XRServer.remove_tracker(tracker)
	_is_added = false


func _publish_other(p_joint: XRBodyTracker.Joint, p_pose: PoseSample) -> void:
	var limb: int = Limbs.CHEST
	if p_joint == XRBodyTracker.JOINT_LEFT_TOES:
		limb = Limbs.LEFT_FOOT
	elif p_joint == XRBodyTracker.JOINT_RIGHT_TOES:
		limb = Limbs.RIGHT_FOOT
	var turn: Quaternion = p_pose.orientation(limb)
	if p_joint == XRBodyTracker.JOINT_NECK:
		turn = turn.slerp(p_pose.orientation(Limbs.HEAD), 0.5)
	if p_pose.details != null:
		turn = p_pose.details.joints.get(p_joint, turn)
	var axes: Quaternion = HumanoidAxes.of_bone(HumanoidAxes.OTHERS[p_joint])
	var position: Vector3 = _figure.attached(limb, _figure.rest_of(p_joint), p_pose)
	tracker.set_joint_transform(p_joint, Transform3D(Basis(turn * axes), position))
	tracker.set_joint_flags(p_joint, _VALID)


## Fingers, if the source knows any of that hand; those that it does not know follow their parents.
func _publish_fingers(p_hand: int, p_pose: PoseSample) -> void:
	var known: Dictionary[int, Quaternion] = {}
	if p_pose.details != null:
		known = p_pose.details.joints
	var joints: PackedInt32Array = FingerJoints.of_hand(p_hand)
	if not Array(joints).any(func(joint: int) -> bool: return known.has(joint)):
		if tracker.get_joint_flags(_THUMBS[p_hand]) != 0:
			for joint: int in joints:
				_clear_joint(joint as XRBodyTracker.Joint)
		return
	var limb: int = 6 if p_hand == 0 else 9
	var length: float = _figure.rest_base(limb).distance_to(_figure.rest_tail(limb))
	var hand: int = HumanoidAxes.JOINTS[limb]
	var turns: Dictionary[int, Quaternion] = {hand: p_pose.orientation(limb)}
	var positions: Dictionary[int, Vector3] = {hand: _figure.bases[limb]}
	for joint: int in joints:
		var above: int = FingerJoints.parent_of(joint)
		var offset: Vector3 = FingerJoints.offset_of(joint, length)
		turns[joint] = known.get(joint, turns[above])
		positions[joint] = positions[above] + turns[above] * offset
		var turn: Quaternion = turns[joint] * HumanoidAxes.of_bone(FingerJoints.bone_of(joint))
		var at: Transform3D = Transform3D(Basis(turn), positions[joint])
		tracker.set_joint_transform(joint as XRBodyTracker.Joint, at)
		tracker.set_joint_flags(joint as XRBodyTracker.Joint, _VALID)


## Says whether any finger is known.
func _tell_of_hands() -> void:
	var flags: int = tracker.body_flags & ~XRBodyTracker.BODY_FLAG_HANDS_SUPPORTED
	for thumb: XRBodyTracker.Joint in _THUMBS:
		if tracker.get_joint_flags(thumb) != 0:
			flags |= XRBodyTracker.BODY_FLAG_HANDS_SUPPORTED
	tracker.body_flags = flags


func _clear_joint(p_joint: XRBodyTracker.Joint) -> void:
	tracker.set_joint_transform(p_joint, Transform3D.IDENTITY)
	tracker.set_joint_flags(p_joint, 0)


func _set_joint(
	p_joint: XRBodyTracker.Joint, p_limb: int, p_turn: Quaternion, p_pose: PoseSample
) -> void:
	var axes: Quaternion = HumanoidAxes.of_limb(p_limb)
	tracker.set_joint_transform(p_joint, Transform3D(Basis(p_turn * axes), Vector3.ZERO))
	var filled: bool = p_pose.details != null and p_pose.details.measured.size() == Limbs.COUNT
	filled = filled and p_pose.details.measured[p_limb] == 0
	tracker.set_joint_flags(p_joint, _FILLED if filled else _VALID)


func _set_joint_position(p_joint: XRBodyTracker.Joint, p_position: Vector3) -> void:
	var at: Transform3D = tracker.get_joint_transform(p_joint)
	tracker.set_joint_transform(p_joint, Transform3D(at.basis, p_position))
