extends SceneTree
## What a client sees over a network that delays, jitters and loses: all methods of smoothing.
##
## Real motion on the soldier's skeleton, a made-up network in simulated time (delays uniform,
## always the same), a display of 60 Hz. Error now: against the truth at the time of display.
## Residual: what is left of it when the lag is taken off. Jerk: over that of the truth; 1 is
## ideal. Options: --bvh=FILE (again for more; default the clips in assets/motion), --rate=30
## (updates per second, again for more; default 10, 15, 30, 60), --delay=25, --jitter=10 (ms),
## --loss=2 (%), --method=none|linear|extrapolate_lerp|hermite|error_offset|adaptive_low_delay
## (again for more), --seconds=25 (of each clip), --seed=1.

const Stats: GDScript = preload("smoothing/smoothing_stats.gd")
const Motion: GDScript = preload("smoothing/smoothing_motion.gd")
const Run: GDScript = preload("smoothing/smoothing_run.gd")
## The crowded world whose cost is measured.
const _PEOPLE: int = 32
const _BODIES: int = 200
const _DEFAULTS: Dictionary = {
	"bvh": "",
	"rate": "",
	"method": "",
	"delay": 25.0,
	"jitter": 10.0,
	"loss": 2.0,
	"seconds": 25.0,
	"seed": 1,
}

var _arguments: BenchArguments = null
var _report: BenchReport = null
var _motions: Array[Motion] = []


func _initialize() -> void:
	_arguments = BenchArguments.parse(OS.get_cmdline_user_args(), _DEFAULTS)
	_report = BenchReport.new("smoothing", _arguments.value("json"))
	var fault: String = _find_fault()
	if fault != "":
		printerr(fault)
		quit(2)
		return
	Motion.open_all(_arguments, _report, _motions)
	if _motions.is_empty():
		quit(_report.finish())
		return
	for rate: String in _list("rate", ["10", "15", "30", "60"]):
		for method: String in _list("method", WorldReplica.SMOOTHING.keys()):
			_measure(method, rate.to_float())
	if not _arguments.is_given("method") and not _arguments.is_given("rate"):
		_measure_cost()
	quit(_report.finish())


func _find_fault() -> String:
	if _arguments.error != "":
		return _arguments.error
	for method: String in _arguments.list("method"):
		if not WorldReplica.SMOOTHING.has(method):
			return (
				"a method is one of %s, found '%s'"
				% [", ".join(WorldReplica.SMOOTHING.keys()), method]
			)
	for rate: String in _arguments.list("rate"):
		if not rate.is_valid_float() or rate.to_float() < 1.0 or rate.to_float() > 60.0:
			return "a rate is 1 to 60 updates per second, found '%s'" % rate
	if _arguments.value("seconds") < 4.0:
		return "--seconds is 4 or more, found %s" % _arguments.value("seconds")
	return ""


func _list(p_name: String, p_default: Array) -> PackedStringArray:
	var given: PackedStringArray = _arguments.list(p_name)
	return given if not given.is_empty() else PackedStringArray(p_default)


func _measure(p_method: String, p_rate: float) -> void:
	var network: Dictionary = {"rate": p_rate}
	for name: String in ["delay", "jitter", "loss", "seed"]:
		network[name] = _arguments.value(name)
	var runs: Array[Run] = []
	for motion: Motion in _motions:
		var run: Run = Run.new()
		run.watch(motion, WorldReplica.SMOOTHING[p_method], network)
		runs.append(run)
	var stats: Stats = Stats.new(runs)
	var name: String = "%s at %d Hz" % [p_method, roundi(p_rate)]
	# The goals are those of the observer's default in the network that they were set for.
	var has: bool = p_method == "adaptive_low_delay" and roundi(p_rate) == 30
	for option: String in ["delay", "jitter", "loss"]:
		has = has and not _arguments.is_given(option)
	var most: BenchReport.Goal = BenchReport.Goal.AT_MOST if has else BenchReport.Goal.NONE
	var least: BenchReport.Goal = BenchReport.Goal.AT_LEAST if has else BenchReport.Goal.NONE
	_report.add(name, "error now", stats.now_deg, "deg")
	_report.add(name, "error now", stats.now_mm, "mm")
	_report.add(name, "lag", stats.lag_ms, "ms", most, 45.0)
	_report.add(name, "residual", stats.residual_mm, "mm", most, 8.0)
	_report.add(name, "jerk", stats.jerk, "of truth", most, 1.0)
	_report.add(name, "jerk", stats.jerk, "of truth", least, 0.6)
	_report.add(name, "joint gap", stats.gap_mm, "mm", most, 0.01)


## What a frame of a crowded world costs.
func _measure_cost() -> void:
	var motion: Motion = _motions[0]
	var skeleton: PersonSkeleton = motion.skeleton
	var smoother: SnapshotSmoother = SnapshotSmoother.new()
	for person: int in _PEOPLE:
		smoother.set_skeleton(
			person, skeleton.parents, skeleton.joints_in_parent, skeleton.joints_in_limb
		)
	var times: Statistics = Statistics.new()
	for tick: int in 300:
		var now: float = tick / 60.0
		for person: int in _PEOPLE:
			smoother.push_person(
				person, tick, now, motion.roots[tick * 4], motion.turns_of(tick * 4)
			)
		for body: int in _BODIES:
			var place: Transform3D = Transform3D(Basis(), Vector3(body, now, 0.0))
			smoother.push_body(body, tick, now, place, Vector3.UP, Vector3.UP, false)
		var begin: int = Time.get_ticks_usec()
		smoother.evaluate(now)
		times.add((Time.get_ticks_usec() - begin) / 1000.0)
	var name: String = "a frame of %d people, %d crates" % [_PEOPLE, _BODIES]
	_report.add(name, "cost p50", times.percentile(0.5), "ms")
	_report.add(name, "cost p99", times.percentile(0.99), "ms")
