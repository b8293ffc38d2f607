extends TestCase
## Heading and mounting of one sensor, from poses and movements.

const Fits: GDScript = preload("fits.gd")
const T: ResetPose.Kind = ResetPose.Kind.T
const N: ResetPose.Kind = ResetPose.Kind.N

var _mounting: Quaternion = Quaternion(Vector3(1.0, -2.0, 0.5).normalized(), 2.1)


func test_who_does_all_as_asked_is_calibrated_exactly() -> void:
	for mount: int in [BodyMounts.PELVIS, BodyMounts.LEFT_FOREARM, BodyMounts.RIGHT_SHANK]:
		var fit: SensorFit = Fits.on(mount)
		for pose: ResetPose.Kind in [T, N]:
			Fits.hold(fit, pose, Vector3.ZERO, 2.5, _mounting)
		Fits.turn(fit, Vector3.RIGHT, Vector3.ZERO, 2.5)
		fit.heading = fit.estimate_heading()
		almost_equal(angle_difference(fit.heading, 2.5), 0.0, 1e-4)
		fit.start_from(fit.hold(T))
		FitSolver.solve(fit, WearerModel.new())
		almost_equal(angle_difference(fit.heading, 2.5), 0.0, 1e-4)
		almost_equal(Rotations.between_deg(fit.mounting, _mounting), 0.0, 0.01)
		almost_equal(fit.fault(fit.hold(N)), Vector3.ZERO, 1e-4)
		almost_equal(fit.deviation(fit.turns[0]), Vector2.ZERO, 1e-4)


func test_poses_that_are_off_to_either_side_cancel() -> void:
	var fit: SensorFit = Fits.on(BodyMounts.STERNUM)
	Fits.hold(fit, T, Vector3(6.0, -3.0, 4.0), 0.7, _mounting)
	Fits.hold(fit, N, Vector3(-6.0, 3.0, -4.0), 0.7, _mounting)
	_solve(fit, WearerModel.new(), 0.7)
	almost_equal(Rotations.between_deg(fit.mounting, _mounting), 0.0, 0.05)
	almost_equal(fit.fault(fit.hold(T)) * 180.0 / PI, Vector3(6.0, -3.0, 4.0), 0.05)
	# Half of the variance of one pose is left.
	var one: float = WearerModel.new().pose_variance(fit, fit.hold(T)).x
	almost_equal(fit.mounting_covariance[0], one / 2.0, 1e-6)


func test_a_pose_that_was_not_held_still_counts_less() -> void:
	var fit: SensorFit = Fits.on(BodyMounts.LEFT_THIGH)
	Fits.hold(fit, T, Vector3.ZERO, 0.0, _mounting)
	Fits.hold(fit, N, Vector3(10.0, 0.0, 0.0), 0.0, _mounting).movement = deg_to_rad(30.0)
	_solve(fit, WearerModel.new(), 0.0)
	is_true(Rotations.between_deg(fit.mounting, _mounting) < 1.0)


func test_a_pose_that_is_held_again_just_alike_tells_nothing_new() -> void:
	var found: PackedFloat64Array = []
	for times: int in [1, 3]:
		var fit: SensorFit = Fits.on(BodyMounts.HEAD)
		for _time: int in times:
			Fits.hold(fit, T, Vector3(8.0, 0.0, 0.0), 0.0, _mounting)
		Fits.hold(fit, N, Vector3.ZERO, 0.0, _mounting)
		_solve(fit, WearerModel.new(), 0.0)
		found.append(Rotations.between_deg(fit.mounting, _mounting))
	almost_equal(found[0], 4.0, 0.05)
	almost_equal(found[1], found[0], 0.05)


func test_the_axis_of_a_hinge_puts_the_mounting_right() -> void:
	# A shank that leans to the side in both poses: only how its knee bends can show that.
	for hinge: float in [0.0, 1.0]:
		var fit: SensorFit = Fits.on(BodyMounts.LEFT_SHANK)
		for pose: ResetPose.Kind in [T, N]:
			Fits.hold(fit, pose, Vector3(0.0, 0.0, 6.0), 0.0, _mounting)
		Fits.turn(fit, Vector3.RIGHT, Vector3(0.0, 0.0, 6.0) * hinge)
		var model: WearerModel = WearerModel.new()
		model.hinge = hinge
		model.hinge_variance = 0.0
		_solve(fit, model, 0.0)
		var left: float = Rotations.between_deg(fit.mounting, _mounting)
		is_true(left < 5.0 if hinge > 0.5 else left > 5.9, "hinge %f: %f deg" % [hinge, left])


func test_without_movements_no_heading_is_known() -> void:
	var fit: SensorFit = Fits.on(BodyMounts.PELVIS)
	Fits.hold(fit, T, Vector3.ZERO, 1.0, _mounting)
	Fits.hold(fit, N, Vector3.ZERO, 1.0, _mounting)
	is_true(is_nan(fit.estimate_heading()))
	fit.start_from(fit.hold(T))
	FitSolver.solve(fit, WearerModel.new())
	equal(fit.heading_variance, INF)
	# One that it is given is taken, and the pose kept.
	FitSolver.solve_for(fit, WearerModel.new(), 1.0)
	almost_equal(Rotations.between_deg(fit.mounting, _mounting), 0.0, 0.05)


func test_the_arms_way_down_shows_their_heading() -> void:
	for mount: int in [BodyMounts.LEFT_HAND, BodyMounts.RIGHT_UPPER_ARM]:
		var fit: SensorFit = Fits.on(mount)
		Fits.hold(fit, T, Vector3.ZERO, -2.0, _mounting)
		Fits.hold(fit, N, Vector3.ZERO, -2.0, _mounting)
		almost_equal(angle_difference(fit.estimate_heading(), -2.0), 0.0, 1e-4)
		fit.heading = -1.8
		fit.start_from(fit.hold(T))
		FitSolver.solve(fit, WearerModel.new())
		almost_equal(angle_difference(fit.heading, -2.0), 0.0, 0.002)


func test_more_movements_show_a_heading_better() -> void:
	var before: float = INF
	for number: int in 4:
		var fit: SensorFit = Fits.on(BodyMounts.RIGHT_FOOT)
		Fits.hold(fit, T, Vector3.ZERO, 0.3)
		for _turn: int in number:
			Fits.turn(fit, Vector3.RIGHT, Vector3.ZERO, 0.3)
		fit.heading = 0.3
		fit.start_from(fit.hold(T))
		FitSolver.solve(fit, WearerModel.new())
		is_true(number == 0 or fit.heading_variance < before * 0.9)
		before = fit.heading_variance


func _solve(r_fit: SensorFit, p_model: WearerModel, p_heading: float) -> void:
	r_fit.heading = p_heading
	r_fit.start_from(r_fit.hold(T))
	FitSolver.solve_for(r_fit, p_model, p_heading)
