class_name MotionSetMessage
extends RefCounted
## The motion set by which a trainee walks: trainee to server, reliable, in parts of this kind
## ([MessageParts]); and what became of it, server to trainee.
##
## The answer, little-endian: u8 message, u16 number of the transfer, u8 [enum Outcome], text.

## What became of a set.
enum Outcome {
	## The body moves by it.
	TAKEN,
	## It does not; the text says why.
	REFUSED,
}

## Bytes of the largest set: twice those of a whole guided recording, 2 min 51 s of motion. In
## memory a set takes ten times as much, and the search in it up to 0.3 ms.
const MAX_BYTES: int = 3 << 19
## Parts of the largest set.
const MAX_PARTS: int = (MAX_BYTES + MessageParts.ROOM - 1) / MessageParts.ROOM
## Longest text, characters.
const MAX_TEXT: int = 200

## Number of the transfer.
var number: int = 0
## What became of it.
var outcome: Outcome = Outcome.TAKEN
## Why it is refused.
var text: String = ""


## The messages that bring the bytes of a set's file; none if it is too large.
static func split(p_bytes: PackedByteArray, p_number: int) -> Array[PackedByteArray]:
	if p_bytes.size() > MAX_BYTES:
		return []
	return MessageParts.split(p_bytes, p_number, Protocol.Message.MOTION_SET)


## Whether a part begins a set that is too large.
static func is_too_large(p_part: PackedByteArray) -> bool:
	return p_part.size() >= 7 and p_part.decode_u16(3) == 0 and p_part.decode_u16(5) > MAX_PARTS


## What became of a set, as bytes.
static func answer(p_number: int, p_outcome: Outcome, p_text: String) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.MOTION_SET, 0, 0, p_outcome]
	bytes.encode_u16(1, p_number)
	return bytes + ByteReader.text_bytes(p_text.left(MAX_TEXT))


## Reads an answer; null if it is invalid.
static func decode_answer(p_bytes: PackedByteArray) -> MotionSetMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var message: MotionSetMessage = MotionSetMessage.new()
	message.number = reader.read_u16()
	var what: int = reader.read_u8()
	message.text = reader.read_text(4 * MAX_TEXT)
	if not reader.is_complete() or not Outcome.values().has(what):
		return null
	message.outcome = what as Outcome
	return message
