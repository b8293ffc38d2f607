extends TestCase
## A wearer who is alone shakes a hand; nothing else that people do is taken for that.

const BEGIN_USEC: int = 1700000000000000

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 4


## How often the gesture was noticed in a motion: [code]func(seconds) -> PoseSample[/code].
func _noticed(p_motion: Callable, p_seconds: float) -> int:
	var feed: WornSensorFeed = WornSensorFeed.new()
	for mount: int in BodyMounts.COUNT:
		var axis: Vector3 = (
			Vector3(_random.randfn(), _random.randfn(), _random.randfn()).normalized()
		)
		feed.add_sensor(mount, Quaternion(axis, _random.randf() * PI), _random.randf() * TAU)
	var gesture: ShakeGesture = ShakeGesture.new()
	var count: int = 0
	for at: int in roundi(p_seconds * 100.0):
		feed.measure(p_motion.call(at / 100.0), BEGIN_USEC + at * 10000)
		for frame: SensorFrame in feed.take_frames():
			count += 1 if gesture.add(frame) else 0
	return count


static func _stand() -> PoseSample:
	return CalibrationGuide.countdown(ResetPose.Kind.N).pose_at(0.0)


func test_a_hand_that_is_shaken_is_noticed_once() -> void:
	for hertz: float in [2.0, 3.0, 4.0]:
		var motion: Callable = func(time_s: float) -> PoseSample:
			var pose: PoseSample = _stand()
			if time_s > 1.0 and time_s < 1.0 + 4.5 / hertz:
				var turn: float = 0.6 * sin(TAU * hertz * time_s)
				for limb: int in [Limbs.LEFT_LOWER_ARM, Limbs.LEFT_HAND]:
					pose.set_orientation(
						limb, pose.orientation(limb) * Quaternion(Vector3.RIGHT, turn)
					)
			return pose
		equal(_noticed(motion, 5.0), 1, "at %.0f Hz" % hertz)


func test_walking_boxing_and_calibrating_are_no_gesture() -> void:
	for file: String in ["01_01.bvh", "01_03.bvh", "Boxing_Toes.bvh"]:
		var source: BvhSource = BvhSource.new()
		source.open("res://assets/motion/" + file)
		equal(_noticed(source.pose_at, 10.0), 0, file)
	var motion: CalibrationMotion = CalibrationMotion.new()
	motion.kind = CalibrationGuide.Kind.FIT_CHECK
	equal(_noticed(motion.pose_at, 30.0), 0)
