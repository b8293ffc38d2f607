class_name NorthFinder
extends RefCounted
## The heading of each sensor from what is measured of it and from how far all of them usually
## agree: shrinkage, with a spread that the measured headings themselves show (empirical Bayes).
##
## Headings are spread about a common one, or about those of an earlier calibration turned as a
## whole. Each spread of [constant SPREADS_DEG] is a hypothesis, weighted by how probable it makes
## what was measured; for each of them a heading is the mean of the measured and the common one,
## weighted by the inverse variances. There is no threshold: norths that agree are taken as common,
## those that do not as they are, and everything between goes over smoothly.

## Spreads that are tried, degrees (standard deviation); the last: any north is as probable.
const SPREADS_DEG: PackedFloat64Array = [0.0, 1.0, 2.0, 4.0, 7.0, 11.0, 16.0, 23.0, 32.0, 45.0, INF]
## How often each is met before anything is measured: as often as if sensors' norths were up to 0 to
## 60 degrees apart, all of which is promised to work. Compasses in rooms without iron agree better;
## but who wears such sensors can say so, and nothing is to be called good that is not.
const COMMON: PackedFloat64Array = [
	0.03, 0.03, 0.04, 0.06, 0.08, 0.10, 0.13, 0.17, 0.18, 0.16, 0.02
]
## The same of changes since an earlier calibration.
const CHANGES: PackedFloat64Array = [
	0.6, 0.22, 0.1, 0.04, 0.02, 0.01, 0.005, 0.002, 0.0015, 0.001, 0.0005
]
## A heading that is known worse than this is not measured, rad.
const MEASURED_RAD: float = 0.5
## Hypotheses that are less probable are left out.
const LEAST: float = 0.003
## Standard deviation that stands for any north, rad: that of an even spread.
const EVEN_RAD: float = PI / 1.7320508

## The headings, rad, by the order of the sensors.
var headings: PackedFloat64Array = PackedFloat64Array()
## What each may be off, by hypothesis, rad: standard deviations; their probabilities are
## [member weights].
var deviations: Array[PackedFloat64Array] = []
var weights: PackedFloat64Array = PackedFloat64Array()

var _centres: PackedFloat64Array = PackedFloat64Array()
var _blurs: PackedFloat64Array = PackedFloat64Array()
var _measured: PackedFloat64Array = PackedFloat64Array()
var _variances: PackedFloat64Array = PackedFloat64Array()
var _means: Array[PackedFloat64Array] = []
var _logs: PackedFloat64Array = PackedFloat64Array()


## Takes what is measured: headings, rad, and their variances, rad² (INF: not at all).
func _init(p_measured: PackedFloat64Array, p_variances: PackedFloat64Array) -> void:
	_measured = p_measured
	_variances = p_variances


## Adds the hypotheses that headings are spread about [param p_centres], which are themselves off by
## variances [param p_blurs] (rad²), by [constant SPREADS_DEG] of the probabilities
## [param p_priors]; the centres are turned as a whole to what is measured, if [param p_turns].
func suppose(
	p_centres: PackedFloat64Array,
	p_blurs: PackedFloat64Array,
	p_priors: PackedFloat64Array,
	p_turns: bool
) -> void:
	_centres = p_centres
	_blurs = p_blurs
	for at: int in SPREADS_DEG.size():
		if p_priors[at] > 0.0:
			_suppose_one(deg_to_rad(SPREADS_DEG[at]), log(p_priors[at]), p_turns)


## How far the heading of a sensor is off, rad, in the mean of the hypotheses.
func deviation(p_at: int) -> float:
	var sum: float = 0.0
	for at: int in weights.size():
		sum += weights[at] * deviations[at][p_at]
	return sum


## Weighs all hypotheses and finds the headings.
func find() -> void:
	var best: float = -INF
	for value: float in _logs:
		best = maxf(best, value)
	var sum: float = 0.0
	for at: int in _logs.size():
		weights.append(exp(_logs[at] - best))
		sum += weights[at]
	for at: int in weights.size():
		weights[at] = 0.0 if weights[at] < LEAST * sum else weights[at] / sum
	headings.resize(_measured.size())
	for sensor: int in _measured.size():
		var mean: Vector2 = Vector2.ZERO
		for at: int in weights.size():
			mean += Vector2.from_angle(_means[at][sensor]) * weights[at]
		headings[sensor] = mean.angle()
		for at: int in weights.size():
			# What a hypothesis holds for another heading than the mean is off too.
			var off: float = angle_difference(headings[sensor], _means[at][sensor])
			deviations[at][sensor] = sqrt(deviations[at][sensor] ** 2 + off * off)


## The middle of angles, rad, robust against a few odd ones; 0 if there are none.
static func middle(p_angles: Array) -> float:
	var best: float = 0.0
	var best_sum: float = INF
	for angle: float in p_angles:
		var sum: float = 0.0
		for other: float in p_angles:
			sum += absf(angle_difference(angle, other))
		if sum < best_sum:
			best_sum = sum
			best = angle
	var mean: Vector2 = Vector2.ZERO
	for angle: float in p_angles:
		if absf(angle_difference(angle, best)) < 0.3:
			mean += Vector2.from_angle(angle)
	return mean.angle() if not p_angles.is_empty() else 0.0


func _suppose_one(p_spread: float, p_log: float, p_turns: bool) -> void:
	var any: bool = is_inf(p_spread)
	var all: float = 0.0 if any else p_spread * p_spread
	var turn: Vector2 = _turn(all) if p_turns else Vector2.ZERO
	var evidence: float = p_log
	var means: PackedFloat64Array = _centres.duplicate()
	var deviation: PackedFloat64Array = PackedFloat64Array()
	if p_turns and turn.y > 0.0 and not any:
		evidence += 0.5 * log(TAU * turn.y) - log(TAU)
	for sensor: int in _measured.size():
		var variance: float = _variances[sensor]
		var spread: float = all + _blurs[sensor]
		var centre: float = _centres[sensor] + turn.x
		var off: float = angle_difference(centre, _measured[sensor])
		if any:
			means[sensor] = _measured[sensor] if variance < EVEN_RAD ** 2 else centre
			deviation.append(minf(sqrt(variance), EVEN_RAD))
			evidence -= log(TAU) if variance < MEASURED_RAD ** 2 else 0.0
			continue
		if variance < MEASURED_RAD ** 2:
			evidence += _log_density(off, variance + spread)
		var prior: float = spread + turn.y
		var part: float = prior / (prior + variance) if not is_inf(variance) else 0.0
		means[sensor] = centre + off * part
		deviation.append(sqrt(prior * (1.0 - part)))
	_means.append(means)
	deviations.append(deviation)
	_logs.append(evidence)


## By how much the centres are turned as a whole, rad, and the variance of that, rad²; zero if
## nothing is measured.
func _turn(p_spread: float) -> Vector2:
	var angles: Array = []
	for sensor: int in _measured.size():
		if _variances[sensor] < MEASURED_RAD ** 2:
			angles.append(angle_difference(_centres[sensor], _measured[sensor]))
	if angles.is_empty():
		return Vector2.ZERO
	var turn: float = middle(angles)
	var total: float = 0.0
	for _round: int in 3:
		var sum: float = 0.0
		total = 0.0
		for sensor: int in _measured.size():
			if _variances[sensor] < MEASURED_RAD ** 2:
				var spread: float = p_spread + _blurs[sensor]
				var weight: float = 1.0 / (_variances[sensor] + spread + 1e-9)
				sum += weight * angle_difference(_centres[sensor] + turn, _measured[sensor])
				total += weight
		turn += sum / total
	return Vector2(turn, 1.0 / total)


## The logarithm of the density of an angle, rad, of a normal distribution that is wound round the
## circle.
static func _log_density(p_off: float, p_variance: float) -> float:
	var sum: float = 1e-12
	for turns: int in [-1, 0, 1]:
		var off: float = p_off + turns * TAU
		sum += exp(-0.5 * off * off / p_variance)
	return log(sum) - 0.5 * log(TAU * p_variance)
