extends Bench
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
const Clips: GDScript = preload("gait/gait_clips.gd")
const Slopes: GDScript = preload("gait/gait_slopes.gd")
const Starts: GDScript = preload("gait/gait_starts.gd")
const Scenes: GDScript = preload("gait/gait_scenes.gd")
const _CASES: Array[String] = ["walks", "stairs", "clips", "slopes", "starts", "scenes"]
const _ROOTS: Array[String] = ["inertial", "contacts", "lowest_foot", "self_righting", "pendulum"]
## Steps, length (m) and duration (s) of a step.
const _WALKS: Dictionary[String, Array] = {
	"level walk 1.2 m/s": [24, 0.65, 0.55],
	"level walk 0.7 m/s": [20, 0.5, 0.7],
	"level walk 1.6 m/s": [28, 0.7, 0.44],
}
const _RISE: float = 0.17
const _TREAD: float = 0.29

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _world: Node3D = null


func options() -> Dictionary:
	return {
		"bvh": "",
		"root": ["", _ROOTS],
		"hz": [60, 10, 1000],
		"noise": 0.0,
		"seed": 1,
		"slope": 0.0,
		"cases": ["", _CASES],
		"scenes": 20,
	}


func measure() -> void:
	Engine.physics_ticks_per_second = option("hz")
	for name: String in values("root", ["inertial", "contacts", "lowest_foot"]):
		for case: String in values("cases", ["clips"] if arguments.is_given("bvh") else _CASES):
			await _run_case(case, name)


func _run_case(p_case: String, p_root: String) -> void:
	match p_case:
		"walks":
			await _run_walks(p_root)
		"stairs":
			await _run_stairs(p_root)
		_:
			var cases: Dictionary[String, GDScript] = {
				"clips": Clips, "slopes": Slopes, "starts": Starts, "scenes": Scenes
			}
			var case: Case = cases[p_case].new(self, report, option("seed"))
			case.root_name = p_root
			case.root_mode = RootModes.BY_NAME[p_root]
			if case is Clips:
				case.files = BenchArguments.clips(arguments)
				case.noise_deg = option("noise")
				case.slope = deg_to_rad(option("slope"))
			if case is Scenes:
				case.count = option("scenes")
				case.clips = _open_clips()
			await case.run()


func _open_clips() -> Array[BvhSource]:
	var result: Array[BvhSource] = []
	for file: String in BenchArguments.clips(arguments):
		var source: BvhSource = BvhSource.new()
		source.open(file)
		if source.error == "":
			result.append(source)
	return result


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
			report.at_most(
				title, "stance-foot skate", 100.0 * stats.skate.mean(), "cm/s", most, goal
			)


func _run_stairs(p_root: String) -> void:
	for rise: float in [_RISE, -_RISE]:
		var ragdoll: Ragdoll = _begin(p_root)
		var walker: Walker = Walker.new(ragdoll.profile)
		walker.climb(16, rise, _TREAD, 0.6)
		var stats: Stats = await _walk(walker, ragdoll, 0.0)
		var title: String = "%s: 16 stairs %s" % [p_root, "up" if rise > 0.0 else "down"]
		_add_travel(title, stats, false)
		var right: float = 1.0 if stats.is_on_tread(_RISE, _TREAD) else 0.0
		report.at_least(title, "on the right tread", right, "", 1.0, p_root == "inertial")


func _begin(p_root: String) -> Ragdoll:
	_random.seed = option("seed")
	_world = Node3D.new()
	root.add_child(_world)
	var ragdoll: Ragdoll = (load(SOLDIER) as PackedScene).instantiate()
	ragdoll.root_mode = RootModes.BY_NAME[p_root]
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
		Case.add_noise(sample, p_noise_deg, _random)
		p_ragdoll.push_sample(time, sample, start)
		p_ragdoll.drive(time, delta)
	_world.queue_free()
	await process_frame
	return stats


func _add_travel(p_title: String, p_stats: Stats, p_has_goal: bool) -> void:
	report.add(p_title, "way", p_stats.way, "m")
	report.at_most(p_title, "max travel error", p_stats.travel_percent(), "%", 4.0, p_has_goal)
	report.at_most(
		p_title, "body height error", 1000.0 * p_stats.height.mean(), "mm", 30.0, p_has_goal
	)
