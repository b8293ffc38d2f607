class_name XrDevices
extends RefCounted
## Reads a wearer's devices from [XRServer] into an [XrFrame]: headset, controllers, tracked hands,
## Vive trackers. For the main thread, once a frame.
##
## Poses are in the tracking space, unscaled. A tracked hand is used before a controller: it knows
## the wrist itself. Names of trackers are OpenXR's user paths.

## Names of the trackers, by [enum XrFrame.Pin].
const PINS: PackedStringArray = [
	"/user/vive_tracker_htcx/role/waist",
	"/user/vive_tracker_htcx/role/chest",
	"/user/vive_tracker_htcx/role/left_foot",
	"/user/vive_tracker_htcx/role/right_foot",
	"/user/vive_tracker_htcx/role/left_knee",
	"/user/vive_tracker_htcx/role/right_knee",
	"/user/vive_tracker_htcx/role/left_elbow",
	"/user/vive_tracker_htcx/role/right_elbow",
	"/user/vive_tracker_htcx/role/left_shoulder",
	"/user/vive_tracker_htcx/role/right_shoulder",
	# Runtimes refuse a map with the role of a handheld object: a prop has one that nobody else uses.
	"/user/vive_tracker_htcx/role/keyboard",
]
## Names of the headset, the controllers and the tracked hands.
const HEAD: StringName = &"head"
const CONTROLLERS: Array[StringName] = [&"left_hand", &"right_hand"]
const HANDS: Array[StringName] = [&"/user/hand_tracker/left", &"/user/hand_tracker/right"]
## The action that is a controller's stick.
const STICK: StringName = &"primary"
## Poses of a controller that lie in the palm, best first.
const _PALM_POSES: Array[StringName] = [&"grip", &"grip_pose", &"default", &"default_pose"]
## The wrist, seen from the middle of the palm, m: back along the hand, in the grip's axes.
const _WRIST: Vector3 = Vector3(0.0, 0.085, 0.0)

## What was read last.
var frame: XrFrame = XrFrame.new()


## Reads all for a moment, µs of Unix time: the one at which the frame will be seen, for which the
## runtime predicts.
func read(p_time_usec: int) -> XrFrame:
	frame.time_usec = p_time_usec
	frame.lose_all()
	_read_head()
	var fingers: Dictionary[int, Quaternion] = {}
	for side: int in 2:
		if not _read_hand(side, fingers):
			_read_controller(side)
	frame.fingers = fingers
	for pin: int in XrFrame.PINS:
		var pose: XRPose = _pose_of(StringName(PINS[pin]), [&"default", &"grip"])
		if pose != null:
			frame.pins[pin] = pose.transform
			frame.has_pins[pin] = 1
	frame.drop_faults()
	return frame


## How far the stick of a hand's controller (0 left, 1 right) is pushed: x right, y ahead, up to 1.
func stick(p_side: int) -> Vector2:
	var tracker: XRPositionalTracker = (
		XRServer.get_tracker(CONTROLLERS[p_side]) as XRPositionalTracker
	)
	var pushed: Variant = tracker.get_input(STICK) if tracker != null else null
	if not pushed is Vector2 or not (pushed as Vector2).is_finite():
		return Vector2.ZERO
	return (pushed as Vector2).limit_length()


## The rotation of a hand from the reset pose by a controller's grip (OpenXR: +X out of the left
## palm and into the right one, -Z out of the fist on the thumb's side).
static func hand_of_grip(p_side: int, p_grip: Basis) -> Quaternion:
	# Fingers are along the grip's -Y; in the reset pose to the side, the palm down, the thumb ahead.
	var out: float = 1.0 - 2.0 * p_side
	var palm: Basis = Basis(Vector3(0, -out, 0), Vector3(-out, 0, 0), Vector3(0, 0, -1))
	return (p_grip.orthonormalized() * palm).get_rotation_quaternion()


func _read_head() -> void:
	var pose: XRPose = _pose_of(HEAD, [&"default"])
	if pose == null:
		return
	frame.head = pose.transform
	frame.has_head = true
	# A headset without a tracker of its own stays at the origin of its space.
	frame.has_place = pose.tracking_confidence != XRPose.XR_TRACKING_CONFIDENCE_LOW
	frame.has_place = frame.has_place or not pose.transform.origin.is_zero_approx()


func _read_controller(p_side: int) -> void:
	var pose: XRPose = _pose_of(CONTROLLERS[p_side], _PALM_POSES)
	if pose == null or not XrFrame.is_pose(pose.transform):
		return
	var hand: Quaternion = hand_of_grip(p_side, pose.transform.basis)
	frame.hands[p_side] = Transform3D(Basis(hand), pose.transform * _WRIST)
	frame.has_hands[p_side] = 1


func _read_hand(p_side: int, r_fingers: Dictionary[int, Quaternion]) -> bool:
	var tracker: XRHandTracker = XRServer.get_tracker(HANDS[p_side]) as XRHandTracker
	if tracker == null or not tracker.has_tracking_data:
		return false
	var wrist: Transform3D = tracker.get_hand_joint_transform(XRHandTracker.HAND_JOINT_WRIST)
	if not _is_valid(tracker, XRHandTracker.HAND_JOINT_WRIST) or not XrFrame.is_pose(wrist):
		return false
	var bone: StringName = &"LeftHand" if p_side == 0 else &"RightHand"
	frame.hands[p_side] = Transform3D(Basis(_turn(wrist, bone)), wrist.origin)
	frame.has_hands[p_side] = 1
	var first: int = (
		XRBodyTracker.JOINT_LEFT_HAND if p_side == 0 else XRBodyTracker.JOINT_RIGHT_HAND
	)
	for joint: int in FingerJoints.of_hand(p_side):
		# Both kinds of trackers have the joints of a hand in the same order: palm, wrist, thumb, ...
		var there: int = joint - first - 1
		if _is_valid(tracker, there):
			var pose: Transform3D = tracker.get_hand_joint_transform(
				there as XRHandTracker.HandJoint
			)
			if XrFrame.is_pose(pose):
				r_fingers[joint] = _turn(pose, FingerJoints.bone_of(joint))
	return true


static func _is_valid(p_tracker: XRHandTracker, p_joint: int) -> bool:
	var flags: int = p_tracker.get_hand_joint_flags(p_joint as XRHandTracker.HandJoint)
	return flags & XRHandTracker.HAND_JOINT_FLAG_ORIENTATION_VALID != 0


static func _turn(p_pose: Transform3D, p_bone: StringName) -> Quaternion:
	var axes: Quaternion = HumanoidAxes.of_bone(p_bone)
	return (p_pose.basis.get_rotation_quaternion() * axes.inverse()).normalized()


## The first of some poses of a tracker that has data, or null.
static func _pose_of(p_tracker: StringName, p_poses: Array[StringName]) -> XRPose:
	var tracker: XRPositionalTracker = XRServer.get_tracker(p_tracker) as XRPositionalTracker
	if tracker == null:
		return null
	for name: StringName in p_poses:
		var pose: XRPose = tracker.get_pose(name)
		if pose != null and pose.has_tracking_data:
			return pose
	return null
