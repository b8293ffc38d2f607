class_name MvnSegments
extends RefCounted
## MVN's 23 segments as the motion of a person.
##
## MVN sends each segment's rotation from its T-pose, in which all are identity and the person
## faces X (SPEC 2.6.2): that is our rotation from the reset pose, in MVN's axes
## ([SourceFrames]). It is calibrated already.

## Number of segments of a body.
const COUNT: int = 23
## Segment of each limb of [Limbs], in the order of types 01 and 02.
const OF_LIMBS: PackedInt32Array = [0, 2, 4, 6, 12, 13, 14, 8, 9, 10, 19, 20, 21, 15, 16, 17]
## Segments that are no limb, and their joints.
const OTHERS: Dictionary[int, int] = {
	5: XRBodyTracker.JOINT_NECK,
	7: XRBodyTracker.JOINT_RIGHT_SHOULDER,
	11: XRBodyTracker.JOINT_LEFT_SHOULDER,
	18: XRBodyTracker.JOINT_RIGHT_TOES,
	22: XRBodyTracker.JOINT_LEFT_TOES,
}
## For each segment of type 05 (Unity) its index in the order of types 01 and 02.
const UNITY_ORDER: PackedInt32Array = [
	0, 15, 16, 17, 18, 19, 20, 21, 22, 1, 2, 3, 4, 11, 12, 13, 14, 7, 8, 9, 10, 5, 6
]
## Parent of each segment of types 01 and 02, -1 for the pelvis.
const PARENTS: PackedInt32Array = [
	-1, 0, 1, 2, 3, 4, 5, 4, 7, 8, 9, 4, 11, 12, 13, 0, 15, 16, 17, 0, 19, 20, 21
]
## Names of the mounts of [BodyMounts] by segment; empty where no tracker is worn. For type 23.
const MOUNTS: Array[StringName] = [
	&"pelvis",
	&"",
	&"",
	&"",
	&"sternum",
	&"",
	&"head",
	&"right_shoulder",
	&"right_upper_arm",
	&"right_forearm",
	&"right_hand",
	&"left_shoulder",
	&"left_upper_arm",
	&"left_forearm",
	&"left_hand",
	&"right_thigh",
	&"right_shank",
	&"right_foot",
	&"",
	&"left_thigh",
	&"left_shank",
	&"left_foot",
	&"",
]


## The pose of a sample of types 01, 02 or 05: for each of the 23 segments, in the datagram's order,
## a position (units of the type) and a rotation (w, x, y, z). [param p_present] is 1 for each
## segment that came; empty: all did. Null if the pelvis is missing or a rotation is invalid.
static func pose(
	p_rotations: PackedFloat32Array,
	p_positions: PackedVector3Array,
	p_frame: SourceFrames.Frame,
	p_present: PackedByteArray = PackedByteArray()
) -> PoseSample:
	if p_rotations.size() < COUNT * 4 or p_positions.size() < COUNT:
		return null
	var turns: Array[Quaternion] = []
	var positions: PackedVector3Array = SourceFrames.positions(p_positions.slice(0, COUNT), p_frame)
	var present: PackedByteArray = p_present.duplicate()
	if present.size() != COUNT:
		present.resize(COUNT)
		present.fill(1)
	var values: PackedFloat32Array = SourceFrames.rotations(p_rotations, p_frame)
	for segment: int in COUNT:
		var at: int = segment * 4
		var turn: Quaternion = Quaternion(
			values[at], values[at + 1], values[at + 2], values[at + 3]
		)
		# A comparison that NaN fails, too.
		if present[segment] != 0 and not absf(turn.length() - 1.0) < 0.1:
			return null
		turns.append(turn.normalized() if present[segment] != 0 else Quaternion.IDENTITY)
	if p_frame == SourceFrames.Frame.MVN_UNITY:
		_sort_unity(turns, positions, present)
	return _pose_of(turns, positions, present)


## Sorts Unity's segments into the usual order and makes their local rotations and positions global.
static func _sort_unity(
	r_turns: Array[Quaternion], r_positions: PackedVector3Array, r_present: PackedByteArray
) -> void:
	var turns: Array[Quaternion] = r_turns.duplicate()
	var positions: PackedVector3Array = r_positions.duplicate()
	var present: PackedByteArray = r_present.duplicate()
	for at: int in COUNT:
		r_turns[UNITY_ORDER[at]] = turns[at]
		r_positions[UNITY_ORDER[at]] = positions[at]
		r_present[UNITY_ORDER[at]] = present[at]
	for segment: int in range(1, COUNT):
		var above: int = PARENTS[segment]
		r_positions[segment] = r_positions[above] + r_turns[above] * r_positions[segment]
		r_turns[segment] = r_turns[above] * r_turns[segment]


static func _pose_of(
	p_turns: Array[Quaternion], p_positions: PackedVector3Array, p_present: PackedByteArray
) -> PoseSample:
	if p_present[0] == 0 or not p_positions[0].is_finite():
		return null
	var filler: LimbFiller = LimbFiller.new()
	for segment: int in COUNT:
		var mount: int = BodyMounts.find(MOUNTS[segment])
		if mount >= 0 and p_present[segment] != 0:
			filler.set_mount(mount, p_turns[segment])
	filler.fill()
	var found: PoseSample = filler.pose()
	found.root = p_positions[0]
	if p_present[OF_LIMBS[Limbs.SPINE]] != 0:
		found.set_orientation(Limbs.SPINE, p_turns[OF_LIMBS[Limbs.SPINE]])
		found.details.measured[Limbs.SPINE] = 1
	for segment: int in OTHERS:
		if p_present[segment] != 0:
			found.details.joints[OTHERS[segment]] = p_turns[segment]
	if not p_present.has(0):
		for limb: int in Limbs.COUNT:
			found.details.positions.append(p_positions[OF_LIMBS[limb]])
	return found
