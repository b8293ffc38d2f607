extends TestCase
## What a client's people do, over the wire: as exact as it is to be, in any order, with losses.

const NetSamples: GDScript = preload("../net_samples.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _writer: SampleWriter = SampleWriter.new()
var _reader: SampleReader = SampleReader.new()


func before_each() -> void:
	_random.seed = 2
	_writer = SampleWriter.new()
	_reader = SampleReader.new()


func test_people_arrive_as_they_were_sent() -> void:
	for round: int in 30:
		var sent: Array[PoseSample] = []
		for person: int in 1 + round % PersonCard.MAX_PEOPLE:
			sent.append(_sample(person, round))
		var datagrams: Array[PackedByteArray] = _writer.write(sent)
		equal(datagrams.size(), 1)
		equal(Protocol.kind_of(datagrams[0]), Protocol.Message.MOTION)
		var got: Array[PoseSample] = _reader.read(datagrams[0])
		equal([got.size(), _reader.error], [sent.size(), ""])
		for at: int in got.size():
			_check(got[at], sent[at])
		_writer.take_ack(_reader.take_ack())


func test_a_motion_takes_fewer_bytes_than_its_poses() -> void:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/01_01.bvh")
	var sizes: Statistics = Statistics.new()
	for step: int in 200:
		var sample: PoseSample = source.pose_at(step / 60.0)
		sample.id = step
		sample.time_usec = 1700000000000000 + step * 16667
		var bytes: PackedByteArray = _writer.write([sample] as Array[PoseSample])[0]
		sizes.add(bytes.size())
		equal(_reader.read(bytes).size(), 1)
		_writer.take_ack(_reader.take_ack())
	is_true(sizes.percentile(0.5) < 30.0, "%d bytes" % sizes.percentile(0.5))


func test_an_acknowledgement_rides_along_once() -> void:
	var ack: PackedByteArray = [Protocol.Message.ACK, 0, 7, 0, 0, 0, 0, 1, 0]
	is_true(_writer.take_along(ack))
	is_false(_writer.take_along(ack), "there is no motion: it has to go alone")
	is_true(_writer.take_along(ack))
	for expected: PackedByteArray in [ack, PackedByteArray()]:
		var bytes: PackedByteArray = _writer.write([_sample(0, 1)] as Array[PoseSample])[0]
		equal(_reader.read(bytes).size(), 1)
		equal(_reader.rider, expected)


func test_what_rides_along_is_an_acknowledgement_or_none() -> void:
	var bytes: PackedByteArray = _writer.write([_sample(0, 1)] as Array[PoseSample])[0]
	equal(_reader.read(bytes + PackedByteArray([Protocol.Message.STATS, 1])).size(), 0)
	contains(_reader.error, "message 8")
	equal(_reader.rider.size(), 0)


func test_twice_and_out_of_order() -> void:
	var first: PackedByteArray = _writer.write([_sample(0, 1)] as Array[PoseSample])[0]
	var second: PackedByteArray = _writer.write([_sample(0, 2)] as Array[PoseSample])[0]
	for bytes: PackedByteArray in [second, first]:
		equal(_reader.read(bytes).size(), 1)
	for bytes: PackedByteArray in [second, first]:
		equal([_reader.read(bytes).size(), _reader.error], [0, ""])


func test_a_server_that_is_new_understands_after_a_while() -> void:
	for round: int in 10:
		_reader.read(_writer.write([_sample(0, round)] as Array[PoseSample])[0])
		_writer.take_ack(_reader.take_ack())
	_reader = SampleReader.new()
	var understood: int = 0
	for round: int in 40:
		var bytes: PackedByteArray = _writer.write([_sample(0, 10 + round)] as Array[PoseSample])[0]
		understood += _reader.read(bytes).size()
		equal(_reader.error, "")
		_writer.take_ack(_reader.take_ack())
	is_true(understood >= 5, "%d" % understood)
	_writer.restart()
	equal(_reader.read(_writer.write([_sample(0, 60)] as Array[PoseSample])[0]).size(), 1)


func test_what_is_no_pose_is_not_sent() -> void:
	equal(_writer.write([] as Array[PoseSample]).size(), 0)
	var sample: PoseSample = _sample(0, 1)
	sample.set_orientation(3, Quaternion(NAN, 0.0, 0.0, 1.0))
	equal(_writer.write([sample] as Array[PoseSample]).size(), 0)
	equal(_writer.write([_sample(8, 1)] as Array[PoseSample]).size(), 0)
	var far: PoseSample = _sample(0, 1)
	far.root = Vector3(30000.0, 0.0, 0.0)
	equal(_reader.read(_writer.write([far] as Array[PoseSample])[0]).size(), 0)
	contains(_reader.error, "root")


func test_other_bytes() -> void:
	for bytes: PackedByteArray in [
		PackedByteArray(),
		PackedByteArray([1]),
		PackedByteArray([2, 3, 4]),
		NetSamples.noise(_random, 2000)
	]:
		equal(_reader.read(bytes).size(), 0)
	equal(_reader.take_ack().size(), 0)


func _sample(p_person: int, p_step: int) -> PoseSample:
	var sample: PoseSample = NetSamples.pose(_random)
	sample.person = p_person
	sample.id = 1000 * p_person + p_step
	# Live sources know when each of them was measured.
	sample.time_usec = 1700000000000000 + p_step * 16667 - p_person * 310
	sample.held_usec = 2000 + p_person * 310
	sample.sent_usec = 123456789 + p_step * 16667
	return sample


func _check(p_got: PoseSample, p_sent: PoseSample) -> void:
	equal([p_got.person, p_got.id], [p_sent.person, p_sent.id])
	almost_equal(float(p_got.time_usec - p_sent.time_usec), 0.0, 10.0)
	almost_equal(float(p_got.held_usec - p_sent.held_usec), 0.0, 50.0)
	almost_equal(float(p_got.sent_usec - p_sent.sent_usec), 0.0, 60.0)
	almost_equal(p_got.root, p_sent.root, 0.0005)
	for limb: int in Limbs.COUNT:
		var off: float = p_got.orientation(limb).angle_to(p_sent.orientation(limb))
		is_true(rad_to_deg(off) < Protocol.MOTION_ERROR_DEG + 0.06, "%f deg" % rad_to_deg(off))
