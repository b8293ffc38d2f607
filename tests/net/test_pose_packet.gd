extends TestCase
## A pose survives the wire exactly; what is no pose is refused with a reason.

const NetSamples: GDScript = preload("net_samples.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1


func test_round_trip_is_exact() -> void:
	for _round: int in 300:
		var sample: PoseSample = NetSamples.pose(_random)
		var bytes: PackedByteArray = PosePacket.encode(sample)
		equal(bytes.size(), PosePacket.SIZE)
		equal(bytes[0], int(Protocol.Message.POSE))
		var got: PoseSample = PosePacket.decode(bytes)
		if got == null:
			fail(PosePacket.error)
			return
		equal(got.id, sample.id)
		equal(got.time_usec, sample.time_usec)
		equal(got.root, sample.root)
		equal(got.orientations, sample.orientations)


func test_fits_a_datagram() -> void:
	is_true(PosePacket.SIZE <= Protocol.MAX_DATAGRAM)


func test_wrong_size() -> void:
	var bytes: PackedByteArray = PosePacket.encode(NetSamples.pose(_random))
	for size: int in [0, 1, PosePacket.SIZE - 1, PosePacket.SIZE + 1]:
		var cut: PackedByteArray = bytes.duplicate()
		cut.resize(size)
		is_null(PosePacket.decode(cut))
		contains(PosePacket.error, "%d bytes instead of %d" % [size, PosePacket.SIZE])


func test_no_rotation_names_the_limb() -> void:
	for norm: float in [0.0, 0.5, 2.0, 1e30, NAN, INF]:
		var sample: PoseSample = NetSamples.pose(_random)
		sample.set_orientation(3, Quaternion(0.0, 0.0, 0.0, norm))
		is_null(PosePacket.decode(PosePacket.encode(sample)), "norm %f" % norm)
		contains(PosePacket.error, "Head has no rotation")


func test_root_that_is_no_place() -> void:
	for root: Vector3 in [Vector3(NAN, 0, 0), Vector3(0, INF, 0), Vector3(0, 0, 2e4)]:
		var sample: PoseSample = NetSamples.pose(_random)
		sample.root = root
		is_null(PosePacket.decode(PosePacket.encode(sample)))
		contains(PosePacket.error, "root")


func test_time_before_1970() -> void:
	var sample: PoseSample = NetSamples.pose(_random)
	sample.time_usec = -1
	is_null(PosePacket.decode(PosePacket.encode(sample)))
	contains(PosePacket.error, "1970")


func test_good_packet_after_a_bad_one() -> void:
	is_null(PosePacket.decode(PackedByteArray()))
	not_null(PosePacket.decode(PosePacket.encode(NetSamples.pose(_random))))
	equal(PosePacket.error, "")
