extends "gait_case.gd"
## Coming to the ground: beginning in any pose with any height told, and getting up after having
## been limp, also under a crate.

const Poses: GDScript = preload("gait_poses.gd")
## Heights that the root is told to begin at, m: nobody who has no position knows them.
const _TOLD: Array[float] = [0.0, 0.3, 0.5, 0.95, 1.5]
const _LIMIT_S: float = 3.0
## The body is on the ground when its lowest point is no further from it, m.
const _ON_GROUND: float = 0.04
## And in its pose when its limbs are off by no more on average, degrees.
const _IN_POSE_DEG: float = 8.0
const _CYCLES: int = 100

var _farthest: float = 0.0


func run() -> void:
	await _run_starts()
	await _run_limp()


func _run_starts() -> void:
	var good: int = 0
	var count: int = 0
	_farthest = 0.0
	var failed: PackedStringArray = []
	for name: String in Poses.POSES:
		for told: float in _TOLD:
			begin()
			add_floor(0.0)
			enter()
			var arrived: bool = await _arrives(Poses.pose_of(name), told)
			good += 1 if arrived else 0
			count += 1
			if not arrived:
				failed.append("%s, told %.2f m (%s)" % [name, told, _state()])
			await end()
	var title: String = "%s: start in %d poses" % [root_name, Poses.POSES.size()]
	_add_share(title, good, count)
	report.at_most(title, "target from the body, max", _farthest, "m", 0.3, has_goals())
	for line: String in failed:
		printerr("%s: %s" % [title, line])


func _run_limp() -> void:
	var good: int = 0
	_farthest = 0.0
	begin()
	add_floor(0.0)
	enter()
	var names: Array[String] = Poses.POSES.keys()
	var title: String = "%s: limp and back" % root_name
	var crate: RigidBody3D = null
	await _arrives(Poses.pose_of("standing"), 0.95)
	for cycle: int in _CYCLES:
		var name: String = names[random.randi() % names.size()]
		var pose: PoseSample = Poses.pose_of(name)
		ragdoll.motor.set_actuation(RagdollMotor.LIMP, "", 0.3)
		await _hold(pose, 1.5)
		if cycle % 2 == 1:
			var above: Vector3 = root_of(ragdoll) + Vector3(random.randf_range(-0.3, 0.3), 1.0, 0.1)
			crate = add_crate(Vector3.ONE * 0.4, above, 15.0)
			await _hold(pose, 1.0)
		ragdoll.motor.set_actuation(RagdollMotor.VELOCITY_MOTOR, "", 0.5)
		var arrived: bool = await _arrives(pose, 0.0)
		good += 1 if arrived else 0
		if not arrived:
			printerr("%s %d, %s: %s" % [title, cycle, name, _state()])
		if crate:
			crate.queue_free()
			crate = null
	_add_share(title, good, _CYCLES)
	report.at_most(title, "target from the body, max", _farthest, "m", 0.3, has_goals())
	await end()


## Whether the body is on the ground in a pose within the time, and stays there for half a second.
func _arrives(p_pose: PoseSample, p_told: float) -> bool:
	var since: float = time_s
	var calm_s: float = 0.0
	while time_s < since + _LIMIT_S and calm_s < 0.5:
		await step(p_pose, Vector3(0.0, p_told, 0.0))
		if time_s > since + 0.1:
			_farthest = maxf(_farthest, target_distance())
		var there: bool = pose_error_deg() < _IN_POSE_DEG and absf(clearance()) < _ON_GROUND
		calm_s = calm_s + 1.0 / Engine.physics_ticks_per_second if there else 0.0
	return calm_s >= 0.5


func _hold(p_pose: PoseSample, p_span_s: float) -> void:
	var until: float = time_s + p_span_s
	while time_s < until:
		await step(p_pose, Vector3.ZERO)


func _state() -> String:
	return (
		"%.1f deg, %.3f m above the ground, root at %.2f m, target at %.2f m"
		% [
			pose_error_deg(),
			clearance(),
			root_of(ragdoll).y,
			ragdoll.motor.get_root_target().y,
		]
	)


func _add_share(p_title: String, p_good: int, p_count: int) -> void:
	report.add(p_title, "cases", p_count, "")
	var share: float = 100.0 * p_good / p_count
	report.at_least(p_title, "on the ground within 3 s", share, "%", 100.0, has_goals())
