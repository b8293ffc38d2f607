class_name SampleRate
extends RefCounted
## How many samples a second come, over the last span that is whole.

## Length of a span, µs.
const SPAN_USEC: int = 1000000

## Samples a second; 0 before the first span is over.
var hz: float = 0.0
## Whether a span has been over.
var is_known: bool = false

var _count: int = 0
var _since_usec: int = -1


## Counts a sample that came at a time, µs.
func add(p_usec: int) -> void:
	_count += 1
	look(p_usec)


## Goes on to a time, µs: a span that is over tells the rate, though nothing comes any more.
func look(p_usec: int) -> void:
	if _since_usec >= 0 and p_usec - _since_usec < SPAN_USEC:
		return
	is_known = _since_usec >= 0
	hz = _count * 1e6 / (p_usec - _since_usec) if is_known else 0.0
	_count = 0
	_since_usec = p_usec


## Begins anew with the next sample, as after a clock that was set.
func clear() -> void:
	_since_usec = -1
