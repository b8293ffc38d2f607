extends TestCase
## Headings of worn sensors that drift are corrected while people move, and at once on demand.

const BEGIN_USEC: int = 1700000000000000

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _feed: WornSensorFeed = null
var _suit: SuitSource = null
var _now_s: float = 0.0
var _rate_hz: float = 12.5


func before_each() -> void:
	_random.seed = 8
	_now_s = 0.0
	_rate_hz = 12.5
	_feed = WornSensorFeed.new()
	_feed.random = _random
	var map: SensorMap = SensorMap.new()
	var calibration: Calibration = Calibration.new()
	for mount: int in BodyMounts.COUNT:
		var mounting: Quaternion = Rotations.from_vector(
			Vector3(_random.randfn(), _random.randfn(), _random.randfn())
		)
		var heading: float = _random.randf_range(-PI, PI)
		var id: String = BodyMounts.NAMES[mount]
		_feed.add_sensor(mount, mounting, heading, id)
		map.assign(id, mount)
		calibration.set_entry(id, mount, heading, mounting)
	_suit = SuitSource.new(_feed)
	_suit.set_map(map)
	_suit.set_calibration(calibration)


func test_drift_of_somebody_who_stands_about_is_taken_off() -> void:
	_drift(5.0)
	var worst: float = _stand(240.0)
	is_true(_mean_raw_deg() > 10.0, "%f deg of drift" % _mean_raw_deg())
	is_true(_mean_off_deg() < 2.0, "%f deg are left" % _mean_off_deg())
	is_true(worst < 1.0, "corrections jump by %f deg" % worst)
	contains(_suit.headings.describe(BodyMounts.HEAD), "corrected")
	var rate: float = absf(_suit.headings.rate_deg_min(BodyMounts.HEAD))
	is_true(absf(rate - 5.0) < 1.0, "%f deg/min" % rate)


func test_who_does_not_drift_is_left_alone_however_twisted() -> void:
	_stand(60.0)
	_stand(120.0, 30.0)
	is_true(_mean_off_deg() < 0.1, "%f deg" % _mean_off_deg())
	equal(_suit.headings.describe(BodyMounts.HEAD), "steady")


func test_a_sensor_that_is_taken_off_says_nothing_of_its_limb_any_more() -> void:
	_stand(30.0)
	var map: SensorMap = _suit.get_profile().map.duplicate()
	map.assign(BodyMounts.NAMES[BodyMounts.LEFT_FOREARM], -1)
	_suit.set_map(map)
	# It lies on a table and is turned there.
	var drifts: PackedFloat32Array = []
	drifts.resize(BodyMounts.COUNT)
	drifts[BodyMounts.LEFT_FOREARM] = 1.0
	_feed.drifts_deg = drifts
	_stand(120.0)
	for mount: int in [BodyMounts.LEFT_UPPER_ARM, BodyMounts.LEFT_HAND, BodyMounts.STERNUM]:
		equal(_suit.headings.describe(mount), "steady")
	equal(_suit.headings.drift.get_correction(BodyMounts.LEFT_FOREARM), 0.0)


func test_headings_are_reset_at_once_and_mountings_stay() -> void:
	_drift(30.0)
	_stand(20.0)
	equal(_suit.reset_heading(), "")
	_stand(0.2)
	is_true(_mean_off_deg() < 1.0, "%f deg are left" % _mean_off_deg())
	is_true(_suit.is_calibrated())


func test_who_lies_cannot_reset() -> void:
	contains(_suit.reset_heading(), "nothing")
	var pose: PoseSample = _pose(0.0, 0.0)
	for limb: int in Limbs.COUNT:
		pose.set_orientation(limb, Quaternion(Vector3.RIGHT, -PI / 2.0) * pose.orientation(limb))
	_feed.measure(pose, BEGIN_USEC)
	_suit.advance(0.0)
	contains(_suit.reset_heading(), "is not upright")


func test_a_calibration_begins_with_no_drift_and_the_next_knows_of_it() -> void:
	_drift(30.0)
	_stand(20.0)
	_suit.reset_heading()
	var old: Calibration = _suit.get_profile().calibration
	var corrected: Calibration = _suit.headings.corrected(old)
	var turned: float = corrected.entries["head"].heading - old.entries["head"].heading
	almost_equal(turned, _feed.heading(2, _now_s) - _feed.heading(2, 0.0), 0.05)
	_suit.set_calibration(corrected)
	equal(_suit.headings.drift.get_correction(BodyMounts.HEAD), 0.0)


func test_magnetometers_hold_the_headings_of_somebody_who_moves_anyhow() -> void:
	_feed.has_magnetics = true
	_drift(5.0)
	for at: int in 1500:
		var pose: PoseSample = PoseSample.new()
		for limb: int in Limbs.COUNT:
			var angle: float = 3.0 * sin(at * 0.013 * (limb + 3)) + at * 0.01
			pose.set_orientation(limb, Rotations.yaw(angle))
		_measure(pose)
	is_true(_mean_off_deg() < 2.5, "%f deg are left" % _mean_off_deg())


func test_accelerations_hold_neighbours_together_whose_postures_never_stay() -> void:
	_drift(5.0)
	_rate_hz = 25.0
	while _now_s < 150.0:
		_measure(_restless(_now_s))
	var raw: float = _apart_deg(PackedFloat64Array())
	var left: float = _apart_deg(_suit.headings.corrections())
	is_true(raw > 8.0 and left < 2.0, "%f of %f deg are left" % [left, raw])


## Lets each sensor drift by so much, one way or the other, degrees a minute.
func _drift(p_deg_min: float) -> void:
	for _sensor: int in BodyMounts.COUNT:
		_feed.drifts_deg.append(p_deg_min / 60.0 * (1.0 if _random.randf() < 0.5 else -1.0))


## Stands for a while, the chest twisted. Returns the largest step of a correction, degrees.
func _stand(p_seconds: float, p_twist_deg: float = 0.0) -> float:
	var most: float = 0.0
	var begin_s: float = _now_s
	while _now_s < begin_s + p_seconds:
		var before: float = _suit.headings.drift.get_correction(BodyMounts.HEAD)
		_measure(_pose(_now_s, p_twist_deg * smoothstep(begin_s, begin_s + 2.0, _now_s)))
		var step: float = _suit.headings.drift.get_correction(BodyMounts.HEAD) - before
		most = maxf(most, absf(rad_to_deg(step)))
	return most


func _pose(p_time_s: float, p_twist_deg: float) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		var turned: Quaternion = Rotations.yaw(0.02 * sin(p_time_s * (0.7 + 0.2 * limb)))
		if limb > Limbs.HIPS and limb < Limbs.LEFT_UPPER_LEG:
			turned *= Rotations.yaw(deg_to_rad(p_twist_deg))
		pose.set_orientation(limb, turned)
	for foot: int in Limbs.FEET:
		pose.set_orientation(foot, Quaternion.IDENTITY)
	return pose


## Somebody who swings to and fro about postures that change all the time.
func _restless(p_time_s: float) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		var at: float = p_time_s + limb * 1.7
		var swung: Vector3 = Vector3(sin(at * 3.1), sin(at * 0.29) + sin(at * 0.17), cos(at * 3.7))
		pose.set_orientation(limb, Rotations.from_vector(swung * Vector3(0.3, 0.9, 0.3)))
	pose.root = Vector3(sin(p_time_s * 4.0), 0.0, sin(p_time_s * 5.0)) * 0.1
	return pose


func _measure(p_pose: PoseSample) -> void:
	_feed.measure(p_pose, BEGIN_USEC + roundi(_now_s * 1e6))
	_suit.advance(_now_s)
	_now_s += 1.0 / _rate_hz


func _mean_off_deg() -> float:
	var taken: PackedFloat64Array = _suit.headings.corrections()
	var sum: float = 0.0
	for sensor: int in BodyMounts.COUNT:
		sum += absf(_feed.heading(sensor, _now_s) - _feed.heading(sensor, 0.0) - taken[sensor])
	return rad_to_deg(sum) / BodyMounts.COUNT


## How far headings are off from what they are off in the mean, degrees, in the mean.
func _apart_deg(p_taken: PackedFloat64Array) -> float:
	var offs: PackedFloat64Array = []
	var mean: float = 0.0
	for sensor: int in BodyMounts.COUNT:
		var taken: float = p_taken[sensor] if not p_taken.is_empty() else 0.0
		offs.append(_feed.heading(sensor, _now_s) - _feed.heading(sensor, 0.0) - taken)
		mean += offs[sensor] / BodyMounts.COUNT
	var sum: float = 0.0
	for off: float in offs:
		sum += absf(off - mean)
	return rad_to_deg(sum) / BodyMounts.COUNT


func _mean_raw_deg() -> float:
	var sum: float = 0.0
	for sensor: int in BodyMounts.COUNT:
		sum += absf(_feed.heading(sensor, _now_s) - _feed.heading(sensor, 0.0))
	return rad_to_deg(sum) / BodyMounts.COUNT
