class_name ErrorForecast
extends RefCounted
## How far limbs will probably be off with a calibration, in degrees, from how much its heading and
## its mounting are off.

## Weight of the usual error of poses, as a number of observations of one limb.
const USUAL: float = 6.0
## How far mounts are tilted from the N-pose while people walk, jump and box, degrees, in each third
## of the time, by mount of [BodyMounts]: medians over recorded clips (assets/motion, whole; left as
## right), and for the last third what makes the mean effect of a wrong heading right.
const TILTS_DEG: Array[Vector3] = [
	Vector3(3, 7, 25),
	Vector3(6, 14, 46),
	Vector3(8, 17, 44),
	Vector3(6, 14, 46),
	Vector3(14, 27, 64),
	Vector3(23, 64, 122),
	Vector3(35, 75, 118),
	Vector3(6, 14, 46),
	Vector3(14, 27, 64),
	Vector3(23, 64, 122),
	Vector3(35, 75, 118),
	Vector3(7, 17, 48),
	Vector3(14, 24, 41),
	Vector3(9, 18, 37),
	Vector3(7, 17, 48),
	Vector3(14, 24, 41),
	Vector3(9, 18, 37),
]


## The error of one limb that is expected, degrees. [param p_deviations] are the standard deviations
## of the heading, rad, under hypotheses of the probabilities [param p_weights].
static func limb_deg(
	p_fit: SensorFit,
	p_model: WearerModel,
	p_deviations: PackedFloat64Array,
	p_weights: PackedFloat64Array
) -> float:
	var scale: float = _scale(p_fit, p_model)
	var mounting: Array[Vector3] = []
	for row: int in 3:
		var at: int = row * 3
		var covariance: PackedFloat64Array = p_fit.mounting_covariance
		mounting.append(Vector3(covariance[at], covariance[at + 1], covariance[at + 2]) * scale)
	var up: Vector3 = ResetPose.rotation(ResetPose.Kind.N, p_fit.mount).inverse() * Vector3.UP
	var sum: float = 0.0
	for at: int in p_weights.size():
		if p_weights[at] <= 0.0:
			continue
		# The mean square of how far apart the ends of a turned arm of length 1 are.
		var heading: float = 2.0 - 2.0 * exp(-0.5 * p_deviations[at] ** 2)
		for third: int in 3:
			var tilt: float = deg_to_rad(TILTS_DEG[p_fit.mount][third])
			sum += p_weights[at] / 3.0 * _mean_off(mounting, p_fit.coupling, up, tilt, heading)
	return rad_to_deg(sum)


## The mean length of a vector whose parts are normal, with mean 0 and a covariance: as if it were
## even in as many directions as the covariance has weight in (Satterthwaite's approximation).
static func mean_length(p_covariance: Array[Vector3]) -> float:
	var trace: float = p_covariance[0].x + p_covariance[1].y + p_covariance[2].z
	var squares: float = 0.0
	for row: Vector3 in p_covariance:
		squares += row.length_squared()
	if trace <= 0.0:
		return 0.0
	var directions: float = clampf(trace * trace / squares, 1.0, 3.0)
	# The mean of chi over its root mean square is 0.798, 0.886 and 0.921 for 1, 2 and 3.
	return sqrt(trace) * (1.0 - 0.25 / directions + 0.05 / (directions * directions))


## The mean length of what a limb is off, rad, that is tilted by an angle to any side: with its
## mounting off by a covariance, and its heading by a variance, which turns the mounting too.
static func _mean_off(
	p_mounting: Array[Vector3], p_coupling: Vector3, p_up: Vector3, p_tilt: float, p_heading: float
) -> float:
	var along: Vector3 = p_coupling - p_up * cos(p_tilt)
	var aside: Vector3 = p_up.cross(Vector3(p_up.z, p_up.x, p_up.y)).normalized() * sin(p_tilt)
	var sum: float = 0.0
	for quarter: int in 4:
		var turned: Vector3 = along + aside.rotated(p_up, PI / 2.0 * quarter)
		var rows: Array[Vector3] = p_mounting.duplicate()
		for row: int in 3:
			rows[row] += turned * turned[row] * p_heading
		sum += mean_length(rows) / 4.0
	return sum


## By how much more or less a limb's poses are off than is usual for this wearer, in variance: as
## far as they disagree.
static func _scale(p_fit: SensorFit, p_model: WearerModel) -> float:
	var off: Vector4 = p_model.apart(p_fit)
	var squares: float = off.x * off.x + off.y * off.y + off.z * off.z
	return (USUAL + squares / p_model.apart_variance(p_fit)) / (USUAL + off.w)
