class_name ClockSync
extends RefCounted
## Estimates the server's clock and tick from answers to [ClockMessage] questions.
##
## The server's time in an answer lies between question and arrival, in the middle if both paths
## took equally long. The quickest round trips of the last seconds bound the error most tightly: the
## offset is theirs, and its slope over minutes is the drift of the two clocks.

## Span whose quickest round trip gives the offset, s.
const WINDOW_S: float = 10.0
## Span over which the drift is measured, s.
const DRIFT_WINDOW_S: float = 120.0
## Least span for a drift, s.
const MIN_DRIFT_S: float = 15.0
## Maximum drift of two clocks, parts per million; more is an error of measurement.
const MAX_DRIFT_PPM: float = 300.0
## A round trip beyond this is of no use, s.
const MAX_TRIP_S: float = 2.0
## An offset that changes by this much means another clock, s.
const JUMP_S: float = 1.0

## Server's time minus ours, µs, at [method reference_usec].
var offset_usec: float = 0.0
## How much faster the server's clock runs, parts per million.
var drift_ppm: float = 0.0
## Mean deviation of the round trip, µs.
var jitter_usec: float = 0.0
## Least round trip of the last seconds, µs.
var round_trip_usec: int = 0
## Answers so far.
var count: int = 0

var _probes: Array[Probe] = []
var _best: Array[Probe] = []
var _at_usec: int = 0
var _tick: int = 0
var _tick_usec: int = 0
var _period_usec: float = 1e6 / 60.0
var _last_trip_usec: int = -1


## One answer.
class Probe:
	var local_usec: int = 0
	var offset_usec: float = 0.0
	var trip_usec: int = 0


## Takes an answer that arrived at a local time, µs.
func arrived(p_packet: ClockMessage, p_arrival_usec: int) -> void:
	var trip: int = p_arrival_usec - p_packet.asked_usec
	if trip < 0 or trip > int(MAX_TRIP_S * 1e6):
		return
	var probe: Probe = Probe.new()
	probe.local_usec = p_arrival_usec - trip / 2
	probe.trip_usec = trip
	probe.offset_usec = p_packet.server_usec - (p_arrival_usec - trip / 2.0)
	if count > 0 and absf(probe.offset_usec - _offset_at(probe.local_usec)) > JUMP_S * 1e6:
		clear()
	if _last_trip_usec >= 0:
		jitter_usec += (absi(trip - _last_trip_usec) - jitter_usec) / 16.0
	_last_trip_usec = trip
	count += 1
	_probes.append(probe)
	while _probes[0].local_usec < p_arrival_usec - int(WINDOW_S * 1e6):
		_probes.pop_front()
	_estimate()
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
	_probes.clear()
	_best.clear()
	count = 0
	drift_ppm = 0.0
	jitter_usec = 0.0
	_last_trip_usec = -1
	_tick_usec = 0


func _offset_at(p_local_usec: int) -> float:
	return offset_usec + drift_ppm * 1e-6 * (p_local_usec - _at_usec)


## The quickest probe of the window, aged by the drift, is the offset.
func _estimate() -> void:
	var best: Probe = null
	var cost: float = INF
	for probe: Probe in _probes:
		# Old probes are less certain, by the error of the drift.
		var age: float = _probes.back().local_usec - probe.local_usec
		if probe.trip_usec / 2.0 + age * 20e-6 < cost:
			cost = probe.trip_usec / 2.0 + age * 20e-6
			best = probe
	round_trip_usec = best.trip_usec
	offset_usec = best.offset_usec
	_at_usec = best.local_usec
	_note_best(best)
	_fit_drift()


func _note_best(p_best: Probe) -> void:
	if _best.is_empty() or _best.back() != p_best:
		_best.append(p_best)
	while _best[0].local_usec < p_best.local_usec - int(DRIFT_WINDOW_S * 1e6):
		_best.pop_front()


## The slope of the best probes by least squares, quick ones counting more.
func _fit_drift() -> void:
	var first: int = _best[0].local_usec
	if _best.back().local_usec - first < int(MIN_DRIFT_S * 1e6):
		return
	var quickest: int = _best[0].trip_usec
	for probe: Probe in _best:
		quickest = mini(quickest, probe.trip_usec)
	var sums: Array[float] = [0.0, 0.0, 0.0, 0.0, 0.0]
	for probe: Probe in _best:
		var weight: float = 1.0 / pow(200.0 + probe.trip_usec - quickest, 2.0)
		var x: float = (probe.local_usec - first) / 1e6
		var y: float = probe.offset_usec - _best[0].offset_usec
		sums[0] += weight
		sums[1] += weight * x
		sums[2] += weight * y
		sums[3] += weight * x * x
		sums[4] += weight * x * y
	var spread: float = sums[0] * sums[3] - sums[1] * sums[1]
	if spread > 0.0:
		var slope: float = (sums[0] * sums[4] - sums[1] * sums[2]) / spread
		drift_ppm = clampf(slope, -MAX_DRIFT_PPM, MAX_DRIFT_PPM)
