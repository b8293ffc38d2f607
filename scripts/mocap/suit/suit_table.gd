class_name SuitTable
extends RefCounted
## Turns frames of sensors into poses: for each sensor its mount and calibration, ready to be used.
##
## A sensor that was silent in a frame keeps its last orientation for [constant SILENT_S].
## Any thread may ask for a pose.

## A sensor that is silent for this long counts as not worn, and its limb is filled, s.
const SILENT_S: float = 0.5

## Mount of each sensor, -1 if it is not worn.
var mounts: PackedInt32Array = PackedInt32Array()
## Whether there is a calibration at all.
var is_calibrated: bool = false
## The pose in which it was calibrated.
var reset_pose: ResetPose.Kind = ResetPose.Kind.T
## The calibration, or null.
var calibration: Calibration = null
## The wearer's size.
var size: BodySize = BodySize.new()

var _entries: Array[Calibration.Entry] = []
var _left: Array[Quaternion] = []
var _right: Array[Quaternion] = []
var _standing: StandingHeight = null
# Written by one thread, read by others: guarded.
var _mutex: Mutex = Mutex.new()
var _last: Array[Quaternion] = []
var _last_usec: PackedInt64Array = PackedInt64Array()
var _filler: LimbFiller = LimbFiller.new()


## Prepares for sensors and who wears them.
func setup(p_sensors: Array[SensorInfo], p_profile: PersonProfile) -> void:
	mounts = p_profile.map.of_sensors(p_sensors)
	calibration = p_profile.calibration
	size = p_profile.size
	is_calibrated = calibration != null
	if is_calibrated:
		reset_pose = calibration.pose
	_standing = StandingHeight.new(p_profile.size)
	var count: int = p_sensors.size()
	_entries.resize(count)
	_left.resize(count)
	_right.resize(count)
	_last.resize(count)
	_last_usec.resize(count)
	for sensor: int in count:
		_last_usec[sensor] = -1
		if is_calibrated:
			_entries[sensor] = calibration.entry_for(p_sensors[sensor].id, mounts[sensor])
		if _entries[sensor] != null:
			_left[sensor] = Rotations.yaw(-_entries[sensor].heading)
			_right[sensor] = _entries[sensor].mounting.inverse()


## The calibration of a sensor; null if it has none where it is worn.
func entry(p_sensor: int) -> Calibration.Entry:
	return _entries[p_sensor]


## Sets the correction of each sensor's heading, rad, beyond the calibration.
func correct(p_drifts: PackedFloat64Array) -> void:
	_mutex.lock()
	for sensor: int in mini(p_drifts.size(), _entries.size()):
		if _entries[sensor] != null:
			_left[sensor] = Rotations.yaw(-_entries[sensor].heading - p_drifts[sensor])
	_mutex.unlock()


## Takes the sensors' orientations of a frame.
func remember(p_frame: SensorFrame) -> void:
	_mutex.lock()
	for sensor: int in mini(p_frame.count(), _last.size()):
		if p_frame.present[sensor] != 0:
			_last[sensor] = p_frame.orientation(sensor)
			_last_usec[sensor] = p_frame.time_usec
	_mutex.unlock()


## The rotation from the reset pose of the limb under a sensor; null if it is not calibrated.
func rotation(p_sensor: int, p_said: Quaternion) -> Variant:
	if p_sensor >= _entries.size() or _entries[p_sensor] == null:
		return null
	return (_left[p_sensor] * p_said * _right[p_sensor]).normalized()


## The pose of a frame, with its time; null if nothing is calibrated or all sensors are silent.
func pose(p_frame: SensorFrame) -> PoseSample:
	_mutex.lock()
	_filler.clear()
	var spoke: int = 0
	for sensor: int in _last.size():
		if _entries[sensor] == null:
			continue
		var said: Quaternion = _last[sensor]
		if sensor < p_frame.count() and p_frame.present[sensor] != 0:
			# Also where newer frames have come while this one waited.
			said = p_frame.orientation(sensor)
		elif not _is_fresh(sensor, p_frame.time_usec):
			continue
		spoke += 1
		var turned: Quaternion = (_left[sensor] * said * _right[sensor]).normalized()
		_filler.set_mount(mounts[sensor], turned)
	if spoke == 0:
		_mutex.unlock()
		return null
	_filler.fill()
	var found: PoseSample = _filler.pose()
	found.time_usec = p_frame.time_usec
	found.root = Vector3(0.0, _standing.of(found), 0.0)
	_add_details(p_frame, found.details)
	_mutex.unlock()
	return found


## Whether a sensor was heard about a time, µs. The mutex is held.
func _is_fresh(p_sensor: int, p_time_usec: int) -> bool:
	var age_s: float = (p_time_usec - _last_usec[p_sensor]) / 1e6
	return _last_usec[p_sensor] >= 0 and absf(age_s) <= SILENT_S


func _add_details(p_frame: SensorFrame, r_details: MotionDetails) -> void:
	r_details.counter = p_frame.counter
	for blade: int in [3, 7]:
		if _filler.known[blade] != 0:
			var joint: int = XRBodyTracker.JOINT_LEFT_SHOULDER
			if blade == 7:
				joint = XRBodyTracker.JOINT_RIGHT_SHOULDER
			r_details.joints[joint] = _filler.rotations[blade]
	if p_frame.rates.is_empty():
		return
	r_details.rates.resize(Limbs.COUNT)
	for sensor: int in mini(p_frame.count(), mounts.size()):
		var mount: int = mounts[sensor]
		if mount < 0 or mount == 3 or mount == 7 or _entries[sensor] == null:
			continue
		var said: Quaternion = p_frame.orientation(sensor)
		if p_frame.present[sensor] != 0:
			var rate: Vector3 = _left[sensor] * (said * p_frame.rates[sensor])
			r_details.rates[BodyMounts.LIMBS[mount]] = rate
