extends TestCase
## Exchanged sensors are found and named by a fit check, whatever their mountings and norths.

const Wearer: GDScript = preload("../calibration/wearer.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 10


func test_any_order_is_found_in_one_round() -> void:
	# 20 Hz, to be quick: one round is judged as if the sensors had been put on in many orders.
	for count: int in [6, 10, 13, 17]:
		for effort: float in [0.7, 1.3]:
			var wearer: Wearer = _wearer(count, effort)
			var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FIT_CHECK)
			var note: String = "%d sensors: %s" % [count, ", ".join(result.advice)]
			equal(result.assignment, wearer.mounts, note)
			equal(result.advice.size(), 0, note)
			is_true(result.is_good(), note)
			is_null(result.calibration)
			var axes: Dictionary[GuideMovements.Movement, MotionAxis] = wearer.process._solver.axes
			for _order: int in 4:
				var told: PackedInt32Array = _shuffled(wearer.mounts)
				equal(FitCheck.new(told, axes).assign(), wearer.mounts, note)


func test_every_exchange_of_neighbours() -> void:
	var wearer: Wearer = _wearer(17, 0.8)
	wearer.calibrate(CalibrationGuide.Kind.FIT_CHECK)
	var axes: Dictionary[GuideMovements.Movement, MotionAxis] = wearer.process._solver.axes
	for mount: int in range(1, 17):
		for other: int in [BodyMounts.PARENTS[mount], BodyMounts.MIRRORS[mount]]:
			var mounts: PackedInt32Array = wearer.mounts.duplicate()
			mounts[mount] = other
			mounts[other] = mount
			equal(FitCheck.new(mounts, axes).assign(), wearer.mounts)


func test_how_sure_it_is() -> void:
	var wearer: Wearer = _wearer(17, 1.0)
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FIT_CHECK)
	for sure: float in result.confidences:
		is_true(sure > FitCheck.SURE and sure <= 1.0)
	# Nobody moved: everything may be anywhere.
	wearer = _wearer(17, 0.0)
	result = wearer.calibrate(CalibrationGuide.Kind.FIT_CHECK)
	is_true(result.confidences[5] < FitCheck.SURE)


func test_more_sensors_than_mounts() -> void:
	var wearer: Wearer = _wearer(10, 0.9)
	for _spare: int in 2:
		wearer.lie_about.append(wearer.feed.add_sensor(0, wearer.any_rotation()))
	var truth: PackedInt32Array = wearer.mounts.duplicate()
	truth.append_array([-1, -1])
	# The first ones were told to lie about.
	wearer.mounts = PackedInt32Array([-1, -1])
	wearer.mounts.append_array(truth.slice(0, 10))
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FIT_CHECK)
	equal(result.assignment, truth)
	is_true(result.is_reassigned())
	contains(result.advice[0], "sensors are worn elsewhere: pelvis (was not worn)")


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
	equal(result.exchanges().size(), 2)
	contains(result.exchanges(), Vector2i(11, 12))
	contains(result.exchanges(), Vector2i(6, 10))


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


func _shuffled(p_mounts: PackedInt32Array) -> PackedInt32Array:
	var mounts: Array = Array(p_mounts)
	for at: int in range(mounts.size() - 1, 0, -1):
		var other: int = _random.randi() % (at + 1)
		var mount: int = mounts[at]
		mounts[at] = mounts[other]
		mounts[other] = mount
	return PackedInt32Array(mounts)


func _wearer(p_count: int, p_effort: float) -> Wearer:
	var wearer: Wearer = Wearer.new()
	wearer.random = _random
	wearer.feed.noise_deg = 0.3
	wearer.wear(SensorMap.layout(p_count))
	wearer.rate_hz = 20.0
	wearer.motion.effort = p_effort
	wearer.motion.mounts = wearer.mounts.duplicate()
	for mount: int in wearer.mounts:
		wearer.motion.sways_deg[mount] = 3.0
	return wearer
