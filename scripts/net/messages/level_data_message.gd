class_name LevelDataMessage
extends RefCounted
## A part of what a [LevelRequestMessage] asks for, or why there is none: server to client,
## reliable, in the order of the file.
##
## Little-endian: u8 message, u16 number of the request, u8 [enum Outcome]; data: u32 offset, u32
## bytes of the whole file, bytes; refused: text why.

## What the answer is.
enum Outcome {
	## Bytes of the file.
	DATA,
	## The server does not send it.
	REFUSED,
}

## Bytes of a file in a message.
const ROOM: int = Protocol.MAX_DATAGRAM - 76
## Longest reason, characters.
const MAX_WHY: int = 200

## Number of the request.
var number: int = 0
## What the answer is.
var outcome: Outcome = Outcome.DATA
## Where the bytes belong in the file.
var offset: int = 0
## Bytes of the whole file.
var size: int = 0
## The bytes.
var data: PackedByteArray = PackedByteArray()
## Why there are none.
var why: String = ""


## Bytes of a file.
static func encode(
	p_number: int, p_offset: int, p_size: int, p_data: PackedByteArray
) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.LEVEL_DATA, 0, 0, Outcome.DATA]
	bytes.encode_u16(1, p_number)
	bytes.append_array(PackedInt32Array([p_offset, p_size]).to_byte_array())
	return bytes + p_data


## Why nothing is sent.
static func refuse(p_number: int, p_why: String) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.LEVEL_DATA, 0, 0, Outcome.REFUSED]
	bytes.encode_u16(1, p_number)
	return bytes + ByteReader.text_bytes(p_why.left(MAX_WHY))


## The answer in a packet, or null if it is invalid.
static func decode(p_bytes: PackedByteArray) -> LevelDataMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var message: LevelDataMessage = LevelDataMessage.new()
	message.number = reader.read_u16()
	var outcome_read: int = reader.read_u8()
	if outcome_read == Outcome.DATA:
		message.offset = reader.read_u32()
		message.size = reader.read_u32()
		message.data = reader.read_bytes(mini(reader.left(), ROOM))
		if message.data.is_empty():
			return null
	elif outcome_read == Outcome.REFUSED:
		message.outcome = Outcome.REFUSED
		message.why = reader.read_text(4 * MAX_WHY)
	else:
		return null
	return message if reader.is_complete() else null
