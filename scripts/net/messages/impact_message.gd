class_name ImpactMessage
extends RefCounted
## Which bodies strike each other in a tick, as bytes: server to client, fast path, each once. Where
## one is lost, a sound is missing.
##
## Little-endian: u8 message; u32 tick; u8 count; of each: u16 entity, u16 other entity, three i24
## for the position (cm), u8 impulse and u8 slip (see [method encode]), u8 material, u8 other
## material.

## Most impacts of a message.
const MAX_COUNT: int = 16
## Bytes of the message without its impacts, and of each.
const HEAD_BYTES: int = 6
const IMPACT_BYTES: int = 17
## Impulse of the first step, N·s, and steps until it has doubled: up to 24.9 kN·s.
const MIN_IMPULSE: float = 0.01
const STEPS_PER_OCTAVE: float = 12.0
## Step of the slip, m/s: up to 16 m/s.
const SLIP_STEP: float = 1.0 / 16.0
## Step of the position, m.
const PLACE_STEP: float = 0.01
const _MAX_PLACE: int = 0x7fffff


## The bytes of at most [constant MAX_COUNT] impacts of a tick. An impulse becomes a number of steps
## on a logarithmic scale, within 3 %.
static func encode(p_tick: int, p_impacts: Array[Impact]) -> PackedByteArray:
	var bytes: PackedByteArray = []
	var count: int = mini(p_impacts.size(), MAX_COUNT)
	bytes.resize(HEAD_BYTES + count * IMPACT_BYTES)
	bytes[0] = Protocol.Message.IMPACTS
	bytes.encode_u32(1, p_tick)
	bytes[5] = count
	for index: int in count:
		_encode_one(bytes, HEAD_BYTES + index * IMPACT_BYTES, p_impacts[index])
	return bytes


## The impacts in a packet; none if it is invalid.
static func decode(p_bytes: PackedByteArray) -> Array[Impact]:
	var impacts: Array[Impact] = []
	if p_bytes.size() < HEAD_BYTES or p_bytes[0] != Protocol.Message.IMPACTS:
		return impacts
	var count: int = p_bytes[5]
	if count > MAX_COUNT or p_bytes.size() != HEAD_BYTES + count * IMPACT_BYTES:
		return impacts
	for index: int in count:
		var impact: Impact = _decode_one(p_bytes, HEAD_BYTES + index * IMPACT_BYTES)
		impact.tick = p_bytes.decode_u32(1)
		impacts.append(impact)
	return impacts


static func _encode_one(p_bytes: PackedByteArray, p_at: int, p_impact: Impact) -> void:
	p_bytes.encode_u16(p_at, p_impact.entity)
	p_bytes.encode_u16(p_at + 2, p_impact.other)
	for axis: int in 3:
		var steps: int = roundi(p_impact.place[axis] / PLACE_STEP)
		var limited: int = clampi(steps, -_MAX_PLACE, _MAX_PLACE) & 0xffffff
		p_bytes.encode_u16(p_at + 4 + axis * 3, limited & 0xffff)
		p_bytes[p_at + 6 + axis * 3] = limited >> 16
	var ratio: float = maxf(p_impact.impulse / MIN_IMPULSE, 1.0)
	p_bytes[p_at + 13] = clampi(roundi(STEPS_PER_OCTAVE * log(ratio) / log(2.0)), 0, 255)
	var slip: int = clampi(roundi(p_impact.slip / SLIP_STEP), 0, 255)
	# A scrape must not become an impact.
	p_bytes[p_at + 14] = maxi(slip, 1) if p_impact.is_scrape() else 0
	p_bytes[p_at + 15] = clampi(p_impact.material, 0, 255)
	p_bytes[p_at + 16] = clampi(p_impact.other_material, 0, 255)


static func _decode_one(p_bytes: PackedByteArray, p_at: int) -> Impact:
	var impact: Impact = Impact.new()
	impact.entity = p_bytes.decode_u16(p_at)
	impact.other = p_bytes.decode_u16(p_at + 2)
	for axis: int in 3:
		var raw: int = p_bytes.decode_u16(p_at + 4 + axis * 3) | p_bytes[p_at + 6 + axis * 3] << 16
		impact.place[axis] = (raw - 0x1000000 if raw > _MAX_PLACE else raw) * PLACE_STEP
	impact.impulse = MIN_IMPULSE * pow(2.0, p_bytes[p_at + 13] / STEPS_PER_OCTAVE)
	impact.slip = p_bytes[p_at + 14] * SLIP_STEP
	impact.material = p_bytes[p_at + 15]
	impact.other_material = p_bytes[p_at + 16]
	return impact
