extends TestCase
## Whatever the mountings, norths and facings: calibrated sensors say what the limbs do.

const Wearer: GDScript = preload("wearer.gd")
const CLIPS: PackedStringArray = ["01_01.bvh", "01_03.bvh", "Boxing_Toes.bvh"]
const EXACT_DEG: float = 0.05

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 6


func test_one_sided_form_for_who_faces_north() -> void:
	# Thesis 6.1: with q' = s0^-1 the limb is s q'. All sensors have the same north, which the
	# wearer faces.
	for kind: CalibrationGuide.Kind in [CalibrationGuide.Kind.T_POSE, CalibrationGuide.Kind.N_POSE]:
		var wearer: Wearer = _wearer(0.0)
		wearer.process.options.facing = CalibrationOptions.Facing.NORTH
		var result: CalibrationResult = wearer.calibrate(kind)
		_check(wearer, result, 0.0, "north")
		for pose: PoseSample in Wearer.clip_poses(CLIPS[0], 1.0, 3):
			var reset: PoseSample = CalibrationMotion.new().pose_at(0.0)
			var zero: Array[Quaternion] = _said(wearer, reset)
			var said: Array[Quaternion] = _said(wearer, pose)
			var got: Array[Quaternion] = wearer.rotations(result.calibration, pose)
			for sensor: int in 17:
				var wanted: Quaternion = said[sensor] * zero[sensor].inverse()
				is_true(Rotations.between_deg(got[sensor], wanted) < EXACT_DEG)


func test_who_does_something_else_is_not_told_that_sensors_are_elsewhere() -> void:
	for late_s: float in [2.5, 5.0]:
		var wearer: Wearer = _wearer(NAN)
		# The wearer begins that much too late.
		wearer.motion.lead_s = late_s
		var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FULL)
		is_false(result.is_reassigned(), "%.1f s late" % late_s)
		is_false(result.is_good())
		var text: String = ", ".join(result.advice)
		is_true(text.contains("follow the figure") or text.contains("in the other pose"), text)


func test_facing_by_compass() -> void:
	for round: int in 6:
		var wearer: Wearer = _wearer(0.0)
		var compass: float = _random.randf_range(-180.0, 180.0)
		wearer.motion.facing = -deg_to_rad(compass)
		wearer.process.options.facing = CalibrationOptions.Facing.HEADING
		wearer.process.options.heading_deg = compass
		var result: CalibrationResult = wearer.calibrate(round % 2)
		_check(wearer, result, wearer.motion.facing, "compass %f" % compass)


func test_facing_from_the_arms() -> void:
	for round: int in 6:
		var wearer: Wearer = _wearer(_random.randf_range(-PI, PI))
		wearer.motion.facing = _random.randf_range(-PI, PI)
		wearer.process.options.pose = round % 2
		var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_TO_N)
		equal(result.advice.size(), 0, ", ".join(result.advice))
		_check(wearer, result, wearer.motion.facing, "from the arms")


func test_any_north_of_each_sensor() -> void:
	for round: int in 6:
		var wearer: Wearer = _wearer(NAN)
		wearer.motion.facing = _random.randf_range(-PI, PI)
		var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FULL)
		is_true(result.is_good())
		contains(result.advice[0], "the norths of the sensors differ")
		contains(result.advice[0], "each got its own")
		_check(wearer, result, wearer.motion.facing, "own norths")
		is_true(result.find(BodyMounts.PELVIS).is_heading_measured)


func test_norths_that_are_mirrored_are_no_arms_that_come_down_ahead() -> void:
	var wearer: Wearer = Wearer.new()
	wearer.random = _random
	wearer.rate_hz = 40.0
	for mount: int in 17:
		wearer.mounts.append(mount)
		var north: float = 0.5 + 1.2 * BodyMounts.side(mount)
		wearer.feed.add_sensor(mount, wearer.any_rotation(), north)
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_TO_N)
	for mount: int in [4, 5, 6, 8, 9, 10]:
		var found: float = deg_to_rad(result.find(mount).heading_deg)
		var off: float = angle_difference(0.5 + 1.2 * BodyMounts.side(mount), found)
		is_true(absf(off) < 0.25, "%s: %.0f deg" % [BodyMounts.title(mount), rad_to_deg(off)])


func test_a_quick_reset_keeps_the_axes_and_takes_the_new_front() -> void:
	for round: int in 6:
		var wearer: Wearer = _wearer(NAN)
		wearer.motion.facing = _random.randf_range(-PI, PI)
		wearer.calibration = wearer.calibrate(CalibrationGuide.Kind.FULL).calibration
		# Straps slip, and the wearer faces elsewhere.
		wearer.motion.facing = _random.randf_range(-PI, PI)
		var limb: int = 5
		var slip: Quaternion = Quaternion(Vector3.RIGHT, 0.6)
		wearer.feed.wear(limb, wearer.mounts[limb], slip * wearer.feed._mountings[limb])
		var begin: int = wearer.now_usec
		var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.QUICK)
		is_true(wearer.now_usec - begin <= 1100000, "a second")
		_check(wearer, result, wearer.motion.facing, "quick")


func test_slower_feeds() -> void:
	for rate: float in [20.0, 60.0, 240.0]:
		var wearer: Wearer = _wearer(NAN)
		wearer.rate_hz = rate
		var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FULL)
		_check(wearer, result, 0.0, "%f Hz" % rate)


func test_noise_hardly_matters() -> void:
	var wearer: Wearer = _wearer(NAN)
	wearer.feed.noise_deg = 0.5
	wearer.motion.facing = 1.0
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FULL)
	is_true(result.is_good(), ", ".join(result.advice))
	wearer.feed.noise_deg = 0.0
	var poses: Array[PoseSample] = Wearer.clip_poses(CLIPS[0], 0.5, 8)
	var off: float = wearer.worst_deg(result.calibration, poses, 1.0)
	is_true(off < 1.3, "%f deg" % off)


func test_turning_the_front_later() -> void:
	var wearer: Wearer = _wearer(NAN)
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FULL)
	result.calibration.turn(0.7)
	_check(wearer, result, -0.7, "turned")


func _wearer(p_north: float) -> Wearer:
	var wearer: Wearer = Wearer.new()
	wearer.random = _random
	wearer.rate_hz = 40.0
	wearer.wear(PackedInt32Array(range(17)), p_north)
	return wearer


func _said(p_wearer: Wearer, p_pose: PoseSample) -> Array[Quaternion]:
	p_wearer.feed.measure(p_pose, p_wearer.now_usec)
	var frame: SensorFrame = p_wearer.feed.take_frames()[0]
	var said: Array[Quaternion] = []
	for sensor: int in frame.count():
		said.append(frame.orientation(sensor))
	return said


func _check(p_wearer: Wearer, p_result: CalibrationResult, p_front: float, p_note: String) -> void:
	equal(p_result.error, "", p_note)
	for clip: String in CLIPS:
		var poses: Array[PoseSample] = Wearer.clip_poses(clip, 0.77, 6)
		var off: float = p_wearer.worst_deg(p_result.calibration, poses, p_front)
		is_true(off < EXACT_DEG, "%s, %s: %f deg" % [p_note, clip, off])
