class_name TrackerSource
extends MotionSource
## Somebody's motion from an [XRBodyTracker]: from OpenXR, or from any of Godot's mocap plugins
## (MVN, Rokoko, Axis Studio, VMC), by the tracker's name.
##
## Joints have the axes of Godot's humanoid bones. What the tracker does not have is filled as from
## a suit with fewer sensors ([LimbFiller]). Call [method advance] in the main thread in every
## frame; any thread may sample.

## Joints that give the mounts of [BodyMounts], best first.
const _JOINTS: Array[Array] = [
	[XRBodyTracker.JOINT_HIPS],
	[XRBodyTracker.JOINT_CHEST, XRBodyTracker.JOINT_UPPER_CHEST],
	[XRBodyTracker.JOINT_HEAD],
	[XRBodyTracker.JOINT_LEFT_SHOULDER],
	[XRBodyTracker.JOINT_LEFT_UPPER_ARM],
	[XRBodyTracker.JOINT_LEFT_LOWER_ARM],
	[XRBodyTracker.JOINT_LEFT_HAND],
	[XRBodyTracker.JOINT_RIGHT_SHOULDER],
	[XRBodyTracker.JOINT_RIGHT_UPPER_ARM],
	[XRBodyTracker.JOINT_RIGHT_LOWER_ARM],
	[XRBodyTracker.JOINT_RIGHT_HAND],
	[XRBodyTracker.JOINT_LEFT_UPPER_LEG],
	[XRBodyTracker.JOINT_LEFT_LOWER_LEG],
	[XRBodyTracker.JOINT_LEFT_FOOT],
	[XRBodyTracker.JOINT_RIGHT_UPPER_LEG],
	[XRBodyTracker.JOINT_RIGHT_LOWER_LEG],
	[XRBodyTracker.JOINT_RIGHT_FOOT],
]

# The flags that there are. The engine leaves those of joints that a plugin never sets
# uninitialised: whatever has other bits says nothing.
const _FLAGS: int = (
	XRBodyTracker.JOINT_FLAG_ORIENTATION_VALID
	| XRBodyTracker.JOINT_FLAG_ORIENTATION_TRACKED
	| XRBodyTracker.JOINT_FLAG_POSITION_VALID
	| XRBodyTracker.JOINT_FLAG_POSITION_TRACKED
)

## Name of the tracker, such as "/user/body_tracker".
var tracker_name: StringName = &""

var _hip_height: float = 0.0
var _filler: LimbFiller = LimbFiller.new()
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _fresh: PoseSample = null


func _init(p_name: StringName) -> void:
	tracker_name = p_name


## Names of the body trackers that there are.
static func list() -> PackedStringArray:
	var found: PackedStringArray = []
	for name: Variant in XRServer.get_trackers(XRServer.TRACKER_BODY):
		found.append(str(name))
	found.sort()
	return found


## Those of them that are not Dismount's own: what a runtime (OpenXR) or another program offers.
static func list_others() -> PackedStringArray:
	var found: PackedStringArray = []
	for name: String in list():
		if not name.begins_with(TrackerPublisher.NAME):
			found.append(name)
	return found


## Reads the tracker, in the main thread, at a time (Unix time, µs).
func advance(p_time_usec: int) -> void:
	var tracker: XRBodyTracker = XRServer.get_tracker(tracker_name) as XRBodyTracker
	if tracker == null:
		error = "there is no body tracker '%s', only: %s" % [tracker_name, ", ".join(list())]
		return
	error = ""
	if not tracker.has_tracking_data:
		return
	var pose: PoseSample = _pose_of(tracker)
	if pose == null or pose.find_fault() != "":
		return
	pose.time_usec = p_time_usec
	_mutex.lock()
	_fresh = pose
	_mutex.unlock()


func get_hip_height() -> float:
	return _hip_height if _hip_height > 0.0 else 0.95


func describe() -> String:
	return "body tracker %s" % tracker_name


func _read(_p_time_usec: int) -> PoseSample:
	_mutex.lock()
	var pose: PoseSample = _fresh
	_fresh = null
	_mutex.unlock()
	return pose


func _pose_of(p_tracker: XRBodyTracker) -> PoseSample:
	_filler.clear()
	for position: int in BodyMounts.COUNT:
		for joint: int in _JOINTS[position]:
			if _filler.known[position] == 0 and _is_turned(p_tracker, joint):
				_filler.set_mount(position, _turn(p_tracker, joint))
	if not _filler.known.has(1):
		return null
	_filler.fill()
	var pose: PoseSample = _filler.pose()
	if _is_turned(p_tracker, XRBodyTracker.JOINT_SPINE):
		pose.set_orientation(Limbs.SPINE, _turn(p_tracker, XRBodyTracker.JOINT_SPINE))
		pose.details.measured[Limbs.SPINE] = 1
	for joint: int in HumanoidAxes.OTHERS:
		if _is_turned(p_tracker, joint):
			pose.details.joints[joint] = _turn(p_tracker, joint)
	for hand: int in 2:
		for joint: int in FingerJoints.of_hand(hand):
			if _is_turned(p_tracker, joint):
				pose.details.joints[joint] = _turn(p_tracker, joint)
	_measure(p_tracker)
	pose.root = Vector3(0.0, get_hip_height(), 0.0)
	if _has_position(p_tracker, XRBodyTracker.JOINT_HIPS):
		pose.root = p_tracker.get_joint_transform(XRBodyTracker.JOINT_HIPS).origin
	return pose


## Height of the hips from the lengths of the leg, once.
func _measure(p_tracker: XRBodyTracker) -> void:
	if _hip_height > 0.0:
		return
	var joints: Array[XRBodyTracker.Joint] = [
		XRBodyTracker.JOINT_LEFT_UPPER_LEG,
		XRBodyTracker.JOINT_LEFT_LOWER_LEG,
		XRBodyTracker.JOINT_LEFT_FOOT
	]
	var positions: PackedVector3Array = []
	for joint: XRBodyTracker.Joint in joints:
		if not _has_position(p_tracker, joint):
			return
		positions.append(p_tracker.get_joint_transform(joint).origin)
	var leg: float = positions[0].distance_to(positions[1]) + positions[1].distance_to(positions[2])
	var ankle: float = BodySize.RATIOS[&"foot_height"] / (0.53 - 0.039)
	_hip_height = clampf(leg * (1.0 + ankle), 0.3, 1.5)


static func _turn(p_tracker: XRBodyTracker, p_joint: int) -> Quaternion:
	var joint: XRBodyTracker.Joint = p_joint as XRBodyTracker.Joint
	var axes: Quaternion = HumanoidAxes.of_bone(_bone(joint))
	var turned: Basis = p_tracker.get_joint_transform(joint).basis
	return (turned.get_rotation_quaternion() * axes.inverse()).normalized()


## The humanoid bone of a joint.
static func _bone(p_joint: XRBodyTracker.Joint) -> StringName:
	if FingerJoints.hand_of(p_joint) >= 0:
		return FingerJoints.bone_of(p_joint)
	if HumanoidAxes.OTHERS.has(p_joint):
		return HumanoidAxes.OTHERS[p_joint]
	return Limbs.BONES[HumanoidAxes.JOINTS.find(p_joint)]


static func _is_turned(p_tracker: XRBodyTracker, p_joint: int) -> bool:
	var joint: XRBodyTracker.Joint = p_joint as XRBodyTracker.Joint
	if _flags(p_tracker, joint) & XRBodyTracker.JOINT_FLAG_ORIENTATION_VALID == 0:
		return false
	var at: Transform3D = p_tracker.get_joint_transform(joint)
	if at == Transform3D.IDENTITY and not _can_be_identity(p_tracker, joint):
		return false
	return at.basis.is_finite() and absf(at.basis.determinant()) > 1e-6


## Whether a joint with the transform that a new tracker has may have been set: bits that are left
## over in memory can look like flags.
static func _can_be_identity(p_tracker: XRBodyTracker, p_joint: XRBodyTracker.Joint) -> bool:
	if p_joint == XRBodyTracker.JOINT_HIPS:
		return true
	if _flags(p_tracker, p_joint) & XRBodyTracker.JOINT_FLAG_POSITION_VALID != 0:
		return false
	return HumanoidAxes.of_bone(_bone(p_joint)).is_equal_approx(Quaternion.IDENTITY)


static func _has_position(p_tracker: XRBodyTracker, p_joint: XRBodyTracker.Joint) -> bool:
	var at: Vector3 = p_tracker.get_joint_transform(p_joint).origin
	var flags: int = _flags(p_tracker, p_joint)
	return flags & XRBodyTracker.JOINT_FLAG_POSITION_VALID != 0 and at.is_finite()


## The flags of a joint; none where they are none that exist.
static func _flags(p_tracker: XRBodyTracker, p_joint: XRBodyTracker.Joint) -> int:
	var flags: int = p_tracker.get_joint_flags(p_joint)
	return flags if flags & ~_FLAGS == 0 else 0
