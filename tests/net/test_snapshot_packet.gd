extends TestCase
## A snapshot survives the wire: small datagrams, each of use alone, all bodies in them together.

const NetSamples: GDScript = preload("net_samples.gd")
## Best that 16 bits a component can promise, degrees.
const MOST_DEG: float = 0.01

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 2


func test_round_trip_in_small_datagrams() -> void:
	for bodies: int in [0, 1, 53, 54, 55, 108, 109, 300]:
		for people: int in [0, 1, 8, 32, 40]:
			_check_round_trip(NetSamples.snapshot(_random, bodies, people))


func test_every_tick_and_rate() -> void:
	for tick: int in [0, 1, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF]:
		for rate: int in [1, 60, 255]:
			var snapshot: Snapshot = NetSamples.snapshot(_random, 1, 1)
			snapshot.tick = tick
			snapshot.tick_rate = rate
			var got: Snapshot = SnapshotPacket.decode(SnapshotPacket.encode(snapshot)[0])
			equal([got.tick, got.tick_rate], [tick, rate])


func test_more_people_than_fit_still_fit_a_datagram() -> void:
	var snapshot: Snapshot = NetSamples.snapshot(_random, 300, 200)
	for datagram: PackedByteArray in SnapshotPacket.encode(snapshot):
		is_true(datagram.size() <= Protocol.MAX_DATAGRAM)
		not_null(SnapshotPacket.decode(datagram))


func test_angles_are_precise() -> void:
	var worst: float = 0.0
	var snapshot: Snapshot = NetSamples.snapshot(_random, 2000, 0)
	for datagram: PackedByteArray in SnapshotPacket.encode(snapshot):
		var got: Snapshot = SnapshotPacket.decode(datagram)
		for id: int in got.bodies:
			worst = maxf(worst, _angle_deg(snapshot.bodies[id].basis, got.bodies[id].basis))
	is_true(worst < MOST_DEG, "worst %f deg" % worst)
	is_true(worst > 0.0, "the angles were not quantised at all")


func test_what_is_none() -> void:
	var bytes: PackedByteArray = SnapshotPacket.encode(NetSamples.snapshot(_random, 3, 2))[0]
	is_null(SnapshotPacket.decode(PackedByteArray()))
	is_null(SnapshotPacket.decode(bytes.slice(0, bytes.size() - 1)))
	is_null(SnapshotPacket.decode(bytes + PackedByteArray([0])))
	var no_rate: PackedByteArray = bytes.duplicate()
	no_rate[5] = 0
	is_null(SnapshotPacket.decode(no_rate), "a tick rate of 0")
	var no_turn: PackedByteArray = bytes.duplicate()
	for byte: int in 8:
		no_turn[no_turn.size() - 1 - byte] = 0
	is_null(SnapshotPacket.decode(no_turn), "a rotation of norm 0")
	var nowhere: PackedByteArray = bytes.duplicate()
	nowhere.encode_float(nowhere.size() - 12, NAN)
	is_null(SnapshotPacket.decode(nowhere), "a place that is not finite")


func _check_round_trip(p_snapshot: Snapshot) -> void:
	var seen: Dictionary[int, Transform3D] = {}
	for datagram: PackedByteArray in SnapshotPacket.encode(p_snapshot):
		is_true(datagram.size() <= Protocol.MAX_DATAGRAM, "%d bytes" % datagram.size())
		equal(datagram[0], int(Protocol.Message.SNAPSHOT))
		var got: Snapshot = SnapshotPacket.decode(datagram)
		if got == null:
			fail("a datagram cannot be decoded alone")
			return
		equal([got.tick, got.tick_rate], [p_snapshot.tick, p_snapshot.tick_rate])
		equal(got.samples.size(), p_snapshot.samples.size())
		for actor: int in p_snapshot.samples:
			equal(got.samples[actor].id, p_snapshot.samples[actor].id)
			equal(got.samples[actor].time_usec, p_snapshot.samples[actor].time_usec)
		for id: int in got.bodies:
			is_false(seen.has(id), "body %d is sent twice" % id)
			seen[id] = got.bodies[id]
	equal(seen.size(), p_snapshot.bodies.size())
	for id: int in p_snapshot.bodies:
		equal(seen[id].origin, p_snapshot.bodies[id].origin)
		is_true(_angle_deg(seen[id].basis, p_snapshot.bodies[id].basis) < MOST_DEG)


## The angle between two rotations; precise for small ones, where acos() is not.
static func _angle_deg(p_a: Basis, p_b: Basis) -> float:
	var turn: Quaternion = p_a.get_rotation_quaternion().inverse() * p_b.get_rotation_quaternion()
	return rad_to_deg(2.0 * asin(minf(Vector3(turn.x, turn.y, turn.z).length(), 1.0)))
