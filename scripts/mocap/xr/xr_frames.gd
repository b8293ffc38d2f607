class_name XrFrames
extends RefCounted
## The last [XrFrame]s of a wearer: written by the main thread in every frame, read by the thread
## that samples, at any moment.

## Frames that are kept.
const KEPT: int = 32
## Time for which a frame holds after its moment, µs; later nothing is known: the runtime has
## stalled.
const HOLD_USEC: int = 250_000

var _mutex: Mutex = Mutex.new()
var _ring: Array[XrFrame] = []
var _count: int = 0
var _next: int = 0
var _recentred: int = 0


func _init() -> void:
	for at: int in KEPT:
		_ring.append(XrFrame.new())


## Takes a frame; the caller may use its own again. A time that is not later than the last one's is
## a clock that was set, or a runtime that was started anew: all before it is forgotten.
func push(p_frame: XrFrame) -> void:
	_mutex.lock()
	if _count > 0 and p_frame.time_usec <= _back(0).time_usec:
		_count = 0
	_ring[_next].copy(p_frame)
	_ring[_next].drop_faults()
	_next = (_next + 1) % KEPT
	_count = mini(_count + 1, KEPT)
	_mutex.unlock()


## The tracking space was moved: whatever hangs on it has to go along at once.
func recentre() -> void:
	_mutex.lock()
	_recentred += 1
	_count = 0
	_mutex.unlock()


## How often the tracking space was moved.
func recentred() -> int:
	_mutex.lock()
	var times: int = _recentred
	_mutex.unlock()
	return times


## Sets a frame to what was at a time, µs of Unix time. Returns whether anything is known of it.
func read(p_time_usec: int, r_frame: XrFrame) -> bool:
	_mutex.lock()
	var is_known: bool = _count > 0 and p_time_usec <= _back(0).time_usec + HOLD_USEC
	if not is_known:
		r_frame.lose_all()
		r_frame.time_usec = p_time_usec
	else:
		_read(p_time_usec, r_frame)
	_mutex.unlock()
	return is_known


func _read(p_time_usec: int, r_frame: XrFrame) -> void:
	if p_time_usec >= _back(0).time_usec:
		r_frame.copy(_back(0))
		return
	for at: int in _count - 1:
		var before: XrFrame = _back(at + 1)
		if before.time_usec <= p_time_usec:
			var span: float = _back(at).time_usec - before.time_usec
			r_frame.blend(before, _back(at), (p_time_usec - before.time_usec) / span)
			return
	r_frame.copy(_back(_count - 1))


func _back(p_at: int) -> XrFrame:
	return _ring[posmod(_next - 1 - p_at, KEPT)]
