class_name LevelRequestMessage
extends RefCounted
## A client that lacks the server's level asks for a piece of one of its files: client to server,
## reliable.
##
## Little-endian: u8 message, u16 number, 32 bytes hash of the level, u8 file (0: the manifest, else
## the number of a file in it, from 1), u32 offset, u32 length.

## Bytes of the hash of a level.
const HASH_SIZE: int = 32
## Largest piece, bytes.
const MAX_LENGTH: int = 65536
## The manifest, as [member file].
const MANIFEST: int = 0

## Number of the request, for its answers.
var number: int = 0
## Hash of the level.
var content_hash: PackedByteArray = PackedByteArray()
## Which of its files.
var file: int = MANIFEST
## Where the piece begins, bytes.
var offset: int = 0
## Bytes that are wanted.
var length: int = 0


## The bytes.
func encode() -> PackedByteArray:
	var bytes: PackedByteArray = []
	bytes.resize(3)
	bytes.encode_u8(0, Protocol.Message.LEVEL_REQUEST)
	bytes.encode_u16(1, number)
	bytes.append_array(content_hash)
	bytes.append(file)
	return bytes + PackedInt32Array([offset, length]).to_byte_array()


## The request in a packet, or null if it is invalid.
static func decode(p_bytes: PackedByteArray) -> LevelRequestMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var request: LevelRequestMessage = LevelRequestMessage.new()
	request.number = reader.read_u16()
	request.content_hash = reader.read_bytes(HASH_SIZE)
	request.file = reader.read_u8()
	request.offset = reader.read_u32()
	request.length = reader.read_u32()
	var is_sound: bool = request.length >= 1 and request.length <= MAX_LENGTH
	return request if reader.is_complete() and is_sound else null
