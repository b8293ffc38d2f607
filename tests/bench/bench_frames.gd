extends Bench
## How old the motion is that frames show at any rate of the display, and how long a step takes.
##
## Real motion on the soldier's skeleton, 60 ticks/s over a LAN with late and lost datagrams, in
## simulated time; at most rates the display's phase drifts against the ticks. Age: of the shown
## moment at the frame's time, as clients measure it ([FrameAges]). Lag: how old what is shown is by
## its content, which no extrapolation can better: where it fits the truth best. Step: from the
## sample in which a hand suddenly is turned to the first frames that show a tenth and half of it.
## Free: frames begin when they are due; screen: up to 4 ms late. Options: --fps=59 (again for more;
## default 50 to 144), --bvh=FILE (again for more; default the clips in assets/motion),
## --seconds=12 (of each clip), --seed=1.

const Stats: GDScript = preload("smoothing/smoothing_stats.gd")
const Motion: GDScript = preload("smoothing/smoothing_motion.gd")
const Watched: GDScript = preload("smoothing/smoothing_run.gd")
const Display: GDScript = preload("frames/frames_display.gd")
const Run: GDScript = preload("frames/frames_run.gd")
const Steps: GDScript = preload("frames/frames_steps.gd")
const _RATES: PackedStringArray = ["50", "59", "60", "72", "75", "90", "120", "144"]
## How much later than the screen's beat frames begin at most, s.
const _LATENESS_S: float = 0.004
const _MAX_AGE_MS: float = 17.0
const _MAX_SD_MS: float = 4.0
const _MAX_JERK: float = 1.0
## Of a step, %.
const _MAX_OVERSHOOT: float = 10.0

var _motions: Array[Motion] = []


func options() -> Dictionary:
	return {"fps": ["", 10, 240], "bvh": "", "seconds": [12.0, 4.0, 3600.0], "seed": 1}


func measure() -> void:
	Motion.open_all(arguments, report, _motions)
	for rate: String in values("fps", _RATES if not _motions.is_empty() else PackedStringArray()):
		_measure(rate.to_float(), 0.0, "%s Hz, free" % rate)
		_measure(rate.to_float(), _LATENESS_S, "%s Hz, screen" % rate)


func _measure(p_rate: float, p_lateness_s: float, p_case: String) -> void:
	var runs: Array[Watched] = []
	var ages: LatencyHistogram = LatencyHistogram.new()
	for motion: Motion in _motions:
		var display: Display = Display.new(p_rate, p_lateness_s, option("seed"))
		var run: Run = Run.new()
		run.watch_on(motion, display)
		runs.append(run)
		ages.merge(display.ages.ages)
	var stats: Stats = Stats.new(runs)
	report.at_most(p_case, "age, mean", ages.mean(), "ms", _MAX_AGE_MS)
	report.at_most(p_case, "age, sd", ages.deviation(), "ms", _MAX_SD_MS)
	report.at_most(p_case, "lag", stats.lag_ms, "ms", _MAX_AGE_MS)
	report.add(p_case, "residual", stats.residual_mm, "mm")
	report.at_most(p_case, "jerk", stats.jerk, "of truth", _MAX_JERK)
	var steps: Steps = Steps.new()
	steps.watch_on(_motions[0].skeleton, Display.new(p_rate, p_lateness_s, option("seed")))
	report.add(p_case, "step, a tenth", steps.first.mean(), "ms")
	report.add(p_case, "step, half", steps.half.mean(), "ms")
	report.add(p_case, "step, half, sd", steps.half.deviation(), "ms")
	report.at_most(p_case, "step, overshoot", steps.overshoot * 100.0, "%", _MAX_OVERSHOOT)
