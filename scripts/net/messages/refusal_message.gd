class_name RefusalMessage
extends RefCounted
## Why a call was not carried out: server to the client that called, reliable, in parts.
##
## Little-endian: u8 message, u16 number of the call, text.

## Longest text, characters.
const MAX_TEXT: int = 200

## Number of the call.
var number: int = 0
## Why it was not carried out.
var why: String = ""


## The bytes.
static func encode(p_number: int, p_why: String) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.REFUSAL, p_number & 0xFF, p_number >> 8]
	return bytes + ByteReader.text_bytes(p_why.left(MAX_TEXT))


## The refusal in a packet, or null if it is none.
static func decode(p_bytes: PackedByteArray) -> RefusalMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var refusal: RefusalMessage = RefusalMessage.new()
	refusal.number = reader.read_u16()
	refusal.why = reader.read_text(4 * MAX_TEXT)
	return refusal if reader.is_complete() else null
