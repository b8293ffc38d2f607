extends Bench
## How precisely a ragdoll follows recorded motion, over whole clips, in every mode.
##
## Options: --bvh=FILE (again for more; default the three clips in assets/motion), --all (every
## mode, both roots, 30, 60 and 120 Hz), or one combination: --mode=velocity_motor|direct_set|
## spring_torque|angular_motor|position_motor|limp, --root=held|soft, --hz=60 (ticks), --buffer=0
## (ticks of delay that make the next sample known), --self-collision. Besides: --gain=50 (1/s),
## --noise=0 (white noise of each limb, deg), --rates (samples know the limbs' turning rates over
## the last 4 ms, as a suit's gyroscopes do), --seconds=0 (of each clip; 0 is all). A file that
## cannot be measured is left out and named at the end.

const Case: GDScript = preload("tracking/tracking_case.gd")
const _START_S: float = 0.3
## Over which a gyroscope's rate is taken, s.
const _GYRO_S: float = 0.004
## Metrics: key in the tracking stats, name, unit, factor.
const _METRICS: Array[Array] = [
	["mean_deg", "mean error", "deg", 1.0],
	["p95_deg", "p95 error", "deg", 1.0],
	["p99_deg", "p99 error", "deg", 1.0],
	["lag_s", "lag", "ms", 1000.0],
	["distance_m", "joint position", "mm", 1000.0],
]

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func options() -> Dictionary:
	return {
		"bvh": "",
		"hz": [60, 10, 1000],
		"mode": ["velocity_motor", Case.MODES],
		"root": ["held", ["held", "soft"]],
		"buffer": [0, 0, 8],
		"self-collision": false,
		"all": false,
		"gain": 0.0,
		"noise": 0.0,
		"rates": false,
		"seconds": 0.0
	}


func measure() -> void:
	var plain: Dictionary[String, float] = {}
	for case: Case in _cases():
		var stats: Dictionary = await _run_case(case)
		if stats["clips"] > 0:
			_add_stats(case, "all %d clips" % stats["clips"], stats, true)
			_compare_self_collision(case, stats["mean_deg"], plain)


func _cases() -> Array:
	if option("all"):
		return Case.all()
	var named: bool = false
	for name: String in ["mode", "root", "hz", "buffer", "self-collision"]:
		named = named or arguments.is_given(name)
	if not named:
		return Case.usual()
	var case: Case = Case.new(option("mode"), option("root"), option("hz"), option("buffer"))
	case.self_collision = option("self-collision")
	return [case]


## Means over the clips, and how many could be measured. A lag counts by its magnitude: a lead in
## one clip does not make up for it.
func _run_case(p_case: Case) -> Dictionary:
	Engine.physics_ticks_per_second = p_case.hz
	_random.seed = 1
	var sums: Dictionary = {"acted": 0, "clips": 0, "lag_unknown": 0}
	for file: String in BenchArguments.clips(arguments):
		var tracking: Dictionary = await _run_clip(file, p_case)
		if tracking.is_empty():
			continue
		_add_stats(p_case, file.get_file(), tracking, false)
		for metric: Array in _METRICS:
			sums[metric[0]] = sums.get(metric[0], 0.0) + absf(tracking[metric[0]])
		for count: String in ["acted", "lag_unknown"]:
			sums[count] += tracking[count]
		sums["clips"] += 1
	for metric: Array in _METRICS:
		sums[metric[0]] = sums.get(metric[0], 0.0) / maxi(sums["clips"], 1)
	return sums


## The stats of a clip; empty where there are none, which is noted.
func _run_clip(p_file: String, p_case: Case) -> Dictionary:
	var source: BvhSource = report.open_clip(p_file)
	if source == null:
		return {}
	var ragdoll: Ragdoll = _make_ragdoll(source, p_case)
	root.add_child(ragdoll)
	if not ragdoll.start():
		report.leave_out(p_file, "the ragdoll does not start")
		ragdoll.queue_free()
		return {}
	ragdoll.motor.measures_lag = true
	ragdoll.motor.set_actuation(p_case.mode)
	var acted: Array[int] = [0]
	ragdoll.motor.guard_acted.connect(func(_actions: int) -> void: acted[0] += 1)
	await _play(source, ragdoll, p_case)
	var tracking: Dictionary = ragdoll.motor.get_tracking()
	tracking["acted"] = acted[0]
	tracking["lag_unknown"] = 0 if tracking["lag_known"] else 1
	ragdoll.queue_free()
	await process_frame
	if tracking["count"] == 0:
		var least: float = _START_S + BvhSource.BLEND_S
		var parts: Array = [source.rig.clip.duration(), least]
		report.leave_out(
			p_file, "%.2f s are too short: the clip has to be longer than %.1f s" % parts
		)
		return {}
	return tracking


func _play(p_source: BvhSource, p_ragdoll: Ragdoll, p_case: Case) -> void:
	var delta: float = 1.0 / p_case.hz
	var length: float = p_source.rig.clip.duration() - BvhSource.BLEND_S
	if option("seconds") > 0.0:
		length = minf(length, option("seconds"))
	var tick: int = 0
	while (tick + p_case.buffer) * delta < length:
		await physics_frame
		# What the step before has made of it.
		if tick * delta > _START_S:
			p_ragdoll.motor.measure(tick * delta)
		var sampled: PoseSample = p_source.pose_at((tick + p_case.buffer) * delta)
		if option("rates"):
			_add_rates(sampled, p_source, (tick + p_case.buffer) * delta)
		_add_noise(sampled)
		p_ragdoll.push_sample((tick + p_case.buffer) * delta, sampled, sampled.root)
		p_ragdoll.drive(tick * delta, delta)
		tick += 1


func _add_rates(p_sample: PoseSample, p_source: BvhSource, p_time_s: float) -> void:
	var before: PoseSample = p_source.pose_at(maxf(p_time_s - _GYRO_S, 0.0))
	p_sample.details = MotionDetails.new()
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = p_sample.orientation(limb) * before.orientation(limb).inverse()
		p_sample.details.rates.append(Rotations.vector(turn) / _GYRO_S)


func _add_noise(p_sample: PoseSample) -> void:
	var size: float = deg_to_rad(option("noise"))
	if size <= 0.0:
		return
	for limb: int in Limbs.COUNT:
		var turn: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn()) * size
		var noise: Quaternion = Quaternion(turn.normalized(), turn.length())
		p_sample.set_orientation(limb, p_sample.orientation(limb) * noise)


func _make_ragdoll(p_source: BvhSource, p_case: Case) -> Ragdoll:
	var ragdoll: Ragdoll = BenchBodies.of_clip(p_source, p_case.root)
	ragdoll.self_collision = p_case.self_collision
	if option("gain") > 0.0:
		ragdoll.gain = option("gain")
	return ragdoll


func _add_stats(p_case: Case, p_of: String, p_stats: Dictionary, p_is_total: bool) -> void:
	# Goals are for all clips together.
	var alone: bool = BenchArguments.clips(arguments).size() == 1
	if p_is_total and alone:
		return
	var name: String = "%s: %s" % [p_case.name(), p_of]
	for metric: Array in _METRICS:
		var goal: float = p_case.goals.get(metric[0], 0.0)
		var kind: BenchReport.Goal = BenchReport.Goal.NONE
		if (p_is_total or alone) and goal > 0.0 and option("noise") == 0.0:
			kind = BenchReport.Goal.AT_MOST
		if kind != BenchReport.Goal.NONE and metric[0] == "lag_s":
			kind = BenchReport.Goal.WITHIN
		var value: float = p_stats[metric[0]] * metric[3]
		report.add(name, metric[1], value, metric[2], kind, goal)
	if p_stats["lag_unknown"] > 0:
		# The value is then the bound of the search, which is beyond any goal.
		report.add(name, "lag beyond the search", p_stats["lag_unknown"], "clips")
	if p_stats["acted"] > 0:
		report.add(name, "guard acted", p_stats["acted"], "ticks")


## What self-collision costs against the same case without.
func _compare_self_collision(
	p_case: Case, p_mean: float, r_plain: Dictionary[String, float]
) -> void:
	var name: String = p_case.name().trim_suffix(", self-collision")
	if not p_case.self_collision:
		r_plain[name] = p_mean
	elif r_plain.has(name):
		var cost: float = p_mean - r_plain[name]
		report.at_most(p_case.name(), "cost", cost, "deg", 0.3)
