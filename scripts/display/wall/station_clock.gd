class_name StationClock
extends RefCounted
## Which tick another display of the station shows at a moment of the own clock: pure, of its
## messages and when they came.
##
## [QuickestArrivals] tell how the clocks differ, so what the network delays now and then moves
## nothing. From the newest message on, ticks go on with their rate.

## So long the other one's ticks go on without a message, µs; then they stand.
const CARRY_USEC: int = 250_000
## After so long without a message nothing is known any more, µs.
const FORGET_USEC: int = 3_000_000

## The newest message; null: none.
var newest: StationMessage = null

var _quickest: QuickestArrivals = QuickestArrivals.new()
var _arrival_usec: int = 0


## Takes a message that came at a time of the own clock, µs. Older ones than the newest count for
## nothing.
func take(p_message: StationMessage, p_arrival_usec: int) -> void:
	var is_new: bool = newest == null or newest.sender != p_message.sender
	if is_new:
		_quickest.clear()
	elif p_message.sequence <= newest.sequence:
		return
	newest = p_message
	_arrival_usec = p_arrival_usec
	_quickest.note(p_arrival_usec * 1e-6, (p_arrival_usec - p_message.sent_usec) * 1e-6)


## Whether the other one has been heard of lately.
func is_known(p_now_usec: int) -> bool:
	return newest != null and p_now_usec - _arrival_usec < FORGET_USEC


## Whether the other one still speaks, so that others may wait for it.
func is_fresh(p_now_usec: int) -> bool:
	return newest != null and p_now_usec - _arrival_usec < CARRY_USEC


## The tick that the other one shows at a moment of the own clock, µs; NAN if nothing is known.
func tick_at(p_at_usec: int, p_now_usec: int) -> float:
	if not is_known(p_now_usec):
		return NAN
	var least: float = _quickest.delay_at(p_at_usec * 1e-6)
	var since_s: float = (p_at_usec - newest.at_usec) * 1e-6 - least
	return newest.tick + clampf(since_s, -CARRY_USEC * 1e-6, CARRY_USEC * 1e-6) * newest.rate
