extends TestCase
## Wrong use of the encoder and the decoder: one clear error, and they work on.

const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
const NetSamples: GDScript = preload("../net/net_samples.gd")

var _encoder: SnapshotEncoder = SnapshotEncoder.new()
var _decoder: SnapshotDecoder = SnapshotDecoder.new()
var _parents: PackedInt32Array = PackedInt32Array(Limbs.PARENTS)
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1


func test_an_encoder_that_is_not_configured() -> void:
	expect_error("SnapshotEncoder: call configure() first.")
	_encoder.begin_tick(1)
	is_false(_encoder.put_person(1, Vector3.ZERO, []))
	_encoder.put_body(1, Transform3D.IDENTITY, Vector3.ZERO, Vector3.ZERO, true)
	_encoder.end_tick()
	_encoder.capture(1)
	_encoder.add_client(1, 60, 1e6)
	_encoder.set_own_person(1, 1)
	_encoder.remove_client(1)
	is_false(_encoder.add_person(1, [], []))
	is_false(_encoder.set_cells(Vector3.ZERO, 1.0, Vector3i.ONE, [1]))
	is_false(_encoder.take_ack(1, []))
	_encoder.set_mark(1, 1, 1, [1, 2, 3])
	equal(_encoder.encode(1, 0).size(), 0)
	equal(_encoder.get_stats(1), {})


func test_a_decoder_that_is_not_configured() -> void:
	expect_error("SnapshotDecoder: call configure() first.")
	equal(_decoder.decode([0, 1, 2, 3]), int(SnapshotDecoder.BROKEN))
	equal(_decoder.get_ack(Vector3.ZERO).size(), 0)
	equal([_decoder.get_tick(), _decoder.get_tick_rate(), _decoder.get_mark()], [-1, 0, {}])
	equal(_decoder.get_people().size() + _decoder.get_bodies().size(), 0)
	equal(_decoder.get_orientations(1).size(), 0)
	equal([_decoder.get_root(1), _decoder.get_body_transform(1)], [Vector3.ZERO, Transform3D()])
	_decoder.clear()


func test_wrong_skeletons() -> void:
	expect_error("SnapshotEncoder: parents come before their children, the first has -1.")
	expect_error("SnapshotDecoder: parents come before their children, the first has -1.")
	var long: PackedInt32Array = [-1]
	long.resize(200)
	for parents: PackedInt32Array in [
		PackedInt32Array(),
		PackedInt32Array([0]),
		PackedInt32Array([-1, 1]),
		PackedInt32Array([-1, -1, 5]),
		PackedInt32Array([-1, 0, -7]),
		long
	]:
		is_false(_encoder.configure(parents, 0.1, 60), str(parents))
		is_false(_decoder.configure(parents, 0.1), str(parents))


func test_wrong_errors_and_rates() -> void:
	expect_error("SnapshotEncoder: an error is 0.02 to 5 degrees.")
	expect_error("SnapshotDecoder: an error is 0.02 to 5 degrees.")
	expect_error("SnapshotEncoder: a tick rate is 1 to 240 a second.")
	for error: float in [0.0, -1.0, 5.1, NAN, INF]:
		is_false(_encoder.configure(_parents, error, 60))
		is_false(_decoder.configure(_parents, error))
	for rate: int in [0, -60, 241, 1 << 40]:
		is_false(_encoder.configure(_parents, 0.1, rate))


func test_wrong_numbers_of_people_and_bodies() -> void:
	expect_error("SnapshotEncoder: a person's number is 0 to 65535.")
	expect_error("SnapshotEncoder: a body's number is 0 to 65535.")
	_configure()
	var bodies: Array[RID] = []
	bodies.resize(Limbs.COUNT)
	for id: int in [-1, 65536, 1 << 40]:
		is_false(_encoder.add_person(id, bodies, _turns()))
		is_false(_encoder.add_body(id, RID()))
		_encoder.begin_tick(5)
		is_false(_encoder.put_person(id, Vector3.ZERO, _turns()))
		_encoder.put_body(id, Transform3D.IDENTITY, Vector3.ZERO, Vector3.ZERO, true)
		_encoder.end_tick()
	for datagram: PackedByteArray in _encoder.encode(1, 0):
		_decoder.decode(datagram)
	equal(_decoder.get_people().size() + _decoder.get_bodies().size(), 0)
	_check_it_works()


func test_wrong_sizes() -> void:
	expect_error("SnapshotEncoder: a person has as many bodies as configure() has named parents.")
	expect_error("SnapshotEncoder: each body has an orientation of four floats in the reset pose.")
	expect_error("SnapshotEncoder: a mark has three steps.")
	_configure()
	var bodies: Array[RID] = []
	bodies.resize(Limbs.COUNT)
	is_false(_encoder.add_person(1, [], []))
	is_false(_encoder.add_person(1, bodies, [1.0, 2.0]))
	_encoder.set_mark(1, 1, 1, [])
	_encoder.set_mark(1, 1, 1, [1, 2, 3, 4])
	_encoder.begin_tick(5)
	is_false(_encoder.put_person(1, Vector3.ZERO, [0.0, 0.0, 0.0, 1.0]))
	_encoder.end_tick()
	_check_it_works()


func test_what_is_no_number() -> void:
	_configure()
	_encoder.add_client(2, 60, NAN)
	_encoder.add_client(3, 1 << 40, INF)
	_encoder.add_client(4, -5, -1.0)
	var no_turns: PackedFloat32Array = _turns()
	no_turns[5] = NAN
	var nowhere: Transform3D = Transform3D(Basis.from_scale(Vector3.ZERO), Vector3(NAN, INF, 0.0))
	for tick: int in 10:
		_encoder.begin_tick(5 + tick)
		_encoder.put_person(1, Vector3(NAN, 0.0, INF), _turns())
		_encoder.put_person(2, Vector3.ZERO, no_turns)
		_encoder.put_body(3, nowhere, Vector3(NAN, 0, 0), Vector3(INF, 0, 0), false)
		_encoder.end_tick()
		for client: int in [1, 2, 3, 4]:
			for datagram: PackedByteArray in _encoder.encode(client, 0):
				is_true(datagram.size() <= 1200)
				if client == 1:
					_decoder.decode(datagram)
					is_true(_decoder.get_body_transform(3).is_finite())
	is_false(_encoder.set_cells(Vector3(NAN, 0, 0), 1.0, Vector3i.ONE, [1]))
	is_false(_encoder.set_cells(Vector3.ZERO, 1.0, Vector3i(-1, -1, 1), [1]))
	is_false(_encoder.set_cells(Vector3.ZERO, 1.0, Vector3i.ONE, []))
	_check_it_works()


func test_the_wrong_order() -> void:
	_configure()
	equal(_encoder.encode(1, 0).size(), 0, "nothing has been put yet")
	_encoder.end_tick()
	_encoder.put_body(7, Transform3D.IDENTITY, Vector3.ZERO, Vector3.ZERO, false)
	_encoder.begin_tick(50)
	_encoder.put_person(6, Vector3.ZERO, _turns())
	_encoder.put_body(7, Transform3D.IDENTITY, Vector3.ZERO, Vector3.ZERO, false)
	_encoder.end_tick()
	_encoder.encode(1, 0)
	# Told in the middle of a tick, of which nothing is known.
	_encoder.begin_tick(51)
	_encoder.encode(1, 0)
	_encoder.encode(1, 0)
	_encoder.begin_tick(20)
	_encoder.encode(1, 0)
	_encoder.begin_tick(-1)
	_encoder.put_person(6, Vector3.ZERO, _turns())
	_encoder.end_tick()
	_encoder.encode(1, 0)
	is_true(true, "it has not crashed")


func test_clients_that_are_not_there() -> void:
	_configure()
	_encoder.begin_tick(5)
	_encoder.end_tick()
	for client: int in [0, -1, 99, 1 << 40]:
		equal(_encoder.encode(client, 0).size(), 0)
		is_false(_encoder.take_ack(client, [5, 0, 0]))
		equal(_encoder.get_stats(client), {})
		_encoder.set_own_person(client, 3)
		_encoder.remove_client(client)
	_check_it_works()


func test_acknowledgements_that_are_none() -> void:
	_configure()
	_encoder.begin_tick(5)
	_encoder.end_tick()
	_encoder.encode(1, 0)
	for size: int in [0, 1, 22, 24, 2000]:
		var bytes: PackedByteArray = []
		bytes.resize(size)
		bytes.fill(5)
		is_false(_encoder.take_ack(1, bytes), "%d bytes" % size)
	var other: PackedByteArray = []
	other.resize(23)
	is_false(_encoder.take_ack(1, other), "another kind")


func _configure() -> void:
	is_true(_encoder.configure(_parents, 0.1, 60))
	is_true(_decoder.configure(_parents, 0.1))
	_encoder.add_client(1, 0, 1e8)


func _turns() -> PackedFloat32Array:
	return NetSamples.pose(_random).orientations


## Whether what is put now is read.
func _check_it_works() -> void:
	_encoder.begin_tick(100)
	var pose: PoseSample = NetSamples.pose(_random)
	is_true(_encoder.put_person(9, pose.root, pose.orientations))
	_encoder.end_tick()
	var datagrams: Array = _encoder.encode(1, 0)
	equal(datagrams.size(), 1)
	equal(_decoder.decode(datagrams[0]), int(SnapshotDecoder.OK))
	equal(_decoder.get_people(), PackedInt32Array([9]))
	almost_equal(_decoder.get_root(9), pose.root, 0.001)
