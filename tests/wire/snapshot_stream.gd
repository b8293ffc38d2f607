extends RefCounted
## Real snapshots of a made-up world, for tests of what carries and shows them.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")

## What is in the world: ids.
var people: PackedInt32Array = []
var bodies: PackedInt32Array = []
## Where everything was put last.
var poses: Dictionary[int, PoseSample] = {}
var places: Dictionary[int, Transform3D] = {}
## The newest tick.
var tick: int = 1000
## Ticks per second.
var rate: int = 60

var _encoder: SnapshotEncoder = SnapshotEncoder.new()
var _known: Dictionary[int, bool] = {}
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func _init(p_people: PackedInt32Array, p_bodies: PackedInt32Array) -> void:
	people = p_people
	bodies = p_bodies
	_random.seed = 3
	_encoder.configure(PackedInt32Array(Limbs.PARENTS), Protocol.POSE_ERROR_DEG, rate)


## Everybody and everything somewhere else, a tick later.
func move() -> void:
	tick += 1
	_encoder.begin_tick(tick)
	for person: int in people:
		var pose: PoseSample = NetSamples.pose(_random)
		poses[person] = pose
		_encoder.put_person(person, pose.root, pose.orientations)
	for body: int in bodies:
		places[body] = NetSamples.transform(_random)
		_encoder.put_body(body, places[body], Vector3.ZERO, Vector3.ZERO, true)
	_encoder.end_tick()


## The same again, a tick later.
func stay() -> void:
	tick += 1
	_encoder.begin_tick(tick)
	for person: int in people:
		_encoder.put_person(person, poses[person].root, poses[person].orientations)
	for body: int in bodies:
		_encoder.put_body(body, places[body], Vector3.ZERO, Vector3.ZERO, true)
	_encoder.end_tick()


## The datagrams of the tick for a client, with what is to be said of its motion.
func datagrams(
	p_client: int = 1, p_motion_ack: PackedByteArray = PackedByteArray()
) -> Array[PackedByteArray]:
	if not _known.has(p_client):
		_known[p_client] = true
		_encoder.add_client(p_client, 0, 1e8)
	if not p_motion_ack.is_empty():
		_encoder.set_motion_ack(p_client, p_motion_ack)
	return _encoder.encode(p_client, 0)


## Takes a client's acknowledgement.
func take_ack(p_client: int, p_bytes: PackedByteArray) -> bool:
	return _encoder.take_ack(p_client, p_bytes)


## A decoder that fits.
static func decoder() -> SnapshotDecoder:
	var made: SnapshotDecoder = SnapshotDecoder.new()
	made.configure(PackedInt32Array(Limbs.PARENTS), Protocol.POSE_ERROR_DEG)
	return made
