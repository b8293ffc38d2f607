class_name JoinReply
extends RefCounted
## What a server says to a [JoinRequest].
##
## Little-endian: u8 [enum Kind]; a welcome: u32 session, 16 bytes token, 32 bytes proof; a refusal:
## text why; waiting: u16 place in the row.

## What it says.
enum Kind {
	## The client is welcome.
	WELCOME,
	## The client is not, and trying again is of no use.
	REFUSED,
	## Somebody will decide.
	WAIT,
	## The client is not welcome now; trying later may help.
	LATER,
}

## Longest reason, characters.
const LONGEST_WHY: int = 200

## What it says.
var kind: Kind = Kind.REFUSED
## Why the client is refused.
var why: String = ""
## Number of the session.
var session: int = 0
## Lets the client come back into its session.
var token: PackedByteArray = PackedByteArray()
## Place in the waiting room's row, from 1.
var place: int = 0

var _signed: PackedByteArray = PackedByteArray()
var _proof: PackedByteArray = PackedByteArray()


## A welcome; the proof shows that the server knows the key.
static func welcome(
	p_session: int, p_token: PackedByteArray, p_key: PackedByteArray, p_said: Array[PackedByteArray]
) -> PackedByteArray:
	var bytes: PackedByteArray = [Kind.WELCOME, 0, 0, 0, 0]
	bytes.encode_u32(1, p_session)
	bytes.append_array(p_token)
	return bytes + _proof_of(p_key, p_said, bytes)


## A refusal.
static func refusal(p_why: String, p_later: bool) -> PackedByteArray:
	var bytes: PackedByteArray = [Kind.LATER if p_later else Kind.REFUSED]
	return bytes + ByteReader.text_bytes(p_why.left(LONGEST_WHY))


## The place in the waiting room's row, from 1.
static func wait(p_place: int) -> PackedByteArray:
	var bytes: PackedByteArray = [Kind.WAIT, 0, 0]
	bytes.encode_u16(1, mini(p_place, 65535))
	return bytes


## What a server says; a refusal if it makes no sense.
static func decode(p_bytes: PackedByteArray) -> JoinReply:
	var answer: JoinReply = JoinReply.new()
	var reader: ByteReader = ByteReader.new(p_bytes)
	var said: int = reader.read_u8()
	match said:
		Kind.WELCOME:
			answer.session = reader.read_u32()
			answer.token = reader.read_bytes(JoinRequest.TOKEN_SIZE)
			answer._signed = p_bytes.slice(0, 5 + JoinRequest.TOKEN_SIZE)
			answer._proof = reader.read_bytes(PasswordKey.SIZE)
		Kind.REFUSED, Kind.LATER:
			answer.why = reader.read_text(4 * LONGEST_WHY)
		Kind.WAIT:
			answer.place = reader.read_u16()
	var silent: bool = answer.why == "" and (said == Kind.REFUSED or said == Kind.LATER)
	if not reader.is_complete() or said >= Kind.size() or silent:
		answer.why = "it answers in a form that is not Dismount's"
		return answer
	answer.kind = said as Kind
	return answer


## Whether the server has proven that it knows the key.
func is_proven(p_key: PackedByteArray, p_said: Array[PackedByteArray]) -> bool:
	return PasswordKey.is_proof(_proof_of(p_key, p_said, _signed), _proof)


static func _proof_of(
	p_key: PackedByteArray, p_said: Array[PackedByteArray], p_welcome: PackedByteArray
) -> PackedByteArray:
	var said: Array[PackedByteArray] = p_said.duplicate()
	said.append(p_welcome)
	return PasswordKey.prove(p_key, "server", said)
