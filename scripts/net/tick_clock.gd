class_name TickClock
extends RefCounted
## The server's tick, set by the main thread and read in the transport's.

var _mutex: Mutex = Mutex.new()
var _tick: int = 0
var _usec: int = 0
var _rate: int = 60


## Sets the tick that begins, and when, µs.
func publish(p_tick: int, p_usec: int, p_rate: int) -> void:
	_mutex.lock()
	_tick = p_tick
	_usec = p_usec
	_rate = p_rate
	_mutex.unlock()


## Answers a question for the time that arrived at a time, µs; see [ClockMessage].
func answer(p_question: PackedByteArray, p_arrival_usec: int) -> PackedByteArray:
	_mutex.lock()
	var tick: int = _tick
	var usec: int = _usec if _usec > 0 else p_arrival_usec
	var rate: int = _rate
	_mutex.unlock()
	return ClockMessage.answer(p_question, p_arrival_usec, tick, usec, rate)
