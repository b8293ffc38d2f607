class_name WorldReplica
extends RefCounted
## A client's copy of the server's world: reads what the server tells, and tells where everything
## is at the moment that is shown.

## Floats of a limb in [method SnapshotSmoother.person_transforms]: position, quaternion.
const FLOATS: int = 7
## Acknowledgements are at least so far apart, µs.
const ACK_PERIOD_USEC: int = 30000
## The decoder takes nothing that is so many ticks older than the newest, unless that was wrong.
const STALE: int = 30

## Datagrams that were of use.
var datagrams: int = 0
## Which bodies there are; null before the server has told.
var world: WorldDescription = null
## The newest tick that has come, or -1.
var newest_tick: int = -1
## What became of the datagram that was taken last.
var outcome: SnapshotDecoder.Outcome = SnapshotDecoder.OK
## Whether the server shall mark every snapshot, for measuring delays.
var wants_marks: bool = false

var _decoder: SnapshotDecoder = SnapshotDecoder.new()
var _smoother: SnapshotSmoother = SnapshotSmoother.new()
var _acked_usec: int = 0
var _error_deg: float = 0.0
## Whether this server has told how exact its poses are: without that snapshots make no sense.
var _is_told: bool = false


func _init() -> void:
	_set_error(Protocol.POSE_ERROR_DEG)


## Sets how motion is made smooth.
func set_smoothing(p_method: SnapshotSmoother.Method) -> void:
	_smoother.method = p_method


## Takes over which bodies there are.
func describe(p_world: WorldDescription) -> void:
	if world != null:
		for actor: int in world.skeletons:
			if not p_world.skeletons.has(actor):
				_smoother.forget_person(actor)
	world = p_world
	_is_told = true
	_set_error(world.pose_error_deg)
	_decoder.keep_people(PackedInt32Array(world.skeletons.keys()))
	for actor: int in world.skeletons:
		var joints: PersonSkeleton = world.skeletons[actor]
		if joints.is_sound():
			_smoother.set_skeleton(
				actor, joints.parents, joints.joints_in_parent, joints.joints_in_limb
			)


## Takes a datagram that arrived at a local time, s. Returns whether it was of use.
func take(p_bytes: PackedByteArray, p_arrival_s: float) -> bool:
	outcome = _decoder.decode(p_bytes) if _is_told else SnapshotDecoder.NOT_BEGUN
	if outcome != SnapshotDecoder.OK:
		return false
	datagrams += 1
	var tick: int = _decoder.get_tick()
	if tick > newest_tick or tick < newest_tick - STALE:
		newest_tick = tick
	_smoother.take(_decoder, p_arrival_s)
	return true


## Tick of the last datagram that was of use, or -1.
func told_tick() -> int:
	return _decoder.get_tick()


## People that the last datagram of use told of.
func told_people() -> PackedInt32Array:
	return _decoder.get_people()


## A number that is the same wherever the last datagram told the same of a person: of its root's
## position and of its limbs' orientations.
func told_fingerprint(p_actor: int) -> int:
	return hash([_decoder.get_root(p_actor), _decoder.get_orientations(p_actor)])


## The mark of the datagram that was taken last, in times of the server's clock but for
## [member LatencyMark.arrival_usec]; null if it had none.
func take_mark() -> LatencyMark:
	var told: Dictionary = _decoder.get_mark()
	if told.is_empty():
		return null
	var steps: PackedInt32Array = told["steps_usec"]
	var mark: LatencyMark = LatencyMark.new()
	mark.person = told["person"]
	mark.sample = told["sample"]
	mark.tick = told["tick"]
	mark.simulated_usec = told["simulated_usec"]
	mark.snapshot_sent_usec = mark.simulated_usec + steps[3]
	mark.received_usec = mark.simulated_usec - steps[2]
	mark.sent_usec = mark.received_usec - steps[1]
	mark.sampled_usec = mark.sent_usec - steps[0]
	return mark


## What is to be said to the server at a time (µs), by somebody who looks from a place (m); mostly
## nothing.
func acknowledgement(p_now_usec: int, p_viewpoint: Vector3) -> PackedByteArray:
	if p_now_usec - _acked_usec < ACK_PERIOD_USEC:
		return PackedByteArray()
	var bytes: PackedByteArray = _decoder.get_ack(p_viewpoint)
	if not bytes.is_empty():
		_acked_usec = p_now_usec
	return bytes


## Forgets the server's world, but not how it was made smooth.
func clear() -> void:
	_decoder.clear()
	_smoother.clear()
	newest_tick = -1
	_is_told = false


## Works out where everything is at a local time, s.
func show(p_now_s: float) -> void:
	_smoother.evaluate(p_now_s)


## The server's tick that is shown, with its fraction, or -1.
func shown_tick() -> float:
	return _smoother.get_shown_tick()


## The server's ticks per second, or 0 while that is not known.
func tick_rate() -> float:
	return _decoder.get_tick_rate()


## How far what is shown is behind the quickest arrivals, s.
func delay() -> float:
	return _smoother.get_delay()


## Whether something is known of a person.
func has_person(p_actor: int) -> bool:
	return _smoother.has_person(p_actor)


## Where a person's limbs are, seven floats each; as received last if [param p_newest].
func person_floats(p_actor: int, p_newest: bool = false) -> PackedFloat32Array:
	if p_newest:
		return _smoother.newest_person_transforms(p_actor)
	return _smoother.person_transforms(p_actor)


## Transforms of a person's bodies, by limb, of such floats.
func limbs_of(p_actor: int, p_floats: PackedFloat32Array) -> Array[Transform3D]:
	var joints: PersonSkeleton = world.skeletons.get(p_actor)
	var bodies: Array[Transform3D] = []
	if joints == null or p_floats.size() != Limbs.COUNT * FLOATS or not joints.is_sound():
		return bodies
	for limb: int in Limbs.COUNT:
		var at: int = limb * FLOATS
		var place: Vector3 = Vector3(p_floats[at], p_floats[at + 1], p_floats[at + 2])
		var turn: Quaternion = Quaternion(
			p_floats[at + 3], p_floats[at + 4], p_floats[at + 5], p_floats[at + 6]
		)
		bodies.append(joints.body_at(limb, place, turn))
	return bodies


## Whether something is known of a rigid body.
func has_body(p_id: int) -> bool:
	return _smoother.has_body(p_id)


## Where a rigid body is; as received last if [param p_newest].
func body_transform(p_id: int, p_newest: bool = false) -> Transform3D:
	if p_newest:
		return _smoother.newest_body_transform(p_id)
	return _smoother.body_transform(p_id)


func _set_error(p_degrees: float) -> void:
	if p_degrees != _error_deg:
		_error_deg = p_degrees
		_decoder.configure(PackedInt32Array(Limbs.PARENTS), p_degrees)
	_decoder.set_wants_marks(wants_marks)
