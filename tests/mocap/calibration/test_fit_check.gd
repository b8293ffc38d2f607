extends TestCase
## Exchanged sensors are found and named by a fit check, whatever their mountings and norths.

const Wearer: GDScript = preload("../calibration/wearer.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 10


func test_every_exchange_is_found_and_named() -> void:
	# All pairs of 17 mounts, not only neighbours; 20 Hz, to be quick.
	var right: Array[MotionAxis] = []
	var wearer: Wearer = _wearer(17, 1.0)
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FIT_CHECK)
	equal(result.swaps.size(), 0, ", ".join(result.advice))
	is_true(result.is_good())
	is_null(result.calibration)
	right.resize(1)
	for first: int in 17:
		for second: int in first:
			var mounts: PackedInt32Array = wearer.mounts.duplicate()
			mounts[first] = second
			mounts[second] = first
			var axes: Dictionary[GuideMovements.Movement, MotionAxis] = wearer.process._solver.axes
			var swaps: Array[Vector2i] = FitCheck.find_swaps(mounts, axes)
			equal(swaps, [Vector2i(second, first)] as Array[Vector2i])


func test_people_who_move_more_or_less_than_asked() -> void:
	for count: int in SensorMap.LAYOUTS:
		for effort: float in [0.7, 1.3]:
			var wearer: Wearer = _wearer(count, effort)
			var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FIT_CHECK)
			var note: String = "%d sensors: %s" % [count, ", ".join(result.advice)]
			equal(result.swaps.size(), 0, note)
			equal(result.advice.size(), 0, note)
			_check_neighbours(wearer, note)


func test_the_message() -> void:
	var wearer: Wearer = _wearer(17, 1.0)
	wearer.mounts[5] = 9
	wearer.mounts[9] = 5
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FIT_CHECK)
	equal(result.advice[0], "left forearm and right forearm look swapped")
	is_false(result.is_good())


func test_two_exchanges_at_once() -> void:
	var wearer: Wearer = _wearer(17, 0.9)
	for pair: Vector2i in [Vector2i(11, 12), Vector2i(6, 10)]:
		wearer.mounts[pair.x] = pair.y
		wearer.mounts[pair.y] = pair.x
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FIT_CHECK)
	equal(result.swaps.size(), 2)
	contains(result.swaps, Vector2i(11, 12))
	contains(result.swaps, Vector2i(6, 10))


func test_a_sensor_that_is_not_worn_is_odd() -> void:
	var wearer: Wearer = _wearer(17, 1.0)
	# It lies on the table and is told to be on the left forearm.
	wearer.feed.wear(5, BodyMounts.PELVIS, Quaternion.IDENTITY)
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FIT_CHECK)
	contains(", ".join(result.advice), "left forearm did not move as asked")


func test_movements_suit_the_sensors() -> void:
	for count: int in SensorMap.LAYOUTS:
		var movements: Array = GuideMovements.informative(SensorMap.layout(count))
		equal(movements.has(GuideMovements.Movement.LEFT_SHRUG), count >= 16)
		is_true(CalibrationGuide.duration_s(CalibrationGuide.Kind.FIT_CHECK) < 45.0)


func _check_neighbours(p_wearer: Wearer, p_note: String) -> void:
	var axes: Dictionary[GuideMovements.Movement, MotionAxis] = p_wearer.process._solver.axes
	for first: int in p_wearer.mounts.size():
		for second: int in first:
			var one: int = p_wearer.mounts[first]
			var other: int = p_wearer.mounts[second]
			var near: bool = BodyMounts.PARENTS[one] == other or BodyMounts.MIRRORS[one] == other
			if not near:
				continue
			var mounts: PackedInt32Array = p_wearer.mounts.duplicate()
			mounts[first] = other
			mounts[second] = one
			var wanted: Vector2i = Vector2i(mini(one, other), maxi(one, other))
			contains(FitCheck.find_swaps(mounts, axes), wanted, p_note)


func _wearer(p_count: int, p_effort: float) -> Wearer:
	var wearer: Wearer = Wearer.new()
	wearer.random = _random
	wearer.feed.random = _random
	wearer.feed.noise_deg = 0.3
	wearer.wear(SensorMap.layout(p_count))
	wearer.rate_hz = 20.0
	wearer.motion.effort = p_effort
	wearer.motion.mounts = wearer.mounts.duplicate()
	for mount: int in wearer.mounts:
		wearer.motion.sways_deg[mount] = 3.0
	return wearer
