class_name PosePacket
extends RefCounted
## A [PoseSample] as bytes, from a trainee to the server.
##
## Little-endian: u8 message, u32 sample id, u64 sampling time (Unix, µs), 3 f32 root position (m),
## then x, y, z, w of each limb as f32. All packets have the same size.

## Size of the packet, bytes.
const SIZE: int = 1 + 4 + 8 + 12 + Limbs.COUNT * 16

const _ROOT: int = 13
const _LIMBS: int = 25

## Why the packet that was decoded last is none, or an empty text.
static var error: String = ""


## The bytes of a sample.
static func encode(p_sample: PoseSample) -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray()
	bytes.resize(_LIMBS)
	bytes.encode_u8(0, Protocol.Message.POSE)
	bytes.encode_u32(1, p_sample.id)
	bytes.encode_u64(5, p_sample.time_usec)
	bytes.encode_float(_ROOT, p_sample.root.x)
	bytes.encode_float(_ROOT + 4, p_sample.root.y)
	bytes.encode_float(_ROOT + 8, p_sample.root.z)
	bytes.append_array(p_sample.orientations.to_byte_array())
	return bytes


## The sample in a packet; null (and a reason in [member error]) if it is not a valid one.
static func decode(p_bytes: PackedByteArray) -> PoseSample:
	if p_bytes.size() != SIZE:
		error = "a pose packet of %d bytes instead of %d" % [p_bytes.size(), SIZE]
		return null
	var sample: PoseSample = PoseSample.new()
	sample.id = p_bytes.decode_u32(1)
	sample.time_usec = p_bytes.decode_u64(5)
	sample.root = Vector3(
		p_bytes.decode_float(_ROOT),
		p_bytes.decode_float(_ROOT + 4),
		p_bytes.decode_float(_ROOT + 8)
	)
	sample.orientations = p_bytes.slice(_LIMBS).to_float32_array()
	error = sample.find_fault()
	if error == "" and sample.time_usec < 0:
		error = "a sampling time before 1970"
	if error != "":
		error = "a pose packet that is no pose: " + error
		return null
	return sample
