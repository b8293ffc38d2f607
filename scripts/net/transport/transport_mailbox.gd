class_name TransportMailbox
extends RefCounted
## Queues between the transport's thread and the others. Every call locks only briefly, and every
## queue is bounded.

## Maximum of fast datagrams that wait for the main thread; beyond it the older half is dropped.
const MAX_FAST: int = 8192
## Maximum of unreliable orders that wait for the thread; further ones are dropped.
const MAX_ORDERS: int = 16384
## Maximum of complaints that wait for the main thread.
const MAX_TROUBLE: int = 64

var _mutex: Mutex = Mutex.new()
var _orders: Array[Array] = []
var _events: Array[TransportEvent] = []
var _fast: Array[FastPacket] = []
var _stats: Dictionary = {}
var _trouble: int = 0
var _taken: int = 0
var _dropped: int = 0


## Gives the thread an order. Returns whether there was room; orders that must not get lost always
## have some.
func post(p_order: Array, p_must: bool) -> bool:
	_mutex.lock()
	var room: bool = p_must or _orders.size() < MAX_ORDERS
	if room:
		_orders.append(p_order)
	else:
		_dropped += 1
	_mutex.unlock()
	return room


## For the thread: the orders since the last call.
func take_orders() -> Array[Array]:
	_mutex.lock()
	var orders: Array[Array] = _orders
	_orders = []
	_mutex.unlock()
	return orders


## For the thread: hands over what has happened.
func hand_over(p_events: Array[TransportEvent], p_fast: Array[FastPacket]) -> void:
	_mutex.lock()
	for event: TransportEvent in p_events:
		if event.kind == TransportEvent.Kind.TROUBLE:
			_trouble += 1
			if _trouble > MAX_TROUBLE:
				continue
		_events.append(event)
	if not p_fast.is_empty():
		_fast.append_array(p_fast)
		if _fast.size() > MAX_FAST:
			var kept: int = MAX_FAST / 2
			_dropped += _fast.size() - kept
			_fast = _fast.slice(_fast.size() - kept)
	_mutex.unlock()


## For the thread: how often the main thread has taken events.
func taken() -> int:
	_mutex.lock()
	var count: int = _taken
	_mutex.unlock()
	return count


## For the thread: publishes stats.
func publish(p_stats: Dictionary) -> void:
	_mutex.lock()
	_stats = p_stats
	_mutex.unlock()


## What has happened since the last call.
func take_events() -> Array[TransportEvent]:
	_mutex.lock()
	var events: Array[TransportEvent] = _events
	_events = []
	_trouble = 0
	_taken += 1
	_mutex.unlock()
	return events


## The fast datagrams since the last call, in the order of their arrival.
func take_fast() -> Array[FastPacket]:
	_mutex.lock()
	var fast: Array[FastPacket] = _fast
	_fast = []
	_mutex.unlock()
	return fast


## The newest stats of the thread; with how much was dropped because nobody took it.
func stats() -> Dictionary:
	_mutex.lock()
	var stats: Dictionary = _stats.duplicate()
	stats["dropped"] = _dropped
	_mutex.unlock()
	return stats
