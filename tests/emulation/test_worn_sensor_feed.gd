extends TestCase
## Sensors that somebody wears say how the limbs turn.

const BEGIN_USEC: int = 1700000000000000

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 5


func test_a_clip_is_measured_at_even_times() -> void:
	var feed: BvhSensorFeed = _feed()
	feed.advance(BEGIN_USEC)
	feed.advance(BEGIN_USEC + 500000)
	var frames: Array[SensorFrame] = feed.take_frames()
	equal(frames.size(), 51)
	equal(feed.take_frames().size(), 0)
	for at: int in frames.size():
		equal(frames[at].time_usec, BEGIN_USEC + at * 10000)
		equal(frames[at].counter, at)
		equal(frames[at].find_fault(), "")
		equal(frames[at].count(), 17)


func test_what_sensors_say_follows_the_limbs() -> void:
	var feed: BvhSensorFeed = _feed()
	feed.advance(BEGIN_USEC)
	feed.advance(BEGIN_USEC + 2000000)
	var frames: Array[SensorFrame] = feed.take_frames()
	for at: int in range(1, frames.size()):
		var pose: PoseSample = feed.pose_at(at / 100.0)
		var before: PoseSample = feed.pose_at((at - 1) / 100.0)
		for sensor: int in 17:
			var limb: int = BodyMounts.LIMBS[sensor]
			var turn: float = Rotations.between(pose.orientation(limb), before.orientation(limb))
			var said: Quaternion = frames[at].orientation(sensor)
			almost_equal(Rotations.between(said, frames[at - 1].orientation(sensor)), turn, 1e-4)
			almost_equal(frames[at].rates[sensor].length(), turn * 100.0, 0.02)


func test_who_stands_feels_gravity_alone() -> void:
	var feed: WornSensorFeed = _worn()
	for at: int in 3:
		feed.measure(CalibrationMotion.new().pose_at(0.0), BEGIN_USEC + at * 10000)
	var frame: SensorFrame = feed.take_frames()[2]
	for sensor: int in 17:
		var pull: Vector3 = frame.orientation(sensor) * frame.accelerations[sensor]
		almost_equal(pull, Vector3(0.0, WornSensorFeed.GRAVITY, 0.0), 1e-3)
	is_true(frame.magnetics.is_empty())


func test_a_forearm_that_turns_is_pulled_to_its_elbow() -> void:
	var feed: WornSensorFeed = _worn()
	var rate: float = 4.0
	for at: int in 50:
		var pose: PoseSample = CalibrationMotion.new().pose_at(0.0)
		pose.set_orientation(Limbs.LEFT_LOWER_ARM, Rotations.yaw(rate * at / 100.0))
		feed.measure(pose, BEGIN_USEC + at * 10000)
	var frame: SensorFrame = feed.take_frames()[40]
	var fore: int = BodyMounts.LEFT_FOREARM
	almost_equal(frame.orientation(fore) * frame.rates[fore], Vector3(0.0, rate, 0.0), 0.01)
	var pull: Vector3 = frame.orientation(fore) * frame.accelerations[fore]
	# The acceleration is that of a sample before.
	var outward: Vector3 = Rotations.yaw(rate * 0.39) * WornSensorFeed.SITS[fore]
	outward.y = 0.0
	almost_equal(pull, Vector3(0.0, 9.81, 0.0) - outward * rate * rate, 0.05)
	# The hand goes along with it, farther out.
	var hand: Vector3 = frame.accelerations[BodyMounts.LEFT_HAND]
	is_true(hand.length() > pull.length(), "%s" % hand)


func test_a_sensor_that_sits_farther_out_is_pulled_more() -> void:
	var feed: WornSensorFeed = _worn()
	feed.misplaced.resize(BodyMounts.COUNT)
	feed.misplaced[BodyMounts.LEFT_FOREARM] = WornSensorFeed.SITS[BodyMounts.LEFT_FOREARM]
	feed.acceleration_biases.resize(BodyMounts.COUNT)
	feed.acceleration_biases[BodyMounts.HEAD] = Vector3(0.3, 0.0, 0.0)
	for at: int in 50:
		var pose: PoseSample = CalibrationMotion.new().pose_at(0.0)
		pose.set_orientation(Limbs.LEFT_LOWER_ARM, Rotations.yaw(4.0 * at / 100.0))
		feed.measure(pose, BEGIN_USEC + at * 10000)
	var frame: SensorFrame = feed.take_frames()[40]
	var pull: Vector3 = frame.accelerations[BodyMounts.LEFT_FOREARM]
	var level: float = sqrt(pull.length_squared() - 9.81 * 9.81)
	almost_equal(level, 16.0 * 2.0 * WornSensorFeed.SITS[BodyMounts.LEFT_FOREARM].x, 0.05)
	var head: Vector3 = frame.accelerations[BodyMounts.HEAD]
	almost_equal(head.length(), Vector3(0.3, 9.81, 0.0).length(), 0.3)
	feed.has_rates = false
	feed.measure(CalibrationMotion.new().pose_at(0.0), BEGIN_USEC + 500000)
	is_true(feed.take_frames()[-1].accelerations.is_empty())


func test_soft_tissue_yields_to_the_limb_alike_each_time() -> void:
	var feed: WornSensorFeed = _worn()
	feed.soft_tissue_deg = 6.0
	var said: Array[SensorFrame] = []
	for tilt: float in [0.0, 1.2, 0.0, 1.2]:
		var pose: PoseSample = PoseSample.new()
		for limb: int in Limbs.COUNT:
			pose.set_orientation(limb, Quaternion(Vector3.RIGHT, tilt))
		# Slowly: swinging yields more.
		for at: int in 2:
			feed.measure(pose, BEGIN_USEC + said.size() * 100000000 + at * 10000)
		said.append(feed.take_frames()[1])
	var turns: PackedFloat32Array = []
	for sensor: int in 17:
		var turned: Quaternion = said[0].orientation(sensor).inverse() * said[1].orientation(sensor)
		turns.append(absf(Rotations.angle(turned) - 1.2))
		var again: float = Rotations.between_deg(
			said[1].orientation(sensor), said[3].orientation(sensor)
		)
		is_true(again < 0.01, "%f deg" % again)
		var upright: float = Rotations.between_deg(
			said[0].orientation(sensor), said[2].orientation(sensor)
		)
		is_true(upright < 0.01, "%f deg" % upright)
	turns.sort()
	is_true(turns[8] > deg_to_rad(1.0) and turns[16] < deg_to_rad(6.1), "%s" % turns)
	is_true(turns[16] - turns[0] > deg_to_rad(1.0), "different for each sensor")


func test_magnetometers_know_north_while_headings_drift() -> void:
	var feed: WornSensorFeed = _worn()
	feed.has_magnetics = true
	feed.drifts_deg.resize(17)
	feed.drifts_deg[2] = 1.0
	feed.disturbances[5] = Vector3(0.5, 0.0, 0.0)
	feed.measure(CalibrationMotion.new().pose_at(0.0), BEGIN_USEC)
	feed.measure(CalibrationMotion.new().pose_at(0.0), BEGIN_USEC + 20000000)
	var frame: SensorFrame = feed.take_frames()[1]
	almost_equal(frame.magnetics[3].length(), 1.0, 1e-3)
	almost_equal(frame.orientation(3) * frame.magnetics[3], WornSensorFeed.FIELD, 1e-3)
	var drifted: Vector3 = frame.orientation(2) * frame.magnetics[2]
	almost_equal(rad_to_deg(atan2(drifted.x, drifted.z)), 20.0, 0.01)
	is_true(frame.magnetics[5].length() > 1.05)
	equal(frame.find_fault(), "")


func test_list_and_silence() -> void:
	var feed: BvhSensorFeed = _feed()
	equal(feed.list_sensors()[3].state_name(), "waiting")
	feed.silent = [3]
	feed.advance(BEGIN_USEC)
	feed.advance(BEGIN_USEC + 100000)
	var sensors: Array[SensorInfo] = feed.list_sensors()
	equal(sensors.size(), 17)
	equal(sensors[0].id, "00300001")
	equal(sensors[0].state_name(), "measuring")
	almost_equal(sensors[0].rate_hz, 100.0, 0.1)
	equal(sensors[3].state_name(), "waiting")
	equal(feed.take_frames()[0].present[3], 0)
	var revision: int = feed.revision
	feed.add_sensor(BodyMounts.HEAD)
	equal(feed.revision, revision + 1)
	contains(feed.describe(), "01_01.bvh")


func test_frames_that_nobody_takes_are_bounded() -> void:
	var feed: BvhSensorFeed = _feed()
	feed.advance(BEGIN_USEC)
	feed.advance(BEGIN_USEC + 8000000)
	var frames: Array[SensorFrame] = feed.take_frames()
	equal(frames.size(), WornSensorFeed.MAX_WAITING)
	equal(frames[frames.size() - 1].time_usec, BEGIN_USEC + 8000000)


func test_faults_of_frames() -> void:
	var frame: SensorFrame = SensorFrame.new()
	frame.resize(2, true)
	equal(frame.find_fault(), "", "nobody spoke")
	frame.set_orientation(0, Quaternion.IDENTITY)
	equal(frame.find_fault(), "")
	frame.set_orientation(1, Quaternion(NAN, 0.0, 0.0, 1.0))
	contains(frame.find_fault(), "sensor 1 has no rotation")
	frame.rates.resize(3)
	contains(frame.find_fault(), "3 rates for 2 sensors")


func test_missing_clip() -> void:
	var feed: BvhSensorFeed = BvhSensorFeed.new()
	feed.open("res://assets/motion/missing.bvh", [0])
	contains(feed.error, "missing.bvh")
	feed.advance(BEGIN_USEC)
	equal(feed.take_frames().size(), 0)


func _feed() -> BvhSensorFeed:
	var feed: BvhSensorFeed = BvhSensorFeed.new()
	feed.open("res://assets/motion/01_01.bvh", PackedInt32Array(range(17)), _random)
	equal(feed.error, "")
	return feed


func _worn() -> WornSensorFeed:
	var feed: WornSensorFeed = WornSensorFeed.new()
	for mount: int in BodyMounts.COUNT:
		feed.add_sensor(mount)
	return feed
