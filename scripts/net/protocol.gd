class_name Protocol
extends RefCounted
## What both ends of a connection must agree on. See [code]docs/protocol.md[/code].

## Raised with every change of what is sent; a server refuses other versions.
const VERSION: int = 1
## UDP port of a server unless told otherwise.
const DEFAULT_PORT: int = 7777
## Largest payload of a datagram, bytes: it passes every usual network in one piece.
const MAX_DATAGRAM: int = 1200
## People and watchers that a server admits unless told otherwise.
const DEFAULT_MAX_CLIENTS: int = 32
## Longest name of a person, characters.
const LONGEST_NAME: int = 32

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
	## Server to client, reliable: which bodies there are, see [WorldDescription].
	WORLD = 3,
}


## The first thing that a client says, as bytes.
static func encode_hello(
	p_role: Role, p_name: String, p_hip_height: float, p_version: int = VERSION
) -> PackedByteArray:
	var hello: Dictionary = {
		"version": p_version, "role": p_role, "name": p_name, "hip_height": p_hip_height
	}
	return var_to_bytes(hello)


## What a client said first, checked. Returns a dictionary with version, role, name and hip_height,
## or with only the key "error" and why it is no such greeting.
static func decode_hello(p_bytes: PackedByteArray) -> Dictionary:
	if p_bytes.size() > 512 or p_bytes.size() < 8:
		return {"error": "the greeting has %d bytes" % p_bytes.size()}
	# Looked at before it is decoded: a broken one would only fill the log with engine errors.
	if p_bytes.decode_u32(0) != TYPE_DICTIONARY:
		return {"error": "the greeting is not in Dismount's form"}
	var said: Variant = bytes_to_var(p_bytes)
	if said is not Dictionary:
		return {"error": "the greeting is not in Dismount's form"}
	var hello: Dictionary = said
	if hello.get("version") is not int:
		return {"error": "the greeting names no version"}
	if hello["version"] != VERSION:
		var versions: Array = [hello["version"], VERSION]
		return {"error": "the client speaks protocol version %d, the server %d" % versions}
	var role: Variant = hello.get("role")
	if role is not int or role < 0 or role >= Role.size():
		return {"error": "the greeting asks for an unknown role"}
	var height: Variant = hello.get("hip_height")
	if height is not float or not (height > 0.2 and height < 2.0):
		return {"error": "the greeting's hip height is no person's"}
	if hello.get("name") is not String:
		return {"error": "the greeting names nobody"}
	var shown: String = (hello["name"] as String).strip_escapes().left(LONGEST_NAME).strip_edges()
	hello["name"] = shown if shown != "" else "nobody"
	return hello


## The server's answer to a greeting: why it refuses, or an empty text if the client is welcome.
static func encode_answer(p_refusal: String) -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray([0 if p_refusal == "" else 1])
	bytes.append_array(p_refusal.to_utf8_buffer())
	return bytes


## Why the server refuses, or an empty text.
static func decode_answer(p_bytes: PackedByteArray) -> String:
	if p_bytes.size() < 2 or p_bytes[0] == 0:
		return ""
	return p_bytes.slice(1).get_string_from_utf8().left(200)
