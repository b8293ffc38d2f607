class_name ClientFastPath
extends RefCounted
## What a client sends and receives without waiting for a frame: its samples, the server's
## acknowledgement of them, and the questions for the server's time.

# Periods of the questions for the time, µs: at first, and later.
const _QUICK_QUESTIONS: int = 20
const _QUICK_USEC: int = 250000
const _SLOW_USEC: int = 1000000

# The peer while we are joined, for whichever thread has something to send.
var _peer: ThreadedPeer = null
var _sending: Mutex = Mutex.new()
var _motion_ack_taker: Callable = Callable()
# Held while the callable runs: after it is taken away it never runs again.
var _taking: Mutex = Mutex.new()


## Has the thread of a peer that is not open yet call this.
func attach(p_peer: ThreadedPeer) -> void:
	p_peer.callbacks.watcher = _watch
	p_peer.callbacks.beacon = _ask_clock
	p_peer.callbacks.beacon_period = _clock_period


## Lets datagrams through to a peer; null stops them.
func open(p_peer: ThreadedPeer) -> void:
	_sending.lock()
	_peer = p_peer
	_sending.unlock()


## Sends a datagram at once, if it is let through. Any thread may call it.
func send(p_bytes: PackedByteArray) -> void:
	_sending.lock()
	if _peer != null:
		_peer.send_fast(MultiplayerPeer.TARGET_PEER_SERVER, p_bytes)
	_sending.unlock()


## See [method ClientLink.set_motion_ack_taker].
func set_motion_ack_taker(p_taker: Callable) -> void:
	_taking.lock()
	_motion_ack_taker = p_taker
	_taking.unlock()


## Runs in the transport's thread.
func _watch(p_bytes: PackedByteArray) -> void:
	var ack: PackedByteArray = SnapshotDecoder.find_motion_ack(p_bytes)
	if ack.is_empty():
		return
	_taking.lock()
	if _motion_ack_taker.is_valid():
		_motion_ack_taker.call(ack)
	_taking.unlock()


## Runs in the transport's thread.
func _ask_clock() -> PackedByteArray:
	return ClockMessage.question(Time.get_ticks_usec())


## Runs in the transport's thread.
func _clock_period(p_count: int) -> int:
	return _QUICK_USEC if p_count < _QUICK_QUESTIONS else _SLOW_USEC
