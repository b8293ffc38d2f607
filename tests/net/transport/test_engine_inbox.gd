extends TestCase
## Packets of spawners and synchronizers wait for their level; all others pass.

var _queue: PacketQueue = null
var _inbox: EngineInbox = null


func before_each() -> void:
	_queue = PacketQueue.new()
	_inbox = EngineInbox.new(_queue)


func test_packets_wait_for_their_level_in_their_order() -> void:
	_push([3, 1])
	_push([4, 7])
	is_false(_inbox.keeps(_packet([4, 1])), "nothing is held yet")
	_inbox.hold()
	equal(_queue.size(), 1, "the one that had come already waits too")
	is_true(_inbox.keeps(_packet([1, 8])))
	is_false(_inbox.keeps(_packet([3, 2])))
	_inbox.release()
	equal(_taken(), [[3, 1], [4, 7], [1, 8]])
	is_false(_inbox.keeps(_packet([1, 8])))


func test_what_has_waited_for_another_level_is_of_no_use() -> void:
	_inbox.hold()
	is_true(_inbox.keeps(_packet([4, 1])))
	_inbox.hold()
	_inbox.release()
	equal(_queue.size(), 0)


func test_there_is_a_limit() -> void:
	_inbox.hold()
	for _count: int in EngineInbox.MAX_HELD + 10:
		_inbox.keeps(_packet([4, 1]))
	_inbox.release()
	equal(_queue.size(), EngineInbox.MAX_HELD)


func _push(p_bytes: Array) -> void:
	_queue.push(_packet(p_bytes))


static func _packet(p_bytes: Array) -> TransportEvent:
	var packet: TransportEvent = TransportEvent.new()
	packet.bytes = PackedByteArray(p_bytes)
	return packet


func _taken() -> Array:
	var found: Array = []
	while _queue.size() > 0:
		found.append(Array(_queue.pop().bytes))
	return found
