class_name JoinRequest
extends RefCounted
## A client's answer to a [Challenge]: its name, role and wishes, with a proof if it has a password.
##
## Little-endian: [constant Protocol.HELLO], u32 version, u8 role, u8 wanted snapshots per
## second (0: as the server does), 32 bytes nonce, 16 bytes token of a lost session (zeros: none),
## name as u16 length and UTF-8, 32 bytes proof. All versions begin with the first two fields.

## Bytes of a token.
const TOKEN_SIZE: int = 16
## Minimum and maximum of bytes of a join request.
const MIN_SIZE: int = 8
## See [constant MIN_SIZE].
const MAX_SIZE: int = 512

## The role that the client asks for.
var role: Roles.Role = Roles.Role.OBSERVER
## Shown to the others.
var name: String = ""
## Snapshots per second that the client wants; 0 as the server does.
var rate: int = 0
## Version that the client speaks.
var version: int = Protocol.VERSION
## Token of the session that the client had; empty if it had none.
var token: PackedByteArray = PackedByteArray()
## Never the same twice.
var nonce: PackedByteArray = PackedByteArray()
## Why it is no join request, or an empty text.
var error: String = ""

var _signed: PackedByteArray = PackedByteArray()
var _proof: PackedByteArray = PackedByteArray()


## The bytes, with the proof that the key is known.
func encode(p_challenge: PackedByteArray, p_key: PackedByteArray) -> PackedByteArray:
	nonce = Crypto.new().generate_random_bytes(32)
	var bytes: PackedByteArray = Protocol.HELLO.to_ascii_buffer()
	bytes.resize(10)
	bytes.encode_u32(4, version)
	bytes.encode_u8(8, role)
	bytes.encode_u8(9, rate)
	var kept: PackedByteArray = token.duplicate()
	kept.resize(TOKEN_SIZE)
	_signed = bytes + nonce + kept + ByteReader.text_bytes(name.left(Protocol.MAX_NAME))
	_proof = PasswordKey.prove(p_key, "client", [p_challenge, _signed])
	return _signed + _proof


## Reads a client's packet; [member error] says why it is no join request.
static func decode(p_bytes: PackedByteArray) -> JoinRequest:
	var request: JoinRequest = JoinRequest.new()
	request.error = request._read(p_bytes)
	return request


## Whether the client has proven that it knows the key.
func is_proven(p_challenge: PackedByteArray, p_key: PackedByteArray) -> bool:
	var expected: PackedByteArray = PasswordKey.prove(p_key, "client", [p_challenge, _signed])
	return PasswordKey.is_proof(expected, _proof)


## Everything that was sent, for the server's own proof.
func whole() -> PackedByteArray:
	return _signed + _proof


func _read(p_bytes: PackedByteArray) -> String:
	if p_bytes.size() < MIN_SIZE or p_bytes.size() > MAX_SIZE:
		return "the join request has %d bytes" % p_bytes.size()
	if p_bytes.slice(0, 4) != Protocol.HELLO.to_ascii_buffer():
		return "the join request is not in Dismount's form"
	var reader: ByteReader = ByteReader.new(p_bytes, 4)
	version = reader.read_u32()
	if version != Protocol.VERSION:
		var versions: Array = [version, Protocol.VERSION]
		return "the client speaks protocol version %d, the server %d" % versions
	var wanted_role: int = reader.read_u8()
	rate = reader.read_u8()
	nonce = reader.read_bytes(32)
	token = reader.read_bytes(TOKEN_SIZE)
	name = reader.read_text(4 * Protocol.MAX_NAME).left(Protocol.MAX_NAME).strip_edges()
	_signed = p_bytes.slice(0, p_bytes.size() - reader.left())
	_proof = reader.read_bytes(PasswordKey.SIZE)
	if not reader.is_complete():
		return "the join request is broken"
	if not Roles.is_role(wanted_role):
		return "the join request asks for an unknown role"
	role = wanted_role as Roles.Role
	name = name if name != "" else "nobody"
	if token.count(0) == TOKEN_SIZE:
		token = PackedByteArray()
	return ""
