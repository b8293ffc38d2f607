class_name EngineInbox
extends RefCounted
## Lets the engine's own packets (of spawners and synchronizers) wait at a client that has not
## loaded the level whose nodes they are about. The program's own pass.

## Packets that may wait; further ones are dropped.
const MAX_HELD: int = 4096

var _queue: PacketQueue = null
var _holds: bool = false
var _held: Array[TransportEvent] = []


func _init(p_queue: PacketQueue) -> void:
	_queue = p_queue


## A level begins to load: from now on they wait, and those that have waited for the last one are of
## no use.
func hold() -> void:
	_held.clear()
	_holds = true
	for packet: TransportEvent in _queue.take_all():
		if not keeps(packet):
			_queue.push(packet)


## The level is there: they follow, in their order.
func release() -> void:
	_holds = false
	for packet: TransportEvent in _held:
		_queue.push(packet)
	_held.clear()


## Whether a packet that has come has to wait; it is kept then.
func keeps(p_packet: TransportEvent) -> bool:
	if not _holds or not EnginePackets.is_one(p_packet.bytes):
		return false
	if _held.size() < MAX_HELD:
		_held.append(p_packet)
	return true
