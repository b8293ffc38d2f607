class_name EffectMessage
extends RefCounted
## A part of the file of an effect: server to client, and instructor to server, reliable, in order.
##
## Little-endian: u8 message, u16 number of the transfer (an instructor's: of the order), text name
## of the effect, u8 number of the part, u8 number of parts, bytes.

## Bytes of a file in a part.
const ROOM: int = Protocol.MAX_DATAGRAM - 120
## Parts of the largest file.
const MAX_PARTS: int = EffectLimits.MAX_BYTES / ROOM + 1

## Number of the transfer, or of an instructor's order.
var number: int = 0
## Name of the effect: [method EffectLimits.is_name].
var name: String = ""
## Number of the part, from 0.
var part: int = 0
## How many parts the file has.
var parts: int = 1
## Bytes of the file.
var data: PackedByteArray = []


## The messages that bring a file; none if it is too large.
static func split(
	p_number: int, p_name: String, p_bytes: PackedByteArray
) -> Array[PackedByteArray]:
	var messages: Array[PackedByteArray] = []
	if p_bytes.size() > EffectLimits.MAX_BYTES:
		return messages
	var count: int = maxi(ceili(float(p_bytes.size()) / ROOM), 1)
	for i: int in count:
		var bytes: PackedByteArray = [Protocol.Message.EFFECT, 0, 0]
		bytes.encode_u16(1, p_number)
		bytes.append_array(ByteReader.text_bytes(p_name))
		bytes.append_array([i, count])
		messages.append(bytes + p_bytes.slice(i * ROOM, (i + 1) * ROOM))
	return messages


## The part in a packet, or null if it is invalid.
static func decode(p_bytes: PackedByteArray) -> EffectMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var message: EffectMessage = EffectMessage.new()
	message.number = reader.read_u16()
	message.name = reader.read_text(EffectLimits.MAX_NAME)
	message.part = reader.read_u8()
	message.parts = reader.read_u8()
	message.data = reader.read_bytes(mini(reader.left(), ROOM))
	if not reader.is_complete() or not EffectLimits.is_name(message.name):
		return null
	if message.parts < 1 or message.parts > MAX_PARTS or message.part >= message.parts:
		return null
	return message
