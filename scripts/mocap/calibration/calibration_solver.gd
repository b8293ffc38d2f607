class_name CalibrationSolver
extends RefCounted
## Computes a calibration from what was measured while the wearer followed a [CalibrationGuide].
##
## Poses and movements give each sensor's heading and mounting ([SensorFit]), all sensors together
## how far their norths agree ([NorthFinder]) and how exactly the wearer did as asked
## ([WearerModel]); from all of it follows how far off the limbs will be ([ErrorForecast]).

## An exchange is named only if it fits better by this much: here people are asked to take poses,
## not to show which sensor is which.
const MUCH_BETTER: float = 5.0
## Poses that disagree by more contradict each other: only the one that is the reference counts,
## rad.
const CONTRADICTS_RAD: float = 0.8
## Arms do not come down further ahead of the body than this, or behind it: norths differ then, rad.
const AHEAD_RAD: float = 0.35
## Rounds of learning how exact the wearer is.
const ROUNDS: int = 3
## How exact an earlier calibration's headings are at best, where nothing is said of it, and how
## fast and far they become worse, degrees and degrees per minute.
const OLD_DEG: float = 0.5
const UNKNOWN_DEG: float = 10.0
const OLD_DEG_MIN: float = 0.5
const OLDEST_DEG: float = 30.0

## Poses that were held, in their order.
var holds: Array[PoseHold] = []
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
var _now_s: float = 0.0
var _model: WearerModel = WearerModel.new()
var _norths: NorthFinder = null
var _fits: Array[SensorFit] = []
# By sensor: a first estimate of its heading from its movements, rad.
var _first: Dictionary[int, float] = {}
var _turned_from_old: float = NAN


## The result of a kind of calibration that ended at a time, s of Unix time.
func solve(p_kind: CalibrationGuide.Kind, p_now_s: float) -> CalibrationResult:
	_result = CalibrationResult.new()
	_now_s = p_now_s
	if not _find_pose():
		_result.error = "no sensor said anything while the pose was held"
		return _result
	_result.calibration = Calibration.new()
	_result.calibration.kind = p_kind
	_result.calibration.pose = _pose
	_result.calibration.made_s = p_now_s
	for sensor: int in sensors.size():
		if mounts[sensor] >= 0 and FitReader.first_hold(holds, _pose).has(sensor):
			_add_fit(sensor)
	_find_exchanges()
	_turned_from_old = _turn_since_old()
	_place_headings()
	_solve_all()
	for sensor: int in sensors.size():
		if mounts[sensor] >= 0:
			_add_quality(sensor)
	_result.mounts.sort_custom(
		func(a: CalibrationResult.PlaceQuality, b: CalibrationResult.PlaceQuality) -> bool:
			return a.mount < b.mount
	)
	if _result.mounts.is_empty():
		_result.error = "no sensor has a mount on the body"
	_result.judge()
	_advise_on_headings()
	return _result


func _find_pose() -> bool:
	_pose = options.pose
	if FitReader.first_hold(holds, _pose) == null and not holds.is_empty():
		_pose = holds[0].pose
	var held: PoseHold = FitReader.first_hold(holds, _pose)
	return held != null and held.frames() > 0


func _add_fit(p_sensor: int) -> void:
	var fit: SensorFit = FitReader.read(p_sensor, mounts[p_sensor], holds, axes)
	_fits.append(fit)
	var heading: float = fit.estimate_heading()
	if not is_nan(heading):
		_first[p_sensor] = heading


## Sensors that turned when others should have, or the other way round; their headings do not
## count.
func _find_exchanges() -> void:
	var found: Dictionary[int, float] = {}
	for fit: SensorFit in _fits:
		if _first.has(fit.sensor):
			found[fit.mount] = _first[fit.sensor]
	var odd: PackedInt32Array = HeadingFinder.reversed(found)
	_result.present = mounts
	if _is_unsettled():
		# Somebody who did something else tells nothing of where sensors are worn.
		_result.assignment = mounts.duplicate()
		_result.advice.append("the body moved while poses were held: follow the figure, once more")
		return
	_result.assignment = FitCheck.new(mounts, axes, MUCH_BETTER).assign()
	for sensor: int in mounts.size():
		if _result.assignment[sensor] < 0:
			# These movements do not show that a sensor is not worn.
			_result.assignment = mounts.duplicate()
	for mount: int in odd:
		var mirror: int = BodyMounts.MIRRORS[mount]
		var above: int = BodyMounts.PARENTS[mount]
		if mirror > mount and odd.has(mirror):
			_exchange(mount, mirror)
		elif odd.has(above) and not odd.has(BodyMounts.MIRRORS[above]):
			_exchange(above, mount)
	for fit: SensorFit in _fits:
		if odd.has(fit.mount):
			_first.erase(fit.sensor)
			fit.turns.clear()
			fit.holds = [fit.hold(_pose)]
	_result.advice.append_array(FitCheck.advice(_result))


## Whether a good part of the body moved while poses were held.
func _is_unsettled() -> bool:
	var moved: int = 0
	for fit: SensorFit in _fits:
		for hold: SensorFit.Hold in fit.holds:
			if hold.movement > deg_to_rad(CalibrationResult.MOVED_DEG * 3.0):
				moved += 1
				break
	return moved * 3 > _fits.size()


## Notes that the sensors of two mounts are exchanged, if nothing else is known of them.
func _exchange(p_first: int, p_second: int) -> void:
	var first: int = mounts.find(p_first)
	var second: int = mounts.find(p_second)
	var known: PackedInt32Array = _result.assignment
	if known[first] == p_first and known[second] == p_second:
		known[first] = p_second
		known[second] = p_first
		_result.assignment = known


## Begins with headings from the movements, where there are none with what the others have.
func _place_headings() -> void:
	var usual: float = NorthFinder.middle(_first.values())
	if options.facing != CalibrationOptions.Facing.MOVEMENT and _first.is_empty():
		usual = options.given_heading()
	for fit: SensorFit in _fits:
		fit.heading = _first.get(fit.sensor, usual)
		var reference: SensorFit.Hold = fit.hold(_pose)
		fit.start_from(reference)
		for at: int in range(fit.holds.size() - 1, -1, -1):
			if fit.fault(fit.holds[at]).length() > CONTRADICTS_RAD:
				fit.holds.remove_at(at)


func _solve_all() -> void:
	for pass_number: int in ROUNDS:
		for fit: SensorFit in _fits:
			FitSolver.solve(fit, _model)
		_find_norths()
		for at: int in _fits.size():
			FitSolver.solve_for(_fits[at], _model, _norths.headings[at])
		if pass_number + 1 < ROUNDS:
			_learn()


func _learn() -> void:
	if holds.size() > 1:
		_model.learn(_fits)
		return
	var offs: Dictionary[SensorFit, Vector3] = {}
	for fit: SensorFit in _fits:
		var entry: Calibration.Entry = _old_entry(fit.sensor)
		if entry != null:
			# Mountings of both, each with the same heading: what differs is the pose.
			offs[fit] = Rotations.vector((fit.mounting * entry.mounting.inverse()).normalized())
	if not offs.is_empty():
		_model.learn_from_old(offs)


func _find_norths() -> void:
	var measured: PackedFloat64Array = []
	var variances: PackedFloat64Array = []
	var ahead: float = _ahead_variance()
	for fit: SensorFit in _fits:
		var is_ahead: bool = ResetPose.hangs(fit.mount) and fit.turns.is_empty()
		measured.append(fit.heading)
		variances.append(fit.heading_variance + (ahead if is_ahead else 0.0))
	_norths = NorthFinder.new(measured, variances)
	var given: bool = options.facing != CalibrationOptions.Facing.MOVEMENT
	var is_auto: bool = options.align == CalibrationOptions.Align.AUTO
	var is_old: bool = is_auto and not is_nan(_turned_from_old) and not given
	if is_old:
		_suppose_old()
	if not is_old or not _first.is_empty():
		var centres: PackedFloat64Array = []
		centres.resize(_fits.size())
		var blurs: PackedFloat64Array = centres.duplicate()
		centres.fill(options.given_heading() if given else 0.0)
		_norths.suppose(centres, blurs, _usual_spreads(), not given)
	_norths.find()


## How far norths are apart before anything is measured: see [constant NorthFinder.COMMON].
func _usual_spreads() -> PackedFloat64Array:
	var spreads: PackedFloat64Array = NorthFinder.COMMON.duplicate()
	if options.align != CalibrationOptions.Align.AUTO:
		spreads.fill(0.0)
		var common: bool = options.align == CalibrationOptions.Align.COMMON
		spreads[0 if common else spreads.size() - 1] = 1.0
	return spreads


## The variance, rad², of what arms that come down ahead of the body, or behind it, turn the
## headings of both sides against each other: that is more probable than norths that are mirrored.
func _ahead_variance() -> float:
	var angles: Array = []
	for fit: SensorFit in _fits:
		if ResetPose.hangs(fit.mount) and fit.turns.is_empty() and _first.has(fit.sensor):
			angles.append(fit.heading)
	if angles.size() < 4:
		return 0.0
	var middle: float = NorthFinder.middle(angles)
	var sum: float = 0.0
	var squares: float = 0.0
	for fit: SensorFit in _fits:
		if ResetPose.hangs(fit.mount) and fit.turns.is_empty() and _first.has(fit.sensor):
			var out: float = angle_difference(middle, fit.heading) * BodyMounts.side(fit.mount)
			sum += out
			squares += out * out
	var mean: float = sum / angles.size()
	var spread: float = maxf(squares / angles.size() - mean * mean, 0.0) / (angles.size() - 1)
	return clampf(mean * mean - 2.0 * spread, 0.0, AHEAD_RAD * AHEAD_RAD)


## That norths are still as they were in the earlier calibration.
func _suppose_old() -> void:
	var own: PackedFloat64Array = []
	var blurs: PackedFloat64Array = []
	var aged_min: float = maxf(_now_s - old.made_s, 0.0) / 60.0
	for fit: SensorFit in _fits:
		var entry: Calibration.Entry = _old_entry(fit.sensor)
		own.append(_turned_from_old + (entry.heading if entry != null else _old_common()))
		var error: float = deg_to_rad(OLD_DEG)
		if entry == null or is_nan(entry.heading_error):
			error = deg_to_rad(UNKNOWN_DEG)
		else:
			error = maxf(error, entry.heading_error)
		error += deg_to_rad(minf(OLD_DEG_MIN * aged_min, OLDEST_DEG))
		blurs.append(error * error)
	_norths.suppose(own, blurs, NorthFinder.CHANGES, true)


## By how much the wearer's front has turned since the old calibration, rad; NaN without one.
func _turn_since_old() -> float:
	var turns: Array = []
	for fit: SensorFit in _fits:
		var entry: Calibration.Entry = _old_entry(fit.sensor)
		if entry != null:
			var turned: Quaternion = entry.rotation(fit.hold(_pose).said)
			turned *= ResetPose.rotation(_pose, fit.mount).inverse()
			turns.append(Rotations.yaw_of(turned))
	return NorthFinder.middle(turns) if not turns.is_empty() else NAN


func _old_entry(p_sensor: int) -> Calibration.Entry:
	if old == null or mounts[p_sensor] < 0:
		return null
	return old.entry_for(sensors[p_sensor].id, mounts[p_sensor])


func _old_common() -> float:
	if old == null:
		return 0.0
	return NorthFinder.middle(
		old.entries.values().map(func(entry: Calibration.Entry) -> float: return entry.heading)
	)


func _add_quality(p_sensor: int) -> void:
	var quality: CalibrationResult.PlaceQuality = CalibrationResult.PlaceQuality.new()
	quality.mount = mounts[p_sensor]
	quality.sensor = sensors[p_sensor].id
	_result.mounts.append(quality)
	quality.is_missing = true
	for at: int in _fits.size():
		var fit: SensorFit = _fits[at]
		if fit.sensor != p_sensor:
			continue
		quality.is_missing = false
		quality.heading_deg = rad_to_deg(wrapf(fit.heading, -PI, PI))
		quality.is_heading_measured = fit.heading_variance < NorthFinder.MEASURED_RAD ** 2
		_result.calibration.set_entry(
			quality.sensor, fit.mount, fit.heading, fit.mounting, _norths.deviation(at)
		)
		var deviations: PackedFloat64Array = []
		for list: PackedFloat64Array in _norths.deviations:
			deviations.append(list[at])
		quality.error_deg = ErrorForecast.limb_deg(fit, _model, deviations, _norths.weights)
		if not quality.is_heading_measured:
			deviations.fill(0.0)
			var seen: float = ErrorForecast.limb_deg(fit, _model, deviations, _norths.weights)
			quality.unseen_deg = quality.error_deg - seen
		_judge_holds(p_sensor, quality)


## How still the poses were held, and how far apart they are.
func _judge_holds(p_sensor: int, r_quality: CalibrationResult.PlaceQuality) -> void:
	var offs: Array[Quaternion] = []
	for held: PoseHold in holds:
		if held.has(p_sensor):
			var moved: float = held.movement_deg(p_sensor)
			r_quality.movement_deg = maxf(r_quality.movement_deg, moved)
			var entry: Calibration.Entry = _result.calibration.entries[r_quality.sensor]
			var limb: Quaternion = entry.rotation(held.mean(p_sensor))
			offs.append(ResetPose.rotation(held.pose, r_quality.mount).inverse() * limb)
	for at: int in range(1, offs.size()):
		var off: float = Rotations.between_deg(offs[0], offs[at])
		r_quality.residual_deg = maxf(r_quality.residual_deg, off)


func _advise_on_headings() -> void:
	if options.facing == CalibrationOptions.Facing.MOVEMENT and _first.is_empty():
		if axes.has(GuideMovements.Movement.ARMS):
			_result.advice.append("the arms' movement was not seen: bring both arms down, straight")
		elif is_nan(_turned_from_old):
			_result.advice.append("nothing shows which way you face: taken as facing north")
	_advise_on_unseen()
	var headings: Array = []
	for fit: SensorFit in _fits:
		headings.append(fit.heading)
	var common: float = NorthFinder.middle(headings)
	var odd: PackedStringArray = []
	for fit: SensorFit in _fits:
		var off: float = absf(angle_difference(common, fit.heading))
		if off > deg_to_rad(CalibrationResult.TURNED_DEG):
			odd.append("%s by %d°" % [BodyMounts.title(fit.mount), roundi(rad_to_deg(off))])
	if not odd.is_empty():
		var differ: String = ", ".join(odd)
		_result.advice.append("the norths of the sensors differ (%s): each got its own" % differ)


## Norths that nothing shows.
func _advise_on_unseen() -> void:
	if _result.unseen_deg < 1.0 or options.align == CalibrationOptions.Align.COMMON:
		return
	var parts: Array = [roundi(_result.unseen_deg)]
	_result.advice.append(
		"nothing shows where each sensor's north is, which is %d° usually: do a full one" % parts
	)
