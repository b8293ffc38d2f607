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
		@warning_ignore("integer_division")
		var step: int = limbs * Motion.RATE / Run.DISPLAY_RATE
		var first: int = int(run.times[0] * Motion.RATE) * limbs
		for at: int in range(0, run.shown.size() - 3 * limbs):
			shown += _third(run.shown, at, limbs)
			@warning_ignore("integer_division")
			true_sum += _third(run.motion.places, first + at / limbs * step + at % limbs, step)
	return sqrt(shown / maxf(true_sum, 1e-12))


static func _third(p_places: PackedVector3Array, p_at: int, p_step: int) -> float:
	if p_at + 3 * p_step >= p_places.size():
		return 0.0
	return (
		(
			p_places[p_at + 3 * p_step]
			- 3.0 * (p_places[p_at + 2 * p_step] - p_places[p_at + p_step])
			- p_places[p_at]
		)
		. length_squared()
	)
