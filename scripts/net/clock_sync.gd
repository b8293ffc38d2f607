class_name ClockSync
extends RefCounted
## Estimates the server's clock and tick from answers to [ClockMessage] questions.
##
## An answer tells two delays: of the way there, by the server's clock and ours, and of the way
## back. Half the difference of their quickest ([QuickestArrivals]) is the offset of the clocks, if
## both ways take equally long at best, and the slope of it over minutes is the drift.

## Of each span of so long, s, the quickest answer counts; of the newest two before the drift is
## known.
const SPAN_S: float = 5.0
## From so many spans on the drift is measured.
const DRIFT_SPANS: int = 4
## Maximum drift of two clocks, parts per million; more is an error of measurement.
const MAX_DRIFT_PPM: float = 300.0
## A round trip beyond this is of no use, s.
const MAX_TRIP_S: float = 2.0
## An offset that changes by this much means another clock, s.
const JUMP_S: float = 1.0

## Server's time minus ours at the newest answer, µs.
var offset_usec: float = 0.0
## How much faster the server's clock runs, parts per million.
var drift_ppm: float = 0.0
## Mean deviation of the round trip, µs.
var jitter_usec: float = 0.0
## Least round trip of the last seconds, µs.
var round_trip_usec: int = 0
## Answers so far.
var count: int = 0

var _there: QuickestArrivals = QuickestArrivals.new()
var _back: QuickestArrivals = QuickestArrivals.new()
var _trip: QuickestArrivals = QuickestArrivals.new()
var _tick: int = 0
var _tick_usec: int = 0
var _period_usec: float = 1e6 / 60.0
var _last_trip_usec: int = -1


func _init() -> void:
	_there.keep(SPAN_S, DRIFT_SPANS, MAX_DRIFT_PPM * 1e-6)
	_back.keep(SPAN_S, DRIFT_SPANS, MAX_DRIFT_PPM * 1e-6)
	_trip.keep(SPAN_S, 0, 0.0)


## Takes an answer that arrived at a local time, µs.
func arrived(p_packet: ClockMessage, p_arrival_usec: int) -> void:
	var trip: int = p_arrival_usec - p_packet.asked_usec
	if trip < 0 or trip > int(MAX_TRIP_S * 1e6):
		return
	var apart_usec: float = p_packet.server_usec - (p_arrival_usec - trip / 2.0)
	if count > 0 and absf(apart_usec - _offset_at(p_arrival_usec)) > JUMP_S * 1e6:
		clear()
	if _last_trip_usec >= 0:
		jitter_usec += (absi(trip - _last_trip_usec) - jitter_usec) / 16.0
	_last_trip_usec = trip
	count += 1
	var at_s: float = p_arrival_usec * 1e-6
	_there.note(at_s, (p_packet.server_usec - p_packet.asked_usec) * 1e-6)
	_back.note(at_s, (p_arrival_usec - p_packet.server_usec) * 1e-6)
	_trip.note(at_s, trip * 1e-6)
	offset_usec = _offset_at(p_arrival_usec)
	drift_ppm = (_there.drift() - _back.drift()) / 2.0 * 1e6
	round_trip_usec = roundi(_trip.delay_at(at_s) * 1e6)
	if p_packet.tick_usec > _tick_usec or count == 1:
		_tick = p_packet.tick
		_tick_usec = p_packet.tick_usec
		_period_usec = 1e6 / p_packet.tick_rate


## Whether anything is known.
func is_known() -> bool:
	return count > 0


## The server's time at a local time, µs.
func server_usec(p_local_usec: int) -> int:
	return p_local_usec + roundi(_offset_at(p_local_usec))


## The local time of a server's time, µs.
func local_usec(p_server_usec: int) -> int:
	var guess: int = p_server_usec - roundi(offset_usec)
	return p_server_usec - roundi(_offset_at(guess))


## The server's tick, with its fraction, at a local time, µs.
func tick_at(p_local_usec: int) -> float:
	return _tick + (server_usec(p_local_usec) - _tick_usec) / _period_usec


## The local time at which a tick (with its fraction) begins, µs.
func local_usec_of_tick(p_tick: float) -> int:
	return local_usec(_tick_usec + roundi((p_tick - _tick) * _period_usec))


## Forgets everything.
func clear() -> void:
	_there.clear()
	_back.clear()
	_trip.clear()
	count = 0
	drift_ppm = 0.0
	jitter_usec = 0.0
	_last_trip_usec = -1
	_tick_usec = 0


func _offset_at(p_local_usec: int) -> float:
	if not is_known():
		return 0.0
	var at_s: float = p_local_usec * 1e-6
	return (_there.delay_at(at_s) - _back.delay_at(at_s)) / 2.0 * 1e6
