extends RefCounted
## Somebody who wears made-up sensors and follows a calibration, for the tests.

const BEGIN_USEC: int = 1700000000000000

## The sensors.
var feed: WornSensorFeed = WornSensorFeed.new()
## What the wearer does.
var motion: CalibrationMotion = CalibrationMotion.new()
## The calibration that runs.
var process: CalibrationProcess = CalibrationProcess.new()
## The one in force.
var calibration: Calibration = null
## Draws where the sensors sit, and their noise.
var random: RandomNumberGenerator = feed.random:
	set(p_random):
		random = p_random
		feed.random = p_random
var rate_hz: float = 100.0
## Place of each sensor.
var mounts: PackedInt32Array = PackedInt32Array()
var now_usec: int = BEGIN_USEC
## Sensors that lie on a table, by number.
var lie_about: PackedInt32Array = PackedInt32Array()


## Puts sensors on mounts, sitting anyhow; the norths all alike (rad), or any if NaN.
func wear(p_mounts: PackedInt32Array, p_north: float = NAN) -> void:
	mounts = p_mounts
	for mount: int in p_mounts:
		var north: float = random.randf_range(-PI, PI) if is_nan(p_north) else p_north
		feed.add_sensor(mount, any_rotation(), north)


## Calibrates from start to end; returns the result.
func calibrate(p_kind: CalibrationGuide.Kind) -> CalibrationResult:
	motion.kind = p_kind
	var start: float = now_usec / 1e6
	var fault: String = process.start(p_kind, feed.list_sensors(), mounts, calibration, start)
	if fault != "":
		return null
	var begin_usec: int = now_usec
	while process.is_running():
		feed.measure(motion.pose_at((now_usec - begin_usec) / 1e6), now_usec)
		for frame: SensorFrame in feed.take_frames():
			for sensor: int in lie_about:
				frame.set_orientation(sensor, Quaternion.IDENTITY)
			process.add_frame(frame)
		now_usec += roundi(1e6 / rate_hz)
		process.advance(now_usec / 1e6)
	return process.result


## What the calibration makes of a pose: a rotation for each sensor.
func rotations(p_calibration: Calibration, p_pose: PoseSample) -> Array[Quaternion]:
	feed.take_frames()
	feed.measure(p_pose, now_usec)
	now_usec += roundi(1e6 / rate_hz)
	var frame: SensorFrame = feed.take_frames()[0]
	var found: Array[Quaternion] = []
	var sensors: Array[SensorInfo] = feed.list_sensors()
	for sensor: int in sensors.size():
		var entry: Calibration.Entry = p_calibration.entries[sensors[sensor].id]
		found.append(entry.rotation(frame.orientation(sensor)))
	return found


## The largest difference, degrees, of what the calibration says of a motion from the motion
## itself, seen from the front that the wearer had in the calibration.
func worst_deg(p_calibration: Calibration, p_poses: Array[PoseSample], p_front: float) -> float:
	var worst: float = 0.0
	for pose: PoseSample in p_poses:
		var got: Array[Quaternion] = rotations(p_calibration, pose)
		for sensor: int in mounts.size():
			var limb: Quaternion = pose.orientation(BodyMounts.LIMBS[mounts[sensor]])
			var wanted: Quaternion = Rotations.yaw(-p_front) * limb
			worst = maxf(worst, Rotations.between_deg(got[sensor], wanted))
	return worst


## The mean of the same differences over sensors and poses, degrees.
func mean_deg(p_calibration: Calibration, p_poses: Array[PoseSample], p_front: float) -> float:
	var sum: float = 0.0
	for pose: PoseSample in p_poses:
		var got: Array[Quaternion] = rotations(p_calibration, pose)
		for sensor: int in mounts.size():
			var limb: Quaternion = pose.orientation(BodyMounts.LIMBS[mounts[sensor]])
			sum += Rotations.between_deg(got[sensor], Rotations.yaw(-p_front) * limb)
	return sum / (mounts.size() * p_poses.size())


func any_axis() -> Vector3:
	var axis: Vector3 = Vector3.ZERO
	while axis.length() < 0.1:
		axis = Vector3(random.randfn(), random.randfn(), random.randfn())
	return axis.normalized()


func any_rotation() -> Quaternion:
	return Quaternion(any_axis(), random.randf_range(-PI, PI))


## Poses of a clip, each so many seconds.
static func clip_poses(p_file: String, p_step_s: float, p_count: int) -> Array[PoseSample]:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/" + p_file)
	var poses: Array[PoseSample] = []
	for at: int in p_count:
		poses.append(source.pose_at(at * p_step_s))
	return poses
