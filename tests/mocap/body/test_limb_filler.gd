extends TestCase
## Limbs without a sensor are filled from their neighbours, plausibly.

const CLIPS: PackedStringArray = ["01_01.bvh", "01_03.bvh", "Boxing_Toes.bvh"]

var _filler: LimbFiller = LimbFiller.new()
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 9


func test_what_is_measured_stays() -> void:
	var pose: PoseSample = _poses("01_01.bvh")[3]
	for count: int in SensorMap.LAYOUTS:
		_wear(SensorMap.layout(count), pose)
		for mount: int in SensorMap.layout(count):
			var limb: int = BodyMounts.LIMBS[mount]
			if mount != 3 and mount != 7:
				almost_equal(_filler.limbs[limb], pose.orientation(limb), 1e-5)
				equal(_filler.measured[limb], 1)


func test_standing_is_standing_with_any_layout() -> void:
	# Upright in T or N, facing anywhere: what is filled stands too.
	for count: int in SensorMap.LAYOUTS:
		for facing: float in [0.0, 1.0, 3.0, -2.0]:
			for kind: int in 2:
				_check_standing(SensorMap.layout(count), facing, kind as ResetPose.Kind)


func test_hands_and_feet_alone_are_enough_to_stand() -> void:
	# Only what comes with a headset: pelvis, chest, head, hands and feet.
	for kind: int in 2:
		_check_standing([0, 1, 2, 6, 10, 13, 16], 0.5, kind as ResetPose.Kind)
	_check_standing([2, 6, 10], 0.5, ResetPose.Kind.N)
	_check_standing([0], 0.5, ResetPose.Kind.N)


func test_joints_bend_only_as_they_can() -> void:
	for count: int in SensorMap.LAYOUTS:
		for round: int in 60:
			_filler.clear()
			for mount: int in SensorMap.layout(count):
				_filler.set_mount(mount, _any_rotation())
			_filler.fill()
			_check_joints(SensorMap.layout(count))


func test_a_forearm_held_out_bends_the_elbow() -> void:
	# As for a handshake: the forearm level, the thumb up.
	for side: float in [1.0, -1.0]:
		var fore: int = 5 if side > 0.0 else 9
		_filler.clear()
		_filler.set_mount(BodyMounts.PELVIS, Quaternion.IDENTITY)
		var hang: Quaternion = Quaternion(Vector3.BACK, -PI / 2.0 * side)
		var shake: Quaternion = Quaternion(Vector3.RIGHT, -PI / 2.0) * hang
		_filler.set_mount(fore, shake)
		_filler.fill()
		var upper: Vector3 = _filler.limbs[4 if side > 0.0 else 7] * Vector3(side, 0.0, 0.0)
		is_true(upper.y < -0.7 and upper.z > 0.2, "the upper arm points at %s" % upper)


func test_a_raised_thigh_lets_the_shank_hang() -> void:
	_filler.clear()
	_filler.set_mount(BodyMounts.PELVIS, Quaternion.IDENTITY)
	_filler.set_mount(11, Quaternion(Vector3.RIGHT, -1.2))
	_filler.fill()
	almost_equal(_filler.limbs[11] * Vector3.DOWN, Vector3.DOWN, 1e-4)
	almost_equal(_filler.limbs[12], Quaternion.IDENTITY, 1e-4)


func test_filled_clips_look_like_the_clips() -> void:
	# Mean angle between a filled limb's direction and the clip's, degrees. Hands are left out: in
	# two of the clips they stand off from the forearm all the time.
	var goals: Dictionary[StringName, float] = {
		&"Spine": 26.0,
		&"Chest": 27.0,
		&"Head": 29.0,
		&"LeftUpperArm": 50.0,
		&"RightUpperArm": 50.0,
		&"LeftUpperLeg": 24.0,
		&"RightUpperLeg": 24.0,
		&"LeftFoot": 23.0,
		&"RightFoot": 23.0,
	}
	for clip: String in CLIPS:
		for count: int in SensorMap.LAYOUTS:
			var errors: PackedFloat32Array = _mean_errors(SensorMap.layout(count), clip)
			for bone: StringName in goals:
				var off: float = errors[Limbs.find(bone)]
				var parts: Array = [clip, count, bone, off]
				is_true(off < goals[bone], "%s, %d sensors: %s is off by %f deg" % parts)


func _mean_errors(p_mounts: PackedInt32Array, p_clip: String) -> PackedFloat32Array:
	var body: BodySize = BodySize.new()
	var bases: PackedVector3Array = body.joints()
	var tails: PackedVector3Array = body.tails()
	var sums: PackedFloat32Array = PackedFloat32Array()
	sums.resize(Limbs.COUNT)
	var poses: Array[PoseSample] = _poses(p_clip)
	for pose: PoseSample in poses:
		_wear(p_mounts, pose)
		for limb: int in Limbs.COUNT:
			var along: Vector3 = tails[limb] - bases[limb]
			var got: Vector3 = _filler.limbs[limb] * along
			var off: float = got.angle_to(pose.orientation(limb) * along)
			sums[limb] += rad_to_deg(off) / poses.size()
	return sums


func _check_standing(p_mounts: PackedInt32Array, p_facing: float, p_kind: ResetPose.Kind) -> void:
	_filler.clear()
	for mount: int in p_mounts:
		_filler.set_mount(mount, Rotations.yaw(p_facing) * ResetPose.rotation(p_kind, mount))
	_filler.fill()
	for mount: int in BodyMounts.COUNT:
		var arm: bool = ResetPose.hangs(mount)
		var told: bool = p_mounts.has(mount)
		for near: int in range(4, 7) if BodyMounts.side(mount) > 0 else range(8, 11):
			told = told or p_mounts.has(near)
		# Arms of which nothing is known hang.
		var kind: ResetPose.Kind = p_kind if told or not arm else ResetPose.Kind.N
		var wanted: Quaternion = Rotations.yaw(p_facing) * ResetPose.rotation(kind, mount)
		var note: String = "%d places, %s" % [p_mounts.size(), BodyMounts.title(mount)]
		var off: float = Rotations.between_deg(_filler.rotations[mount], wanted)
		is_true(off < 9.0, "%s is off by %f deg" % [note, off])


func _check_joints(p_mounts: PackedInt32Array) -> void:
	for upper: int in [4, 8]:
		if not p_mounts.has(upper) and p_mounts.has(upper + 1):
			var turn: Quaternion = _filler.rotations[upper].inverse() * _filler.rotations[upper + 1]
			var bend: Vector3 = Rotations.vector(turn)
			almost_equal(bend.x, 0.0, 1e-3, "upper arms do not turn below the forearm")
			is_true(bend.length() < 2.62, "an elbow of %f rad" % bend.length())
	for thigh: int in [11, 14]:
		if not p_mounts.has(thigh):
			var turn: Quaternion = _filler.rotations[thigh].inverse() * _filler.rotations[thigh + 1]
			var bend: Vector3 = Rotations.vector(turn)
			almost_equal(bend.y, 0.0, 1e-3, "knees do not twist")
			almost_equal(bend.z, 0.0, 1e-3, "knees do not bend sideways")
			is_true(bend.x >= -1e-4 and bend.x < 2.62, "a knee of %f rad" % bend.x)
		if not p_mounts.has(thigh + 2):
			var ankle: float = Rotations.between_deg(
				_filler.rotations[thigh + 1], _filler.rotations[thigh + 2]
			)
			is_true(ankle < LimbFiller.ANKLE_DEG + 0.1, "an ankle of %f deg" % ankle)


func _wear(p_mounts: PackedInt32Array, p_pose: PoseSample) -> void:
	_filler.clear()
	for mount: int in p_mounts:
		_filler.set_mount(mount, p_pose.orientation(BodyMounts.LIMBS[mount]))
	_filler.fill()


func _poses(p_clip: String) -> Array[PoseSample]:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/" + p_clip)
	var poses: Array[PoseSample] = []
	for at: int in 30:
		poses.append(source.pose_at(at * 0.62))
	return poses


func _any_rotation() -> Quaternion:
	var parts: Array[float] = []
	for part: int in 4:
		parts.append(_random.randfn())
	return Quaternion(parts[0], parts[1], parts[2], parts[3]).normalized()
