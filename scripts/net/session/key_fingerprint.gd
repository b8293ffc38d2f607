class_name KeyFingerprint
extends RefCounted
## How a server's public key is shown to people, who read it out to one another: "SHA256:" and 43
## characters, the form of ssh.

const PREFIX: String = "SHA256:"

## Bytes of a public key, and of the seed that it is made from.
const KEY_SIZE: int = 32


## The fingerprint of a public key.
static func of(p_key: PackedByteArray) -> String:
	var context: HashingContext = HashingContext.new()
	context.start(HashingContext.HASH_SHA256)
	context.update(p_key)
	return PREFIX + to_text(context.finish())


## Bytes as base64 without padding.
static func to_text(p_bytes: PackedByteArray) -> String:
	return Marshalls.raw_to_base64(p_bytes).rstrip("=")


## The bytes of a key that [method to_text] has made, or nothing if a text is none.
static func from_text(p_text: String) -> PackedByteArray:
	# 43 characters have 258 bits: the engine would report an error for what is no base64.
	var pattern: RegEx = RegEx.create_from_string("^[A-Za-z0-9+/]{42}[AEIMQUYcgkosw048]$")
	if pattern.search(p_text) == null:
		return PackedByteArray()
	return Marshalls.base64_to_raw(p_text + "=")


## What is wrong with a text that should be a fingerprint, or an empty text.
static func find_fault(p_text: String) -> String:
	if p_text.begins_with(PREFIX) and not from_text(p_text.trim_prefix(PREFIX)).is_empty():
		return ""
	var shown: String = ByteReader.clean(p_text).left(80)
	return "write %s and 43 characters, as the server's log has it, not '%s'" % [PREFIX, shown]
