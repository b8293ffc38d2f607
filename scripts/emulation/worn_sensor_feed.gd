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
## Maximum of what a sensor can measure, m/s².
const CLIPPED: float = 160.0
## The earth's magnetic field where the wearer is: north is +Z, in units of its own strength.
const FIELD: Vector3 = Vector3(0.0, -0.906, 0.423)
## Where the joint of each mount is, from the joint of its parent, in the reset pose (Godot's frame,
## m): a person of 1.75 m. Accelerations follow from it.
const OFFSETS: Array[Vector3] = [
	Vector3(0.0, 0.0, 0.0),
	Vector3(0.0, 0.28, 0.0),
	Vector3(0.0, 0.27, 0.0),
	Vector3(0.03, 0.2, 0.0),
	Vector3(0.15, 0.0, 0.0),
	Vector3(0.3, 0.0, 0.0),
	Vector3(0.25, 0.0, 0.0),
	Vector3(-0.03, 0.2, 0.0),
	Vector3(-0.15, 0.0, 0.0),
	Vector3(-0.3, 0.0, 0.0),
	Vector3(-0.25, 0.0, 0.0),
	Vector3(0.09, -0.05, 0.0),
	Vector3(0.0, -0.43, 0.0),
	Vector3(0.0, -0.42, 0.0),
	Vector3(-0.09, -0.05, 0.0),
	Vector3(0.0, -0.43, 0.0),
	Vector3(0.0, -0.42, 0.0),
]
## Where on its mount a sensor sits, m, from the mount's joint in the reset pose.
const SITS: Array[Vector3] = [
	Vector3(0.0, 0.06, -0.1),
	Vector3(0.0, 0.12, 0.1),
	Vector3(0.0, 0.16, -0.1),
	Vector3(0.08, 0.05, -0.06),
	Vector3(0.15, 0.04, 0.0),
	Vector3(0.2, 0.03, 0.0),
	Vector3(0.06, 0.02, 0.0),
	Vector3(-0.08, 0.05, -0.06),
	Vector3(-0.15, 0.04, 0.0),
	Vector3(-0.2, 0.03, 0.0),
	Vector3(-0.06, 0.02, 0.0),
	Vector3(0.07, -0.2, 0.03),
	Vector3(0.03, -0.18, 0.05),
	Vector3(0.0, -0.03, 0.1),
	Vector3(-0.07, -0.2, 0.03),
	Vector3(-0.03, -0.18, 0.05),
	Vector3(0.0, -0.03, 0.1),
]
## Rate of turn at which soft tissue lags by a quarter of what it yields at most, rad/s.
const TISSUE_RATE: float = 5.0
## Mounts that are no limb, and the joints under which a pose may have them.
const BLADES: Dictionary[int, int] = {
	3: XRBodyTracker.JOINT_LEFT_SHOULDER, 7: XRBodyTracker.JOINT_RIGHT_SHOULDER
}

## How far each sample is off at random, degrees (standard deviation of each axis).
var noise_deg: float = 0.0
## How fast the heading of each sensor drifts, degrees per second, by sensor; empty: not at all.
var drifts_deg: PackedFloat32Array = PackedFloat32Array()
## How fast the drift itself sways, as a part of it, and in which time, s: sensor by sensor at
## another moment.
var drift_sway: float = 0.0
var drift_sway_s: float = 240.0
## How far a sensor turns on its limb when the limb is level instead of upright, degrees, and by a
## part of that when it is swung: about an axis of its own for each sensor, always the same way.
var soft_tissue_deg: float = 0.0
## Where each sensor sits beside [constant SITS], m, by sensor; empty: there.
var misplaced: PackedVector3Array = PackedVector3Array()
## The size of the wearer, in sizes of [constant OFFSETS].
var size: float = 1.0
## How far each acceleration is off at random, m/s² (standard deviation of each axis), and by how
## much always, by sensor; empty: nothing.
var acceleration_noise: float = 0.0
var acceleration_biases: PackedVector3Array = PackedVector3Array()
## Whether sensors say how they are accelerated, and at which rate they turn.
var has_rates: bool = true
## Whether sensors say what their magnetometers measure.
var has_magnetics: bool = false
## What iron nearby adds to the field at a sensor, by sensor's number, as [constant FIELD].
var disturbances: Dictionary[int, Vector3] = {}
## Silent sensors, by number.
var silent: PackedInt32Array = PackedInt32Array()
## Draws the noise.
var random: RandomNumberGenerator = RandomNumberGenerator.new()

var _ids: PackedStringArray = PackedStringArray()
var _mounts: PackedInt32Array = PackedInt32Array()
var _mountings: Array[Quaternion] = []
var _headings: PackedFloat32Array = PackedFloat32Array()
# Of each sensor: its limb, how it was turned without its north and noise, where, how fast it was.
var _limbs: Array[Quaternion] = []
var _before: Array[Quaternion] = []
var _places: PackedVector3Array = PackedVector3Array()
var _speeds: PackedVector3Array = PackedVector3Array()
# Of each sensor: how the limb's tilt turns it, a column for each of two axes, unit vectors.
var _tissues: Array[PackedVector3Array] = []
var _before_usec: int = -1
var _joints: PackedVector3Array = PackedVector3Array()
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
	_limbs.append(Quaternion.IDENTITY)
	_before.append(Quaternion.IDENTITY)
	_places.append(Vector3.ZERO)
	_speeds.append(Vector3.ZERO)
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
	frame.resize(_ids.size(), has_rates, has_rates, has_magnetics)
	frame.time_usec = p_time_usec
	frame.counter = _counter
	_counter = (_counter + 1) & 0xFFFF
	_place_joints(p_pose)
	for sensor: int in _ids.size():
		if not silent.has(sensor):
			_measure_sensor(sensor, p_pose, passed, step, frame)
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


## Which way a sensor's north is turned after so many seconds, rad.
func heading(p_sensor: int, p_passed_s: float) -> float:
	var drifted_s: float = p_passed_s
	if drift_sway != 0.0:
		var angle: float = TAU * p_passed_s / drift_sway_s
		var swayed: float = cos(p_sensor * 2.4) - cos(angle + p_sensor * 2.4)
		drifted_s += drift_sway * drift_sway_s / TAU * swayed
	var drift_deg: float = drifts_deg[p_sensor] if p_sensor < drifts_deg.size() else 0.0
	return _headings[p_sensor] + deg_to_rad(drift_deg) * drifted_s


## The rotation of a mount of [BodyMounts] in a pose.
static func limb_rotation(p_pose: PoseSample, p_mount: int) -> Quaternion:
	var limb: Quaternion = p_pose.orientation(BodyMounts.LIMBS[p_mount])
	if p_pose.details != null and BLADES.has(p_mount):
		return p_pose.details.joints.get(BLADES[p_mount], limb)
	return limb


func _measure_sensor(
	p_sensor: int, p_pose: PoseSample, p_passed_s: float, p_step_s: float, r_frame: SensorFrame
) -> void:
	var limb: Quaternion = limb_rotation(p_pose, _mounts[p_sensor])
	var place: Vector3 = _joints[_mounts[p_sensor]] + limb * _sits(p_sensor)
	var turned: Quaternion = limb * _tissue(p_sensor, limb, p_step_s) * _mountings[p_sensor]
	var pull: Vector3 = Vector3(0.0, GRAVITY, 0.0)
	if p_step_s > 0.0:
		var speed: Vector3 = (place - _places[p_sensor]) / p_step_s
		if not _speeds[p_sensor].is_zero_approx():
			pull += (speed - _speeds[p_sensor]) / p_step_s
		_speeds[p_sensor] = speed
		if has_rates:
			var rate: Vector3 = Rotations.vector(_before[p_sensor].inverse() * turned) / p_step_s
			r_frame.rates[p_sensor] = rate
	if has_rates:
		var felt: Vector3 = turned.inverse() * pull.limit_length(CLIPPED)
		r_frame.accelerations[p_sensor] = felt + _wrong_acceleration(p_sensor)
	if has_magnetics:
		var field: Vector3 = FIELD + disturbances.get(p_sensor, Vector3.ZERO)
		r_frame.magnetics[p_sensor] = turned.inverse() * field
	_places[p_sensor] = place
	_before[p_sensor] = turned
	turned = Rotations.yaw(heading(p_sensor, p_passed_s)) * turned
	if noise_deg > 0.0:
		var off: Vector3 = Vector3(random.randfn(), random.randfn(), random.randfn())
		turned = turned * Rotations.from_vector(off * deg_to_rad(noise_deg))
	r_frame.set_orientation(p_sensor, turned.normalized())


## Where the joints of all mounts are, from the root.
func _place_joints(p_pose: PoseSample) -> void:
	_joints.resize(BodyMounts.COUNT)
	for mount: int in BodyMounts.COUNT:
		var parent: int = BodyMounts.PARENTS[mount]
		_joints[mount] = p_pose.root
		if parent >= 0:
			var above: Quaternion = limb_rotation(p_pose, parent)
			_joints[mount] = _joints[parent] + above * OFFSETS[mount] * size


## Where a sensor sits on its mount, m, from the mount's joint in the reset pose.
func _sits(p_sensor: int) -> Vector3:
	var off: Vector3 = misplaced[p_sensor] if p_sensor < misplaced.size() else Vector3.ZERO
	return SITS[_mounts[p_sensor]] * size + off


## How far an acceleration is off, m/s², in the sensor's axes.
func _wrong_acceleration(p_sensor: int) -> Vector3:
	var off: Vector3 = Vector3.ZERO
	if acceleration_noise > 0.0:
		off = Vector3(random.randfn(), random.randfn(), random.randfn()) * acceleration_noise
	if p_sensor < acceleration_biases.size():
		off += acceleration_biases[p_sensor]
	return off


## How the soft tissue under a sensor has given way: as its limb is tilted and swung.
func _tissue(p_sensor: int, p_limb: Quaternion, p_step_s: float) -> Quaternion:
	if soft_tissue_deg <= 0.0:
		return Quaternion.IDENTITY
	while _tissues.size() < _ids.size():
		var axes: PackedVector3Array = []
		for _axis: int in 3:
			var any: Vector3 = Vector3(random.randfn(), random.randfn(), random.randfn())
			axes.append(any.normalized())
		_tissues.append(axes)
	var upright: Vector3 = p_limb.inverse() * Vector3.UP
	var turned: Vector3 = _tissues[p_sensor][0] * upright.x + _tissues[p_sensor][1] * upright.z
	if p_step_s > 0.0:
		var swung: float = Rotations.between(_limbs[p_sensor], p_limb) / p_step_s / TISSUE_RATE
		turned += _tissues[p_sensor][2] * minf(swung, 1.0) * 0.25
	_limbs[p_sensor] = p_limb
	return Rotations.from_vector(turned * deg_to_rad(soft_tissue_deg))
