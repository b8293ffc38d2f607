extends TestCase
## How exactly somebody holds poses and moves is learnt from that wearer's own calibration.

const Fits: GDScript = preload("fits.gd")
const T: ResetPose.Kind = ResetPose.Kind.T
const N: ResetPose.Kind = ResetPose.Kind.N

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 5


func test_exact_and_careless_wearers_are_distinguished() -> void:
	var before: float = 0.0
	for off_deg: float in [0.3, 1.0, 2.0, 4.0, 6.0]:
		var model: WearerModel = WearerModel.new()
		model.learn(_wearers(off_deg))
		for mount: int in [BodyMounts.LEFT_HAND, BodyMounts.PELVIS]:
			var found: float = rad_to_deg(sqrt(model.base_variance(mount)))
			almost_equal(found, off_deg, 0.3 * off_deg + 0.6)
		is_true(model.base_variance(BodyMounts.PELVIS) > before)
		before = model.base_variance(BodyMounts.PELVIS)


func test_one_limb_that_stepped_says_nothing_of_the_wearer() -> void:
	var fits: Array[SensorFit] = _wearers(1.0)
	var model: WearerModel = WearerModel.new()
	model.learn(fits)
	var before: float = model.base_variance(BodyMounts.PELVIS)
	var stepped: SensorFit = Fits.on(BodyMounts.LEFT_FOOT)
	Fits.hold(stepped, T, Vector3.ZERO)
	Fits.hold(stepped, N, Vector3(0.0, 40.0, 0.0))
	fits.append(stepped)
	model.learn(fits)
	is_true(model.base_variance(BodyMounts.PELVIS) <= before * 1.01)


func test_what_is_off_anew_becomes_less_by_holding_again() -> void:
	for is_anew: bool in [false, true]:
		var fits: Array[SensorFit] = []
		for mount: int in BodyMounts.COUNT:
			var fit: SensorFit = Fits.on(mount)
			for pose: ResetPose.Kind in [T, N]:
				var off: Vector3 = _any(3.0)
				Fits.hold(fit, pose, off)
				Fits.hold(fit, pose, _any(3.0) if is_anew else off)
			fits.append(fit)
		var model: WearerModel = WearerModel.new()
		model.learn(fits)
		var pelvis: SensorFit = fits[BodyMounts.PELVIS]
		# Two holds of a pose together: half of what one alone may be off.
		var both: float = model.pose_variance(pelvis, pelvis.holds[0]).x / 2.0
		almost_equal(rad_to_deg(sqrt(both)), 2.1 if is_anew else 3.0, 0.8)


func test_arms_that_all_stay_up_count_against_the_pose_with_hanging_arms() -> void:
	var fits: Array[SensorFit] = []
	for mount: int in BodyMounts.COUNT:
		var fit: SensorFit = Fits.on(mount)
		Fits.hold(fit, T, _any(1.0))
		var up: Vector3 = Vector3(0.0, 0.0, 12.0 * BodyMounts.side(mount))
		Fits.hold(fit, N, _any(1.0) + (up if ResetPose.hangs(mount) else Vector3.ZERO))
		fits.append(fit)
	var model: WearerModel = WearerModel.new()
	model.learn(fits)
	for fit: SensorFit in fits:
		var high: float = model.pose_variance(fit, fit.hold(T)).z
		var low: float = model.pose_variance(fit, fit.hold(N)).z
		is_true(low > 10.0 * high if ResetPose.hangs(fit.mount) else is_equal_approx(low, high))


func test_whether_movements_go_about_axes_of_limbs() -> void:
	for is_hinged: bool in [false, true]:
		var fits: Array[SensorFit] = []
		for mount: int in BodyMounts.COUNT:
			var fit: SensorFit = Fits.on(mount)
			Fits.hold(fit, T, _any(4.0))
			var off: Vector3 = _any(4.0)
			Fits.hold(fit, N, off)
			var asked: Quaternion = ResetPose.rotation(N, mount)
			var askew: Vector3 = _any(0.5)
			Fits.turn(fit, Vector3.RIGHT, askew + asked * off if is_hinged else askew)
			fits.append(fit)
		var model: WearerModel = WearerModel.new()
		model.learn(fits)
		is_true(model.hinge > 0.6 if is_hinged else model.hinge < 0.3, "%f" % model.hinge)


func test_movements_that_are_askew_say_less() -> void:
	var found: PackedFloat64Array = []
	for askew_deg: float in [0.5, 6.0]:
		var fits: Array[SensorFit] = _wearers(0.5)
		for fit: SensorFit in fits:
			Fits.turn(fit, Vector3.RIGHT, _any(askew_deg))
		var model: WearerModel = WearerModel.new()
		model.learn(fits)
		found.append(rad_to_deg(sqrt(model.axis_variance(fits[0].turns[0]))))
	is_true(found[0] < 1.5 and found[1] > 4.0, "%s" % found)
	# And small movements less than large ones.
	var small: SensorFit.Turn = SensorFit.Turn.new()
	small.angle = 0.2
	var large: SensorFit.Turn = SensorFit.Turn.new()
	large.angle = 1.2
	var usual: WearerModel = WearerModel.new()
	is_true(usual.axis_variance(small) > 3.0 * usual.axis_variance(large))


func test_one_pose_is_judged_by_an_older_calibration() -> void:
	var found: PackedFloat64Array = []
	for off_deg: float in [1.0, 5.0]:
		var offs: Dictionary[SensorFit, Vector3] = {}
		for mount: int in BodyMounts.COUNT:
			offs[Fits.on(mount)] = _any(off_deg) * (PI / 180.0)
		var model: WearerModel = WearerModel.new()
		model.learn_from_old(offs)
		found.append(rad_to_deg(sqrt(model.base_variance(BodyMounts.PELVIS))))
	# The older one is off as well, so that one pose is a little less.
	almost_equal(found[0], 0.9, 0.5)
	almost_equal(found[1], 4.1, 0.8)


## A sensor on each mount, that is off in each pose at random, degrees about each axis.
func _wearers(p_off_deg: float) -> Array[SensorFit]:
	var fits: Array[SensorFit] = []
	for mount: int in BodyMounts.COUNT:
		var fit: SensorFit = Fits.on(mount)
		Fits.hold(fit, T, _any(p_off_deg))
		Fits.hold(fit, N, _any(p_off_deg))
		fits.append(fit)
	return fits


func _any(p_deg: float) -> Vector3:
	return Vector3(_random.randfn(), _random.randfn(), _random.randfn()) * p_deg
