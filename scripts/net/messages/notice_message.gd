class_name NoticeMessage
extends RefCounted
## What a server has to say to one client beside the state of the world, as bytes.
##
## u8 [constant Protocol.Message.CONTROL], u8 [enum Protocol.Notice], then a text, or of
## [constant Protocol.Notice.CALIBRATE] u8 index, u8 pose, u16 number.

## Longest text, characters.
const MAX_TEXT: int = 200

## What it is about.
var kind: Protocol.Notice = Protocol.Notice.TELL
## The reason of a dismissal, or a text for the client's user.
var text: String = ""
## Which of the client's people is to calibrate.
var index: int = 0
## In which pose.
var pose: int = 0
## Number for the answer, a [WearerMessage].
var number: int = 0


## Something that the client's user is to know.
static func tell(p_text: String) -> PackedByteArray:
	return _encode_text(Protocol.Notice.TELL, p_text)


## The client must leave and not come back; the text says why.
static func dismiss(p_why: String) -> PackedByteArray:
	return _encode_text(Protocol.Notice.DISMISSED, p_why)


## One of the client's people is to calibrate in a pose.
static func calibrate(p_index: int, p_pose: int, p_number: int) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.CONTROL, Protocol.Notice.CALIBRATE]
	bytes.append_array([p_index, p_pose, 0, 0])
	bytes.encode_u16(4, p_number)
	return bytes


## Reads a server's message; null if it is invalid.
static func decode(p_bytes: PackedByteArray) -> NoticeMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var what: int = reader.read_u8()
	if what >= Protocol.Notice.size():
		return null
	var notice: NoticeMessage = NoticeMessage.new()
	notice.kind = what as Protocol.Notice
	if notice.kind == Protocol.Notice.CALIBRATE:
		notice.index = reader.read_u8()
		notice.pose = reader.read_u8()
		notice.number = reader.read_u16()
	else:
		notice.text = reader.read_text(4 * MAX_TEXT)
	return notice if reader.is_complete() else null


static func _encode_text(p_kind: Protocol.Notice, p_text: String) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.CONTROL, p_kind]
	return bytes + ByteReader.text_bytes(p_text.left(MAX_TEXT))
