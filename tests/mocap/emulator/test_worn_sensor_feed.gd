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
			var gravity: Vector3 = said * frames[at].accelerations[sensor]
			almost_equal(gravity, Vector3(0.0, WornSensorFeed.GRAVITY, 0.0), 1e-3)


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
