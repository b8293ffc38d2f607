class_name WornSensorFeed
extends SensorFeed
## Sensors as somebody would wear them whose motion is known: for tests, and for trying without a
## suit.
##
## A sensor's orientation is s = H r M: r is the limb's rotation from the reset pose, M how the
## sensor sits on the limb, H which way the sensor's global frame is turned about the vertical.

## Maximum of waiting frames; beyond it the oldest are dropped.
const MAX_WAITING: int = 512
## Gravity, m/s².
const GRAVITY: float = 9.81
## Mounts that are no limb, and the joints under which a pose may have them.
const BLADES: Dictionary[int, int] = {
	3: XRBodyTracker.JOINT_LEFT_SHOULDER, 7: XRBodyTracker.JOINT_RIGHT_SHOULDER
}

## How far each sample is off at random, degrees (standard deviation of each axis).
var noise_deg: float = 0.0
## How fast the heading of each sensor drifts, degrees per second, by sensor; empty: not at all.
var drifts_deg: PackedFloat32Array = PackedFloat32Array()
## Silent sensors, by number.
var silent: PackedInt32Array = PackedInt32Array()
## Draws the noise.
var random: RandomNumberGenerator = RandomNumberGenerator.new()

var _ids: PackedStringArray = PackedStringArray()
var _mounts: PackedInt32Array = PackedInt32Array()
var _mountings: Array[Quaternion] = []
var _headings: PackedFloat32Array = PackedFloat32Array()
var _before: Array[Quaternion] = []
var _before_usec: int = -1
var _begin_usec: int = -1
var _counter: int = 0
var _rate_hz: float = 0.0
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _waiting: Array[SensorFrame] = []


## Puts a sensor on a mount of [BodyMounts]; [param p_heading] in rad. Returns its number.
func add_sensor(
	p_mount: int,
	p_mounting: Quaternion = Quaternion.IDENTITY,
	p_heading: float = 0.0,
	p_id: String = ""
) -> int:
	_mutex.lock()
	var number: int = _ids.size()
	_ids.append(p_id if p_id != "" else "%08X" % (0x00300001 + number))
	_mounts.append(p_mount)
	_mountings.append(p_mounting.normalized())
	_headings.append(p_heading)
	_before.append(Quaternion.IDENTITY)
	revision += 1
	_mutex.unlock()
	return number


## Changes how a sensor sits, as if it slipped or was put elsewhere.
func wear(p_sensor: int, p_mount: int, p_mounting: Quaternion) -> void:
	_mutex.lock()
	_mounts[p_sensor] = p_mount
	_mountings[p_sensor] = p_mounting.normalized()
	_mutex.unlock()


## Measures a pose that the wearer takes at a time (Unix time, µs).
func measure(p_pose: PoseSample, p_time_usec: int) -> void:
	_mutex.lock()
	if _begin_usec < 0:
		_begin_usec = p_time_usec
	var passed: float = (p_time_usec - _begin_usec) / 1e6
	var step: float = (p_time_usec - _before_usec) / 1e6 if _before_usec >= 0 else 0.0
	var frame: SensorFrame = SensorFrame.new()
	frame.resize(_ids.size(), true, true)
	frame.time_usec = p_time_usec
	frame.counter = _counter
	_counter = (_counter + 1) & 0xFFFF
	for sensor: int in _ids.size():
		if silent.has(sensor):
			continue
		var turned: Quaternion = _orientation(sensor, p_pose, passed)
		if step > 0.0:
			frame.rates[sensor] = Rotations.vector(_before[sensor].inverse() * turned) / step
		frame.accelerations[sensor] = turned.inverse() * Vector3(0.0, GRAVITY, 0.0)
		frame.set_orientation(sensor, turned)
		_before[sensor] = turned
	_before_usec = p_time_usec
	_rate_hz = 1.0 / step if step > 0.0 else 0.0
	_waiting.append(frame)
	if _waiting.size() > MAX_WAITING:
		_waiting.pop_front()
	_mutex.unlock()


func list_sensors() -> Array[SensorInfo]:
	var found: Array[SensorInfo] = []
	_mutex.lock()
	for sensor: int in _ids.size():
		var info: SensorInfo = SensorInfo.new()
		info.id = _ids[sensor]
		info.where = "worn / %d" % (sensor + 1)
		var speaks: bool = _before_usec >= 0 and not silent.has(sensor)
		info.state = SensorInfo.State.MEASURING if speaks else SensorInfo.State.WAITING
		info.rate_hz = _rate_hz if speaks else 0.0
		info.age_s = 0.0 if speaks else INF
		found.append(info)
	_mutex.unlock()
	return found


func take_frames() -> Array[SensorFrame]:
	_mutex.lock()
	var frames: Array[SensorFrame] = _waiting
	_waiting = []
	_mutex.unlock()
	return frames


func describe() -> String:
	return "%d made-up sensors" % _ids.size()


func _orientation(p_sensor: int, p_pose: PoseSample, p_passed_s: float) -> Quaternion:
	var heading: float = _headings[p_sensor]
	if p_sensor < drifts_deg.size():
		heading += deg_to_rad(drifts_deg[p_sensor]) * p_passed_s
	var mount: int = _mounts[p_sensor]
	var limb: Quaternion = p_pose.orientation(BodyMounts.LIMBS[mount])
	if BLADES.has(mount) and p_pose.details != null:
		limb = p_pose.details.joints.get(BLADES[mount], limb)
	var turned: Quaternion = Rotations.yaw(heading) * limb * _mountings[p_sensor]
	if noise_deg > 0.0:
		var off: Vector3 = Vector3(random.randfn(), random.randfn(), random.randfn())
		turned = turned * Rotations.from_vector(off * deg_to_rad(noise_deg))
	return turned.normalized()
