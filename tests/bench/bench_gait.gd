extends SceneTree
## Where a person's travel comes from if no position is known: walking, stairs, jumps, on the
## bodies.
##
## Without --bvh: a made-up walker with the soldier's body (level at three speeds, clean and with
## 1 degree of noise; 16 stairs up and down), then the clips of assets/motion. Options: --bvh=FILE
## (again for more; its own hips are the truth), --root=inertial|contacts|lowest_foot|
## self_righting|pendulum (default the first three), --hz=60, --noise=0 (deg, for --bvh), --slope=0
## (deg, of the ground under --bvh), --seed=1 (of the noise, and of the
## first scene), --cases=walks|stairs|clips|slopes|
## starts|scenes (again for more; default all, with --bvh the clips alone), --scenes=20 (how many
## random ones).

const Walker: GDScript = preload("gait/walker.gd")
const Stats: GDScript = preload("gait/gait_stats.gd")
const Case: GDScript = preload("gait/gait_case.gd")
const Slopes: GDScript = preload("gait/gait_slopes.gd")
const Starts: GDScript = preload("gait/gait_starts.gd")
const Scenes: GDScript = preload("gait/gait_scenes.gd")
const _CASES: Array[String] = ["walks", "stairs", "clips", "slopes", "starts", "scenes"]
const _SOLDIER: String = "res://scenes/actor/soldier.tscn"
const _ROOTS: Dictionary[String, RagdollMotor.RootMode] = {
	"inertial": RagdollMotor.ROOT_INERTIAL,
	"contacts": RagdollMotor.ROOT_CONTACTS,
	"lowest_foot": RagdollMotor.ROOT_LOWEST_FOOT,
	"self_righting": RagdollMotor.ROOT_SELF_RIGHTING,
	"pendulum": RagdollMotor.ROOT_PENDULUM,
}
## Steps, length (m) and duration (s) of a step.
const _WALKS: Dictionary[String, Array] = {
	"level walk 1.2 m/s": [24, 0.65, 0.55],
	"level walk 0.7 m/s": [20, 0.5, 0.7],
	"level walk 1.6 m/s": [28, 0.7, 0.44],
}
const _RISE: float = 0.17
const _TREAD: float = 0.29
## A person whose lowest point is higher than this flies, m.
const _FLIGHT: float = 0.04
## Clips shorter than this hold no way that could be measured, s.
const _SHORTEST_S: float = 1.0

var _arguments: BenchArguments = null
var _report: BenchReport = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _world: Node3D = null


func _initialize() -> void:
	_arguments = (
		BenchArguments
		. parse(
			OS.get_cmdline_user_args(),
			{
				"bvh": "",
				"root": "",
				"hz": 60,
				"noise": 0.0,
				"seed": 1,
				"slope": 0.0,
				"cases": "",
				"scenes": 20,
			}
		)
	)
	_run.call_deferred()


func _run() -> void:
	var fault: String = _find_fault()
	if fault != "":
		printerr(fault)
		quit(2)
		return
	_report = BenchReport.new("gait", _arguments.value("json"))
	Engine.physics_ticks_per_second = _arguments.value("hz")
	var roots: PackedStringArray = _arguments.list("root")
	if roots.is_empty():
		roots = ["inertial", "contacts", "lowest_foot"]
	for name: String in roots:
		for case: String in _cases():
			await _run_case(case, name)
	quit(_report.finish())


func _cases() -> PackedStringArray:
	if _arguments.is_given("cases"):
		return _arguments.list("cases")
	return ["clips"] if _arguments.is_given("bvh") else _CASES


func _run_case(p_case: String, p_root: String) -> void:
	match p_case:
		"walks":
			await _run_walks(p_root)
		"stairs":
			await _run_stairs(p_root)
		"clips":
			for file: String in BenchArguments.clips(_arguments):
				await _run_clip(file, p_root)
		_:
			var cases: Dictionary[String, GDScript] = {
				"slopes": Slopes, "starts": Starts, "scenes": Scenes
			}
			var case: Case = cases[p_case].new(self, _report, _arguments.value("seed"))
			case.root_name = p_root
			case.root_mode = _ROOTS[p_root]
			if case is Scenes:
				case.count = _arguments.value("scenes")
				case.clips = _open_clips()
			await case.run()


func _open_clips() -> Array[BvhSource]:
	var result: Array[BvhSource] = []
	for file: String in BenchArguments.clips(_arguments):
		var source: BvhSource = BvhSource.new()
		source.open(file)
		if source.error == "":
			result.append(source)
	return result


func _find_fault() -> String:
	if _arguments.error != "":
		return _arguments.error
	for name: String in _arguments.list("root"):
		if not _ROOTS.has(name):
			return "a root is one of %s, found '%s'" % [", ".join(_ROOTS.keys()), name]
	for name: String in _arguments.list("cases"):
		if not _CASES.has(name):
			return "a case is one of %s, found '%s'" % [", ".join(_CASES), name]
	if _arguments.value("hz") < 10 or _arguments.value("hz") > 1000:
		return "a tick rate is between 10 and 1000, found %d" % _arguments.value("hz")
	return ""


func _run_walks(p_root: String) -> void:
	for noise: float in [0.0, 1.0]:
		for name: String in _WALKS:
			var ragdoll: Ragdoll = _begin(p_root)
			var walker: Walker = Walker.new(ragdoll.profile)
			walker.walk(_WALKS[name][0], _WALKS[name][1], _WALKS[name][2])
			var stats: Stats = await _walk(walker, ragdoll, noise)
			var title: String = "%s: %s%s" % [p_root, name, ", 1 deg noise" if noise > 0.0 else ""]
			var goal: bool = p_root == "inertial"
			_add_travel(title, stats, goal)
			var most: float = 8.0 if noise > 0.0 else 3.0
			_add(title, "stance-foot skate", 100.0 * stats.skate.mean(), "cm/s", goal, most)


func _run_stairs(p_root: String) -> void:
	for rise: float in [_RISE, -_RISE]:
		var ragdoll: Ragdoll = _begin(p_root)
		var walker: Walker = Walker.new(ragdoll.profile)
		walker.climb(16, rise, _TREAD, 0.6)
		var stats: Stats = await _walk(walker, ragdoll, 0.0)
		var title: String = "%s: 16 stairs %s" % [p_root, "up" if rise > 0.0 else "down"]
		_add_travel(title, stats, false)
		var right: float = 1.0 if stats.is_on_tread(_RISE, _TREAD) else 0.0
		var kind: BenchReport.Goal = BenchReport.Goal.NONE
		if p_root == "inertial":
			kind = BenchReport.Goal.AT_LEAST
		_report.add(title, "on the right tread", right, "", kind, 1.0)


func _begin(p_root: String) -> Ragdoll:
	_random.seed = _arguments.value("seed")
	_world = Node3D.new()
	root.add_child(_world)
	var ragdoll: Ragdoll = (load(_SOLDIER) as PackedScene).instantiate()
	ragdoll.root_mode = _ROOTS[p_root]
	return ragdoll


func _walk(p_walker: Walker, p_ragdoll: Ragdoll, p_noise_deg: float) -> Stats:
	p_walker.build_ground(_world)
	_world.add_child(p_ragdoll)
	p_ragdoll.start()
	var stats: Stats = Stats.new()
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var before: Dictionary[int, Vector3] = {}
	for tick: int in int(p_walker.duration / delta):
		await physics_frame
		var time: float = tick * delta
		if tick > 2:
			stats.add_root(Case.root_of(p_ragdoll), p_walker.pose_at(time).root)
			for side: int in [-1, 1]:
				var ball: Vector3 = Case.ball_of(p_ragdoll, side)
				if before.has(side) and p_walker.is_standing(side, time):
					var moved: Vector3 = ball - before[side]
					stats.skate.add(Vector2(moved.x, moved.z).length() / delta)
				before[side] = ball
		var sample: PoseSample = p_walker.pose_at(time)
		var start: Vector3 = p_walker.pose_at(0.0).root
		_add_noise(sample, p_noise_deg)
		p_ragdoll.push_sample(time, sample, start)
		p_ragdoll.drive(time, delta)
	_world.queue_free()
	await process_frame
	return stats


func _run_clip(p_file: String, p_root: String) -> void:
	var source: BvhSource = _report.open_clip(p_file)
	if source == null:
		return
	if source.rig.clip.duration() < _SHORTEST_S:
		var parts: Array = [source.rig.clip.duration(), _SHORTEST_S]
		_report.leave_out(p_file, "%.2f s are too short for a way: %.0f s is the least" % parts)
		return
	_begin(p_root).free()
	var ragdoll: Ragdoll = Ragdoll.new()
	var skeleton: Skeleton3D = BvhSkeleton.make(source.rig)
	ragdoll.add_child(skeleton)
	ragdoll.profile = SkeletonShapes.describe(skeleton)
	RagdollBuilder.build(skeleton, ragdoll.profile)
	ragdoll.root_mode = _ROOTS[p_root]
	_build_ground(ragdoll)
	_world.add_child(ragdoll)
	if not ragdoll.start():
		_report.leave_out(p_file, "the ragdoll does not start")
		_world.queue_free()
		return
	var stats: Stats = Stats.new()
	await _play(source, ragdoll, stats)
	_world.queue_free()
	await process_frame
	var title: String = "%s: %s" % [p_root, p_file.get_file()]
	# The goal is for level walking, and whether a file is that, only its owner knows.
	_add_travel(title, stats, p_root == "inertial" and _arguments.is_given("bvh"))
	_report.add(title, "stance-foot skate", 100.0 * stats.skate.mean(), "cm/s")
	if stats.flights > 0 or stats.invented > 0:
		var share: float = 100.0 * stats.found / maxf(stats.flights, 1.0)
		_report.add(title, "flights in truth", stats.flights, "")
		_add_least(title, "flights found", share, "%", p_root == "inertial", 90.0)
		_add(title, "flights invented", stats.invented, "", p_root == "inertial", 0.0)


## Level, or the slope that is asked for.
func _build_ground(p_ragdoll: Ragdoll) -> void:
	if _arguments.value("slope") == 0.0:
		Walker.new(p_ragdoll.profile).build_ground(_world)
	else:
		_world.add_child(Case.make_floor(deg_to_rad(_arguments.value("slope"))))


func _play(p_source: BvhSource, p_ragdoll: Ragdoll, p_stats: Stats) -> void:
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var soles: Dictionary[Vector2i, Array] = {}
	for tick: int in int((p_source.rig.clip.duration() - BvhSource.BLEND_S) / delta):
		await physics_frame
		var time: float = tick * delta
		var sample: PoseSample = p_source.pose_at(time)
		if tick > 2:
			p_stats.add_root(Case.root_of(p_ragdoll), sample.root)
			_note_soles(p_ragdoll, sample, p_stats, soles)
		_add_noise(sample, _arguments.value("noise"))
		p_ragdoll.push_sample(time, sample, p_source.pose_at(0.0).root)
		p_ragdoll.drive(time, delta)


## Compares the sole points of the bodies with those of the true motion.
func _note_soles(
	p_ragdoll: Ragdoll, p_true: PoseSample, p_stats: Stats, r_last: Dictionary[Vector2i, Array]
) -> void:
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var places: Array[Vector3] = _true_joints(p_ragdoll.profile, p_true)
	var lowest: float = INF
	var now: Dictionary[Vector2i, Array] = {}
	for i: int in p_ragdoll.profile.limbs.size():
		var limb: RagdollLimb = p_ragdoll.profile.limbs[i]
		for j: int in limb.contact_points.size():
			var local: Vector3 = (
				limb.rest_orientation.inverse() * (limb.contact_points[j] - limb.anchor)
			)
			var turn: Quaternion = (
				p_true.orientation(Limbs.find(limb.bone)) * limb.reset_orientation
			)
			var there: Vector3 = places[i] + turn * local
			lowest = minf(lowest, there.y - limb.contact_radius)
			if limb.is_foot:
				now[Vector2i(i, j)] = [there, Case.point_of(p_ragdoll, i, local)]
	for key: Vector2i in now:
		if r_last.has(key):
			var truth: Vector3 = (now[key][0] - r_last[key][0]) / delta
			var shown: Vector3 = (now[key][1] - r_last[key][1]) / delta
			var stands: bool = Vector2(truth.x, truth.z).length() < Stats.STANDS_BELOW
			if stands and now[key][0].y < lowest + Stats.STANDS_WITHIN:
				p_stats.skate.add(Vector2(shown.x - truth.x, shown.z - truth.z).length())
	p_stats.add_flight(lowest > _FLIGHT, p_ragdoll.motor.is_flying())
	r_last.assign(now)


static func _true_joints(p_profile: RagdollProfile, p_pose: PoseSample) -> Array[Vector3]:
	var places: Array[Vector3] = []
	for i: int in p_profile.limbs.size():
		var limb: RagdollLimb = p_profile.limbs[i]
		var parent: int = p_profile.get_parent_index(i)
		if parent < 0:
			places.append(p_pose.root)
			continue
		var above: RagdollLimb = p_profile.limbs[parent]
		var turn: Quaternion = p_pose.orientation(Limbs.find(above.bone)) * above.reset_orientation
		var arm: Vector3 = above.rest_orientation.inverse() * (limb.anchor - above.anchor)
		places.append(places[parent] + turn * arm)
	return places


func _add_noise(p_sample: PoseSample, p_degrees: float) -> void:
	for limb: int in Limbs.COUNT if p_degrees > 0.0 else 0:
		var axis: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn())
		var turn: Quaternion = Quaternion(axis.normalized(), axis.length() * deg_to_rad(p_degrees))
		p_sample.set_orientation(limb, p_sample.orientation(limb) * turn)


func _add_travel(p_title: String, p_stats: Stats, p_has_goal: bool) -> void:
	_report.add(p_title, "way", p_stats.way, "m")
	_add(p_title, "max travel error", p_stats.travel_percent(), "%", p_has_goal, 4.0)
	_add(p_title, "body height error", 1000.0 * p_stats.height.mean(), "mm", p_has_goal, 30.0)


func _add(
	p_case: String, p_metric: String, p_value: float, p_unit: String, p_has: bool, p_goal: float
) -> void:
	var kind: BenchReport.Goal = BenchReport.Goal.AT_MOST if p_has else BenchReport.Goal.NONE
	_report.add(p_case, p_metric, p_value, p_unit, kind, p_goal)


func _add_least(
	p_case: String, p_metric: String, p_value: float, p_unit: String, p_has: bool, p_goal: float
) -> void:
	var kind: BenchReport.Goal = BenchReport.Goal.AT_LEAST if p_has else BenchReport.Goal.NONE
	_report.add(p_case, p_metric, p_value, p_unit, kind, p_goal)
