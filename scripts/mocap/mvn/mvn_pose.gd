class_name MvnPose
extends RefCounted
## Makes poses of MVN's samples (types 01, 02 and 05, see [MvnReceiver]).
##
## MVN calibrates its wearers itself: its segments have no rotation in the T-pose, which is the
## reset pose of [Limbs].

## Further from the pelvis than that no segment is, m: such places are in centimetres.
const MOST_REACH: float = 5.0

## Metres of the stream's unit of length; 0: as the type has it, and centimetres where metres cannot
## be.
var unit_m: float = 0.0
## The newest rotations of the 23 segments in the world, from the reset pose.
var rotations: Array[Quaternion] = []
## Where the 23 segments begin in the world, m.
var places: PackedVector3Array = PackedVector3Array()

var _unity_order: PackedByteArray = MvnEncoder.get_unity_order()
var _is_cm: bool = false
var _known: PackedByteArray = PackedByteArray()


func _init() -> void:
	rotations.resize(MvnSegments.COUNT)
	rotations.fill(Quaternion.IDENTITY)
	places.resize(MvnSegments.COUNT)
	_known.resize(MvnSegments.COUNT)


## The pose of a sample, or null if it has none.
func read(p_sample: Dictionary) -> PoseSample:
	_known.fill(0)
	var segments: PackedInt32Array = p_sample["segments"]
	for item: int in mini(segments.size(), MvnSegments.COUNT):
		var place: int = _place_of(p_sample["type"], segments, item)
		_take(p_sample, item, place)
	if _known[0] == 0:
		return null
	if p_sample["type"] == 5:
		_chain()
	_fill()
	_find_unit(p_sample["type"])
	return _make(p_sample)


## Which segment an item is: its number, or its place in the datagram where numbers are odd.
func _place_of(p_type: int, p_segments: PackedInt32Array, p_item: int) -> int:
	if p_type == 5:
		return _unity_order[p_item]
	if p_segments.size() >= MvnSegments.COUNT:
		return p_item
	# Not all are sent: only the numbers tell.
	return clampi(p_segments[p_item] - 1, 0, MvnSegments.COUNT - 1)


func _take(p_sample: Dictionary, p_item: int, p_place: int) -> void:
	var turn: Quaternion = _rotation(p_sample, p_item)
	# A rotation has two quaternions; the nearer one keeps filters behind it steady.
	if turn.dot(rotations[p_place]) < 0.0:
		turn = -turn
	rotations[p_place] = turn
	places[p_place] = SourceFrames.place(p_sample["positions"][p_item], _frame(p_sample["type"]))
	_known[p_place] = 1


func _rotation(p_sample: Dictionary, p_item: int) -> Quaternion:
	if p_sample["type"] == 1:
		return SourceFrames.rotation_from_euler(p_sample["euler"][p_item])
	var wxyz: PackedFloat32Array = p_sample["orientations"]
	var at: int = p_item * 4
	var frame: SourceFrames.Frame = _frame(p_sample["type"])
	return (
		SourceFrames.rotation(wxyz[at], wxyz[at + 1], wxyz[at + 2], wxyz[at + 3], frame).normalized()
	)


static func _frame(p_type: int) -> SourceFrames.Frame:
	match p_type:
		1:
			return SourceFrames.Frame.MVN_Y_UP
		5:
			return SourceFrames.Frame.MVN_UNITY
	return SourceFrames.Frame.XSENS


## In type 05 only the pelvis is global, all others refer to the segment before them.
func _chain() -> void:
	for place: int in range(1, MvnSegments.COUNT):
		var parent: int = MvnSegments.PARENTS[place]
		places[place] = places[parent] + rotations[parent] * places[place]
		rotations[place] = (rotations[parent] * rotations[place]).normalized()


## Segments that were not sent go with the segment before them.
func _fill() -> void:
	for place: int in range(1, MvnSegments.COUNT):
		if _known[place] == 0:
			rotations[place] = rotations[MvnSegments.PARENTS[place]]
			places[place] = places[MvnSegments.PARENTS[place]]


func _find_unit(p_type: int) -> void:
	var scale: float = unit_m
	if p_type == 1 and unit_m > 0.0:
		scale = unit_m / 0.01
	if unit_m <= 0.0:
		if p_type != 1 and not _is_cm:
			for place: Vector3 in places:
				_is_cm = _is_cm or place.distance_to(places[0]) > MOST_REACH
		scale = 0.01 if p_type != 1 and _is_cm else 1.0
	if scale != 1.0:
		for place: int in places.size():
			places[place] *= scale


func _make(p_sample: Dictionary) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	var details: MotionDetails = MotionDetails.new()
	details.positions.resize(Limbs.COUNT)
	details.measured.resize(Limbs.COUNT)
	for limb: int in Limbs.COUNT:
		var segment: int = MvnSegments.OF_LIMBS[limb]
		pose.set_orientation(limb, rotations[segment])
		details.positions[limb] = places[segment]
		details.measured[limb] = _known[segment]
	for segment: int in MvnSegments.JOINTS:
		details.joints[MvnSegments.JOINTS[segment]] = rotations[segment]
	if p_sample["fingers"] == MvnSegments.FINGERS and p_sample["type"] != 5:
		_take_fingers(p_sample, details)
	details.counter = p_sample["sample"]
	pose.details = details
	pose.root = places[0]
	pose.time_usec = p_sample["time_usec"]
	return pose


func _take_fingers(p_sample: Dictionary, r_details: MotionDetails) -> void:
	var first: int = MvnSegments.COUNT + int(p_sample["props"])
	var segments: PackedInt32Array = p_sample["segments"]
	var has_presence: bool = p_sample.has("present")
	for finger: int in mini(segments.size() - first, MvnSegments.FINGERS):
		var joint: int = MvnSegments.finger_joint(finger)
		if joint >= 0 and (not has_presence or p_sample["present"][first + finger] != 0):
			r_details.joints[joint] = _rotation(p_sample, first + finger)
