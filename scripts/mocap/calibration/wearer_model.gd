class_name WearerModel
extends RefCounted
## How exactly a wearer holds poses and makes movements, learnt from that wearer's calibration
## itself (empirical Bayes).
##
## Each variance begins with what is usual and is drawn to what the data show: from where the two
## poses disagree, from how far axes that should be level are not, from whether movements begin as
## the pose before was held. A usual variance counts as much as so many observed ones (the inverse
## gamma prior of a normal variance; Gelman et al., Bayesian Data Analysis, section 2.6).

## Usual error of holding a pose: of arms and heads, and of the rest, degrees about each axis.
const USUAL_ARMS_DEG: float = 2.0
const USUAL_REST_DEG: float = 1.7
## Usual error of a movement's axis, degrees in each direction.
const USUAL_ASKEW_DEG: float = 2.0
## Weight of what is usual, as a number of observations: of poses, and of axes.
const USUAL_POSES: float = 4.0
const USUAL_AXES: float = 2.0
## A movement that turns a limb by this shows its axis with twice the variance of a large one, rad.
const HALF_SEEN_RAD: float = 0.4
## Of the axis' change during a movement this part is no part of the mean's error.
const SCATTER_PART: float = 0.25
## Variance of what a hold tells even of somebody who does all exactly, rad²: 0.05 degrees.
const FLOOR: float = 7.6e-7
## Movement during a hold, by so much of its largest part the mean is off.
const MOVEMENT_PART: float = 0.25
## Greatest error, rad: beyond it a limb has stepped, or its sensor has slipped.
const MAX_RAD: float = 0.5

## Whether movements go about axes of the limbs (1) or of the body (0); see [SensorFit].
var hinge: float = 0.5
## Variance of [member hinge].
var hinge_variance: float = 0.08

# What a limb is off each time that one pose is taken, rad² about each axis: of arms and heads, and
# of the rest.
var _arms: float = deg_to_rad(USUAL_ARMS_DEG) ** 2
var _rest: float = deg_to_rad(USUAL_REST_DEG) ** 2
# And what it is off differently when the pose is taken again.
var _arms_again: float = 0.0
var _rest_again: float = 0.0
var _askew: float = deg_to_rad(USUAL_ASKEW_DEG) ** 2
# Variance of how far arms hang from where they should, all together.
var _lowering: float = 0.0


## How much a limb may be off in a hold, by its axes, rad². What is the same in all holds of a pose
## does not become less by holding it again.
func pose_variance(p_fit: SensorFit, p_hold: SensorFit.Hold) -> Vector3:
	var again: float = _arms_again if _is_loose(p_fit.mount) else _rest_again
	var one: float = base_variance(p_fit.mount) * p_fit.count(p_hold.pose) + again
	one += FLOOR + (p_hold.movement * MOVEMENT_PART) ** 2
	var found: Vector3 = Vector3(one, one, one)
	if p_hold.pose == ResetPose.Kind.N and ResetPose.hangs(p_fit.mount):
		found.z += _lowering
	return found


## How far a limb is usually apart between T and N, rad² about each axis.
func apart_variance(p_fit: SensorFit) -> float:
	var again: float = _arms_again if _is_loose(p_fit.mount) else _rest_again
	var one: float = 2.0 * (base_variance(p_fit.mount) + FLOOR)
	for pose: ResetPose.Kind in [ResetPose.Kind.T, ResetPose.Kind.N]:
		one += again / maxi(p_fit.count(pose), 1)
	return one


## How exactly a mount is held in one pose, however often, rad² about each axis.
func base_variance(p_mount: int) -> float:
	return _arms if _is_loose(p_mount) else _rest


## How far the axis of a movement may be off in each direction, rad².
func axis_variance(p_turn: SensorFit.Turn) -> float:
	var seen: float = HALF_SEEN_RAD / maxf(p_turn.angle, 0.01)
	return _askew * (1.0 + seen * seen) + SCATTER_PART * p_turn.scatter ** 2 + FLOOR


## Learns from what [SensorFit]s leave unexplained.
func learn(p_fits: Array[SensorFit]) -> void:
	_learn_lowering(p_fits)
	_arms_again = _learn_again(p_fits, true)
	_rest_again = _learn_again(p_fits, false)
	_arms = _learn_poses(p_fits, true)
	_rest = _learn_poses(p_fits, false)
	for _round: int in 3:
		_learn_axes(p_fits)


## Learns from an older mounting of each sensor how exactly one pose is held now: both are off, the
## older one less, as it comes from two poses mostly.
func learn_from_old(p_offs: Dictionary[SensorFit, Vector3]) -> void:
	for is_arm: bool in [false, true]:
		var sum: float = 0.0
		var number: int = 0
		for fit: SensorFit in p_offs:
			var off: Vector3 = p_offs[fit]
			if _is_loose(fit.mount) == is_arm and off.length() < MAX_RAD:
				sum += off.length_squared() / 1.5
				number += 3
		if is_arm:
			_arms = _drawn(USUAL_ARMS_DEG, USUAL_POSES, sum, number)
		else:
			_rest = _drawn(USUAL_REST_DEG, USUAL_POSES, sum, number)


## What a mount is off in T beyond what it is off in N, in the directions that no heading changes;
## and how many directions those are.
func apart(p_fit: SensorFit) -> Vector4:
	if p_fit.count(ResetPose.Kind.T) == 0 or p_fit.count(ResetPose.Kind.N) == 0:
		return Vector4.ZERO
	var off: Vector3 = p_fit.mean_fault(ResetPose.Kind.T) - p_fit.mean_fault(ResetPose.Kind.N)
	if not ResetPose.hangs(p_fit.mount):
		return Vector4(off.x, off.y, off.z, 3.0)
	var up: Vector3 = ResetPose.rotation(ResetPose.Kind.N, p_fit.mount).inverse() * Vector3.UP
	var turned: Vector3 = (up - Vector3.UP).normalized()
	off -= turned * off.dot(turned)
	return Vector4(off.x, off.y, off.z, 2.0)


## The variance that is usual, drawn to observed squares.
static func _drawn(p_usual_deg: float, p_weight: float, p_sum: float, p_number: float) -> float:
	return (deg_to_rad(p_usual_deg) ** 2 * p_weight + p_sum) / (p_weight + p_number)


static func _is_loose(p_mount: int) -> bool:
	return ResetPose.hangs(p_mount) or p_mount == BodyMounts.HEAD


## Arms that all hang too far out were not brought down: that counts against N and not against T.
func _learn_lowering(p_fits: Array[SensorFit]) -> void:
	var sum: float = 0.0
	var squares: float = 0.0
	var number: int = 0
	for fit: SensorFit in p_fits:
		var off: Vector4 = apart(fit)
		if ResetPose.hangs(fit.mount) and off.w > 0.0:
			var out: float = off.z * BodyMounts.side(fit.mount)
			sum += out
			squares += out * out
			number += 1
	_lowering = 0.0
	if number >= 2:
		var mean: float = sum / number
		var spread: float = maxf(squares / number - mean * mean, 0.0) / (number - 1)
		_lowering = maxf(mean * mean - 2.0 * spread - 2.0 * _arms / number, 0.0)


## What is off in all holds of a pose alike, from how far T and N are apart.
func _learn_poses(p_fits: Array[SensorFit], p_arms: bool) -> float:
	var sum: float = 0.0
	var number: float = 0.0
	var again: float = _arms_again if p_arms else _rest_again
	for fit: SensorFit in p_fits:
		var off: Vector4 = apart(fit)
		var along: Vector3 = Vector3(off.x, off.y, off.z)
		if _is_loose(fit.mount) != p_arms or off.w == 0.0 or along.length() > MAX_RAD:
			continue
		if ResetPose.hangs(fit.mount) and _lowering > 0.0:
			along.z = 0.0
			off.w -= 1.0
		# Both poses are off, each as the mean over its holds.
		var means: float = again / fit.count(ResetPose.Kind.T)
		means += again / fit.count(ResetPose.Kind.N)
		sum += (along.length_squared() - off.w * means) / 2.0
		number += off.w
	return maxf(_drawn(USUAL_ARMS_DEG if p_arms else USUAL_REST_DEG, USUAL_POSES, sum, number), 0.0)


## The error that differs each time that a pose is taken, from poses that were held again; 0 if none
## was, as the two cannot be separated then.
func _learn_again(p_fits: Array[SensorFit], p_arms: bool) -> float:
	var sum: float = 0.0
	var number: int = 0
	for fit: SensorFit in p_fits:
		for pose: ResetPose.Kind in [ResetPose.Kind.T, ResetPose.Kind.N]:
			if _is_loose(fit.mount) != p_arms or fit.count(pose) < 2:
				continue
			var mean: Vector3 = fit.mean_fault(pose)
			for held: SensorFit.Hold in fit.holds:
				if held.pose == pose:
					sum += minf((fit.fault(held) - mean).length_squared(), MAX_RAD ** 2)
			number += 3 * (fit.count(pose) - 1)
	return sum / number if number > 0 else 0.0


## How far axes are not level, as far as limbs that were off in the pose before do not explain it;
## and whether they do.
func _learn_axes(p_fits: Array[SensorFit]) -> void:
	var products: float = 0.0
	var squares: float = 0.0
	var noise: float = _askew + hinge * hinge * _rest * 0.5
	for fit: SensorFit in p_fits:
		for turn: SensorFit.Turn in fit.turns:
			var expected: float = _expected_tilt(fit, turn)
			products += fit.deviation(turn).y * expected / noise
			squares += expected * expected / noise
	# Both are possible beforehand: a half, give or take a half.
	hinge = clampf((products + 2.0) / (squares + 4.0), 0.0, 1.0)
	hinge_variance = 1.0 / (squares + 4.0)
	var sum: float = 0.0
	var number: int = 0
	for fit: SensorFit in p_fits:
		for turn: SensorFit.Turn in fit.turns:
			var left: float = fit.deviation(turn).y - hinge * _expected_tilt(fit, turn)
			var seen: float = HALF_SEEN_RAD / maxf(turn.angle, 0.01)
			var explained: float = hinge * hinge * base_variance(fit.mount) * 0.5
			sum += maxf(minf(left * left, 0.1) - explained, 0.0) / (1.0 + seen * seen)
			number += 1
	_askew = _drawn(USUAL_ASKEW_DEG, USUAL_AXES, sum, number)


## How far up an axis of the limb would point, from what the two poses say of the limb, rad.
func _expected_tilt(p_fit: SensorFit, p_turn: SensorFit.Turn) -> float:
	var off: Vector4 = apart(p_fit)
	if off.w == 0.0:
		return 0.0
	var asked: Quaternion = ResetPose.rotation(ResetPose.Kind.N, p_fit.mount)
	var half: Vector3 = asked * Vector3(off.x, off.y, off.z) * -0.5
	return half.dot(p_turn.wanted.cross(Vector3.UP))
