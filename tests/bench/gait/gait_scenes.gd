extends "gait_case.gd"
## Random scenes, many beside one another in one world.

const Scene: GDScript = preload("gait_scene.gd")
## So many at once, and how far apart, m.
const _AT_ONCE: int = 40
const _APART: float = 25.0
## The target is never further from the body than this, m.
const _TARGET: float = 0.3
## Nobody is in the air for longer than a jump takes, s.
const _JUMP_S: float = 0.7
## Who goes back so far (m) while he walks ahead goes the wrong way.
const _BACK: float = 0.5
const _WALKS: int = 12
const _HZ: float = 60.0

## How many scenes.
var count: int = 20
var clips: Array[BvhSource] = []

var _farthest: float = 0.0
var _far: int = 0
var _levitations: int = 0
var _wrong: int = 0
var _motions: Array[Array] = []


func run() -> void:
	await _make_motions()
	var done: int = 0
	while done < count:
		var many: int = mini(_AT_ONCE, count - done)
		await _run_batch(first_seed + done, many)
		done += many
	var title: String = "%s: random scenes" % root_name
	var has: bool = has_goals()
	report.add(title, "scenes", count, "")
	report.at_most(title, "target from the body, max", _farthest, "m", _TARGET, has)
	report.at_most(title, "scenes where it was further", _far, "", 0.0, has)
	report.at_most(title, "levitations", _levitations, "", 0.0, has)
	report.at_most(title, "wrong ways", _wrong, "", 0.0, has)


## Stairs up and down, level walks of any pace, and the clips, as poses.
func _make_motions() -> void:
	begin()
	for i: int in _WALKS:
		var walker: Walker = Walker.new(ragdoll.profile)
		if i < 2:
			walker.climb(10, 0.17 if i == 0 else -0.17, 0.29, 0.6)
		else:
			walker.walk(12, random.randf_range(0.4, 0.75), random.randf_range(0.4, 0.7))
		var poses: Array = []
		for tick: int in int((walker.duration + 1.0) * _HZ):
			poses.append(walker.pose_at(tick / _HZ))
		_motions.append(poses)
	for clip: BvhSource in clips:
		var poses: Array = []
		for tick: int in int((clip.rig.clip.duration() - BvhSource.BLEND_S) * _HZ):
			poses.append(clip.pose_at(tick / _HZ))
		_motions.append(poses)
	ragdoll.free()
	await end()


func _run_batch(p_seed: int, p_many: int) -> void:
	var all: Node3D = Node3D.new()
	_tree.root.add_child(all)
	var scenes: Array[Scene] = []
	var motors: Array[RagdollMotor] = []
	for i: int in p_many:
		var scene: Scene = Scene.new(_tree, report, p_seed + i)
		scene.root_mode = root_mode
		scene.motions = _motions
		scene.walks = _WALKS
		scene.climbs = 2
		scene.build(all, Vector3(i * _APART, 0.0, 0.0))
		scenes.append(scene)
		motors.append(scene.ragdoll.motor)
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var times: PackedFloat64Array = []
	times.resize(p_many)
	while scenes[0].time_s < Scene.LENGTH_S:
		await _tree.physics_frame
		times.fill(scenes[0].time_s)
		for scene: Scene in scenes:
			scene.send()
		RagdollMotor.drive_all(motors, times, delta)
		for scene: Scene in scenes:
			scene.note()
	for scene: Scene in scenes:
		_judge(scene)
	all.queue_free()
	await _tree.process_frame


func _judge(p_scene: Scene) -> void:
	_farthest = maxf(_farthest, p_scene.farthest)
	var faults: PackedStringArray = []
	if p_scene.farthest > _TARGET:
		_far += 1
		faults.append("target %.2f m from the body" % p_scene.farthest)
	if p_scene.aloft_s > _JUMP_S:
		_levitations += 1
		faults.append("in the air for %.1f s" % p_scene.aloft_s)
	if p_scene.get_ahead() < -_BACK:
		_wrong += 1
		faults.append("%.1f m backward" % -p_scene.get_ahead())
	if not faults.is_empty():
		printerr(
			"scene of seed %d (%s): %s" % [p_scene.first_seed, p_scene.title, ", ".join(faults)]
		)
