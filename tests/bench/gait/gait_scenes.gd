extends "gait_case.gd"
## Random scenes, one for each seed: somebody walks on a slope or on rough ground among loose
## crates, or does what a clip has, from any moment of it on. Now and then nothing comes from the
## suit.

const _LENGTH_S: float = 6.0
const _STEEPEST_DEG: float = 30.0
const _MOST_CRATES: int = 12
## The target is never further from the body than this, m.
const _TARGET: float = 0.3
## Nobody is higher above what is under him than this (m) for longer than a jump takes, s.
const _LEVITATION: float = 0.1
const _JUMP_S: float = 0.7
## Who goes back so far (m) while he walks ahead goes the wrong way.
const _BACK: float = 0.5
## Clearances are looked for every so many ticks: 50 rays each.
const _LOOKS: int = 6

## How many scenes.
var count: int = 20
var clips: Array[BvhSource] = []

var _farthest: float = 0.0
var _far: int = 0
var _levitations: int = 0
var _wrong: int = 0


func run() -> void:
	for i: int in count:
		random.seed = first_seed + i
		await _run_scene(first_seed + i)
	var title: String = "%s: random scenes" % root_name
	var at_most: BenchReport.Goal = BenchReport.Goal.NONE
	if root_mode == RagdollMotor.ROOT_INERTIAL:
		at_most = BenchReport.Goal.AT_MOST
	report.add(title, "scenes", count, "")
	report.add(title, "target from the body, max", _farthest, "m", at_most, _TARGET)
	report.add(title, "scenes where it was further", _far, "", at_most, 0.0)
	report.add(title, "levitations", _levitations, "", at_most, 0.0)
	report.add(title, "wrong ways", _wrong, "", at_most, 0.0)


func _run_scene(p_number: int) -> void:
	begin()
	var angle: float = deg_to_rad(random.randf_range(-_STEEPEST_DEG, _STEEPEST_DEG))
	if random.randf() < 0.2:
		add_bumps(0.1)
		angle = 0.0
	else:
		add_floor(angle)
	_strew_crates(tan(angle))
	var walker: Walker = Walker.new(ragdoll.profile)
	walker.walk(12, random.randf_range(0.4, 0.75), random.randf_range(0.4, 0.7))
	var clip: BvhSource = null
	if not clips.is_empty() and random.randf() < 0.5:
		clip = clips[random.randi() % clips.size()]
	enter()
	var found: Dictionary[String, float] = await _play(walker, clip)
	_farthest = maxf(_farthest, found["distance"])
	var faults: PackedStringArray = []
	if found["distance"] > _TARGET:
		_far += 1
		faults.append("target %.2f m from the body" % found["distance"])
	if found["aloft_s"] > _JUMP_S:
		_levitations += 1
		faults.append("in the air for %.1f s" % found["aloft_s"])
	if not clip and found["ahead"] < -_BACK:
		_wrong += 1
		faults.append("%.1f m backward" % -found["ahead"])
	if not faults.is_empty():
		var what: String = "clip %d" % clips.find(clip) if clip else "walk"
		var where: String = "%s on %+.0f deg" % [what, rad_to_deg(angle)]
		printerr("scene of seed %d (%s): %s" % [p_number, where, ", ".join(faults)])
	await end()


func _strew_crates(p_rise: float) -> void:
	for i: int in random.randi() % (_MOST_CRATES + 1):
		var size: Vector3 = Vector3(
			random.randf_range(0.2, 0.6),
			random.randf_range(0.15, 0.6),
			random.randf_range(0.2, 0.6)
		)
		var place: Vector3 = Vector3(
			random.randf_range(-1.5, 1.5), 0.0, random.randf_range(0.7, 7.0)
		)
		place.y = p_rise * place.z + size.y
		add_crate(size, place, random.randf_range(2.0, 40.0))


## What is found out: the target's greatest distance from the body (m), for how long the body was
## in the air (s), and how far it went ahead (m).
func _play(p_walker: Walker, p_clip: BvhSource) -> Dictionary[String, float]:
	var from: float = 0.0
	if p_clip:
		from = random.randf() * maxf(p_clip.rig.clip.duration() - _LENGTH_S - 1.0, 0.0)
	elif random.randf() < 0.5:
		from = random.randf_range(1.0, 3.0)
	var stalls_at: float = random.randf_range(1.0, 12.0)
	var stalls_until: float = stalls_at + random.randf_range(0.2, 1.5)
	var farthest: float = 0.0
	var aloft: float = 0.0
	var longest: float = 0.0
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var tick: int = 0
	while time_s < _LENGTH_S:
		var moment: float = from + time_s
		var pose: PoseSample = p_clip.pose_at(moment) if p_clip else p_walker.pose_at(moment)
		await step(pose, Vector3(0.0, 0.95, 0.0), time_s < stalls_at or time_s > stalls_until)
		tick += 1
		if time_s > 0.5:
			farthest = maxf(farthest, target_distance())
		if tick % _LOOKS == 0 and time_s > 1.0:
			aloft = aloft + _LOOKS * delta if clearance() > _LEVITATION else 0.0
			longest = maxf(longest, aloft)
	return {"distance": farthest, "aloft_s": longest, "ahead": root_of(ragdoll).z}
