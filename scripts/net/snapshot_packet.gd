class_name SnapshotPacket
extends RefCounted
## A [Snapshot] as datagrams of at most [constant Protocol.MAX_DATAGRAM] bytes, each of which can be
## used without the others.
##
## Little-endian: u8 message, u32 tick, u8 tick rate (1/s), u8 number of samples, u8 number of
## bodies; a sample: u16 actor, u32 sample id, u64 sampling time (µs); a body: u16 id, 3 f32
## position (m), 4 i16 quaternion x, y, z, w times 32767 (error below 0.005 degrees).

const _HEADER: int = 8
const _SAMPLE: int = 14
const _BODY: int = 22
const _UNIT: float = 32767.0


## The datagrams of a snapshot. Every datagram names all samples, so that any of them tells the
## delay.
static func encode(p_snapshot: Snapshot) -> Array[PackedByteArray]:
	var samples: PackedByteArray = _encode_samples(p_snapshot)
	var room: int = mini((Protocol.MAX_DATAGRAM - _HEADER - samples.size()) / _BODY, 255)
	var ids: Array[int] = p_snapshot.bodies.keys()
	var datagrams: Array[PackedByteArray] = []
	for first: int in range(0, maxi(ids.size(), 1), room):
		var count: int = mini(room, ids.size() - first)
		var bytes: PackedByteArray = PackedByteArray()
		bytes.resize(_HEADER)
		bytes.encode_u8(0, Protocol.Message.SNAPSHOT)
		bytes.encode_u32(1, p_snapshot.tick)
		bytes.encode_u8(5, p_snapshot.tick_rate)
		bytes.encode_u8(6, samples.size() / _SAMPLE)
		bytes.encode_u8(7, count)
		bytes.append_array(samples)
		var at: int = bytes.size()
		bytes.resize(at + count * _BODY)
		for i: int in count:
			var id: int = ids[first + i]
			_encode_body(bytes, at + i * _BODY, id, p_snapshot.bodies[id])
		datagrams.append(bytes)
	return datagrams


## The part of a snapshot in a datagram, or null if it is none.
static func decode(p_bytes: PackedByteArray) -> Snapshot:
	var size: int = p_bytes.size()
	if size < _HEADER or size > Protocol.MAX_DATAGRAM:
		return null
	var samples: int = p_bytes.decode_u8(6)
	var bodies: int = p_bytes.decode_u8(7)
	if size != _HEADER + samples * _SAMPLE + bodies * _BODY or p_bytes.decode_u8(5) == 0:
		return null
	var snapshot: Snapshot = Snapshot.new()
	snapshot.tick = p_bytes.decode_u32(1)
	snapshot.tick_rate = p_bytes.decode_u8(5)
	for i: int in samples:
		var at: int = _HEADER + i * _SAMPLE
		var mark: Snapshot.SampleMark = Snapshot.SampleMark.new()
		mark.id = p_bytes.decode_u32(at + 2)
		mark.time_usec = p_bytes.decode_u64(at + 6)
		snapshot.samples[p_bytes.decode_u16(at)] = mark
	for i: int in bodies:
		if not _decode_body(p_bytes, _HEADER + samples * _SAMPLE + i * _BODY, snapshot):
			return null
	return snapshot


static func _encode_samples(p_snapshot: Snapshot) -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray()
	var most: int = mini(p_snapshot.samples.size(), 40)
	bytes.resize(most * _SAMPLE)
	var at: int = 0
	for actor: int in p_snapshot.samples:
		if at >= bytes.size():
			break
		bytes.encode_u16(at, actor)
		bytes.encode_u32(at + 2, p_snapshot.samples[actor].id)
		bytes.encode_u64(at + 6, p_snapshot.samples[actor].time_usec)
		at += _SAMPLE
	return bytes


static func _encode_body(
	p_bytes: PackedByteArray, p_at: int, p_id: int, p_transform: Transform3D
) -> void:
	var turn: Quaternion = p_transform.basis.get_rotation_quaternion()
	p_bytes.encode_u16(p_at, p_id)
	p_bytes.encode_float(p_at + 2, p_transform.origin.x)
	p_bytes.encode_float(p_at + 6, p_transform.origin.y)
	p_bytes.encode_float(p_at + 10, p_transform.origin.z)
	p_bytes.encode_s16(p_at + 14, roundi(turn.x * _UNIT))
	p_bytes.encode_s16(p_at + 16, roundi(turn.y * _UNIT))
	p_bytes.encode_s16(p_at + 18, roundi(turn.z * _UNIT))
	p_bytes.encode_s16(p_at + 20, roundi(turn.w * _UNIT))


static func _decode_body(p_bytes: PackedByteArray, p_at: int, p_snapshot: Snapshot) -> bool:
	var place: Vector3 = Vector3(
		p_bytes.decode_float(p_at + 2),
		p_bytes.decode_float(p_at + 6),
		p_bytes.decode_float(p_at + 10)
	)
	var turn: Quaternion = Quaternion(
		p_bytes.decode_s16(p_at + 14),
		p_bytes.decode_s16(p_at + 16),
		p_bytes.decode_s16(p_at + 18),
		p_bytes.decode_s16(p_at + 20)
	)
	var norm: float = turn.length() / _UNIT
	if not place.is_finite() or norm < 0.9 or norm > 1.1:
		return false
	p_snapshot.bodies[p_bytes.decode_u16(p_at)] = Transform3D(Basis(turn.normalized()), place)
	return true
