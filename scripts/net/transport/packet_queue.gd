class_name PacketQueue
extends RefCounted
## Packets that have come, until the multiplayer API takes them one by one.
##
## What was taken is dropped all at once: to take the first of an array away would move the others.

var _packets: Array[TransportEvent] = []
var _next: int = 0


## One more has come.
func push(p_packet: TransportEvent) -> void:
	_packets.append(p_packet)


## Number of those that wait.
func size() -> int:
	return _packets.size() - _next


## The next one, or null.
func front() -> TransportEvent:
	return _packets[_next] if _next < _packets.size() else null


## Takes the next one, or null.
func pop() -> TransportEvent:
	var packet: TransportEvent = front()
	_next += 0 if packet == null else 1
	return packet


## Takes all that wait.
func take_all() -> Array[TransportEvent]:
	var packets: Array[TransportEvent] = _packets.slice(_next)
	clear()
	return packets


## Whether one of somebody waits.
func has_from(p_peer: int) -> bool:
	for i: int in range(_next, _packets.size()):
		if _packets[i].peer == p_peer:
			return true
	return false


## Forgets those of somebody that wait.
func forget(p_peer: int) -> void:
	drop_taken()
	_packets = _packets.filter(func(packet: TransportEvent) -> bool: return packet.peer != p_peer)


## Frees those that were taken.
func drop_taken() -> void:
	if _next > 0:
		_packets = _packets.slice(_next)
		_next = 0


## Forgets all.
func clear() -> void:
	_packets.clear()
	_next = 0
