extends SceneTree
## How precisely a ragdoll follows recorded motion, over whole clips.
##
## Options: --bvh=FILE (again for more; default the three clips in assets/motion), --hz=60 (ticks),
## --mode=velocity_motor, --root=held|soft, --buffer=0 (ticks of delay that make the next sample
## known), --gain=45 (1/s), --seconds=0 (of each clip; 0 is all).

const _GOAL_MEAN: float = 1.3
const _GOAL_P95: float = 4.0
const _START_S: float = 0.3

var _arguments: BenchArguments = null
var _report: BenchReport = null


func _initialize() -> void:
	_arguments = BenchArguments.parse(
		OS.get_cmdline_user_args(),
		{
			"bvh": "",
			"hz": 60,
			"mode": "velocity_motor",
			"root": "held",
			"buffer": 0,
			"gain": 45.0,
			"seconds": 0.0
		}
	)
	_run.call_deferred()


func _run() -> void:
	var fault: String = _find_fault()
	if fault != "":
		printerr(fault)
		quit(2)
		return
	_report = BenchReport.new("tracking", _arguments.value("json"))
	Engine.physics_ticks_per_second = _arguments.value("hz")
	var files: PackedStringArray = BenchArguments.clips(_arguments)
	var means: Statistics = Statistics.new()
	var p95s: Statistics = Statistics.new()
	for file: String in files:
		var tracking: Dictionary = await _run_clip(file)
		if tracking.has("error"):
			printerr(tracking["error"])
			quit(2)
			return
		means.add(tracking["mean_deg"])
		p95s.add(tracking["p95_deg"])
	if files.size() > 1:
		_add_figures("all %d clips" % files.size(), means.mean(), p95s.mean(), true)
	_report.finish()
	quit(0)


func _find_fault() -> String:
	if _arguments.error != "":
		return _arguments.error
	if _arguments.value("mode") != "velocity_motor":
		return "the one mode is velocity_motor, found '%s'" % _arguments.value("mode")
	if not _arguments.value("root") in ["held", "soft"]:
		return "a root is held or soft, found '%s'" % _arguments.value("root")
	if _arguments.value("hz") < 10 or _arguments.value("hz") > 1000:
		return "a tick rate is between 10 and 1000, found %d" % _arguments.value("hz")
	return ""


func _run_clip(p_file: String) -> Dictionary:
	var source: BvhSource = BvhSource.new()
	source.open(p_file)
	if source.error != "":
		return {"error": source.error}
	var ragdoll: Ragdoll = _make_ragdoll(source.rig)
	root.add_child(ragdoll)
	if not ragdoll.start():
		return {"error": "%s: the ragdoll does not start" % p_file}
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var buffer: float = float(_arguments.value("buffer")) * delta
	var length: float = source.rig.clip.duration() - BvhSource.BLEND_S
	if _arguments.value("seconds") > 0.0:
		length = minf(length, _arguments.value("seconds"))
	var tick: int = 0
	while tick * delta + buffer < length:
		await physics_frame
		# What the step before has made of it.
		if tick * delta > _START_S:
			ragdoll.motor.measure(tick * delta)
		var sampled: PoseSample = source.pose_at(tick * delta + buffer)
		ragdoll.push_sample(tick * delta + buffer, sampled, sampled.root)
		ragdoll.drive(tick * delta, delta)
		tick += 1
	var tracking: Dictionary = ragdoll.motor.get_tracking()
	ragdoll.queue_free()
	await process_frame
	if tracking["count"] == 0:
		return {"error": "%s: the clip is too short to measure" % p_file}
	var alone: bool = _arguments.list("bvh").size() == 1
	_add_figures(p_file.get_file(), tracking["mean_deg"], tracking["p95_deg"], alone)
	return tracking


func _make_ragdoll(p_rig: BvhRig) -> Ragdoll:
	var ragdoll: Ragdoll = Ragdoll.new()
	var skeleton: Skeleton3D = BvhSkeleton.make(p_rig)
	ragdoll.add_child(skeleton)
	ragdoll.profile = SkeletonShapes.describe(skeleton)
	RagdollBuilder.build(skeleton, ragdoll.profile)
	var held: bool = _arguments.value("root") == "held"
	ragdoll.root_mode = Ragdoll.RootMode.HELD if held else Ragdoll.RootMode.SOFT
	ragdoll.gain = _arguments.value("gain")
	return ragdoll


func _add_figures(p_case: String, p_mean: float, p_p95: float, p_is_total: bool) -> void:
	var goal: BenchReport.Goal = BenchReport.Goal.NONE
	# The goal is for all clips together, causal, at 60 Hz, with the hips held.
	var as_named: bool = _arguments.value("hz") == 60 and _arguments.value("root") == "held"
	if p_is_total and as_named and _arguments.value("buffer") == 0:
		goal = BenchReport.Goal.AT_MOST
	var name: String = "%s, %s, %d Hz" % [p_case, _arguments.value("root"), _arguments.value("hz")]
	_report.add(name, "mean error", p_mean, "deg", goal, _GOAL_MEAN)
	_report.add(name, "p95 error", p_p95, "deg", goal, _GOAL_P95)
