extends SceneTree
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
const _DEFAULTS: Dictionary = {"fps": "", "bvh": "", "seconds": 12.0, "seed": 1}

var _arguments: BenchArguments = null
var _report: BenchReport = null
var _motions: Array[Motion] = []


func _initialize() -> void:
	_arguments = BenchArguments.parse(OS.get_cmdline_user_args(), _DEFAULTS)
	_report = BenchReport.new("frames", _arguments.value("json"))
	var rates: PackedStringArray = _arguments.list("fps")
	rates = _RATES if rates.is_empty() else rates
	var fault: String = _find_fault(rates)
	if fault != "":
		printerr(fault)
		quit(2)
		return
	Motion.open_all(_arguments, _report, _motions)
	if _motions.is_empty():
		quit(_report.finish())
		return
	for rate: String in rates:
		_measure(rate.to_float(), 0.0, "%s Hz, free" % rate)
		_measure(rate.to_float(), _LATENESS_S, "%s Hz, screen" % rate)
	quit(_report.finish())


func _find_fault(p_rates: PackedStringArray) -> String:
	if _arguments.error != "":
		return _arguments.error
	for rate: String in p_rates:
		if not rate.is_valid_float() or rate.to_float() < 10.0 or rate.to_float() > 240.0:
			return "frames per second are 10 to 240, found '%s'" % rate
	if _arguments.value("seconds") < 4.0:
		return "--seconds is 4 or more, found %s" % _arguments.value("seconds")
	return ""


func _measure(p_rate: float, p_lateness_s: float, p_case: String) -> void:
	var runs: Array[Watched] = []
	var ages: LatencyHistogram = LatencyHistogram.new()
	for motion: Motion in _motions:
		var display: Display = Display.new(p_rate, p_lateness_s, _arguments.value("seed"))
		var run: Run = Run.new()
		run.watch_on(motion, display)
		runs.append(run)
		ages.merge(display.ages.ages)
	var stats: Stats = Stats.new(runs)
	var most: BenchReport.Goal = BenchReport.Goal.AT_MOST
	_report.add(p_case, "age, mean", ages.mean(), "ms", most, _MAX_AGE_MS)
	_report.add(p_case, "age, sd", ages.deviation(), "ms", most, _MAX_SD_MS)
	_report.add(p_case, "lag", stats.lag_ms, "ms", most, _MAX_AGE_MS)
	_report.add(p_case, "residual", stats.residual_mm, "mm")
	_report.add(p_case, "jerk", stats.jerk, "of truth", most, _MAX_JERK)
	var steps: Steps = Steps.new()
	steps.watch_on(
		_motions[0].skeleton, Display.new(p_rate, p_lateness_s, _arguments.value("seed"))
	)
	_report.add(p_case, "step, a tenth", steps.first.mean(), "ms")
	_report.add(p_case, "step, half", steps.half.mean(), "ms")
	_report.add(p_case, "step, half, sd", steps.half.deviation(), "ms")
	_report.add(p_case, "step, overshoot", steps.overshoot * 100.0, "%", most, _MAX_OVERSHOOT)
