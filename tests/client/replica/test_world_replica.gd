extends TestCase
## A client's copy of the world, whatever comes in whatever order.

const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")

var _replica: WorldReplica = WorldReplica.new()
var _stream: SnapshotStream = SnapshotStream.new([1, 2], [1024, 1026])
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _now: float = 100.0
var _marks: Array[LatencyMark] = []


func before_each() -> void:
	_random.seed = 1


func test_snapshots_before_the_world() -> void:
	# Without the world nobody knows how exact poses are.
	_advance(20, false)
	equal([_replica.datagrams, _replica.newest_tick], [0, -1])
	_know([1, 2])
	_advance(20)
	is_true(_replica.datagrams >= 20)
	_replica.evaluate(_now)
	equal(_replica.tick_rate(), 60.0)
	is_true(_replica.has_body(1024) and _replica.has_body(1026) and not _replica.has_body(1025))
	is_true(_replica.has_person(1) and _replica.has_person(2) and not _replica.has_person(3))
	var limbs: Array[Transform3D] = _replica.limbs_of(1, _replica.person_floats(1))
	equal(limbs.size(), Limbs.COUNT)
	for limb: Transform3D in limbs:
		is_true(limb.is_finite())


func test_what_came_last_is_where_the_server_has_it() -> void:
	_know([1, 2])
	_advance(5)
	equal(_replica.newest_tick, _stream.tick)
	for body: int in _stream.bodies:
		almost_equal(_replica.body_transform(body, true), _stream.places[body], 0.02)
	var floats: PackedFloat32Array = _replica.person_floats(2, true)
	almost_equal(Vector3(floats[0], floats[1], floats[2]), _stream.poses[2].root, 0.001)


func test_who_leaves_is_forgotten() -> void:
	_know([1, 2])
	_advance(10)
	_stream.people = [1]
	var gone: EntityTableMessage = EntityTableMessage.new()
	gone.version = 2
	gone.despawned = [2]
	is_true(_replica.take(gone.encode(), _now))
	is_false(_replica.has_person(2))
	is_true(_replica.has_person(1))
	equal(_replica.limbs_of(2, _replica.person_floats(1)).size(), 0)
	_advance(10)
	is_false(_replica.has_person(2))


func test_acknowledgements_are_not_too_frequent() -> void:
	_know([1, 2])
	_give()
	var first: int = 1000000
	is_false(_replica.acknowledgement(first, Vector3.ZERO).is_empty())
	_give()
	var early: int = first + WorldReplica.ACK_PERIOD_USEC - 1
	is_true(_replica.acknowledgement(early, Vector3.ZERO).is_empty(), "too soon")
	is_false(_replica.acknowledgement(early + 1, Vector3.ZERO).is_empty(), "what was kept back")
	var late: int = first + 10 * WorldReplica.ACK_PERIOD_USEC
	is_true(_replica.acknowledgement(late, Vector3.ZERO).is_empty(), "nothing has come since")


func test_the_server_takes_the_acknowledgements() -> void:
	_know([1, 2])
	_give()
	var bytes: PackedByteArray = _replica.acknowledgement(1000000, Vector3(1.0, 2.0, 3.0))
	equal(bytes[0], int(Protocol.Message.ACK))
	is_true(_stream.take_ack(1, bytes))


func test_marks_are_told_as_moments() -> void:
	_know([1, 2])
	_replica.marked.connect(func(each: LatencyMark) -> void: _marks.append(each))
	var encoder: SnapshotEncoder = SnapshotEncoder.new()
	encoder.configure(PackedInt32Array(Limbs.PARENTS), Protocol.POSE_ERROR_DEG, 60)
	encoder.add_client(1, 0, 1e8)
	encoder.begin_tick(500)
	var pose: PoseSample = NetSamples.pose(_random)
	encoder.put_person(2, pose.root, pose.orientations)
	encoder.end_tick()
	encoder.set_mark(2, 77, 9000000, [1000, 2000, 3000])
	for bytes: PackedByteArray in encoder.encode(1, 9000400):
		is_true(_replica.take(bytes, _now))
	var mark: LatencyMark = _marks[0]
	equal([mark.person, mark.sample, mark.tick], [2, 77, 500])
	equal(mark.simulated_usec, 9000000)
	equal(mark.snapshot_sent_usec, 9000400)
	equal(mark.received_usec, 9000000 - 3000)
	equal(mark.sent_usec, 9000000 - 5000)
	equal(mark.sampled_usec, 9000000 - 6000)


func test_poses_as_exact_as_the_server_says() -> void:
	var encoder: SnapshotEncoder = SnapshotEncoder.new()
	encoder.configure(PackedInt32Array(Limbs.PARENTS), 0.5, 60)
	encoder.add_client(1, 0, 1e8)
	_know([1], 0.5)
	for tick: int in 20:
		encoder.begin_tick(500 + tick)
		var pose: PoseSample = NetSamples.pose(_random)
		encoder.put_person(1, pose.root, pose.orientations)
		encoder.end_tick()
		for bytes: PackedByteArray in encoder.encode(1, 0):
			is_true(_replica.take(bytes, _now))
		encoder.take_ack(1, _replica.acknowledgement(1000000 + tick * 20000, Vector3.ZERO))
		var floats: PackedFloat32Array = _replica.person_floats(1, true)
		for limb: int in Limbs.COUNT:
			var at: int = limb * WorldReplica.FLOATS + 3
			var turn: Quaternion = Quaternion(
				floats[at], floats[at + 1], floats[at + 2], floats[at + 3]
			)
			is_true(turn.angle_to(pose.orientation(limb)) < deg_to_rad(0.6))


func test_clear_and_another_server() -> void:
	_know([1, 2])
	_advance(10)
	_replica.clear()
	equal([_replica.newest_tick, _replica.tick_rate()], [-1, 0.0])
	is_false(_replica.has_person(1) or _replica.has_body(1024))
	is_true(_replica.acknowledgement(9000000, Vector3.ZERO).is_empty())
	# Its ticks begin anew.
	_stream = SnapshotStream.new([5], [1023 + 4])
	_stream.tick = 3
	_know([5])
	_advance(10)
	equal(_replica.newest_tick, 13)
	is_true(_replica.has_person(5) and _replica.has_body(1027) and not _replica.has_body(1024))


func test_garbage_changes_nothing() -> void:
	_know([1, 2])
	_advance(10)
	for _round: int in 300:
		# Of kinds that are no snapshot's: the decoder's own fuzzer tries the others.
		var bytes: PackedByteArray = NetSamples.noise(_random, 100)
		if not bytes.is_empty():
			bytes[0] = bytes[0] | 1
		is_false(_replica.take(bytes, _now))
	equal(_replica.newest_tick, _stream.tick)
	_advance(5)
	equal(_replica.newest_tick, _stream.tick)
	almost_equal(_replica.body_transform(1024, true), _stream.places[1024], 0.02)


func test_a_skeleton_that_is_none_is_not_shown() -> void:
	_stream.people = [1]
	_know([1], Protocol.POSE_ERROR_DEG, PersonSkeleton.new())
	_advance(5)
	_replica.evaluate(_now)
	var floats: PackedFloat32Array = []
	floats.resize(Limbs.COUNT * WorldReplica.FLOATS)
	equal(_replica.limbs_of(1, floats).size(), 0)


func test_floats_of_a_wrong_number() -> void:
	_know([1])
	equal(_replica.limbs_of(1, [1.0, 2.0]).size(), 0)
	equal(_replica.limbs_of(8, []).size(), 0)


func test_before_anything_came() -> void:
	_replica.evaluate(_now)
	equal([_replica.shown_tick(), _replica.tick_rate()], [-1.0, 0.0])
	is_false(_replica.has_person(1) or _replica.has_body(1))
	is_true(_replica.acknowledgement(1000000, Vector3.ZERO).is_empty())


func _advance(p_ticks: int, p_is_used: bool = true) -> void:
	for _tick: int in p_ticks:
		_give(p_is_used)
		_replica.evaluate(_now)
		var bytes: PackedByteArray = _replica.acknowledgement(int(_now * 1e6), Vector3.ZERO)
		if not bytes.is_empty():
			is_true(_stream.take_ack(1, bytes))


func _give(p_is_used: bool = true) -> void:
	_stream.move()
	_now += 1.0 / 60.0
	for bytes: PackedByteArray in _stream.datagrams():
		equal(_replica.take(bytes, _now), p_is_used)


## Lets the replica know of these people, and of the bodies of the stream.
func _know(
	p_people: Array,
	p_error_deg: float = Protocol.POSE_ERROR_DEG,
	p_skeleton: PersonSkeleton = _skeleton()
) -> void:
	var message: EntityTableMessage = EntityTableMessage.new()
	message.is_full = true
	message.version = 1
	message.pose_error_deg = p_error_deg
	message.types = [EntityType.person(), _prop_type()]
	for id: int in p_people + Array(_stream.bodies):
		var row: EntityRow = EntityRow.new()
		row.id = id
		row.type_number = 0 if p_people.has(id) else 1
		row.type = message.types[row.type_number]
		row.values = row.type.spawn_schema().defaults()
		row.skeleton = p_skeleton
		message.spawned.append(row)
	is_true(_replica.take(message.encode(), _now))


static func _prop_type() -> EntityType:
	var type: EntityType = EntityType.new()
	type.name = &"prop"
	type.body = EntityType.Body.RIGID
	return type


static func _skeleton() -> PersonSkeleton:
	var joints: PersonSkeleton = PersonSkeleton.new()
	for _limb: int in Limbs.COUNT:
		joints.add(Vector3(0.0, 0.2, 0.0), Vector3(0.0, -0.2, 0.0), Quaternion.IDENTITY)
	return joints


func test_a_forged_tick_far_ahead_does_not_last() -> void:
	_know([1, 2])
	_advance(60)
	is_true(_replica.take([0, 0, 0, 120, 0, 0, 0, 0x40, 60, 0], _now), "nobody can tell")
	_forward(180)
	equal(_replica.newest_tick, _stream.tick)
	_replica.evaluate(_now)
	is_true(absf(_replica.shown_tick() - _stream.tick) < 20.0, "%f" % _replica.shown_tick())
	almost_equal(_replica.body_transform(1024, true), _stream.places[1024], 0.02)


## Like [method _advance], but not all that comes needs to be of use.
func _forward(p_ticks: int) -> void:
	for _tick: int in p_ticks:
		_stream.move()
		_now += 1.0 / 60.0
		for bytes: PackedByteArray in _stream.datagrams():
			_replica.take(bytes, _now)
		_replica.evaluate(_now)
		var bytes: PackedByteArray = _replica.acknowledgement(int(_now * 1e6), Vector3.ZERO)
		if not bytes.is_empty():
			_stream.take_ack(1, bytes)
