extends TestCase
## A worn suit becomes the motion of a person.

const BEGIN_USEC: int = 1700000000000000

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _feed: BvhSensorFeed = null
var _suit: SuitSource = null
var _now_usec: int = 0


func before_each() -> void:
	_random.seed = 12
	_feed = BvhSensorFeed.new()
	_feed.open("res://assets/motion/01_01.bvh", PackedInt32Array(range(17)), _random)
	var motion: CalibrationMotion = CalibrationMotion.new()
	motion.kind = CalibrationGuide.Kind.FULL
	motion.facing = 0.8
	_feed.prelude = motion
	_feed.prelude_s = CalibrationGuide.duration_s(CalibrationGuide.Kind.FULL)
	_suit = SuitSource.new(_feed)
	_now_usec = BEGIN_USEC


func test_the_clip_comes_out_as_it_went_in() -> void:
	_calibrate()
	_go(0.1)
	var compared: int = 0
	for step: int in 200:
		_go(0.02)
		var sample: PoseSample = _suit.sample(_now_usec)
		var passed: float = (sample.time_usec - _feed._start_usec) / 1e6
		# Between two measurements it is between what they said.
		var first: int = floori(passed * 100.0 + 1e-6)
		var before: PoseSample = _feed.pose_at(first / 100.0)
		var after: PoseSample = _feed.pose_at((first + 1) / 100.0)
		equal(sample.id, step)
		equal(sample.find_fault(), "")
		for limb: int in Limbs.COUNT:
			if limb == 1:
				continue
			var wanted: Quaternion = before.orientation(limb).slerp(
				after.orientation(limb), passed * 100.0 - first
			)
			var turned: Quaternion = Rotations.yaw(-0.8) * wanted
			var off: float = Rotations.between_deg(sample.orientation(limb), turned)
			is_true(off < 0.05, "%s is off by %f deg" % [Limbs.BONES[limb], off])
			compared += 1
		almost_equal(Vector2(sample.root.x, sample.root.z), Vector2.ZERO)
		var high: float = sample.root.y / _suit.get_hip_height()
		is_true(high > 0.6 and high < 1.15, "the hips are at %f" % high)
	equal(compared, 200 * 15)


func test_a_program_that_stands_still_for_seconds_calibrates_as_well() -> void:
	equal(_suit.start_calibration(CalibrationGuide.Kind.FULL, _now_usec / 1e6), "")
	while _suit.process.is_running():
		# Frames come evenly, but are looked at once in 1.7 s.
		for _step: int in 34:
			_now_usec += 50000
			_feed.advance(_now_usec)
		_suit.advance(_now_usec / 1e6)
	var result: CalibrationResult = _suit.process.result
	equal(result.error, "")
	is_true(result.error_deg < 2.0, "%f deg" % result.error_deg)
	for place: CalibrationResult.PlaceQuality in result.mounts:
		is_true(place.movement_deg < 1.0, "%s moved" % BodyMounts.title(place.mount))


func test_samples_have_the_time_of_their_measurement_and_come_once() -> void:
	_calibrate()
	_go(0.1)
	var sample: PoseSample = _suit.sample(_now_usec + 5000)
	is_true(sample.time_usec <= _now_usec and sample.time_usec > _now_usec - 10000)
	is_null(_suit.sample(_now_usec + 5000), "nothing newer")
	not_null(_suit.sample(_now_usec + 40000), "guessed on for a while")
	is_null(_suit.sample(_now_usec + 200000) if _suit.sample(_now_usec + 150000) else null)
	_go(0.3)
	not_null(_suit.sample(_now_usec))


func test_nothing_before_calibration() -> void:
	_go(1.0)
	is_null(_suit.sample(_now_usec))
	is_false(_suit.is_calibrated())


func test_the_old_calibration_stays_until_the_new_one_is_accepted() -> void:
	_calibrate()
	var old: Calibration = _suit.get_profile().calibration
	equal(_suit.start_calibration(CalibrationGuide.Kind.T_POSE, _now_usec / 1e6), "")
	_go(1.0)
	not_null(_suit.sample(_now_usec), "goes on meanwhile")
	_go(5.0)
	equal(_suit.process.phase, CalibrationProcess.Phase.DONE)
	is_true(_suit.get_profile().calibration == old)
	is_false(_suit.process.result.is_good(), "somebody walks")
	_suit.refuse_calibration()
	is_true(_suit.get_profile().calibration == old)


func test_a_result_is_shown_before_it_is_accepted() -> void:
	_suit.start_calibration(CalibrationGuide.Kind.FULL, _now_usec / 1e6)
	_go(_feed.prelude_s + 1.0)
	is_null(_suit.sample(_now_usec))
	not_null(_suit.newest_pose)
	_suit.refuse_calibration()
	_go(0.1)
	is_null(_suit.newest_pose)


func test_the_body_goes_over_to_another_calibration() -> void:
	_calibrate()
	_go(0.1)
	var before: PoseSample = _suit.sample(_now_usec)
	var other: Calibration = _suit.get_profile().calibration
	other.turn(PI / 2.0)
	_suit.set_calibration(other)
	var steps: int = 0
	for step: int in 40:
		_go(0.02)
		var pose: PoseSample = _suit.sample(_now_usec)
		if pose == null:
			continue
		var turned: float = Rotations.between_deg(before.orientation(0), pose.orientation(0))
		is_true(turned < 12.0, "turned by %f deg at once" % turned)
		before = pose
		steps += 1
	is_true(steps > 30)


func test_a_silent_sensor_is_filled_from_its_neighbours() -> void:
	_calibrate()
	_go(0.1)
	equal(_suit.sample(_now_usec).details.measured[5], 1)
	_feed.silent = [5]
	_go(0.3)
	equal(_suit.sample(_now_usec).details.measured[5], 1, "it keeps what it said for a while")
	_go(0.5)
	var sample: PoseSample = _suit.sample(_now_usec)
	equal(sample.details.measured[5], 0)
	almost_equal(sample.orientation(5), sample.orientation(6), 1e-5, "as the hand")
	_feed.silent = []
	_go(0.1)
	equal(_suit.sample(_now_usec).details.measured[5], 1)


func test_rates_are_those_of_the_limbs() -> void:
	_calibrate()
	_go(0.5)
	var before: PoseSample = _suit.sample(_now_usec)
	_go(0.01)
	var after: PoseSample = _suit.sample(_now_usec)
	for limb: int in Limbs.COUNT:
		if limb == 1:
			continue
		var turn: Quaternion = after.orientation(limb) * before.orientation(limb).inverse()
		var rate: Vector3 = Rotations.vector(turn) * 100.0
		almost_equal(after.details.rates[limb], rate, 0.05, Limbs.BONES[limb])


func test_sensors_that_come_later() -> void:
	_calibrate()
	_go(0.1)
	_feed.add_sensor(BodyMounts.HEAD, Quaternion.IDENTITY, 0.0, "new")
	_go(0.1)
	not_null(_suit.sample(_now_usec))
	equal(_suit.newest_frame.count(), 18)


func test_broken_frames_are_dropped() -> void:
	_calibrate()
	_go(0.1)
	_suit.sample(_now_usec)
	var frame: SensorFrame = SensorFrame.new()
	frame.resize(17)
	frame.present.fill(1)
	_feed._waiting.append(frame)
	var short: SensorFrame = SensorFrame.new()
	short.resize(1)
	short.time_usec = _now_usec
	_feed._waiting.append(short)
	not_null(_suit.sample(_now_usec))
	equal(_suit.faulty_frames(), 1)


func test_sampled_by_a_thread_while_shown_by_another() -> void:
	_calibrate()
	var sampler: MotionSampler = MotionSampler.new()
	var delivered: Array[PoseSample] = []
	sampler.add_source(0, _suit)
	sampler.start(200.0, func(samples: Array[PoseSample]) -> void: delivered.append_array(samples))
	for step: int in 6000:
		_go(0.01)
		OS.delay_usec(500)
		# The thread of a busy machine may come late.
		if step >= 200 and sampler.stats(0)["samples"] > 3:
			break
	sampler.stop()
	is_true(delivered.size() > 3)
	for at: int in range(1, delivered.size()):
		is_true(delivered[at].time_usec > delivered[at - 1].time_usec)


func test_another_suit_than_last_time() -> void:
	var profile: PersonProfile = PersonProfile.new()
	profile.map.assign("00999999", BodyMounts.PELVIS)
	_suit.set_profile(profile)
	_go(0.1)
	equal(_suit.get_profile().map.mounts.size(), 17)
	_calibrate()
	_go(0.1)
	not_null(_suit.newest_pose)


func test_who_wears_it() -> void:
	_calibrate()
	var profile: PersonProfile = PersonProfile.new()
	profile.name = "Anna"
	profile.size.set_height(1.5)
	profile.map = _suit.get_profile().map
	profile.calibration = _suit.get_profile().calibration
	_suit.set_profile(profile)
	almost_equal(_suit.get_hip_height(), 0.795)
	contains(_suit.describe(), "worn by Anna")
	_go(0.1)
	is_true(_suit.sample(_now_usec).root.y < 0.85)
	var map: SensorMap = profile.map.duplicate()
	map.exchange(5, 9)
	_suit.set_map(map)
	_go(1.0)
	equal(_suit.sample(_now_usec).details.measured[5], 0, "its calibration is void")


func test_what_was_known_of_somebody_else_is_forgotten() -> void:
	_calibrate()
	var mine: PersonProfile = _suit.get_profile()
	not_null(_suit.quality)
	is_null(_suit.process.result, "nothing waits any more")
	_suit.set_profile(mine.duplicate())
	not_null(_suit.quality, "the same calibration is as good as before")
	var other: PersonProfile = mine.duplicate()
	other.name = "Anna"
	other.calibration = Calibration.new()
	_suit.set_profile(other)
	is_null(_suit.quality, "nothing is known of Anna's")
	_suit.set_profile(mine)
	is_null(_suit.quality)


func _calibrate() -> void:
	equal(_suit.start_calibration(CalibrationGuide.Kind.FULL, _now_usec / 1e6), "")
	var results: Array[CalibrationResult] = []
	_suit.calibrated.connect(results.append)
	_go(_feed.prelude_s)
	equal(results.size(), 1)
	equal(results[0].error, "")
	_suit.accept_calibration()
	is_true(_suit.is_calibrated())


func _go(p_seconds: float) -> void:
	var end: int = _now_usec + roundi(p_seconds * 1e6)
	while _now_usec < end:
		_now_usec = mini(_now_usec + 10000, end)
		_feed.advance(_now_usec)
		_suit.advance(_now_usec / 1e6)
