extends TestCase
## Calibrations that nobody leads: what one leaves behind must not be in the way of the next.

const KIND: CalibrationGuide.Kind = CalibrationGuide.Kind.QUICK

var _calibration: ClientCalibration = null


func before_each() -> void:
	_calibration = ClientCalibration.new()


func test_one_at_a_time() -> void:
	var first: SuitSource = _make_wearer()
	equal(_calibration.start(first, KIND, 0.0), "")
	is_true(_calibration.is_running())
	contains(_calibration.start(first, KIND, 0.1), "going on")
	contains(_calibration.start(_make_wearer(), KIND, 0.1), "going on")


func test_one_that_the_panel_leads_is_not_disturbed() -> void:
	var wearer: SuitSource = _make_wearer()
	equal(wearer.start_calibration(CalibrationGuide.Kind.FULL, 0.0), "")
	contains(_calibration.start(wearer, KIND, 0.1), "going on")
	equal(wearer.process.kind, CalibrationGuide.Kind.FULL)


func test_a_wearer_who_leaves_meanwhile_is_forgotten() -> void:
	var gone: SuitSource = _make_wearer()
	equal(_calibration.start(gone, KIND, 0.0), "")
	_calibration.forget(gone)
	is_false(_calibration.is_running())
	equal(_calibration.start(_make_wearer(), KIND, 1.0), "")


func test_one_that_the_panel_ended_is_forgotten() -> void:
	var wearer: SuitSource = _make_wearer()
	equal(_calibration.start(wearer, KIND, 0.0), "")
	wearer.refuse_calibration()
	is_false(_calibration.is_running())
	equal(_calibration.start(wearer, KIND, 1.0), "")
	equal(wearer.calibrated.get_connections().size(), 1)


func _make_wearer() -> SuitSource:
	var feed: WornSensorFeed = WornSensorFeed.new()
	for place: int in 5:
		feed.add_sensor(place)
	return SuitSource.new(feed)
