class_name WearerMessage
extends RefCounted
## What a trainee's client says of its suit, and of calibrations that an instructor asked for:
## trainee to server, reliable.
##
## Little-endian: u8 message, u16 number (0: about the suit; else that of the
## [constant Protocol.Notice.CALIBRATE] which it answers), u8 1 if that was accepted, text.

## Longest text, characters.
const MAX_TEXT: int = 100

## Number of the calibration that it answers; 0: it is about the suit.
var number: int = 0
## Whether the calibration was accepted.
var accepted: bool = false
## The suit's state, or the outcome.
var text: String = ""


## The bytes.
static func encode(p_number: int, p_accepted: bool, p_text: String) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.WEARER, 0, 0, 1 if p_accepted else 0]
	bytes.encode_u16(1, p_number)
	return bytes + ByteReader.text_bytes(p_text.left(MAX_TEXT))


## What is in a packet, or null if it is invalid.
static func decode(p_bytes: PackedByteArray) -> WearerMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var message: WearerMessage = WearerMessage.new()
	message.number = reader.read_u16()
	message.accepted = reader.read_u8() == 1
	message.text = reader.read_text(4 * MAX_TEXT)
	return message if reader.is_complete() else null
