class_name AnswerMessage
extends RefCounted
## What became of an order, or what instructors should know: server to instructor, reliable, in
## parts.
##
## Little-endian: u8 message, u16 number of the order, u8 [enum Outcome], text.

## What became of an order.
enum Outcome {
	## It was carried out.
	DONE,
	## It was not; the text says why.
	FAILED,
	## It was begun: another answer follows.
	BEGUN,
	## No answer: something that happened.
	NOTICE,
}

## Longest text, characters.
const MAX_TEXT: int = 400

## Number of the order.
var number: int = 0
## What became of it.
var outcome: Outcome = Outcome.DONE
## About whom, and what.
var text: String = ""


## The bytes.
static func encode(p_number: int, p_outcome: Outcome, p_text: String) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.ANSWER, 0, 0, p_outcome]
	bytes.encode_u16(1, p_number)
	return bytes + ByteReader.text_bytes(p_text.left(MAX_TEXT))


## The answer in a packet, or null if it is invalid.
static func decode(p_bytes: PackedByteArray) -> AnswerMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var answer: AnswerMessage = AnswerMessage.new()
	answer.number = reader.read_u16()
	var what: int = reader.read_u8()
	answer.text = reader.read_text(4 * MAX_TEXT)
	if not reader.is_complete() or not Outcome.values().has(what):
		return null
	answer.outcome = what as Outcome
	return answer
