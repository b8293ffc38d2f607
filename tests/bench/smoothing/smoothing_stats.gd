extends RefCounted
## Compares what was shown with what was true, over several runs.

const Motion: GDScript = preload("smoothing_motion.gd")
const Run: GDScript = preload("smoothing_run.gd")
## Lags between which the best is looked for, s.
const _MIN_LAG_S: float = -0.05
const _MAX_LAG_S: float = 0.25
const _GOLDEN: float = 0.6180339887

## The lag at which what is shown fits best, ms.
var lag_ms: float = 0.0
## What then is left, mm RMS over all limbs.
var residual_mm: float = 0.0
## The error against the truth at the time of the display, RMS.
var now_deg: float = 0.0
var now_mm: float = 0.0
## RMS jerk of what is shown over that of the truth, both at the display's rate.
var jerk: float = 0.0
## The widest gap at any joint, mm.
var gap_mm: float = 0.0

var _runs: Array[Run] = []


func _init(p_runs: Array[Run]) -> void:
	_runs = p_runs
	var squares: float = 0.0
	var count: int = 0
	for run: Run in _runs:
		squares += run.angle_squares
		count += run.angles
		gap_mm = maxf(gap_mm, run.gap * 1000.0)
	now_deg = rad_to_deg(sqrt(squares / count))
	now_mm = _error(0.0) * 1000.0
	_find_lag()
	jerk = _jerk_ratio()


## Golden section: the error grows to both sides of the best lag.
func _find_lag() -> void:
	var low: float = _MIN_LAG_S
	var high: float = _MAX_LAG_S
	while high - low > 0.0005:
		var third: float = high - (high - low) * _GOLDEN
		var other: float = low + (high - low) * _GOLDEN
		if _error(third, 3) < _error(other, 3):
			high = other
		else:
			low = third
	lag_ms = (low + high) * 500.0
	residual_mm = _error((low + high) / 2.0) * 1000.0


## RMS distance (m) to the truth so many seconds ago; of every n-th frame.
func _error(p_lag_s: float, p_every: int = 1) -> float:
	var sum: float = 0.0
	var count: int = 0
	for run: Run in _runs:
		var limbs: int = run.motion.skeleton.count()
		for frame: int in range(0, run.times.size(), p_every):
			var at: float = (run.times[frame] - p_lag_s) * Motion.RATE
			var sample: int = clampi(int(at), 0, run.motion.count - 2)
			var part: float = clampf(at - sample, 0.0, 1.0)
			var first: int = sample * limbs
			for limb: int in limbs:
				var true_place: Vector3 = run.motion.places[first + limb].lerp(
					run.motion.places[first + limbs + limb], part
				)
				sum += run.shown[frame * limbs + limb].distance_squared_to(true_place)
		@warning_ignore("integer_division")
		count += limbs * ((run.times.size() + p_every - 1) / p_every)
	return sqrt(sum / maxi(count, 1))


func _jerk_ratio() -> float:
	var shown: float = 0.0
	var true_sum: float = 0.0
	for run: Run in _runs:
		var limbs: int = run.motion.skeleton.count()
		shown += _jerk(run.shown, limbs)
		true_sum += _jerk(_true_places(run), limbs)
	return sqrt(shown / maxf(true_sum, 1e-12))


## Where the limbs truly were, as many times as they were shown and as far apart.
func _true_places(p_run: Run) -> PackedVector3Array:
	var limbs: int = p_run.motion.skeleton.count()
	var all: PackedVector3Array = p_run.motion.places
	var places: PackedVector3Array = PackedVector3Array()
	var first: int = int(p_run.times[0] * Motion.RATE)
	for frame: int in p_run.times.size():
		var at: float = minf(first + frame * Motion.RATE / p_run.display_rate, p_run.motion.count)
		var sample: int = clampi(int(at), 1, p_run.motion.count - 3)
		for limb: int in range(sample * limbs, (sample + 1) * limbs):
			var before: Vector3 = all[limb - limbs]
			var behind: Vector3 = all[limb + 2 * limbs]
			places.append(
				all[limb].cubic_interpolate(all[limb + limbs], before, behind, at - sample)
			)
	return places


## Sum of the squares of the third differences.
static func _jerk(p_places: PackedVector3Array, p_step: int) -> float:
	var sum: float = 0.0
	for at: int in p_places.size() - 3 * p_step:
		var middle: Vector3 = p_places[at + 2 * p_step] - p_places[at + p_step]
		sum += (p_places[at + 3 * p_step] - 3.0 * middle - p_places[at]).length_squared()
	return sum
