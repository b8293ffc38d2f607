class_name PoseMessage
extends RefCounted
## A [PoseSample] as bytes, from a trainee to the server.
##
## Little-endian: u8 message, u8 codec (low four bits) and person (high), u32 sample id, u64
## sampling time (Unix, µs), u32 how long it was held (µs), u64 when it was sent (server's clock,
## µs; 0 unknown), 3 f32 root position (m), then the limbs' rotations from the reset pose as the
## [PoseCodec] has them: 132 bytes in all with the usual codec.

## How rotations may be written, by the names that options have.
const CODECS: Dictionary[String, PoseCodec.Coding] = {
	"smallest_3": PoseCodec.SMALLEST_3,
	"thesis_12": PoseCodec.THESIS_12,
	"thesis_4": PoseCodec.THESIS_4,
	"float": PoseCodec.FLOATS,
}
## Bytes before the rotations.
const HEADER: int = 1 + 1 + 4 + 8 + 4 + 8 + 12

const _ROOT: int = 26
const _CODEC_MASK: int = 15
const _PERSON_SHIFT: int = 4
const _LONGEST: int = HEADER + Limbs.COUNT * 16

## Why the packet that was decoded last is none, or an empty text.
static var error: String = ""


## The bytes of a sample.
static func encode(
	p_sample: PoseSample, p_codec: PoseCodec.Coding = PoseCodec.SMALLEST_3
) -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray()
	bytes.resize(HEADER)
	bytes.encode_u8(0, Protocol.Message.POSE)
	bytes.encode_u8(1, p_codec | p_sample.person << _PERSON_SHIFT)
	bytes.encode_u32(2, p_sample.id)
	bytes.encode_u64(6, p_sample.time_usec)
	bytes.encode_u32(14, mini(p_sample.held_usec, 0xFFFFFFFF))
	bytes.encode_u64(18, p_sample.sent_usec)
	bytes.encode_float(_ROOT, p_sample.root.x)
	bytes.encode_float(_ROOT + 4, p_sample.root.y)
	bytes.encode_float(_ROOT + 8, p_sample.root.z)
	bytes.append_array(PoseCodec.encode(p_sample.orientations, p_codec))
	return bytes


## The sample in a packet; null (and a reason in [member error]) if it is not a valid one.
static func decode(p_bytes: PackedByteArray) -> PoseSample:
	if p_bytes.size() <= HEADER or p_bytes.size() > _LONGEST:
		error = "a pose packet of %d bytes" % p_bytes.size()
		return null
	if CODECS.find_key(p_bytes[1] & _CODEC_MASK) == null:
		error = "a pose packet of the unknown codec %d" % (p_bytes[1] & _CODEC_MASK)
		return null
	var sample: PoseSample = PoseSample.new()
	sample.person = p_bytes[1] >> _PERSON_SHIFT
	sample.id = p_bytes.decode_u32(2)
	sample.time_usec = p_bytes.decode_u64(6)
	sample.held_usec = p_bytes.decode_u32(14)
	sample.sent_usec = p_bytes.decode_u64(18)
	sample.root = Vector3(
		p_bytes.decode_float(_ROOT),
		p_bytes.decode_float(_ROOT + 4),
		p_bytes.decode_float(_ROOT + 8)
	)
	var codec: PoseCodec.Coding = (p_bytes[1] & _CODEC_MASK) as PoseCodec.Coding
	sample.orientations = PoseCodec.decode(p_bytes.slice(HEADER), codec)
	error = sample.find_fault()
	if error == "" and (sample.time_usec < 0 or sample.sent_usec < 0):
		error = "a time before 1970"
	if error == "" and sample.person >= PersonCard.MAX_PEOPLE:
		error = "of the client's person %d" % sample.person
	if error != "":
		error = "a pose packet that is no pose: " + error
		return null
	return sample
