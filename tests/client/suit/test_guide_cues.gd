extends TestCase
## A calibration is heard: its last seconds, its steps, and its result.

var _cues: GuideCues = null
var _process: CalibrationProcess = null
var _feed: WornSensorFeed = null
var _tones: Array[String] = []


func before_each() -> void:
	_cues = GuideCues.new()
	add_child(_cues)
	_process = CalibrationProcess.new()
	_feed = WornSensorFeed.new()
	_feed.add_sensor(0)
	_tones.clear()


func after_each() -> void:
	_cues.queue_free()
	await process_frames(1)


func test_seconds_and_steps_are_heard() -> void:
	var mounts: PackedInt32Array = [0]
	_process.options.ready_s = 8.0
	equal(_process.start(CalibrationGuide.Kind.T_POSE, _feed.list_sensors(), mounts, null, 0.0), "")
	var player: AudioStreamPlayer = _cues.get_child(0)
	var last: AudioStream = null
	var heard: Array[float] = []
	for at: int in 110:
		var now_s: float = at * 0.1
		_feed.measure(CalibrationGuide.countdown(ResetPose.Kind.T).pose_at(0.0), at * 100000)
		for frame: SensorFrame in _feed.take_frames():
			_process.add_frame(frame)
		_process.advance(now_s)
		player.stream = null
		_cues.follow(_process)
		if player.stream != null:
			heard.append(now_s)
			last = player.stream
	# Three seconds before the pose, the pose, and the result.
	equal(heard.size(), 5, str(heard))
	almost_equal(heard[0], 5.0, 0.15)
	almost_equal(heard[3], 8.0, 0.15)
	almost_equal(heard[4], 10.0, 0.15)
	is_true(last.get_length() > 0.4, "the result is a long tone")


func test_a_result_is_put_in_words() -> void:
	var result: CalibrationResult = CalibrationResult.new()
	result.error = "no sensor said anything"
	contains(GuideCues.spoken(result), "It did not work. no sensor said anything")
	result = CalibrationResult.new()
	result.calibration = Calibration.new()
	result.error_deg = 2.4
	equal(GuideCues.spoken(result), "Good. Off by about 2 degrees.")
