class_name ServerAnnouncement
extends RefCounted
## What a server tells clients that look for servers, as the bytes behind the head of its answer.
## See docs/protocol.md.

## Version of these bytes; later ones begin like this one.
const VERSION: int = 1
## Longest name of a server, bytes of UTF-8.
const MAX_NAME: int = 48
## Longest name of a world, bytes.
const MAX_WORLD: int = 64
## Longest name of a scenario, bytes.
const MAX_SCENARIO: int = 96
## Longest version of a program, bytes.
const MAX_PROGRAM: int = 32

const _ROLE_BITS: int = 0x3F
const _WAITING_ROOM: int = 0x40
const _SEALS: int = 0x80
const _MAX_U16: int = 0xFFFF

## Version of the protocol that the server speaks.
var protocol: int = Protocol.VERSION
## A number of this run of the server, the same at all of its addresses.
var run: int = 0
## Clients that are there.
var people: int = 0
## Clients that there is room for.
var places: int = 0
## Bit r is set where the role of number r needs a password.
var locked_roles: int = 0
## Whether an instructor admits each newcomer.
var has_waiting_room: bool = false
## Whether connections are sealed.
var seals: bool = true
## What the server is called.
var name: String = ""
## The world that is there.
var world: String = ""
## What is practised there; empty where nothing is.
var scenario: String = ""
## Version of the server's program.
var program: String = ""


## The bytes to announce.
func encode() -> PackedByteArray:
	var bytes: PackedByteArray = []
	bytes.resize(18)
	bytes.encode_u8(0, VERSION)
	bytes.encode_u32(1, protocol)
	bytes.encode_s64(5, run)
	bytes.encode_u16(13, clampi(people, 0, _MAX_U16))
	bytes.encode_u16(15, clampi(places, 0, _MAX_U16))
	var flags: int = locked_roles & _ROLE_BITS
	flags |= _WAITING_ROOM if has_waiting_room else 0
	flags |= _SEALS if seals else 0
	bytes.encode_u8(17, flags)
	bytes.append_array(ByteReader.text_bytes(shorten(name, MAX_NAME)))
	bytes.append_array(ByteReader.text_bytes(shorten(world, MAX_WORLD)))
	bytes.append_array(ByteReader.text_bytes(shorten(scenario, MAX_SCENARIO)))
	bytes.append_array(ByteReader.text_bytes(shorten(program, MAX_PROGRAM)))
	return bytes


## Reads what somebody who says that he is a server has sent; null if it is none.
static func decode(p_bytes: PackedByteArray) -> ServerAnnouncement:
	var reader: ByteReader = ByteReader.new(p_bytes)
	var made: ServerAnnouncement = ServerAnnouncement.new()
	if reader.read_u8() < VERSION:
		return null
	made.protocol = reader.read_u32()
	var run_bytes: PackedByteArray = reader.read_bytes(8)
	made.run = run_bytes.decode_s64(0) if run_bytes.size() == 8 else 0
	made.people = reader.read_u16()
	made.places = reader.read_u16()
	var flags: int = reader.read_u8()
	made.locked_roles = flags & _ROLE_BITS
	made.has_waiting_room = flags & _WAITING_ROOM != 0
	made.seals = flags & _SEALS != 0
	made.name = reader.read_text(MAX_NAME)
	made.world = reader.read_text(MAX_WORLD)
	made.scenario = reader.read_text(MAX_SCENARIO)
	made.program = reader.read_text(MAX_PROGRAM)
	# What a later version says besides is left unread.
	return made if not reader.failed else null


## The longest beginning of a text that fits into so many bytes of UTF-8, without what cannot be
## seen.
static func shorten(p_text: String, p_most_bytes: int) -> String:
	# No letter has less than a byte.
	var text: String = ByteReader.clean(p_text.left(p_most_bytes)).strip_edges()
	while text.to_utf8_buffer().size() > p_most_bytes:
		text = text.left(-1)
	return text
