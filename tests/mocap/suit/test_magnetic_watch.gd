extends TestCase
## Iron beside a sensor is noticed by strength and dip of its magnetic field.

const BEGIN_USEC: int = 1700000000000000

var _drift: HeadingDrift = null
var _watch: MagneticWatch = null
var _feed: WornSensorFeed = null
var _frames: int = 0


func before_each() -> void:
	_drift = HeadingDrift.new()
	_watch = MagneticWatch.new(_drift)
	_feed = WornSensorFeed.new()
	_frames = 0
	for mount: int in BodyMounts.COUNT:
		_feed.add_sensor(mount)
		_drift.set_sensor(mount, mount, 0.0, Quaternion.IDENTITY)


func test_without_magnetometers_nothing_is_known() -> void:
	_go(5.0)
	equal(_watch.word(BodyMounts.HEAD), "unknown")
	equal(_watch.describe(BodyMounts.HEAD), "unknown")


func test_iron_beside_one_sensor_disturbs_it_alone_until_it_goes() -> void:
	_feed.has_magnetics = true
	_go(5.0)
	equal(_watch.word(BodyMounts.HEAD), "good")
	_feed.disturbances[BodyMounts.HEAD] = Vector3(0.0, 0.0, 0.4)
	_go(5.0)
	equal(_watch.judge(BodyMounts.HEAD), MagneticWatch.Verdict.DISTURBED)
	equal(_watch.word(BodyMounts.PELVIS), "good")
	is_true(_watch.strength(BodyMounts.HEAD) > 1.1, "%f" % _watch.strength(BodyMounts.HEAD))
	is_true(_watch.dip_deg(BodyMounts.HEAD) < -15.0, "%f" % _watch.dip_deg(BodyMounts.HEAD))
	contains(_watch.describe(BodyMounts.HEAD), "disturbed (1")
	_feed.disturbances.clear()
	_go(8.0)
	equal(_watch.word(BodyMounts.HEAD), "good")


func _go(p_seconds: float) -> void:
	for _frame: int in roundi(p_seconds * 20.0):
		var pose: PoseSample = CalibrationMotion.new().pose_at(0.0)
		_feed.measure(pose, BEGIN_USEC + _frames * 50000)
		_frames += 1
		for frame: SensorFrame in _feed.take_frames():
			_drift.add(
				frame.time_usec,
				frame.present,
				frame.orientations,
				frame.magnetics,
				frame.accelerations
			)
