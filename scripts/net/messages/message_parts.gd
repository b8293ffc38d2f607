class_name MessageParts
extends RefCounted
## Cuts a large reliable packet into parts that fit a datagram each, and joins them again.
##
## A part, little-endian: u8 message, u16 number of the packet, u16 number of the
## part, u16 number of parts, bytes. Parts arrive in order; a new packet replaces an unfinished one.
## What is one kind of message by itself, such as [MotionSetMessage], has parts of that kind.

## Bytes of a packet in a part.
const ROOM: int = Protocol.MAX_DATAGRAM - 64
## Maximum of parts of a packet.
const MAX_PARTS: int = 4096

const _HEADER: int = 7

## Number of the packet that is being joined; -1: none.
var packet: int = -1

var _most: int = MAX_PARTS
var _parts: int = 0
var _joined: PackedByteArray = PackedByteArray()
var _next: int = 0


## Joins packets of so many parts at most.
func _init(p_most_parts: int = MAX_PARTS) -> void:
	_most = p_most_parts


## The parts of a packet, as messages of a kind; empty if it is too large.
static func split(
	p_bytes: PackedByteArray, p_packet: int, p_kind: int = Protocol.Message.PART
) -> Array[PackedByteArray]:
	var count: int = maxi(ceili(float(p_bytes.size()) / ROOM), 1)
	var parts: Array[PackedByteArray] = []
	if count > MAX_PARTS:
		return parts
	for i: int in count:
		var part: PackedByteArray = PackedByteArray()
		part.resize(_HEADER)
		part.encode_u8(0, p_kind)
		part.encode_u16(1, p_packet & 0xFFFF)
		part.encode_u16(3, i)
		part.encode_u16(5, count)
		part.append_array(p_bytes.slice(i * ROOM, (i + 1) * ROOM))
		parts.append(part)
	return parts


## Adds a part. Returns the whole packet when it is complete, otherwise no bytes. A part that does
## not fit in is dropped with what was joined so far.
func join(p_part: PackedByteArray) -> PackedByteArray:
	if p_part.size() < _HEADER or p_part.size() > Protocol.MAX_DATAGRAM:
		return PackedByteArray()
	var from: int = p_part.decode_u16(1)
	var number: int = p_part.decode_u16(3)
	var parts: int = p_part.decode_u16(5)
	if number == 0:
		packet = from
		_parts = parts
		_next = 0
		# Not clear(): whoever got the last packet may still hold it.
		_joined = PackedByteArray()
	var fits: bool = from == packet and number == _next and parts == _parts
	if not fits or number >= parts or parts > _most:
		packet = -1
		_joined = PackedByteArray()
		return PackedByteArray()
	_joined.append_array(p_part.slice(_HEADER))
	_next += 1
	return _joined if _next == _parts else PackedByteArray()
