class_name GroundGaits
extends RefCounted
## The walk of a clip on ground that the wearer does not have: slopes, a kerb, stairs; begun at
## eight moments, so that each foot meets what comes at another part of its step.
##
## What counts is how far the body has come along the wearer's way when the clip ends, in % of it,
## and whether it has fallen. A clip whose wearer does not walk far enough is left out. Loose crates
## hold everybody up: through them less is asked of who is faster, falls count as what they cost of
## the way, and how high the hips come tells who climbs instead.

## Names of the grounds. Numbers are slopes, deg, up for positive ones.
const KINDS: Array[String] = ["0", "5", "-5", "10", "-10", "20", "-20", "kerb", "up", "down"]
const CRATES: String = "crates"
## Who is faster runs, m/s.
const RUN: float = 2.4
const _MOMENTS: int = 8
## Time from one moment to the next, and what is played at most and at least, s.
const _APART_S: float = 0.15
const _LONGEST_S: float = 5.0
const _SHORTEST_S: float = 1.5
## What is left at a clip's end, s: clips are blended into their beginning.
const _END_S: float = 0.6
## The wearer walks so far at least, m.
const _LEAST_WAY: float = 1.5
const _GOAL: float = 95.0
## Through crates, %: of who walks, walks fast (from this speed on, m/s) and runs.
const _CRATES_GOALS: Array[float] = [60.0, 50.0, 40.0]
const _FAST: float = 1.6
const _CRATES: int = 200
## Kerbs and stairs begin so far ahead, m.
const _BEGIN: float = 0.6
const _KERB: float = 0.15
const _RISE: float = 0.17
const _TREAD: float = 0.29
const _STAIRS: int = 16

var _tree: SceneTree = null
var _report: BenchReport = null
var _hz: int = 60
var _root: RagdollMotor.RootMode = RagdollMotor.ROOT_GROUNDED


func _init(
	p_tree: SceneTree, p_report: BenchReport, p_hz: int, p_root: RagdollMotor.RootMode
) -> void:
	_tree = p_tree
	_report = p_report
	_hz = p_hz
	_root = p_root


## Plays a clip on a ground from each moment and tells the worst and how many miss the goal.
func walk(p_performer: ContactPerformer, p_kind: String, p_case: String) -> void:
	var least: float = INF
	var goal: float = _goal(p_performer, p_kind)
	var highest: float = 0.0
	var missed: int = 0
	var played: int = 0
	for moment: int in _MOMENTS:
		var from: float = 0.3 + moment * _APART_S
		var seconds: float = minf(_LONGEST_S, p_performer.duration() - _END_S - from)
		if seconds < _SHORTEST_S or _way(p_performer, from, seconds).length() < _LEAST_WAY:
			continue
		var found: Vector2 = await _walk(p_performer, p_kind, from, seconds)
		played += 1
		least = minf(least, found.x)
		highest = maxf(highest, found.y)
		missed += 1 if found.x < goal else 0
	if played == 0:
		return
	_report.at_least(p_case, "least of the way", least, "%", goal)
	_report.add(p_case, "walks that miss it", missed, "of %d" % played)
	if p_kind == CRATES:
		_report.at_most(p_case, "hips too high at most", highest, "m", 0.3)


func _goal(p_performer: ContactPerformer, p_kind: String) -> float:
	if p_kind != CRATES:
		return _GOAL
	var seconds: float = minf(_LONGEST_S, p_performer.duration() - _END_S)
	var speed: float = _way(p_performer, 0.0, seconds).length() / maxf(seconds, 0.1)
	return _CRATES_GOALS[2 if speed >= RUN else (1 if speed >= _FAST else 0)]


## How far the body comes, in % of the wearer's way; 0 for who falls, but among crates; and how much
## higher than the wearer's its hips come, m.
func _walk(
	p_performer: ContactPerformer, p_kind: String, p_from: float, p_seconds: float
) -> Vector2:
	var world: ContactWorld = ContactWorld.new(_hz)
	_tree.root.add_child(world)
	_build(world, p_kind, int(p_from * 1000.0))
	var person: ContactPerson = p_performer.enter(world, _root)
	var way: Vector3 = _way(p_performer, p_from, p_seconds)
	var turn: Quaternion = Quaternion(Vector3.UP, -atan2(way.x, way.z))
	var first: Vector3 = p_performer.hips_at(p_from, person) * Vector3(1.0, 0.0, 1.0)
	world.add_person(
		person,
		func(t: float) -> PoseSample: return _turned(p_performer.source.pose_at(p_from + t), turn),
		func(t: float) -> Vector3: return turn * (p_performer.hips_at(p_from + t, person) - first)
	)
	var fell: Array[bool] = [false]
	var high: Array[float] = [0.0]
	await world.run(
		p_seconds,
		func() -> bool:
			var phase: int = person.ragdoll.motor.get_balance().get("phase", 0)
			fell[0] = fell[0] or phase == RagdollMotor.BALANCE_FALLING
			var meant: Vector3 = person.joint(0, person.targets_at(world.time_s))
			high[0] = maxf(high[0], person.joint(0, person.bodies()).y - meant.y)
			return false
	)
	var done: float = person.joint(0, person.bodies()).z
	var meant: float = person.joint(0, person.targets_at(world.time_s)).z
	person.pose = Callable()
	person.place = Callable()
	world.queue_free()
	await _tree.process_frame
	return Vector2(0.0 if fell[0] and p_kind != CRATES else 100.0 * done / meant, high[0])


func _way(p_performer: ContactPerformer, p_from: float, p_seconds: float) -> Vector3:
	var source: BvhSource = p_performer.source
	var way: Vector3 = source.pose_at(p_from + p_seconds).root - source.pose_at(p_from).root
	return way * Vector3(1.0, 0.0, 1.0)


static func _turned(p_pose: PoseSample, p_turn: Quaternion) -> PoseSample:
	for slot: int in Limbs.COUNT:
		p_pose.set_orientation(slot, p_turn * p_pose.orientation(slot))
	return p_pose


func _build(p_world: ContactWorld, p_kind: String, p_seed: int) -> void:
	var slope: float = p_kind.to_float() if p_kind.is_valid_float() else 0.0
	var tilt: Basis = Basis(Vector3.RIGHT, -deg_to_rad(slope))
	if p_kind != "down":
		p_world.add_block(Vector3(200.0, 1.0, 200.0), Transform3D(tilt, tilt.y * -0.5))
	match p_kind:
		"kerb":
			_add_tread(p_world, 0.0, _KERB, 30.0)
		"up":
			_add_stairs(p_world, _RISE)
		"down":
			_add_tread(p_world, -20.0, 0.0, 20.0)
			_add_stairs(p_world, -_RISE)
		CRATES:
			_add_crates(p_world, p_seed)


## Crates of 0.5 to 13 kg, 5 to 20 cm high, over the whole way.
func _add_crates(p_world: ContactWorld, p_seed: int) -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = p_seed
	for crate: int in _CRATES:
		var size: Vector3 = Vector3(
			random.randf_range(0.15, 0.4),
			random.randf_range(0.05, 0.2),
			random.randf_range(0.15, 0.4)
		)
		var at: Vector3 = Vector3(
			random.randf_range(-1.2, 1.2), size.y / 2.0, random.randf_range(_BEGIN, 14.0)
		)
		p_world.add_crate(size, at, size.x * size.y * size.z * 400.0)


func _add_stairs(p_world: ContactWorld, p_rise: float) -> void:
	for step: int in _STAIRS:
		var length: float = _TREAD if step < _STAIRS - 1 else 20.0
		_add_tread(p_world, step * _TREAD, p_rise * (step + 1), length)


## A block from a place on (m, after [constant _BEGIN]) whose top is at a height, m.
func _add_tread(p_world: ContactWorld, p_from: float, p_top: float, p_length: float) -> void:
	var place: Vector3 = Vector3(0.0, p_top - 2.0, _BEGIN + p_from + p_length / 2.0)
	p_world.add_block(Vector3(6.0, 4.0, p_length), Transform3D(Basis(), place))
