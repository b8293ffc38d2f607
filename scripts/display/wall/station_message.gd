class_name StationMessage
extends RefCounted
## What the displays of a station tell one another each frame: which moment they show, and where the
## station is.
##
## Little-endian: u32 magic, u8 version, u8 kind, u32 fingerprint of the layout, u32 sender (a
## random number), u32 sequence, u64 time of sending and u64 time at which the tick is shown (µs of
## the sender's clock), f64 tick, f32 ticks per second, the station in the world: 3 f32 (m) and 4
## f32 (quaternion), the eyes in the station: 3 f32 (m), and the axis to the right one: 3 f32.
## Nothing secures it: it is for a station's own network.

## Who speaks.
enum Kind {
	## The first client: all show this.
	LEAD,
	## Another one: this it would show by itself.
	WANT,
}

## The first bytes of each: "DMST".
const MAGIC: int = 0x54534D44
## Of this form.
const VERSION: int = 1
## Bytes of a message.
const SIZE: int = 98
## Most ticks per second that are believed, and the largest tick.
const _MAX_RATE: float = 1000.0
const _MAX_TICK: float = 1e12
const _MAX_M: float = 1e6

## Who speaks.
var kind: Kind = Kind.LEAD
## Of the layout's bytes: displays of another layout are not heard.
var fingerprint: int = 0
## The speaker's random number.
var sender: int = 0
## Counts the speaker's messages.
var sequence: int = 0
## When it was sent, µs of the speaker's clock.
var sent_usec: int = 0
## When the tick is shown, µs of the speaker's clock.
var at_usec: int = 0
## The tick of the server that is shown, or wanted.
var tick: float = 0.0
## Ticks per second.
var rate: float = 0.0
## The station in the world at that tick, m.
var mount: Transform3D = Transform3D.IDENTITY
## Between the viewer's eyes, in the station's frame, m.
var eye: Vector3 = Vector3.ZERO
## The axis from the left eye to the right one, in the station's frame.
var right: Vector3 = Vector3.RIGHT


## The bytes of it.
func encode() -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray()
	bytes.resize(SIZE)
	bytes.encode_u32(0, MAGIC)
	bytes.encode_u8(4, VERSION)
	bytes.encode_u8(5, kind)
	bytes.encode_u32(6, fingerprint)
	bytes.encode_u32(10, sender)
	bytes.encode_u32(14, sequence)
	bytes.encode_u64(18, sent_usec)
	bytes.encode_u64(26, at_usec)
	bytes.encode_double(34, tick)
	bytes.encode_float(42, rate)
	var turn: Quaternion = mount.basis.get_rotation_quaternion()
	var values: PackedFloat32Array = [
		mount.origin.x, mount.origin.y, mount.origin.z, turn.x, turn.y, turn.z, turn.w
	]
	values.append_array([eye.x, eye.y, eye.z, right.x, right.y, right.z])
	for at: int in values.size():
		bytes.encode_float(46 + 4 * at, values[at])
	return bytes


## The message of bytes from anybody; null where they are none.
static func decode(p_bytes: PackedByteArray) -> StationMessage:
	if p_bytes.size() != SIZE or p_bytes.decode_u32(0) != MAGIC:
		return null
	if p_bytes[4] != VERSION or p_bytes[5] > Kind.WANT:
		return null
	var found: StationMessage = StationMessage.new()
	found.kind = p_bytes[5] as Kind
	found.fingerprint = p_bytes.decode_u32(6)
	found.sender = p_bytes.decode_u32(10)
	found.sequence = p_bytes.decode_u32(14)
	found.sent_usec = p_bytes.decode_u64(18)
	found.at_usec = p_bytes.decode_u64(26)
	found.tick = p_bytes.decode_double(34)
	found.rate = p_bytes.decode_float(42)
	var place: Vector3 = _vector(p_bytes, 46)
	found.eye = _vector(p_bytes, 74)
	found.right = _vector(p_bytes, 86)
	var turn: Quaternion = Quaternion(
		p_bytes.decode_float(58),
		p_bytes.decode_float(62),
		p_bytes.decode_float(66),
		p_bytes.decode_float(70)
	)
	if not place.is_finite() or place.length() > _MAX_M or not turn.is_finite():
		return null
	if not found.eye.is_finite() or not found.right.is_finite():
		return null
	if absf(turn.length() - 1.0) > 0.01 or not _is_time(found):
		return null
	found.mount = Transform3D(Basis(turn.normalized()), place)
	return found


static func _vector(p_bytes: PackedByteArray, p_at: int) -> Vector3:
	return Vector3(
		p_bytes.decode_float(p_at), p_bytes.decode_float(p_at + 4), p_bytes.decode_float(p_at + 8)
	)


static func _is_time(p_found: StationMessage) -> bool:
	var is_tick: bool = p_found.tick >= 0.0 and p_found.tick < _MAX_TICK
	var is_rate: bool = p_found.rate > 0.0 and p_found.rate <= _MAX_RATE
	var ahead: int = p_found.at_usec - p_found.sent_usec
	return is_tick and is_rate and p_found.sent_usec >= 0 and absi(ahead) < 10_000_000
