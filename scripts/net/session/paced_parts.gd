class_name PacedParts
extends RefCounted
## Parts of large messages that wait to be sent: a few of them in each tick, in turn to all who get
## some, so that nobody else notices. What is sent to somebody stays in its order.

## Parts that are sent in a tick, of all sessions together.
const PER_TICK: int = 24

var _waiting: Dictionary[int, Array] = {}


## Lets parts wait for a session.
func add(p_session: int, p_parts: Array[PackedByteArray]) -> void:
	var parts: Array = _waiting.get_or_add(p_session, [])
	parts.append_array(p_parts)


## Whether something waits for a session: what is sent to it has to wait too.
func has(p_session: int) -> bool:
	return _waiting.has(p_session)


## Forgets what waits for a session.
func forget(p_session: int) -> void:
	_waiting.erase(p_session)


## Sends what a tick has room for: [code]func(session: int, part: PackedByteArray) -> void[/code].
func advance(p_send: Callable) -> void:
	var left: int = PER_TICK
	while left > 0 and not _waiting.is_empty():
		for session: int in _waiting.keys():
			p_send.call(session, _waiting[session].pop_front())
			if _waiting[session].is_empty():
				_waiting.erase(session)
			left -= 1
			if left == 0:
				return
