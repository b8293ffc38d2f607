class_name PasswordKey
extends RefCounted
## A key made from a password, and the proof that somebody knows it without revealing it.

## Rounds of the derivation: they make guessing from a recorded session slow.
const ROUNDS: int = 2000
## Maximum of rounds that a client does for a server.
const MAX_ROUNDS: int = 50000
## Bytes of a proof and of a key.
const SIZE: int = 32

const _HASH: HashingContext.HashType = HashingContext.HASH_SHA256


## The key of a password: PBKDF2 with HMAC-SHA256, one block.
static func derive(p_password: String, p_salt: PackedByteArray, p_rounds: int) -> PackedByteArray:
	var crypto: Crypto = Crypto.new()
	# HMAC takes no empty key in Godot.
	var secret: PackedByteArray = ("dismount:" + p_password).to_utf8_buffer()
	var block: PackedByteArray = crypto.hmac_digest(
		_HASH, secret, p_salt + PackedByteArray([0, 0, 0, 1])
	)
	var key: PackedByteArray = block.duplicate()
	for _round: int in p_rounds - 1:
		block = crypto.hmac_digest(_HASH, secret, block)
		for i: int in 4:
			key.encode_u64(8 * i, key.decode_u64(8 * i) ^ block.decode_u64(8 * i))
	return key


## The proof of a side ("client" or "server") over everything that was sent.
static func prove(
	p_key: PackedByteArray, p_side: String, p_said: Array[PackedByteArray]
) -> PackedByteArray:
	var whole: PackedByteArray = ("DSMT " + p_side).to_ascii_buffer()
	for part: PackedByteArray in p_said:
		var size: PackedByteArray = [0, 0, 0, 0]
		size.encode_u32(0, part.size())
		whole.append_array(size + part)
	return Crypto.new().hmac_digest(_HASH, p_key, whole)


## Whether a proof is right; takes as long for any that is wrong.
static func is_proof(p_expected: PackedByteArray, p_given: PackedByteArray) -> bool:
	return p_given.size() == SIZE and Crypto.new().constant_time_compare(p_expected, p_given)
