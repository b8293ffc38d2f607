extends RefCounted
## One client of a moving world by way of our own coding: what it costs, and how wrong what it
## shows.

const MovingWorld: GDScript = preload("moving_world.gd")
const CLIENT: int = 1
## Bytes that IP, UDP and sealing add to each datagram.
const TRANSPORT_BYTES: int = 46

## Stats of the case.
var bits: int = 0
## The same without headers of UDP, IP and ENet.
var payload_bits: int = 0
var crate_square: float = 0.0
var crate_count: int = 0
var encode_usec: PackedFloat64Array = []

var _encoder: SnapshotEncoder = SnapshotEncoder.new()
var _decoder: SnapshotDecoder = SnapshotDecoder.new()
var _smoother: SnapshotSmoother = SnapshotSmoother.new()
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _to_client: Array = []
var _to_server: Array = []
var _history: Array[Array] = []
var _rate: int = 60
var _way_ticks: float = 0.0
var _jitter_ticks: float = 0.0
var _loss: float = 0.0
var _tick: int = 0


## A network: one way in s, up to so much more, and the share of datagrams that get lost.
func _init(
	p_rate: int,
	p_kilobits: float,
	p_way_s: float,
	p_jitter_s: float,
	p_loss: float,
	p_error_deg: float = Protocol.POSE_ERROR_DEG
) -> void:
	_random.seed = 5
	_rate = Engine.physics_ticks_per_second
	_way_ticks = p_way_s * _rate
	_jitter_ticks = p_jitter_s * _rate
	_loss = p_loss
	var parents: PackedInt32Array = PackedInt32Array(Limbs.PARENTS)
	_encoder.configure(parents, p_error_deg, _rate)
	_decoder.configure(parents, p_error_deg)
	_encoder.add_client(CLIENT, p_rate, p_kilobits * 1000.0)
	_smoother.set_tick_rate(_rate)


## Goes on by a tick of the world, after its step.
func advance(p_world: MovingWorld) -> void:
	_tick += 1
	# What arrives between two ticks is there before the next snapshot is made.
	_deliver()
	_put(p_world)
	var begin: int = Time.get_ticks_usec()
	var datagrams: Array[PackedByteArray] = _encoder.encode(CLIENT, begin)
	if not datagrams.is_empty():
		encode_usec.append(Time.get_ticks_usec() - begin)
	for bytes: PackedByteArray in datagrams:
		bits += (bytes.size() + TRANSPORT_BYTES) * 8
		payload_bits += bytes.size() * 8
		_post(_to_client, bytes)
	_compare(p_world)


func _put(p_world: MovingWorld) -> void:
	_encoder.begin_tick(_tick)
	for person: int in p_world.people.size():
		var sample: PoseSample = p_world.pose(person, float(_tick) / _rate)
		_encoder.put_person(person, sample.root, sample.orientations)
	var places: Array[Transform3D] = []
	for id: int in p_world.crates.size():
		var crate: RigidBody3D = p_world.crates[id]
		_encoder.put_body(
			id,
			crate.global_transform,
			crate.linear_velocity,
			crate.angular_velocity,
			crate.sleeping
		)
		places.append(crate.global_transform)
	_encoder.end_tick()
	for person: int in p_world.people.size():
		_encoder.set_mark(person, _tick, _tick * 16667, [1000, 1000, 4000])
	_history.append(places)
	if _history.size() > 120:
		_history.pop_front()


func _post(p_box: Array, p_bytes: PackedByteArray) -> void:
	if _random.randf() >= _loss:
		p_box.append([_tick + _way_ticks + _random.randf() * _jitter_ticks, p_bytes])


func _deliver() -> void:
	# In the order of arrival, which need not be that of sending.
	_to_client.sort_custom(func(p_a: Array, p_b: Array) -> bool: return p_a[0] < p_b[0])
	while not _to_client.is_empty() and _to_client[0][0] <= _tick:
		var packet: Array = _to_client.pop_front()
		if _decoder.decode(packet[1]) == SnapshotDecoder.OK:
			_smoother.take(_decoder, packet[0] / _rate)
			_post(_to_server, _decoder.get_ack(Vector3(0.0, 1.7, 0.0)))
	for packet: Array in _to_server.duplicate():
		if packet[0] <= _tick:
			_encoder.take_ack(CLIENT, packet[1])
			_to_server.erase(packet)


## What is shown against the truth at the moment that is shown.
func _compare(p_world: MovingWorld) -> void:
	_smoother.evaluate(float(_tick) / _rate)
	var shown: float = _smoother.get_shown_tick() - 1.0
	var last: int = _tick - 1
	var at: float = shown - (last - (_history.size() - 1))
	if _tick < 2 * _rate or at < 0.0 or at > _history.size() - 1:
		return
	for id: int in p_world.crates.size():
		var before: Transform3D = _history[floori(at)][id]
		var truth: Transform3D = before.interpolate_with(_history[ceili(at)][id], at - floorf(at))
		crate_square += truth.origin.distance_squared_to(_smoother.body_transform(id).origin)
		crate_count += 1
