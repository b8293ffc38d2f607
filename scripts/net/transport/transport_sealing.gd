class_name TransportSealing
extends RefCounted
## Whether the datagrams of a connection are sealed, and with which passwords.

## Why a client that was given a password does not join a server that asks for none.
const ASKS_FOR_NO_PASSWORD: String = (
	"it asks for no password, so that it may be another server;"
	+ " if it is the right one, come without a password"
)
## Bytes that IP and UDP add to each datagram, what says without sealing that it goes beside ENet,
## and those that sealing adds.
const _HEADER_BYTES: int = 28
const _KIND_BYTES: int = 1
const _SEALING_BYTES: int = 18

## Whether they are.
var seals: bool = true
## Version of the protocol, which both ends of a sealed connection must share.
var version: int = 0
## On a server: the password of each role, by number; empty where it needs none.
var passwords: PackedStringArray = PackedStringArray()
## On a server: what its key pair is made from, 32 bytes; nothing: a fresh one for each socket.
var server_key: PackedByteArray = PackedByteArray()
## On a client: the public key that a server has to prove where there is no password, 32 bytes;
## nothing: any will do.
var known_key: PackedByteArray = PackedByteArray()
## On a client: the role that it asks for.
var role: int = 0
## On a client: its password.
var password: String = ""
## On a client: what it got in the connection before, see [member TransportEvent.return_tag].
var return_tag: PackedByteArray = PackedByteArray()


## Without sealing.
static func off() -> TransportSealing:
	var made: TransportSealing = TransportSealing.new()
	made.seals = false
	return made


## Bytes that a datagram has on the wire more than the message in it.
func datagram_overhead() -> int:
	return _HEADER_BYTES + (_SEALING_BYTES if seals else _KIND_BYTES)


## Hands this to a socket that is not open yet.
func set_up(p_socket: SealedSocket) -> void:
	p_socket.set_sealing(seals, version)
	p_socket.set_passwords(passwords)
	p_socket.set_server_key(server_key)
	p_socket.set_client(role, password, return_tag)
	p_socket.set_known_key(known_key)


## A line for the log.
func describe() -> String:
	if not seals:
		return "the connection is not sealed: use a trusted network or a VPN"
	if password != "" or Array(passwords).any(func(text: String) -> bool: return text != ""):
		return "the connection is sealed, and both ends prove that they know the password"
	return "the connection is sealed; without a password only the server proves its key"


## Why a server has not let a client in, for its log; from [method SealedSocket.take_refusal].
func describe_refusal(p_refusal: Dictionary) -> String:
	var why: String = "it comes without the server's sealing"
	match p_refusal["notice"]:
		SealedSocket.NOTICE_WRONG_PASSWORD:
			why = "the password is wrong"
		SealedSocket.NOTICE_LATER:
			why = "too many wrong passwords came from its address"
		SealedSocket.NOTICE_OTHER_VERSION:
			var versions: Array = [p_refusal["version"], version]
			why = "the client speaks protocol version %d, the server %d" % versions
		SealedSocket.NOTICE_SERVER_IS_OPEN:
			why = "it wants a sealed connection, which this server does not make (--sealing=0)"
	return "refused a client from %s: %s" % [p_refusal["address"], why]


## Why the server does not want the connection of a socket, or an empty text.
func explain(p_socket: SealedSocket) -> String:
	match p_socket.get_notice():
		SealedSocket.NOTICE_WRONG_PASSWORD:
			return "the password is wrong"
		SealedSocket.NOTICE_LATER:
			return "too many wrong passwords came from your address"
		SealedSocket.NOTICE_OTHER_VERSION:
			var versions: Array = [version, p_socket.get_server_version()]
			return "the client speaks protocol version %d, the server %d" % versions
		SealedSocket.NOTICE_SERVER_IS_OPEN:
			return "it does not seal connections: come with --sealing=0, if the network can be trusted"
		SealedSocket.NOTICE_SERVER_SEALS:
			return "it wants sealed connections: come without --sealing=0"
		SealedSocket.NOTICE_ASKS_FOR_NO_PASSWORD:
			return ASKS_FOR_NO_PASSWORD
		SealedSocket.NOTICE_OTHER_KEY:
			return "it shows another key than the last time"
	return ""
