class_name HeadingKeeper
extends RefCounted
## Takes the drift off the headings of a suit's sensors, slowly and all the time, as [HeadingDrift]
## finds it; or at once, while the wearer stands and looks ahead.
##
## A new calibration begins with none. A suit whose list of sensors changes keeps what is known of
## those that stay where they were. For one thread.

## Drift below which nothing is corrected, degrees a minute.
const STEADY_DEG_MIN: float = 0.3
## Greatest distance of a limb's tilt from that of a reset pose, degrees.
const IN_POSE_DEG: float = 30.0

## What finds the drift, by mount.
var drift: HeadingDrift = HeadingDrift.new()

var _calibration: Calibration = null
var _mounts: PackedInt32Array = PackedInt32Array()
var _size: BodySize = null


## Forgets all drift.
func clear() -> void:
	drift.reset()
	_calibration = null


## Takes a frame and corrects the table that turns it into poses.
func add(p_frame: SensorFrame, p_table: SuitTable) -> void:
	if not p_table.is_calibrated:
		return
	var is_followed: bool = p_table.calibration == _calibration and p_table.size == _size
	if not is_followed or p_table.mounts != _mounts:
		_follow(p_table)
	drift.add(
		p_frame.time_usec,
		p_frame.present,
		p_frame.orientations,
		p_frame.magnetics,
		p_frame.accelerations
	)
	p_table.correct(corrections())


## The correction of each sensor's heading, rad.
func corrections() -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	found.resize(_mounts.size())
	for sensor: int in _mounts.size():
		if _mounts[sensor] >= 0:
			found[sensor] = drift.get_correction(_mounts[sensor])
	return found


## A calibration with the headings as they have become.
func corrected(p_calibration: Calibration) -> Calibration:
	if p_calibration == null or p_calibration != _calibration:
		return p_calibration
	var found: Calibration = Calibration.new()
	found.kind = p_calibration.kind
	found.pose = p_calibration.pose
	found.made_s = p_calibration.made_s
	for id: String in p_calibration.entries:
		var entry: Calibration.Entry = p_calibration.entries[id]
		var heading: float = entry.heading + drift.get_correction(entry.mount)
		found.set_entry(id, entry.mount, heading, entry.mounting, entry.heading_error)
	return found


## Sets the headings anew from a frame of a wearer who stands upright and looks ahead, feet
## parallel. Arms that hang or are held out to the sides are set too, others keep their angle to the
## chest. Mountings stay. Returns why it cannot, or an empty text.
func reset_ahead(p_frame: SensorFrame, p_table: SuitTable) -> String:
	if p_frame == null:
		return "the suit says nothing"
	if not p_table.is_calibrated:
		return "the suit is not calibrated yet"
	var turns: PackedFloat64Array = []
	for mount: int in BodyMounts.COUNT:
		turns.append(NAN)
	for sensor: int in mini(p_frame.count(), p_table.mounts.size()):
		if p_frame.present[sensor] == 0 or p_table.entry(sensor) == null:
			continue
		# As the table has it, the correction being taken off already.
		var limb: Quaternion = p_table.rotation(sensor, p_frame.orientation(sensor))
		var mount: int = p_table.mounts[sensor]
		turns[mount] = _turn_from_pose(mount, limb)
		if is_nan(turns[mount]) and not ResetPose.hangs(mount):
			return "the %s is not upright: stand and look ahead" % BodyMounts.title(mount)
	return _set_turns(turns)


## How fast a mount's heading drifts, degrees a minute; 0 where nothing is corrected.
func rate_deg_min(p_mount: int) -> float:
	return rad_to_deg(drift.get_rate(p_mount)) * 60.0 * drift.get_trust()


## The state of a mount's heading in words: "steady", or how fast it drifts.
func describe(p_mount: int) -> String:
	var rate: float = rate_deg_min(p_mount)
	if absf(rate) < STEADY_DEG_MIN:
		return "steady"
	return "drifting %.1f°/min, corrected" % absf(rate)


## How far a limb is turned about the vertical from the reset pose that it is in, rad; NaN if it is
## in none.
static func _turn_from_pose(p_mount: int, p_limb: Quaternion) -> float:
	var best: float = deg_to_rad(IN_POSE_DEG)
	var found: float = NAN
	for kind: ResetPose.Kind in [ResetPose.Kind.T, ResetPose.Kind.N]:
		var off: Quaternion = p_limb * ResetPose.rotation(kind, p_mount).inverse()
		var turn: float = Rotations.yaw_of(off)
		var tilt: float = Rotations.angle(Rotations.yaw(-turn) * off)
		if tilt < best:
			best = tilt
			found = turn
	return found


func _set_turns(p_turns: PackedFloat64Array) -> String:
	var drifts: PackedFloat64Array = []
	var known: int = 0
	for mount: int in BodyMounts.COUNT:
		var above: int = mount
		while above >= 0 and is_nan(p_turns[above]):
			above = BodyMounts.PARENTS[above]
		known += 1 if above == mount else 0
		drifts.append(drift.get_correction(mount) + (p_turns[above] if above >= 0 else 0.0))
	if known == 0:
		return "no sensor says anything"
	drift.restart(drifts)
	return ""


func _follow(p_table: SuitTable) -> void:
	if p_table.calibration != _calibration:
		drift.reset()
	_calibration = p_table.calibration
	_size = p_table.size
	SensorPositions.new(_size).set_joints(drift)
	_mounts = p_table.mounts.duplicate()
	for sensor: int in _mounts.size():
		var entry: Calibration.Entry = p_table.entry(sensor)
		if entry != null:
			drift.set_sensor(sensor, _mounts[sensor], entry.heading, entry.mounting)
		else:
			# Moved, or taken off: it says nothing of a limb until it is calibrated anew.
			drift.set_sensor(sensor, -1, 0.0, Quaternion.IDENTITY)
