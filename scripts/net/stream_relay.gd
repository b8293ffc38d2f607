class_name StreamRelay
extends RefCounted
## Relays a stream of the fast path that the server does not read, such as voice, from each client
## to those whom it interests. A feature makes one for its kind of message.
##
## A client sends a datagram with the kind in its first byte; what follows is its own. Others get
## the kind, the number of the sender's session (u32, little endian), and what followed. Datagrams
## may be lost, and come twice or in another order.

## Bytes before what a client sent, in what the others get.
const HEAD: int = 5

## Datagrams that were relayed, counted for each receiver, since the start.
var relayed: int = 0

var _link: ServerLink = null
var _kind: int = 0
var _audience: Callable = Callable()
var _allowance: Allowance = null
var _max_bytes: int = 0


## Relays messages of a kind whose senders have a capability (of [enum Roles.Capability]; 0: all),
## of each client so many a second, with at most so many bytes each. Who gets them says
## [code]func(session: int) -> PackedInt32Array[/code] with the sessions, such as
## [code]NearbySessions.find[/code].
func _init(
	p_link: ServerLink,
	p_kind: int,
	p_audience: Callable,
	p_capability: int,
	p_per_second: int,
	p_max_bytes: int = Protocol.MAX_DATAGRAM - HEAD
) -> void:
	_link = p_link
	_kind = p_kind
	_audience = p_audience
	_allowance = Allowance.new(p_per_second, p_per_second)
	_max_bytes = p_max_bytes
	_link.handle(p_kind, MessageHandlers.Path.FAST, _on_datagram, p_capability)
	_link.client_left.connect(_allowance.forget)


## Who sent a datagram that was relayed: the number of its session, or 0 if it is none.
static func sender_of(p_bytes: PackedByteArray) -> int:
	return p_bytes.decode_u32(1) if p_bytes.size() >= HEAD else 0


func _on_datagram(p_session: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	if p_bytes.size() - 1 > _max_bytes:
		return "%d bytes of a stream, %d is the most" % [p_bytes.size() - 1, _max_bytes]
	if not _allowance.take(p_session.id, Time.get_ticks_usec() / 1e6):
		return "more of a stream than is relayed"
	var audience: PackedInt32Array = _audience.call(p_session.id)
	var bytes: PackedByteArray = p_bytes.slice(0, 1)
	bytes.resize(HEAD)
	bytes.encode_u32(1, p_session.id)
	bytes.append_array(p_bytes.slice(1))
	var copies: Array[PackedByteArray] = []
	copies.resize(audience.size())
	copies.fill(bytes)
	_link.send_datagrams(audience, copies)
	relayed += copies.size()
	return ""
