extends TestCase
## Sony's mocopi stream. The layout is that of a packet in t-34400/mocopi_protocol_supplement
## (sample_fram.bin, 1591 bytes, and sample_skdf.bin, 1821 bytes); that repository's parser read
## what [MocopiWriter] writes, and [MocopiReader] those two packets.

const CLIP: String = "res://assets/motion/01_01.bvh"
## The first bytes of sample_fram.bin, up to the first bone, less the sender's address.
const BEFORE_ADDRESS: String = (
	"230000006865616412000000667479706f736f6e79206d6f74696f6e20666f726d617401000000"
	+ "7672736e011a000000736e646608000000"
)


func test_the_layout_is_that_of_a_packet_of_the_app() -> void:
	var writer: MocopiWriter = MocopiWriter.new()
	var datagrams: Array[PackedByteArray] = writer.write(_clip().pose_at(0.0))
	equal(datagrams[0].size(), 1821, "skdf")
	equal(datagrams[1].size(), 1591, "fram")
	for datagram: PackedByteArray in datagrams:
		var head: String = datagram.slice(0, 56).hex_encode()
		equal(head.left(24), BEFORE_ADDRESS.left(24))
		equal(datagram.slice(16, 34).get_string_from_ascii(), "sony motion format")
		equal(datagram.slice(43, 55).hex_encode(), "1a000000736e646608000000")
		equal(datagram.decode_u16(75), 12351)
	equal(datagrams[1].slice(77, 85).hex_encode(), "e20500006672616d")


func test_a_clip_arrives_as_it_is() -> void:
	var clip: BvhSource = _clip()
	var line: LossyLine = LossyLine.new()
	line.loss = 0.0
	line.twice = 0.0
	line.jitter_usec = 0
	var stream: PoseStream = PoseStream.new(MocopiReader.new())
	var person: StreamPerson = line.run(clip, MocopiWriter.new(clip.get_body()), stream, 3.0)
	is_true(line.worst_deg() < 0.01, "%f deg" % line.worst_deg())
	is_true(line.worst_root < 0.001, "%f m" % line.worst_root)
	almost_equal(person.get_hip_height(), clip.get_hip_height(), 0.001)


func test_loss_and_duplicates_are_hardly_seen() -> void:
	var clip: BvhSource = _clip()
	var line: LossyLine = LossyLine.new(8)
	var stream: PoseStream = PoseStream.new(MocopiReader.new())
	var person: StreamPerson = line.run(clip, MocopiWriter.new(clip.get_body()), stream, 4.0)
	is_true(line.errors.percentile(0.95) < 0.1, "p95 %f deg" % line.errors.percentile(0.95))
	is_true(person.stats()["twice"] > 10 and person.stats()["lost"] > 10)


func test_bones_that_lie_otherwise_at_rest_are_turned_back() -> void:
	var reader: MocopiReader = MocopiReader.new()
	var rest: Quaternion = Quaternion(Vector3.UP, 0.7)
	var turn: Quaternion = Quaternion(Vector3.RIGHT, 0.4)
	var writer: MocopiWriter = MocopiWriter.new()
	var datagrams: Array[PackedByteArray] = writer.write(_still())
	# The hips' rotation is the first of each.
	for part: int in 2:
		var at: int = _find(datagrams[part], "tran") + 4
		var own: Quaternion = rest if part == 0 else turn * rest
		var floats: PackedFloat32Array = [own.x, own.y, own.z, own.w]
		var bytes: PackedByteArray = floats.to_byte_array()
		for step: int in 16:
			datagrams[part][at + step] = bytes[step]
	reader.read(datagrams[0], "x")
	var samples: Array[StreamSample] = reader.read(datagrams[1], "x")
	equal(samples.size(), 1)
	for limb: int in Limbs.COUNT:
		almost_equal(samples[0].pose.orientation(limb), turn, 1e-5)


func test_what_is_none_is_reported() -> void:
	var reader: MocopiReader = MocopiReader.new()
	var frame: PackedByteArray = MocopiWriter.new().write(_still())[1]
	var cases: Dictionary[String, PackedByteArray] = {}
	var long: PackedByteArray = frame.duplicate()
	long.encode_u32(0, 0xFFFFFFF0)
	cases["box of 4294967280"] = long
	var other: PackedByteArray = frame.duplicate()
	other[20] = 0x58
	cases["sony motion format"] = other
	var nan_turn: PackedByteArray = frame.duplicate()
	nan_turn.encode_float(_find(frame, "tran") + 4, NAN)
	cases["bone 0"] = nan_turn
	cases["are left"] = frame.slice(0, 700)
	for wanted: String in cases:
		reader.fault = ""
		equal(reader.read(cases[wanted], "x").size(), 0, wanted)
		contains(reader.fault, wanted)
	equal(LossyLine.fuzz(reader, MocopiWriter.new().write(_still()), 1500), "")


static func _find(p_bytes: PackedByteArray, p_name: String) -> int:
	var name: PackedByteArray = p_name.to_ascii_buffer()
	var at: int = 0
	while p_bytes.slice(at, at + 4) != name:
		at += 1
	return at


static func _still() -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	pose.time_usec = LossyLine.BEGIN_USEC
	for limb: int in Limbs.COUNT:
		pose.set_orientation(limb, Quaternion.IDENTITY)
	return pose


func _clip() -> BvhSource:
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	return clip
