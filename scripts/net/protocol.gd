class_name Protocol
extends RefCounted
## What both ends of a connection must agree on. See [code]docs/protocol.md[/code].

## What a client wants to be.
enum Role {
	## Watches.
	OBSERVER,
	## Has a body.
	TRAINEE,
}

## First byte of every packet.
enum Message {
	## Trainee to server: a [PoseSample], see [PosePacket].
	POSE = 1,
	## Server to client: where bodies are, see [SnapshotPacket].
	SNAPSHOT = 2,
	## Server to client, reliable: which bodies there are, see [WorldDescription]. In [PacketParts].
	WORLD = 3,
	## A part of a packet that is too large for a datagram, see [PacketParts].
	PART = 4,
}

## Raised with every change of what is sent; a server refuses other versions.
const VERSION: int = 1
## First bytes of a greeting.
const HELLO: String = "DSMT"
## UDP port of a server unless told otherwise.
const DEFAULT_PORT: int = 7777
## Largest payload of a datagram, bytes: it passes every usual network in one piece.
const MAX_DATAGRAM: int = 1200
## How far a limb's orientation may be off on the wire, degrees.
const POSE_ERROR_DEG: float = 0.1
## Bytes that UDP, IP and ENet add to each datagram of the fast path.
const TRANSPORT_BYTES: int = 40
## People and watchers that a server admits unless told otherwise.
const DEFAULT_MAX_CLIENTS: int = 32
## Longest name of a person, characters.
const LONGEST_NAME: int = 32


## The first thing that a client says, as bytes. Little-endian: [constant HELLO], u32 version, u8
## role, f64 hip height (m), name as u16 length and UTF-8. Version 1 and later begin alike.
static func encode_hello(
	p_role: Role, p_name: String, p_hip_height: float, p_version: int = VERSION
) -> PackedByteArray:
	var bytes: PackedByteArray = HELLO.to_ascii_buffer()
	bytes.resize(17)
	bytes.encode_u32(4, p_version)
	bytes.encode_u8(8, p_role)
	bytes.encode_double(9, p_hip_height)
	bytes.append_array(ByteReader.text_bytes(p_name.left(LONGEST_NAME)))
	return bytes


## What a client said first, checked. Returns a dictionary with version, role, name and hip_height,
## or with only the key "error" and why it is no such greeting.
static func decode_hello(p_bytes: PackedByteArray) -> Dictionary:
	if p_bytes.size() > 512 or p_bytes.size() < 8:
		return {"error": "the greeting has %d bytes" % p_bytes.size()}
	if p_bytes.slice(0, 4) != HELLO.to_ascii_buffer():
		return {"error": "the greeting is not in Dismount's form"}
	var reader: ByteReader = ByteReader.new(p_bytes, 4)
	var hello: Dictionary = {"version": reader.read_u32()}
	if hello["version"] != VERSION:
		var versions: Array = [hello["version"], VERSION]
		return {"error": "the client speaks protocol version %d, the server %d" % versions}
	hello["role"] = reader.read_u8()
	hello["hip_height"] = reader.read_double()
	var shown: String = reader.read_text(4 * LONGEST_NAME).left(LONGEST_NAME).strip_edges()
	hello["name"] = shown if shown != "" else "nobody"
	if not reader.is_complete():
		return {"error": "the greeting is broken"}
	if hello["role"] >= Role.size():
		return {"error": "the greeting asks for an unknown role"}
	if not (hello["hip_height"] > 0.2 and hello["hip_height"] < 2.0):
		return {"error": "the greeting's hip height is no person's"}
	return hello


## The server's answer to a greeting: u8 0 if the client is welcome, else 1 and why not, as u16
## length and UTF-8.
static func encode_answer(p_refusal: String) -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray([0 if p_refusal == "" else 1])
	bytes.append_array(ByteReader.text_bytes(p_refusal.left(200)))
	return bytes


## Why the server refuses, or an empty text.
static func decode_answer(p_bytes: PackedByteArray) -> String:
	var reader: ByteReader = ByteReader.new(p_bytes)
	var refused: bool = reader.read_u8() != 0
	var why: String = reader.read_text(800)
	if not reader.is_complete() or refused == (why == ""):
		return "it answers in a form that is not Dismount's"
	return why
