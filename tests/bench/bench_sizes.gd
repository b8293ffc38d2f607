extends Bench
## How precisely soldiers of other sizes follow recorded motion, on the floor and in the air.
##
## Options: --bvh=FILE (again for more; default the three clips in assets/motion), --seconds=0 (of
## each clip; 0 is all).

const HZ: int = 60
## Greatest difference to the body of the scene, deg.
const _GOAL_DEG: float = 0.1
const _START_S: float = 0.3
## People: height, m, and how much longer legs and arms are than usual.
const _PEOPLE: Dictionary[String, Vector3] = {
	"as in the scene": Vector3(0.0, 1.0, 1.0),
	"1.45 m": Vector3(1.45, 1.0, 1.0),
	"2.05 m": Vector3(2.05, 1.0, 1.0),
	"1.45 m, long legs, short arms": Vector3(1.45, 1.15, 0.85),
	"2.05 m, short legs, long arms": Vector3(2.05, 0.85, 1.15),
}


func options() -> Dictionary:
	return {"bvh": "", "seconds": 0.0}


func measure() -> void:
	Engine.physics_ticks_per_second = HZ
	for mode: RagdollMotor.RootMode in [RagdollMotor.ROOT_HELD, RagdollMotor.ROOT_SOFT]:
		var usual: float = 0.0
		for who: String in _PEOPLE:
			var sums: Dictionary = {}
			var count: int = 0
			for file: String in BenchArguments.clips(arguments):
				count += 1 if await _run_clip(file, _PEOPLE[who], mode, sums) else 0
			if count == 0:
				continue
			var mean: float = sums["mean_deg"] / count
			if usual == 0.0:
				usual = mean
			_add(who, mode, mean, usual, sums["p95_deg"] / count, sums["acted"])


func _add(
	p_who: String, p_mode: int, p_mean: float, p_usual: float, p_p95: float, p_acted: int
) -> void:
	var name: String = "%s, %s" % [p_who, "held" if p_mode == RagdollMotor.ROOT_HELD else "soft"]
	var goal: float = p_usual + _GOAL_DEG
	report.at_most(name, "mean error", p_mean, "deg", goal)
	report.add(name, "p95 error", p_p95, "deg")
	report.at_most(name, "guard acted", p_acted, "ticks", 0.0)


## Adds a clip's stats to the sums. Returns whether there are any.
func _run_clip(
	p_file: String, p_person: Vector3, p_mode: RagdollMotor.RootMode, r_sums: Dictionary
) -> bool:
	var source: BvhSource = report.open_clip(p_file)
	if source == null:
		return false
	var ragdoll: Ragdoll = BenchBodies.soldier(p_mode)
	_fit(ragdoll, p_person)
	root.add_child(ragdoll)
	ragdoll.start()
	var acted: Array[int] = [0]
	ragdoll.motor.guard_acted.connect(func(_actions: int) -> void: acted[0] += 1)
	await _play(source, ragdoll)
	var tracking: Dictionary = ragdoll.motor.get_tracking()
	ragdoll.queue_free()
	await process_frame
	if tracking["count"] == 0:
		report.leave_out(p_file, "%.2f s are too short to measure" % source.rig.clip.duration())
		return false
	for key: String in ["mean_deg", "p95_deg"]:
		r_sums[key] = r_sums.get(key, 0.0) + tracking[key]
	r_sums["acted"] = r_sums.get("acted", 0) + acted[0]
	return true


static func _fit(p_ragdoll: Ragdoll, p_person: Vector3) -> void:
	if p_person.x <= 0.0:
		return
	var figure: RestSkeleton = RestSkeleton.new(p_ragdoll.get_skeleton())
	var factor: float = p_person.x / BodyMass.stature(figure)
	var lengths: PackedFloat32Array = BodyScale.own_lengths(p_ragdoll)
	for limb: int in Limbs.COUNT:
		var share: float = p_person.y if limb >= 10 else p_person.z if limb >= 4 else 1.0
		lengths[limb] *= factor * share
	p_ragdoll.fit(lengths)


func _play(p_source: BvhSource, p_ragdoll: Ragdoll) -> void:
	var delta: float = 1.0 / HZ
	var length: float = p_source.rig.clip.duration() - BvhSource.BLEND_S
	if option("seconds") > 0.0:
		length = minf(length, option("seconds"))
	var scale: float = p_ragdoll.get_hip_height() / p_source.get_hip_height()
	var tick: int = 0
	while tick * delta < length:
		await physics_frame
		if tick * delta > _START_S:
			p_ragdoll.motor.measure(tick * delta)
		var sampled: PoseSample = p_source.pose_at(tick * delta)
		p_ragdoll.push_sample(tick * delta, sampled, sampled.root * scale)
		p_ragdoll.drive(tick * delta, delta)
		tick += 1
