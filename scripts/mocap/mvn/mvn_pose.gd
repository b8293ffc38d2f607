class_name MvnPose
extends RefCounted
## Turns MVN's samples into poses (types 01, 02 and 05, see [MvnReceiver]), one after the other.
##
## [MvnSegments] defines what a segment is and where it points; here samples are put into its
## order, and what shows only over time is handled.

## Greatest distance of a segment from the pelvis, m: positions beyond it are in centimetres.
const MAX_REACH: float = 5.0
## The stream's frame by type.
const FRAMES: Dictionary[int, SourceFrames.Frame] = {
	1: SourceFrames.Frame.MVN_Y_UP,
	2: SourceFrames.Frame.XSENS,
	5: SourceFrames.Frame.MVN_UNITY,
}
## Joints of one hand in the order of its segments, as steps from the first joint of the thumb; the
## carpus, which comes before them, goes with the hand.
const _FINGER_STEPS: Array[int] = [
	0, 1, 2, 4, 5, 6, 7, 9, 10, 11, 12, 14, 15, 16, 17, 19, 20, 21, 22
]
## Segments of two hands.
const _FINGERS: int = 40

## Metres of the stream's unit of length; 0: as the type has it, and centimetres where metres cannot
## be.
var unit_m: float = 0.0

var _is_cm: bool = false
var _last: PoseSample = null


## The pose of a sample, or null if it has none.
func read(p_sample: Dictionary) -> PoseSample:
	var type: int = p_sample["type"]
	var wxyz: PackedFloat32Array = _rotations(p_sample)
	var present: PackedByteArray = p_sample.get("present", PackedByteArray())
	present = present.slice(0, MvnSegments.COUNT)
	var segments: PackedInt32Array = p_sample["segments"]
	var pose: PoseSample = null
	if segments.size() >= MvnSegments.COUNT:
		pose = MvnSegments.pose(wxyz, p_sample["positions"], FRAMES[type], present)
	elif type != 5:
		pose = _read_some(p_sample, wxyz)
	if pose == null:
		return null
	if p_sample["fingers"] == _FINGERS and type != 5:
		_take_fingers(p_sample, wxyz, pose.details)
	_keep_signs(pose)
	_scale(pose, type)
	pose.details.counter = p_sample["sample"]
	pose.time_usec = p_sample["time_usec"]
	_last = pose
	return pose


## The joint of a finger's segment, counted from the left carpus; -1 for the two carpi.
static func finger_joint(p_finger: int) -> int:
	@warning_ignore("integer_division")
	var of_hand: int = _FINGERS / 2
	var step: int = p_finger % of_hand - 1
	if step < 0:
		return -1
	var thumb: int = XRBodyTracker.JOINT_LEFT_THUMB_METACARPAL
	if p_finger >= of_hand:
		thumb = XRBodyTracker.JOINT_RIGHT_THUMB_METACARPAL
	return thumb + _FINGER_STEPS[step]


## Reads a sample with fewer segments than a body has: their numbers say which they are.
func _read_some(p_sample: Dictionary, p_wxyz: PackedFloat32Array) -> PoseSample:
	var wxyz: PackedFloat32Array = []
	wxyz.resize(MvnSegments.COUNT * 4)
	var positions: PackedVector3Array = []
	positions.resize(MvnSegments.COUNT)
	var present: PackedByteArray = []
	present.resize(MvnSegments.COUNT)
	var segments: PackedInt32Array = p_sample["segments"]
	for item: int in segments.size():
		var position: int = segments[item] - 1
		if position < 0 or position >= MvnSegments.COUNT:
			continue
		for part: int in 4:
			wxyz[position * 4 + part] = p_wxyz[item * 4 + part]
		positions[position] = p_sample["positions"][item]
		present[position] = 1
	return MvnSegments.pose(wxyz, positions, FRAMES[p_sample["type"]], present)


## Rotations of all items, as w, x, y, z in the stream's frame.
static func _rotations(p_sample: Dictionary) -> PackedFloat32Array:
	if p_sample["type"] != 1:
		return p_sample["orientations"]
	var wxyz: PackedFloat32Array = []
	for angles: Vector3 in p_sample["euler"]:
		var turn: Quaternion = SourceFrames.rotation_from_euler(angles)
		wxyz.append_array([turn.w, turn.x, turn.y, turn.z])
	return wxyz


## A rotation has two quaternions; the one nearer to the last keeps filters behind it steady.
func _keep_signs(r_pose: PoseSample) -> void:
	if _last == null:
		return
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = r_pose.orientation(limb)
		if turn.dot(_last.orientation(limb)) < 0.0:
			r_pose.set_orientation(limb, -turn)


func _scale(r_pose: PoseSample, p_type: int) -> void:
	var scale: float = 1.0
	if unit_m > 0.0:
		scale = unit_m / 0.01 if p_type == 1 else unit_m
	elif p_type != 1:
		for position: Vector3 in r_pose.details.positions:
			_is_cm = _is_cm or position.distance_to(r_pose.root) > MAX_REACH
		scale = 0.01 if _is_cm else 1.0
	if scale != 1.0:
		r_pose.root *= scale
		for at: int in r_pose.details.positions.size():
			r_pose.details.positions[at] *= scale


## Behind the body come props, then the left hand, then the right one.
static func _take_fingers(
	p_sample: Dictionary, p_wxyz: PackedFloat32Array, r_details: MotionDetails
) -> void:
	var first: int = MvnSegments.COUNT + int(p_sample["props"])
	var present: PackedByteArray = p_sample.get("present", PackedByteArray())
	var count: int = (p_sample["segments"] as PackedInt32Array).size()
	var frame: SourceFrames.Frame = FRAMES[p_sample["type"]]
	for finger: int in mini(count - first, _FINGERS):
		var item: int = first + finger
		var joint: int = finger_joint(finger)
		if joint < 0 or (item < present.size() and present[item] == 0):
			continue
		var at: int = item * 4
		var turn: Quaternion = SourceFrames.rotation(
			p_wxyz[at], p_wxyz[at + 1], p_wxyz[at + 2], p_wxyz[at + 3], frame
		)
		r_details.joints[joint] = turn.normalized()
