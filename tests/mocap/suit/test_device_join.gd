extends TestCase
## Two masters that measure each in its own time are one suit.

const PERIOD_USEC: int = 10000
const BEGIN_USEC: int = 1700000000000000
const CLIP: String = "res://assets/motion/Boxing_Toes.bvh"
## Limbs under the two sensors.
const LIMBS: PackedInt32Array = [6, 15]

var _clip: BvhSource = null


func before_each() -> void:
	_clip = BvhSource.new()
	_clip.open(CLIP)


## What a device says at a moment of the clip, s: sensors are limbs of the clip.
func _frame(p_sensors: PackedInt32Array, p_time_s: float) -> SensorFrame:
	var frame: SensorFrame = SensorFrame.new()
	frame.resize(2)
	frame.time_usec = BEGIN_USEC + roundi(p_time_s * 1e6)
	frame.counter = roundi(p_time_s * 1e6 / PERIOD_USEC)
	for sensor: int in p_sensors:
		frame.set_orientation(sensor, _clip.pose_at(p_time_s).orientation(LIMBS[sensor]))
	return frame


## The mean error of sensor 1, deg, as a client would sample it at 60 Hz while frames come in; the
## worst age of what it gets, s, is printed too.
func _error_deg(p_phase: float, p_is_apart: bool, p_silent_after_s: float = INF) -> Vector2:
	var join: DeviceJoin = DeviceJoin.new()
	var poses: LivePoses = LivePoses.new()
	var errors: Statistics = Statistics.new()
	var oldest: float = 0.0
	var sampled_s: float = 0.05
	for at: int in 400:
		var begin_s: float = at * PERIOD_USEC / 1e6
		for device: int in 2:
			var time_s: float = begin_s + (device * p_phase * PERIOD_USEC / 1e6)
			while sampled_s < time_s:
				var pose: PoseSample = poses.at(BEGIN_USEC + roundi(sampled_s * 1e6))
				sampled_s += 1.0 / 60.0
				if pose == null:
					continue
				var moment_s: float = (pose.time_usec - BEGIN_USEC) / 1e6
				oldest = maxf(oldest, sampled_s - 1.0 / 60.0 - moment_s)
				var limb: Quaternion = _clip.pose_at(moment_s).orientation(LIMBS[1])
				errors.add(Rotations.between_deg(pose.orientation(LIMBS[1]), limb))
			if device == 1 and time_s > p_silent_after_s:
				continue
			if p_is_apart:
				join.push(device, _frame([device], time_s))
			elif device == 1:
				join.push(device, _frame([0, 1], time_s))
			for frame: SensorFrame in join.take():
				poses.push(_pose(frame), frame.period_s)
	return Vector2(errors.mean(), oldest)


func _pose(p_frame: SensorFrame) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	pose.time_usec = p_frame.time_usec
	for limb: int in Limbs.COUNT:
		pose.set_orientation(limb, Quaternion.IDENTITY)
	for sensor: int in 2:
		if p_frame.present[sensor] != 0:
			pose.set_orientation(LIMBS[sensor], p_frame.orientation(sensor))
	return pose


func test_two_are_as_good_as_one_at_any_phase() -> void:
	for phase: float in [0.02, 0.25, 0.5, 0.75, 0.97]:
		var one: Vector2 = _error_deg(phase, false)
		var two: Vector2 = _error_deg(phase, true)
		var note: String = "phase %.2f: %.4f deg with one, %.4f with two" % [phase, one.x, two.x]
		is_true(two.x - one.x < 0.03, note)
		is_true(two.y < one.y + 0.002, "no later: %.4f s and %.4f s" % [one.y, two.y])


func test_every_moment_has_all_sensors_in_order() -> void:
	var join: DeviceJoin = DeviceJoin.new()
	var last: int = 0
	for at: int in 50:
		for device: int in 2:
			join.push(device, _frame([device], at * 0.01 + device * 0.004))
			for frame: SensorFrame in join.take():
				is_true(frame.time_usec > last)
				last = frame.time_usec
				equal(frame.find_fault(), "")
				if at > 1:
					equal(frame.present.count(1), 2)
					almost_equal(frame.period_s, 0.01, 1e-4)


func test_a_device_that_goes_silent_stops_nobody() -> void:
	var join: DeviceJoin = DeviceJoin.new()
	var newest: SensorFrame = null
	var behind_usec: int = 0
	for at: int in 200:
		join.push(0, _frame([0], at * 0.01))
		if at < 50:
			join.push(1, _frame([1], at * 0.01 + 0.003))
		for frame: SensorFrame in join.take():
			newest = frame
		if at > 1:
			behind_usec = maxi(behind_usec, BEGIN_USEC + at * PERIOD_USEC - newest.time_usec)
	is_true(behind_usec <= 3 * PERIOD_USEC, "held up for %d us" % behind_usec)
	equal(newest.time_usec, BEGIN_USEC + 199 * PERIOD_USEC)
	equal(newest.present[0], 1)
	equal(newest.present[1], 0, "silent for over half a second")


func test_a_late_device_whose_last_frames_came_at_once_is_not_flung() -> void:
	var join: DeviceJoin = DeviceJoin.new()
	var worst: float = 0.0
	for at: int in 60:
		join.push(0, _frame([0], at * 0.01))
		if at < 49:
			join.push(1, _frame([1], at * 0.01 + 0.003))
		elif at == 49:
			var squeezed: SensorFrame = _frame([1], at * 0.01 + 0.003)
			squeezed.time_usec -= PERIOD_USEC - 200
			join.push(1, squeezed)
		for frame: SensorFrame in join.take():
			if at > 1 and frame.present[1] != 0:
				var truth: Quaternion = (
					_clip.pose_at((frame.time_usec - BEGIN_USEC) / 1e6).orientation(LIMBS[1])
				)
				worst = maxf(worst, Rotations.between_deg(frame.orientation(1), truth))
	is_true(worst < 2.0, "%.1f deg off" % worst)


func test_one_device_passes_unchanged() -> void:
	var join: DeviceJoin = DeviceJoin.new()
	for at: int in 20:
		var said: SensorFrame = _frame([0, 1], at * 0.01)
		join.push(3, said)
		var frames: Array[SensorFrame] = join.take()
		equal(frames.size(), 1)
		equal(frames[0].time_usec, said.time_usec)
		equal(frames[0].counter, said.counter)
		almost_equal(frames[0].orientation(1), said.orientation(1), 1e-6)
