class_name JoinReply
extends RefCounted
## A server's answer to a [JoinRequest].
##
## Little-endian: u8 [enum Kind]; a welcome: u32 session, 16 bytes token, text
## name of the level, 8 bytes its fingerprint, 32 bytes proof; a refusal:
## text why; waiting: u16 position, u8 [enum Wait].

## The kind of answer.
enum Kind {
	## The client is admitted.
	WELCOME,
	## The client is refused, and trying again is useless.
	REFUSED,
	## It waits: another answer follows.
	WAIT,
	## The client is refused now; trying later may help.
	LATER,
}

## What a client waits for.
enum Wait {
	## An instructor, who decides.
	INSTRUCTOR,
	## Room at a server that is full.
	ROOM,
	## Room among the clients of its own address.
	SHARE,
}

## Longest reason, characters.
const MAX_WHY: int = 200

## The kind of answer.
var kind: Kind = Kind.REFUSED
## Why the client is refused.
var why: String = ""
## Number of the session.
var session: int = 0
## Lets the client come back into its session.
var token: PackedByteArray = PackedByteArray()
## Position among those who wait, from 1.
var position: int = 0
## What the client waits for.
var waits_for: Wait = Wait.INSTRUCTOR
## Name of the server's level.
var level_name: String = ""
## Fingerprint of the level at the server.
var level_fingerprint: PackedByteArray = PackedByteArray()

var _signed: PackedByteArray = PackedByteArray()
var _proof: PackedByteArray = PackedByteArray()


## A welcome; the proof shows that the server knows the key.
static func welcome(
	p_session: Session, p_rules: ServerRules, p_key: PackedByteArray, p_said: Array[PackedByteArray]
) -> PackedByteArray:
	var bytes: PackedByteArray = [Kind.WELCOME, 0, 0, 0, 0]
	bytes.encode_u32(1, p_session.id)
	bytes.append_array(p_session.token)
	bytes.append_array(ByteReader.text_bytes(p_rules.level_name))
	var fingerprint: PackedByteArray = p_rules.level_fingerprint.duplicate()
	fingerprint.resize(Protocol.FINGERPRINT_SIZE)
	bytes.append_array(fingerprint)
	return bytes + _proof_of(p_key, p_said, bytes)


## A refusal.
static func refusal(p_why: String, p_later: bool) -> PackedByteArray:
	var bytes: PackedByteArray = [Kind.LATER if p_later else Kind.REFUSED]
	return bytes + ByteReader.text_bytes(p_why.left(MAX_WHY))


## The position among those who wait, from 1.
static func wait(p_position: int, p_for: Wait = Wait.INSTRUCTOR) -> PackedByteArray:
	var bytes: PackedByteArray = [Kind.WAIT, 0, 0, p_for]
	bytes.encode_u16(1, mini(p_position, 65535))
	return bytes


## Reads a server's packet; a refusal if it is invalid.
static func decode(p_bytes: PackedByteArray) -> JoinReply:
	var reply: JoinReply = JoinReply.new()
	var reader: ByteReader = ByteReader.new(p_bytes)
	var said: int = reader.read_u8()
	match said:
		Kind.WELCOME:
			reply.session = reader.read_u32()
			reply.token = reader.read_bytes(JoinRequest.TOKEN_SIZE)
			reply.level_name = reader.read_text(4 * Protocol.MAX_LEVEL_NAME)
			reply.level_fingerprint = reader.read_bytes(Protocol.FINGERPRINT_SIZE)
			reply._signed = p_bytes.slice(0, p_bytes.size() - reader.left())
			reply._proof = reader.read_bytes(PasswordKey.SIZE)
		Kind.REFUSED, Kind.LATER:
			reply.why = reader.read_text(4 * MAX_WHY)
		Kind.WAIT:
			reply.position = reader.read_u16()
			reply.waits_for = mini(reader.read_u8(), Wait.SHARE) as Wait
	var silent: bool = reply.why == "" and (said == Kind.REFUSED or said == Kind.LATER)
	if not reader.is_complete() or said >= Kind.size() or silent:
		reply.why = "it replys in a form that is not Dismount's"
		return reply
	reply.kind = said as Kind
	return reply


## Whether the server has proven that it knows the key.
func is_proven(p_key: PackedByteArray, p_said: Array[PackedByteArray]) -> bool:
	return PasswordKey.is_proof(_proof_of(p_key, p_said, _signed), _proof)


static func _proof_of(
	p_key: PackedByteArray, p_said: Array[PackedByteArray], p_welcome: PackedByteArray
) -> PackedByteArray:
	var said: Array[PackedByteArray] = p_said.duplicate()
	said.append(p_welcome)
	return PasswordKey.prove(p_key, "server", said)
