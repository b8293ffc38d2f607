class_name CallMessage
extends RefCounted
## A call of a method of a node that server and clients share: see [SharedNodes]. Both ways,
## reliable or fast path.
##
## Little-endian: u8 message, u16 number of the call, texts path of the node below the shared one
## and method, u8 number of arguments, of each its [CallValues].

## Longest path and method, bytes.
const MAX_TEXT: int = 250
## Maximum of arguments.
const MAX_ARGUMENTS: int = 16

## Number of the call, for a refusal.
var number: int = 0
## Path of the node below the shared one; "." is that one itself.
var path: String = ""
## Name of the method.
var method: String = ""
## What the method gets.
var arguments: Array = []
## Why it cannot be sent, or an empty text: see [method encode].
var error: String = ""


## The bytes; none and an [member error] if it cannot be sent.
func encode() -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.CALL, number & 0xFF, number >> 8]
	bytes.append_array(ByteReader.text_bytes(path))
	bytes.append_array(ByteReader.text_bytes(method))
	bytes.append(arguments.size())
	error = "more than %d arguments" % MAX_ARGUMENTS if arguments.size() > MAX_ARGUMENTS else ""
	for argument: Variant in arguments:
		error = CallValues.append(bytes, argument) if error == "" else error
	if error == "" and bytes.size() > Protocol.MAX_DATAGRAM:
		error = "the arguments are too large"
	return bytes if error == "" else PackedByteArray()


## The call in a packet, or null if it is none.
static func decode(p_bytes: PackedByteArray) -> CallMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var call: CallMessage = CallMessage.new()
	call.number = reader.read_u16()
	call.path = reader.read_text(MAX_TEXT)
	call.method = reader.read_text(MAX_TEXT)
	var count: int = reader.read_u8()
	if reader.failed or count > MAX_ARGUMENTS:
		return null
	for _argument: int in count:
		call.arguments.append(CallValues.read(reader))
	return call if reader.is_complete() else null
