extends TestCase
## Calibrations that nobody leads at the panel: what the wearer reads, what is taken, what is kept.

const NAME: String = "test client calibration"
const RATE_HZ: float = 50.0

var _calibration: ClientCalibration = null
var _feed: WornSensorFeed = null
var _source: SuitSource = null
var _motion: CalibrationMotion = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _begin_usec: int = 1700000000000000
var _now_usec: int = _begin_usec
var _read: Array[String] = []


func before_each() -> void:
	_random.seed = 4
	_calibration = ClientCalibration.new()
	_feed = WornSensorFeed.new()
	for mount: int in BodyMounts.COUNT:
		var turn: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn())
		_feed.add_sensor(mount, Quaternion.from_euler(turn))
	_motion = CalibrationMotion.new()
	_source = SuitSource.new(_feed)
	_source.rename(NAME)
	_read.clear()
	_begin_usec = 1700000000000000
	_now_usec = _begin_usec


func after_each() -> void:
	CalibrationStore.new().remove(NAME)


func test_the_wearer_is_told_what_to_do_and_the_result_is_kept() -> void:
	_run(CalibrationGuide.Kind.T_TO_N)
	is_true(_source.is_calibrated())
	is_false(_calibration.is_running())
	is_true(_read.any(func(text: String) -> bool: return text.contains("arms straight out")))
	is_true(_read.any(func(text: String) -> bool: return text.ends_with("\n3")), "counts down")
	contains(_calibration.text(_now_s()), "Calibrated")
	equal(_calibration.text(_now_s() + 60.0), "", "and not for ever")
	var kept: PersonProfile = CalibrationStore.new().read(NAME)
	not_null(kept)
	equal(kept.calibration.entries.size(), BodyMounts.COUNT)


func test_who_does_not_hold_still_keeps_the_old_calibration() -> void:
	_run(CalibrationGuide.Kind.T_POSE)
	var before: Calibration = _source.get_profile().calibration
	not_null(before)
	_motion.sways_deg = {5: 30.0, 6: 30.0}
	_run(CalibrationGuide.Kind.T_POSE)
	is_true(_source.get_profile().calibration == before)
	contains(_calibration.text(_now_s()), "Not calibrated")
	contains(_calibration.text(_now_s()), "left forearm", "the wearer reads what was wrong")


func test_one_at_a_time() -> void:
	_measure()
	equal(_calibration.start(_source, CalibrationGuide.Kind.FULL, _now_s()), "")
	is_true(_calibration.is_running())
	contains(_calibration.start(_source, CalibrationGuide.Kind.T_POSE, _now_s()), "going on")


func test_a_suit_that_is_silent_cannot_be_calibrated() -> void:
	var fault: String = _calibration.start(_source, CalibrationGuide.Kind.T_POSE, _now_s())
	if fault == "":
		for _step: int in 600:
			_now_usec += 20000
			_source.advance(_now_s())
			_read.append(_calibration.text(_now_s()))
		is_true(_read.any(func(text: String) -> bool: return text.contains("Not calibrated")))
	is_false(_source.is_calibrated())


func test_a_wearer_who_leaves_meanwhile_is_forgotten() -> void:
	_measure()
	equal(_calibration.start(_source, CalibrationGuide.Kind.FULL, _now_s()), "")
	_calibration.forget(_source)
	is_false(_calibration.is_running())
	equal(_source.calibrated.get_connections().size(), 0)
	_run_anew()


func test_one_that_the_panel_ended_is_forgotten() -> void:
	_measure()
	equal(_calibration.start(_source, CalibrationGuide.Kind.FULL, _now_s()), "")
	_source.refuse_calibration()
	is_false(_calibration.is_running())
	_run_anew()


func test_one_that_the_panel_leads_is_not_disturbed() -> void:
	_measure()
	equal(_source.start_calibration(CalibrationGuide.Kind.FULL, _now_s()), "")
	contains(_calibration.start(_source, CalibrationGuide.Kind.QUICK, _now_s()), "going on")
	equal(_source.process.kind, CalibrationGuide.Kind.FULL)


func _run_anew() -> void:
	_source.refuse_calibration()
	_run(CalibrationGuide.Kind.T_TO_N)
	is_true(_source.is_calibrated())


func _run(p_kind: CalibrationGuide.Kind) -> void:
	_motion.kind = p_kind
	_begin_usec = _now_usec
	_measure()
	equal(_calibration.start(_source, p_kind, _now_s()), "")
	var steps: int = ceili((CalibrationGuide.duration_s(p_kind) + 1.0) * RATE_HZ)
	for _step: int in steps:
		_now_usec += roundi(1e6 / RATE_HZ)
		_measure()
		_read.append(_calibration.text(_now_s()))


func _measure() -> void:
	_feed.measure(_motion.pose_at((_now_usec - _begin_usec) / 1e6), _now_usec)
	_source.advance(_now_s())


func _now_s() -> float:
	return _now_usec / 1e6
