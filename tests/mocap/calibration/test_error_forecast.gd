extends TestCase
## What a calibration says of its own error is what wearers then have, and what cannot be seen is
## said.

const Fits: GDScript = preload("fits.gd")
const Wearer: GDScript = preload("wearer.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 11


func test_a_pose_alone_is_not_called_good() -> void:
	# Norths apart by 40 degrees, which nothing shows: what is usual is said, and what helps.
	var wearer: Wearer = Wearer.new()
	wearer.random = _random
	for mount: int in 17:
		var north: float = deg_to_rad(_random.randf_range(-40.0, 40.0))
		wearer.mounts.append(mount)
		wearer.feed.add_sensor(mount, wearer.any_rotation(), north)
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_POSE)
	is_false(result.is_good())
	not_equal(result.word(), "good")
	is_true(result.unseen_deg > 3.0)
	is_true(result.is_acceptable(), "the wearer can do no better in that pose")
	contains(", ".join(result.advice), "nothing shows where each sensor's north is")
	contains(", ".join(result.advice), "full")
	# Who knows that they agree can say so.
	wearer.process.options.align = CalibrationOptions.Align.COMMON
	result = wearer.calibrate(CalibrationGuide.Kind.T_POSE)
	equal(result.word(), "good")
	# And a full calibration measures them.
	wearer.process.options.align = CalibrationOptions.Align.AUTO
	result = wearer.calibrate(CalibrationGuide.Kind.FULL)
	equal(result.word(), "good")
	almost_equal(result.unseen_deg, 0.0)


func test_a_quick_reset_is_as_good_as_what_it_keeps() -> void:
	for kind: CalibrationGuide.Kind in [CalibrationGuide.Kind.T_POSE, CalibrationGuide.Kind.FULL]:
		var wearer: Wearer = _wearer(0.3)
		wearer.rate_hz = 25.0
		wearer.calibration = wearer.calibrate(kind).calibration
		var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.QUICK)
		equal(result.word() == "good", kind == CalibrationGuide.Kind.FULL, result.describe())


func test_poses_that_disagree_are_not_called_good() -> void:
	var wearer: Wearer = _wearer(0.0)
	wearer.rate_hz = 25.0
	for hold: int in 2:
		var faults: Dictionary = {}
		for mount: int in 17:
			faults[mount] = Quaternion(wearer.any_axis(), deg_to_rad(12.0))
		wearer.motion.hold_faults.append(faults)
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_TO_N)
	var poses: Array[PoseSample] = Wearer.clip_poses("01_01.bvh", 0.5, 4)
	var error: float = wearer.mean_deg(result.calibration, poses, 0.0)
	is_true(error > 6.0)
	almost_equal(result.error_deg, error, 3.0)
	not_equal(result.word(), "good")


func test_a_wrong_heading_does_as_much_as_is_forecast() -> void:
	var poses: Array[PoseSample] = []
	var steps: Dictionary[String, float] = {
		"01_01.bvh": 1.1, "01_03.bvh": 1.8, "Boxing_Toes.bvh": 1.5
	}
	for clip: String in steps:
		poses.append_array(Wearer.clip_poses(clip, steps[clip], 20))
	for pose: ResetPose.Kind in [ResetPose.Kind.T, ResetPose.Kind.N]:
		for mount: int in [0, 2, 4, 5, 9, 11, 12, 16]:
			var fit: SensorFit = Fits.on(mount)
			var held: SensorFit.Hold = Fits.hold(fit, pose, Vector3.ZERO)
			fit.heading = deg_to_rad(20.0)
			fit.start_from(held)
			var sum: float = 0.0
			for sample: PoseSample in poses:
				var limb: Quaternion = sample.orientation(BodyMounts.LIMBS[mount])
				var got: Quaternion = Rotations.yaw(-fit.heading) * limb * fit.mounting.inverse()
				sum += Rotations.between_deg(got, limb) / poses.size()
			FitSolver.solve(fit, WearerModel.new())
			fit.mounting_covariance.resize(9)
			fit.mounting_covariance.fill(0.0)
			var said: float = ErrorForecast.limb_deg(
				fit, WearerModel.new(), [deg_to_rad(20.0)], [1.0]
			)
			# A normal error of that deviation is 0.8 of it in the mean.
			almost_equal(said, 0.8 * sum, 0.25 * sum, BodyMounts.title(mount))


func test_the_mean_length_of_normal_vectors() -> void:
	# Chi with 1, 2 and 3 degrees of freedom.
	var cases: Array[Vector2] = [Vector2(1, 0.798), Vector2(2, 1.253), Vector2(3, 1.596)]
	for case: Vector2 in cases:
		var rows: Array[Vector3] = [Vector3.ZERO, Vector3.ZERO, Vector3.ZERO]
		for row: int in int(case.x):
			rows[row][row] = 4.0
		almost_equal(ErrorForecast.mean_length(rows), 2.0 * case.y, 0.02)


func _wearer(p_north: float) -> Wearer:
	var wearer: Wearer = Wearer.new()
	wearer.random = _random
	wearer.rate_hz = 25.0
	wearer.wear(PackedInt32Array(range(17)), p_north)
	return wearer
