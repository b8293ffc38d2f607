extends TestCase
## A pose survives the wire exactly; what is no pose is refused with a reason.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1


func test_every_codec_comes_back() -> void:
	var exact: Dictionary[String, float] = {
		"float": 1e-6, "thesis_12": 0.1, "thesis_4": 3.0, "smallest_3": 0.02
	}
	for codec: String in PoseMessage.CODECS:
		for _round: int in 100:
			var sample: PoseSample = NetSamples.pose(_random)
			sample.held_usec = _random.randi() & 0xFFFF
			sample.sent_usec = _random.randi()
			var bytes: PackedByteArray = PoseMessage.encode(sample, PoseMessage.CODECS[codec])
			is_true(bytes.size() <= Protocol.MAX_DATAGRAM)
			equal(bytes[0], int(Protocol.Message.POSE))
			var got: PoseSample = PoseMessage.decode(bytes)
			if got == null:
				fail(PoseMessage.error)
				return
			equal([got.id, got.time_usec, got.root], [sample.id, sample.time_usec, sample.root])
			equal([got.held_usec, got.sent_usec], [sample.held_usec, sample.sent_usec])
			for limb: int in Limbs.COUNT:
				# The engine's angle errs by up to 0.08 degrees.
				var off: float = got.orientation(limb).angle_to(sample.orientation(limb))
				is_true(rad_to_deg(off) <= exact[codec] + 0.08, "%s: %f" % [codec, rad_to_deg(off)])


func test_wrong_size_and_codec() -> void:
	var bytes: PackedByteArray = PoseMessage.encode(NetSamples.pose(_random))
	for size: int in [0, 1, PoseMessage.HEADER, bytes.size() - 1, bytes.size() + 1, 2000]:
		var cut: PackedByteArray = bytes.duplicate()
		cut.resize(size)
		is_null(PoseMessage.decode(cut), "%d bytes" % size)
		not_equal(PoseMessage.error, "")
	for codec: int in range(4, 16):
		bytes[1] = codec
		is_null(PoseMessage.decode(bytes))
		contains(PoseMessage.error, "codec %d" % codec)


func test_a_person_too_many() -> void:
	for person: int in 16:
		var sample: PoseSample = NetSamples.pose(_random)
		sample.person = person
		var got: PoseSample = PoseMessage.decode(PoseMessage.encode(sample))
		equal(got != null, person < PersonCard.MAX_PEOPLE)
		if got != null:
			equal(got.person, person)
		else:
			contains(PoseMessage.error, "person %d" % person)


func test_what_is_no_rotation() -> void:
	for norm: float in [0.0, 0.5, 2.0, 1e30, NAN, INF]:
		var sample: PoseSample = NetSamples.pose(_random)
		sample.set_orientation(3, Quaternion(0.0, 0.0, 0.0, norm))
		is_null(PoseMessage.decode(NetSamples.raw_pose(sample)), "norm %f" % norm)
		contains(PoseMessage.error, "no pose")


func test_root_that_is_no_place() -> void:
	for root: Vector3 in [Vector3(NAN, 0, 0), Vector3(0, INF, 0), Vector3(0, 0, 2e4)]:
		var sample: PoseSample = NetSamples.pose(_random)
		sample.root = root
		is_null(PoseMessage.decode(PoseMessage.encode(sample)))
		contains(PoseMessage.error, "root")


func test_time_before_1970() -> void:
	var sample: PoseSample = NetSamples.pose(_random)
	sample.time_usec = -1
	is_null(PoseMessage.decode(PoseMessage.encode(sample)))
	contains(PoseMessage.error, "1970")


func test_good_packet_after_a_bad_one() -> void:
	is_null(PoseMessage.decode(PackedByteArray()))
	not_null(PoseMessage.decode(PoseMessage.encode(NetSamples.pose(_random))))
	equal(PoseMessage.error, "")
