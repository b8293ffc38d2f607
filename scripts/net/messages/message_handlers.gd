class_name MessageHandlers
extends RefCounted
## The handler of each message, by its first byte. A feature registers its messages with a link; the
## links know no others.

## How a message arrives.
enum Path {
	## In a datagram of the fast path.
	FAST,
	## Over the reliable channel.
	RELIABLE,
	## Either way.
	ANY,
}

## Kinds from here to there are the transport's own: see docs/protocol.md.
const TRANSPORT_FIRST: int = 0x60
const TRANSPORT_LAST: int = 0x6F

var _handlers: Dictionary[int, Handler] = {}


## The handler of one kind of message.
class Handler:
	extends RefCounted
	var handler: Callable = Callable()
	var path: Path = Path.ANY
	var capability: int = 0


## Registers the handler of a kind of message. [param p_capability] is the one of
## [enum Roles.Capability] that its sender needs, or 0.
func add(p_kind: int, p_path: Path, p_handler: Callable, p_capability: int = 0) -> void:
	assert(p_kind >= 0 and p_kind < Protocol.BASED_MOTION and not _handlers.has(p_kind))
	assert(p_kind < TRANSPORT_FIRST or p_kind > TRANSPORT_LAST)
	var entry: Handler = Handler.new()
	entry.handler = p_handler
	entry.path = p_path
	entry.capability = p_capability
	_handlers[p_kind] = entry


## The handler of a message that came by a path, or null.
func find(p_bytes: PackedByteArray, p_path: Path) -> Handler:
	var kind: int = Protocol.kind_of(p_bytes)
	if not _handlers.has(kind):
		return null
	var entry: Handler = _handlers[kind]
	return entry if entry.path == Path.ANY or entry.path == p_path else null
