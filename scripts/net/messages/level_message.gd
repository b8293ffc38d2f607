class_name LevelMessage
extends RefCounted
## Which level the server has now: server to client, reliable, before the entities in it.
##
## Little-endian: u8 message, text name, 8 bytes fingerprint.

## Name of the level.
var name: String = ""
## Fingerprint of the level at the server.
var fingerprint: PackedByteArray = PackedByteArray()


## The bytes for a level.
static func encode(p_name: String, p_fingerprint: PackedByteArray) -> PackedByteArray:
	var padded: PackedByteArray = p_fingerprint.duplicate()
	padded.resize(Protocol.FINGERPRINT_SIZE)
	var bytes: PackedByteArray = [Protocol.Message.LEVEL]
	return bytes + ByteReader.text_bytes(p_name) + padded


## The level in a packet, or null if it is invalid.
static func decode(p_bytes: PackedByteArray) -> LevelMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var message: LevelMessage = LevelMessage.new()
	message.name = reader.read_text(4 * Protocol.MAX_LEVEL_NAME)
	message.fingerprint = reader.read_bytes(Protocol.FINGERPRINT_SIZE)
	return message if reader.is_complete() else null
