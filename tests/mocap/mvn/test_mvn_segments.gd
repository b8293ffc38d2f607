extends TestCase
## A person as MVN streams it, in each of its three kinds of pose, is that person.

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _turns: Array[Quaternion] = []
var _places: PackedVector3Array = PackedVector3Array()


func before_each() -> void:
	_random.seed = 14
	_turns.clear()
	_places.clear()
	for segment: int in MvnSegments.COUNT:
		var parts: Array[float] = []
		for part: int in 4:
			parts.append(_random.randfn())
		_turns.append(Quaternion(parts[0], parts[1], parts[2], parts[3]).normalized())
		_places.append(Vector3(_random.randfn(), _random.randfn(), _random.randfn()))


func test_type_02() -> void:
	# Godot's (x, y, z) is Xsens' (z, x, y).
	var told: PackedFloat32Array = PackedFloat32Array()
	var places: PackedVector3Array = PackedVector3Array()
	for segment: int in MvnSegments.COUNT:
		var turn: Quaternion = _turns[segment]
		told.append_array([turn.w, turn.z, turn.x, turn.y])
		places.append(Vector3(_places[segment].z, _places[segment].x, _places[segment].y))
	_check(MvnSegments.pose(told, places, SourceFrames.Frame.XSENS))


func test_type_01_is_y_up_in_centimetres() -> void:
	var told: PackedFloat32Array = PackedFloat32Array()
	var places: PackedVector3Array = PackedVector3Array()
	for segment: int in MvnSegments.COUNT:
		var turn: Quaternion = _turns[segment]
		told.append_array([turn.w, turn.x, turn.y, turn.z])
		places.append(_places[segment] * 100.0)
	_check(MvnSegments.pose(told, places, SourceFrames.Frame.MVN_Y_UP))


func test_type_05_is_local_left_handed_and_in_another_order() -> void:
	var told: PackedFloat32Array = PackedFloat32Array()
	var places: PackedVector3Array = PackedVector3Array()
	for at: int in MvnSegments.COUNT:
		var segment: int = MvnSegments.UNITY_ORDER[at]
		var above: int = MvnSegments.PARENTS[segment]
		var turn: Quaternion = _turns[segment]
		var place: Vector3 = _places[segment]
		if above >= 0:
			turn = _turns[above].inverse() * turn
			place = _turns[above].inverse() * (place - _places[above])
		told.append_array([turn.w, turn.x, -turn.y, -turn.z])
		places.append(place * Vector3(-1.0, 1.0, 1.0))
	_check(MvnSegments.pose(told, places, SourceFrames.Frame.MVN_UNITY))


func test_segments_of_both_orders_are_the_same_person() -> void:
	var seen: PackedInt32Array = MvnSegments.UNITY_ORDER.duplicate()
	seen.sort()
	equal(seen, PackedInt32Array(range(MvnSegments.COUNT)))
	for segment: int in range(1, MvnSegments.COUNT):
		is_true(MvnSegments.PARENTS[segment] < segment)
	for limb: int in Limbs.COUNT:
		var place: int = BodyMounts.find(MvnSegments.MOUNTS[MvnSegments.OF_LIMBS[limb]])
		if limb != 1:
			equal(BodyMounts.LIMBS[place], limb)


func test_missing_and_broken_segments() -> void:
	var told: PackedFloat32Array = PackedFloat32Array()
	for segment: int in MvnSegments.COUNT:
		told.append_array([1.0, 0.0, 0.0, 0.0])
	var frame: SourceFrames.Frame = SourceFrames.Frame.XSENS
	var present: PackedByteArray = PackedByteArray()
	present.resize(MvnSegments.COUNT)
	is_null(MvnSegments.pose(told, _places, frame, present), "nobody")
	present.fill(1)
	present[14] = 0
	var pose: PoseSample = MvnSegments.pose(told, _places, frame, present)
	equal(pose.details.measured[6], 0)
	equal(pose.details.positions.size(), 0)
	equal(pose.find_fault(), "")
	told[4 * 3 + 1] = NAN
	is_null(MvnSegments.pose(told, _places, frame))
	is_null(MvnSegments.pose(told.slice(0, 40), _places, frame))
	is_null(MvnSegments.pose(told, _places.slice(0, 3), frame))


func _check(p_pose: PoseSample) -> void:
	for limb: int in Limbs.COUNT:
		var segment: int = MvnSegments.OF_LIMBS[limb]
		almost_equal(p_pose.orientation(limb), _turns[segment], 1e-4, Limbs.BONES[limb])
		almost_equal(p_pose.details.positions[limb], _places[segment], 1e-4, Limbs.BONES[limb])
	almost_equal(p_pose.root, _places[0], 1e-5)
	almost_equal(
		p_pose.details.joints[XRBodyTracker.JOINT_LEFT_SHOULDER] as Quaternion, _turns[11], 1e-4
	)
