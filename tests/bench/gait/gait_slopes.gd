extends "gait_case.gd"
## A level walk on ground that is not: slopes, hills and hollows. The wearer's own floor is level,
## so his pose says nothing of them.

const _ANGLES_DEG: Array[float] = [-20.0, -10.0, -5.0, 5.0, 10.0, 20.0]
const _BUMP: float = 0.1

var _highest: float = 0.0


func run() -> void:
	for angle: float in _ANGLES_DEG:
		begin()
		add_floor(deg_to_rad(angle))
		await _walk("%s: level walk on %+.0f deg" % [root_name, angle])
	begin()
	add_bumps(_BUMP)
	await _walk("%s: level walk on bumps of 20 cm" % root_name)


func _walk(p_title: String) -> void:
	var walker: Walker = Walker.new(ragdoll.profile)
	walker.walk(24, 0.65, 0.55)
	enter()
	var stats: Stats = Stats.new()
	var before: Dictionary[int, Vector3] = {}
	_highest = 0.0
	while time_s < walker.duration:
		var pose: PoseSample = walker.pose_at(time_s)
		if time_s > 0.5:
			_note(walker, pose, stats, before)
		await step(pose, walker.pose_at(0.0).root)
	report.add(p_title, "way", stats.way, "m")
	var has: bool = has_goals()
	report.at_most(p_title, "max travel error", stats.travel_percent(), "%", 4.0, has)
	report.at_most(p_title, "stance-foot skate", 100.0 * stats.skate.mean(), "cm/s", 3.0, has)
	report.at_most(p_title, "hips above their height", _highest, "m", 0.2, has)
	await end()


func _note(
	p_walker: Walker, p_pose: PoseSample, p_stats: Stats, r_before: Dictionary[int, Vector3]
) -> void:
	var root: Vector3 = root_of(ragdoll)
	p_stats.add_root(root, p_pose.root)
	var ground: float = ground_under(root)
	if is_finite(ground):
		_highest = maxf(_highest, root.y - ground - p_pose.root.y)
	note_skate(p_walker, time_s, p_stats, r_before)
