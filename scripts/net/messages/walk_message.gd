class_name WalkMessage
extends RefCounted
## Where the server has somebody who walks without a suit, as bytes: to that person's client, where
## its own ticks came to something else.
##
## Little-endian: u8 message, u16 entity of the person, u32 tick after which the state is so, u8
## number of the correction, then the state as [method WalkerMover.get_state] has it.

## Bytes of a state.
const STATE_BYTES: int = 116

## Entity of the person.
var person: int = 0
## The tick after which the state is so.
var tick: int = 0
## Counts the corrections of a person; wraps at 16.
var number: int = 0
## See [method WalkerMover.get_state].
var state: PackedByteArray = PackedByteArray()


## The message as bytes.
func encode() -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.WALK, 0, 0, 0, 0, 0, 0, number]
	bytes.encode_u16(1, person)
	bytes.encode_u32(3, tick)
	return bytes + state


## Reads a server's message; null if it is invalid.
static func decode(p_bytes: PackedByteArray) -> WalkMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var read: WalkMessage = WalkMessage.new()
	read.person = reader.read_u16()
	read.tick = reader.read_u32()
	read.number = reader.read_u8()
	read.state = reader.read_bytes(STATE_BYTES)
	return read if reader.is_complete() else null
