class_name EventMessage
extends RefCounted
## Events as bytes: server to client. Reliable ones go on the reliable channel; the others go on the
## fast path, each again in the next few datagrams.
##
## Little-endian: u8 message; u8 count; of each: u16 number, u32 tick, u16 entity, u8 which of its
## type's events, u8 size, its values as in [method EntitySchema.encode].

## Maximum of bytes of an event's values.
const MAX_BYTES: int = 128
## Bytes of an event without its values.
const HEAD_BYTES: int = 10


## The bytes of at most 255 events.
static func encode(p_events: Array[EntityEvent]) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.EVENTS, p_events.size()]
	for event: EntityEvent in p_events:
		var head: PackedByteArray = []
		head.resize(HEAD_BYTES)
		head.encode_u16(0, event.number)
		head.encode_u32(2, event.tick)
		head.encode_u16(6, event.entity)
		head.encode_u8(8, event.event)
		head.encode_u8(9, event.bytes.size())
		bytes.append_array(head)
		bytes.append_array(event.bytes)
	return bytes


## The events in a packet; none if it is invalid.
static func decode(p_bytes: PackedByteArray) -> Array[EntityEvent]:
	var events: Array[EntityEvent] = []
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	for _event: int in reader.read_u8():
		var event: EntityEvent = EntityEvent.new()
		event.number = reader.read_u16()
		event.tick = reader.read_u32()
		event.entity = reader.read_u16()
		event.event = reader.read_u8()
		var size: int = reader.read_u8()
		if size > MAX_BYTES or reader.failed:
			return []
		event.bytes = reader.read_bytes(size)
		events.append(event)
	if not reader.is_complete():
		events.clear()
	return events
