extends Bench
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

var _motions: Array[Motion] = []


func options() -> Dictionary:
	return {
		"bvh": "",
		"rate": ["", 1, 60],
		"method": ["", WorldReplica.SMOOTHING.keys()],
		"delay": 25.0,
		"jitter": 10.0,
		"loss": 2.0,
		"seconds": [25.0, 4.0, 3600.0],
		"seed": 1,
	}


func measure() -> void:
	Motion.open_all(arguments, report, _motions)
	if _motions.is_empty():
		return
	for rate: String in values("rate", ["10", "15", "30", "60"]):
		for method: String in values("method", WorldReplica.SMOOTHING.keys()):
			_measure(method, rate.to_float())
	if not arguments.is_given("method") and not arguments.is_given("rate"):
		_measure_cost()


func _measure(p_method: String, p_rate: float) -> void:
	var network: Dictionary = {"rate": p_rate}
	for name: String in ["delay", "jitter", "loss", "seed"]:
		network[name] = option(name)
	var runs: Array[Run] = []
	for motion: Motion in _motions:
		var run: Run = Run.new()
		run.watch(motion, WorldReplica.SMOOTHING[p_method], network)
		runs.append(run)
	var stats: Stats = Stats.new(runs)
	var name: String = "%s at %d Hz" % [p_method, roundi(p_rate)]
	# The goals are those of the observer's default in the network that they were set for.
	var has: bool = p_method == "adaptive_low_delay" and roundi(p_rate) == 30
	for name_of: String in ["delay", "jitter", "loss"]:
		has = has and not arguments.is_given(name_of)
	report.add(name, "error now", stats.now_deg, "deg")
	report.add(name, "error now", stats.now_mm, "mm")
	report.at_most(name, "lag", stats.lag_ms, "ms", 45.0, has)
	report.at_most(name, "residual", stats.residual_mm, "mm", 8.0, has)
	report.at_most(name, "jerk", stats.jerk, "of truth", 1.0, has)
	report.at_least(name, "jerk", stats.jerk, "of truth", 0.6, has)
	report.at_most(name, "joint gap", stats.gap_mm, "mm", 0.01, has)


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
	report.add(name, "cost p50", times.percentile(0.5), "ms")
	report.add(name, "cost p99", times.percentile(0.99), "ms")
