class_name Challenge
extends RefCounted
## The server's first message to a client: its version and what it asks for.
##
## Little-endian: [constant Protocol.HELLO], u32 version, u8 a bit for each role that needs a
## password, u32 rounds of the key's derivation, 16 bytes salt, 32 bytes nonce.

## What stands for the challenge in the proofs of a sealed connection, where none is sent.
const SEALED: String = "DSMT sealed"
## Size, bytes.
const SIZE: int = 61

## Bit r is set where [enum Roles.Role] r needs a password.
var locked_roles: int = 0
## Rounds of [method PasswordKey.derive].
var rounds: int = PasswordKey.ROUNDS
## Salt of [method PasswordKey.derive].
var salt: PackedByteArray = PackedByteArray()
## Never the same twice.
var nonce: PackedByteArray = PackedByteArray()
## Why it is invalid, or an empty text.
var error: String = ""


## The bytes.
func encode() -> PackedByteArray:
	var bytes: PackedByteArray = Protocol.HELLO.to_ascii_buffer()
	bytes.resize(13)
	bytes.encode_u32(4, Protocol.VERSION)
	bytes.encode_u8(8, locked_roles)
	bytes.encode_u32(9, rounds)
	return bytes + salt + nonce


## Whether a role needs a password.
func is_locked(p_role: Roles.Role) -> bool:
	return locked_roles & (1 << p_role) != 0


## Reads a server's packet; [member error] says why it is no challenge.
static func decode(p_bytes: PackedByteArray) -> Challenge:
	var challenge: Challenge = Challenge.new()
	if p_bytes.size() < 8 or p_bytes.slice(0, 4) != Protocol.HELLO.to_ascii_buffer():
		challenge.error = "it answers in a form that is not Dismount's"
	elif p_bytes.decode_u32(4) != Protocol.VERSION:
		var versions: Array = [p_bytes.decode_u32(4), Protocol.VERSION]
		challenge.error = "it speaks protocol version %d, this client %d" % versions
	elif p_bytes.size() != SIZE or p_bytes.decode_u32(9) > PasswordKey.MAX_ROUNDS:
		challenge.error = "its challenge is broken"
	else:
		challenge.locked_roles = p_bytes.decode_u8(8)
		challenge.rounds = p_bytes.decode_u32(9)
		challenge.salt = p_bytes.slice(13, 29)
		challenge.nonce = p_bytes.slice(29)
	return challenge
