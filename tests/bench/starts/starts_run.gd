class_name StartsRun
extends RefCounted
## One clip in the benchmark of beginnings: bodies side by side that begin at moments of it, or go
## on at them after a pause, beside one that does neither.

## How long pauses are, s.
const PAUSES: Array[float] = [0.2, 0.35, 0.6, 0.9, 1.5, 3.0]
## How many moments of a clip are tried.
const MOMENTS: int = 8
## For how long a body is looked at, s: shorter in short clips.
const _WATCH_S: float = 0.6
const _WATCH_SHORT_S: float = 0.3
## How long a body moves before it pauses, s.
const _BEFORE_S: float = 1.0
## Between the bodies, m.
const _APART_M: float = 4.0
const _MOST_S: float = 12.0

var bodies: Array[StartBody] = []
var root_mode: RagdollMotor.RootMode = RagdollMotor.ROOT_GROUNDED
## Samples that are known before the step that shows them: ticks.
var buffer: int = 0
## Samples a second; 0: as many as ticks.
var sample_hz: int = 0

var _world: ContactWorld = null
var _source: BvhSource = null
var _count: int = 0
var _usual: StartBody = null
var _rate: int = 60
var _steps: int = 0
var _watch_s: float = _WATCH_S


func run(p_tree: SceneTree, p_source: BvhSource, p_hz: int) -> void:
	_source = p_source
	_rate = sample_hz if sample_hz > 0 else p_hz
	_world = ContactWorld.new(p_hz)
	p_tree.root.add_child(_world)
	_world.add_block(Vector3(300.0, 1.0, 300.0), Transform3D(Basis(), Vector3.DOWN * 0.5))
	_watch_s = clampf(_source.get_period() / 3.0, _WATCH_SHORT_S, _WATCH_S)
	_plan()
	await p_tree.physics_frame
	var length: float = _length() + _watch_s
	while _world.time_s < length:
		await _step(p_tree)
	for body: StartBody in bodies:
		body.judge(_usual, _world.delta_s)
	_world.queue_free()
	await p_tree.process_frame


func _length() -> float:
	return minf(_source.get_period() - _world.delta_s, _MOST_S) - _watch_s


func _plan() -> void:
	_usual = _add(0.0)
	for i: int in MOMENTS:
		var moment: float = lerpf(minf(1.0, _length() / 3.0), _length(), float(i) / (MOMENTS - 1))
		bodies.append(_add(moment))
		var pause: float = PAUSES[i % PAUSES.size()]
		var paused: StartBody = _add(maxf(moment - pause - _BEFORE_S, 0.0))
		paused.stops_s = moment - pause
		paused.goes_on_s = moment
		if paused.stops_s > 0.2:
			bodies.append(paused)


func _add(p_begins_s: float) -> StartBody:
	var body: StartBody = StartBody.new()
	# Whole ticks: what is asked is what comes after a beginning, not when that was.
	body.begins_s = floorf(p_begins_s / _world.delta_s) * _world.delta_s
	body.goes_on_s = body.begins_s
	body.origin = Vector3.RIGHT * _APART_M * (_count - MOMENTS)
	_count += 1
	return body


func _enter(p_body: StartBody) -> void:
	var ragdoll: Ragdoll = BenchBodies.of_clip(_source, root_mode)
	_world.add_child(ragdoll)
	p_body.person = ContactPerson.new(ragdoll)
	ragdoll.start()


func _step(p_tree: SceneTree) -> void:
	var all: Array[StartBody] = [_usual]
	all.append_array(bodies)
	var now: float = _world.time_s
	var known: float = now + buffer * _world.delta_s
	var first: int = ceili((known - _world.delta_s) * _rate + 1e-6)
	for k: int in range(maxi(first, 0), floori(known * _rate + 1e-6) + 1):
		_send(all, float(k) / _rate)
	for body: StartBody in all:
		if body.person != null and body.person.ragdoll.motor != null:
			body.person.ragdoll.drive(now, _world.delta_s)
	await p_tree.physics_frame
	_world.time_s += _world.delta_s
	_look()


func _send(p_all: Array[StartBody], p_time_s: float) -> void:
	var sample: PoseSample = _source.pose_at(p_time_s)
	for body: StartBody in p_all:
		if p_time_s < body.begins_s - 1e-6 or not body.hears(p_time_s):
			continue
		if body.person == null and _world.time_s < body.goes_on_s + _watch_s:
			_enter(body)
		if body.person != null:
			body.person.ragdoll.push_sample(p_time_s, sample, sample.root + body.origin)


func _look() -> void:
	_steps += 1
	var sample: PoseSample = _source.pose_at(_world.time_s)
	var targets: Array[Transform3D] = _usual.person.targets(sample, sample.root)
	_usual.note(_steps, targets)
	for body: StartBody in bodies:
		var since: float = _world.time_s - body.goes_on_s
		if body.person == null or since < StartBody.LOOK_S - 1e-6:
			continue
		if since < _watch_s:
			body.note(_steps, targets)
		else:
			body.person.ragdoll.queue_free()
			body.person = null
