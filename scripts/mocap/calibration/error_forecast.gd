class_name ErrorForecast
extends RefCounted
## How far limbs will probably be off with a calibration, in degrees, from how much its heading and
## its mounting are off.

## So many numbers that poses usually are off by weigh as much as what one limb shows of itself.
const USUAL: float = 6.0
## Part of the vertical that stays where it is in a mount's axes while people walk, jump and box,
## from the N-pose, by mount of [BodyMounts]: the mean over recorded clips.
const STAYS: PackedFloat64Array = [
	0.95, 0.9, 0.88, 0.9, 0.75, 0.4, 0.35, 0.9, 0.75, 0.4, 0.35, 0.85, 0.86, 0.9, 0.85, 0.86, 0.9
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
	var stays: float = STAYS[p_fit.mount]
	var along: Vector3 = p_fit.coupling - up * stays
	var sum: float = 0.0
	for at: int in p_weights.size():
		if p_weights[at] <= 0.0:
			continue
		var heading: float = p_deviations[at] ** 2
		var rows: Array[Vector3] = mounting.duplicate()
		for row: int in 3:
			rows[row] += along * along[row] * heading
			# The rest of the vertical is anywhere.
			rows[row][row] += heading * (1.0 - stays * stays) / 3.0
		sum += p_weights[at] * mean_length(rows)
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


## By how much more or less a limb's poses are off than is usual for this wearer, in variance: as
## far as they disagree.
static func _scale(p_fit: SensorFit, p_model: WearerModel) -> float:
	var off: Vector4 = p_model.apart(p_fit)
	var squares: float = off.x * off.x + off.y * off.y + off.z * off.z
	return (USUAL + squares / p_model.apart_variance(p_fit)) / (USUAL + off.w)
