class_name CalibrationSolver
extends RefCounted
## Computes a calibration from what was measured while the wearer followed a [CalibrationGuide].

## An exchange is named only if it fits better by this much: here people are asked to take poses,
## not to show which sensor is which.
const MUCH_BETTER: float = 5.0

## Poses that were held.
var holds: Dictionary[ResetPose.Kind, PoseHold] = {}
## Movements that were made.
var axes: Dictionary[GuideMovements.Movement, MotionAxis] = {}
## The sensors, in the order of the frames.
var sensors: Array[SensorInfo] = []
## Mount of each sensor, -1 if it is not worn.
var mounts: PackedInt32Array = PackedInt32Array()
## How it is to be done.
var options: CalibrationOptions = CalibrationOptions.new()
## The present calibration, or null.
var old: Calibration = null

var _result: CalibrationResult = null
var _pose: ResetPose.Kind = ResetPose.Kind.T
var _finder: HeadingFinder = null
var _turned_from_old: float = NAN
var _common: float = 0.0


## The result of a kind of calibration that ended at a time, s of Unix time.
func solve(p_kind: CalibrationGuide.Kind, p_now_s: float) -> CalibrationResult:
	_result = CalibrationResult.new()
	if not _find_pose():
		_result.error = "no sensor said anything while the pose was held"
		return _result
	_result.calibration = Calibration.new()
	_result.calibration.kind = p_kind
	_result.calibration.pose = _pose
	_result.calibration.made_s = p_now_s
	_find_headings()
	_find_swaps()
	_common = _common_heading()
	var each: bool = _is_each_its_own()
	for sensor: int in sensors.size():
		if mounts[sensor] >= 0:
			_solve_sensor(sensor, each)
	_result.mounts.sort_custom(
		func(a: CalibrationResult.PlaceQuality, b: CalibrationResult.PlaceQuality) -> bool:
			return a.mount < b.mount
	)
	if _result.mounts.is_empty():
		_result.error = "no sensor has a mount on the body"
	_result.judge()
	_advise_on_headings(each)
	return _result


func _find_pose() -> bool:
	_pose = options.pose
	if not holds.has(_pose) and not holds.is_empty():
		_pose = holds.keys()[0]
	return holds.has(_pose) and holds[_pose].frames() > 0


func _find_headings() -> void:
	_finder = HeadingFinder.new()
	var both: bool = holds.has(ResetPose.Kind.T) and holds.has(ResetPose.Kind.N)
	for sensor: int in sensors.size():
		var mount: int = mounts[sensor]
		if mount < 0:
			continue
		for movement: GuideMovements.Movement in axes:
			var wanted: Vector3 = GuideMovements.axis(movement, mount)
			var axis: MotionAxis = axes[movement]
			if movement == GuideMovements.Movement.ARMS and both and _held_both(sensor):
				# From pose to pose is steadier than the path between them.
				var start: Quaternion = holds[ResetPose.Kind.T].mean(sensor)
				var turn: Vector3 = Rotations.vector(
					holds[ResetPose.Kind.N].mean(sensor) * start.inverse()
				)
				var level: Vector3 = Vector3(turn.x, 0.0, turn.z)
				var purity: float = level.length() / maxf(turn.length(), 1e-6)
				_finder.add(mount, wanted, level.normalized(), turn.length(), purity)
			else:
				var angle: float = axis.turn(sensor)
				_finder.add(mount, wanted, axis.axis(sensor), angle, axis.purity(sensor))


## Sensors that turned when others should have, or the other way round; their headings do not
## count.
func _find_swaps() -> void:
	var odd: PackedInt32Array = _finder.reversed()
	for mount: int in odd:
		var mirror: int = BodyMounts.MIRRORS[mount]
		var above: int = BodyMounts.PARENTS[mount]
		if mirror > mount and odd.has(mirror):
			_result.swaps.append(Vector2i(mount, mirror))
		elif odd.has(above) and not odd.has(BodyMounts.MIRRORS[above]):
			_result.swaps.append(Vector2i(above, mount))
	for mount: int in odd:
		_finder.forget(mount)
	for swap: Vector2i in FitCheck.find_swaps(mounts, axes, MUCH_BETTER):
		if not _result.swaps.has(swap):
			_result.swaps.append(swap)
	for swap: Vector2i in _result.swaps:
		_result.advice.append(FitCheck.describe(swap))


func _held_both(p_sensor: int) -> bool:
	return holds[ResetPose.Kind.T].has(p_sensor) and holds[ResetPose.Kind.N].has(p_sensor)


func _common_heading() -> float:
	if options.facing != CalibrationOptions.Facing.MOVEMENT:
		return options.given_heading()
	if not _finder.measured.is_empty():
		return _finder.common()
	_turned_from_old = _turn_since_old()
	return 0.0


## By how much the wearer's front has turned since the old calibration, rad; NaN without one.
func _turn_since_old() -> float:
	var turns: Array = []
	for sensor: int in sensors.size():
		var entry: Calibration.Entry = _old_entry(sensor)
		if entry != null and holds[_pose].has(sensor):
			var turned: Quaternion = entry.rotation(holds[_pose].mean(sensor))
			turned *= ResetPose.rotation(_pose, mounts[sensor]).inverse()
			turns.append(Rotations.yaw_of(turned))
	return HeadingFinder.middle(turns) if not turns.is_empty() else NAN


func _old_entry(p_sensor: int) -> Calibration.Entry:
	if old == null or mounts[p_sensor] < 0:
		return null
	return old.entry_for(sensors[p_sensor].id, mounts[p_sensor])


func _is_each_its_own() -> bool:
	if options.align == CalibrationOptions.Align.AUTO:
		return _finder.spread() > deg_to_rad(CalibrationResult.OWN_NORTH_DEG)
	return options.align == CalibrationOptions.Align.EACH


func _heading_of(p_sensor: int, p_each: bool) -> float:
	if p_each:
		return _finder.nearest(mounts[p_sensor], _common)
	if is_nan(_turned_from_old):
		return _common
	var entry: Calibration.Entry = _old_entry(p_sensor)
	return _turned_from_old + (entry.heading if entry != null else _old_common())


func _old_common() -> float:
	return HeadingFinder.middle(
		old.entries.values().map(func(entry: Calibration.Entry) -> float: return entry.heading)
	)


func _solve_sensor(p_sensor: int, p_each: bool) -> void:
	var mount: int = mounts[p_sensor]
	var quality: CalibrationResult.PlaceQuality = CalibrationResult.PlaceQuality.new()
	quality.mount = mount
	quality.sensor = sensors[p_sensor].id
	_result.mounts.append(quality)
	if not holds[_pose].has(p_sensor):
		quality.is_missing = true
		return
	var heading: float = _heading_of(p_sensor, p_each)
	quality.heading_deg = rad_to_deg(wrapf(heading, -PI, PI))
	quality.is_heading_measured = p_each and _finder.measured.has(mount)
	quality.movement_deg = holds[_pose].movement_deg(p_sensor)
	var wanted: Quaternion = ResetPose.rotation(_pose, mount)
	var said: Quaternion = holds[_pose].mean(p_sensor)
	_result.calibration.set_sensor(quality.sensor, mount, heading, said, wanted)
	var entry: Calibration.Entry = _result.calibration.entries[quality.sensor]
	for other: ResetPose.Kind in holds:
		if other != _pose and holds[other].has(p_sensor):
			var there: Quaternion = entry.rotation(holds[other].mean(p_sensor))
			quality.movement_deg = maxf(quality.movement_deg, holds[other].movement_deg(p_sensor))
			quality.residual_deg = Rotations.between_deg(there, ResetPose.rotation(other, mount))


func _advise_on_headings(p_each: bool) -> void:
	if options.facing == CalibrationOptions.Facing.MOVEMENT and _finder.measured.is_empty():
		if axes.has(GuideMovements.Movement.ARMS):
			_result.advice.append("the arms' movement was not seen: bring both arms down, straight")
		elif is_nan(_turned_from_old):
			_result.advice.append("nothing shows which way you face: taken as facing north")
	var odd: PackedStringArray = []
	for mount: int in _finder.measured:
		var off: float = absf(angle_difference(_finder.common(), _finder.measured[mount]))
		if off > deg_to_rad(CalibrationResult.TURNED_DEG):
			odd.append("%s by %d°" % [BodyMounts.title(mount), roundi(rad_to_deg(off))])
	if odd.is_empty():
		return
	var differ: String = ", ".join(odd)
	if not p_each:
		_result.advice.append("turned about another axis (%s): straight to the side?" % differ)
	elif axes.size() < 2:
		var wanted: String = "a full calibration aligns trunk and legs too"
		_result.advice.append("the norths of the sensors differ (%s): %s" % [differ, wanted])
	else:
		_result.advice.append("the norths of the sensors differ (%s): each got its own" % differ)
