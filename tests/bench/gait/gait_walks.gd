extends "gait_case.gd"
## A made-up walker on level ground, clean and with noise on every limb, or on 16 stairs.

## Steps, length (m) and duration (s) of a step.
const _WALKS: Dictionary[String, Array] = {
	"level walk 1.2 m/s": [24, 0.65, 0.55],
	"level walk 0.7 m/s": [20, 0.5, 0.7],
	"level walk 1.6 m/s": [28, 0.7, 0.44],
}
const _RISE: float = 0.17
const _TREAD: float = 0.29

## Stairs are climbed instead.
var climbs: bool = false


func run() -> void:
	if climbs:
		await _run_stairs()
		return
	for noise: float in [0.0, 1.0]:
		for name: String in _WALKS:
			begin()
			var walker: Walker = Walker.new(ragdoll.profile)
			walker.walk(_WALKS[name][0], _WALKS[name][1], _WALKS[name][2])
			var stats: Stats = await _walk(walker, noise)
			var title: String = "%s: %s%s"
			title %= [root_name, name, ", 1 deg noise" if noise > 0.0 else ""]
			_add_travel(title, stats, has_goals())
			var skate: float = 100.0 * stats.skate.mean()
			var most: float = 8.0 if noise > 0.0 else 3.0
			report.at_most(title, "stance-foot skate", skate, "cm/s", most, has_goals())


func _run_stairs() -> void:
	for rise: float in [_RISE, -_RISE]:
		begin()
		var walker: Walker = Walker.new(ragdoll.profile)
		walker.climb(16, rise, _TREAD, 0.6)
		var stats: Stats = await _walk(walker, 0.0)
		var title: String = "%s: 16 stairs %s" % [root_name, "up" if rise > 0.0 else "down"]
		_add_travel(title, stats, false)
		var right: float = 1.0 if stats.is_on_tread(_RISE, _TREAD) else 0.0
		report.at_least(title, "on the right tread", right, "", 1.0, has_goals())


func _walk(p_walker: Walker, p_noise_deg: float) -> Stats:
	random.seed = first_seed
	p_walker.build_ground(world)
	enter()
	var stats: Stats = Stats.new()
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var before: Dictionary[int, Vector3] = {}
	var told: Vector3 = p_walker.pose_at(0.0).root
	for tick: int in int(p_walker.duration / delta):
		await _tree.physics_frame
		var time: float = tick * delta
		var sample: PoseSample = p_walker.pose_at(time)
		if tick > 2:
			stats.add_root(root_of(ragdoll), sample.root)
			note_skate(p_walker, time, stats, before)
		add_noise(sample, p_noise_deg, random)
		ragdoll.push_sample(time, sample, told)
		ragdoll.drive(time, delta)
	await end()
	return stats


func _add_travel(p_title: String, p_stats: Stats, p_has_goal: bool) -> void:
	report.add(p_title, "way", p_stats.way, "m")
	report.at_most(p_title, "max travel error", p_stats.travel_percent(), "%", 4.0, p_has_goal)
	var off: float = 1000.0 * p_stats.height.mean()
	report.at_most(p_title, "body height error", off, "mm", 30.0, p_has_goal)
