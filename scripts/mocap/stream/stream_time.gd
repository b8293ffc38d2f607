class_name StreamTime
extends RefCounted
## When samples were measured, in this machine's time, from the sender's clock or count and the
## times at which they arrive.
##
## The quickest arrivals of the last seconds show how far the two clocks are apart; all others
## waited somewhere on the way. Where the sender's time does not run as time does (stopped, slow
## motion) the arrival is all that is known. A sender that only counts is taken to measure evenly.

## Over which it is judged whether the sender's time runs, and over which a period is measured, µs.
const SPAN_USEC: int = 1000000
## After so long without a sample everything begins anew; no sample waits so long on its way, µs.
const GAP_USEC: int = 500000
## Counts and arrivals that are looked at at once.
const MAX_WINDOW: int = 2048
## Two samples are at least so far apart, µs.
const STEP_USEC: int = 100

var _is_known: bool = false
var _runs: bool = false
var _last_code: int = 0
var _last_arrival: int = 0
var _last_time: int = 0
var _began_code: int = 0
var _began_arrival: int = 0
var _quickest: int = 0
var _before: int = 0
var _counter: int = -1
var _counted: float = 0.0
var _period_usec: float = 0.0
# Counts and arrivals since the period was looked at, and the quickest of the first time.
var _window: PackedInt64Array = PackedInt64Array()
var _first: PackedInt64Array = PackedInt64Array()
var _look_usec: int = 0


## The time of a sample, µs of Unix time, that arrived at one: later than the last one's, and not
## later than its arrival. [param p_code_usec] is the sender's own time.
func at(p_code_usec: int, p_arrival_usec: int) -> int:
	var is_late: bool = p_arrival_usec - _last_arrival > GAP_USEC
	if not _is_known or p_code_usec < _last_code or p_arrival_usec < _last_arrival or is_late:
		_begin(p_code_usec, p_arrival_usec)
	_last_code = p_code_usec
	_last_arrival = p_arrival_usec
	var passed: int = p_arrival_usec - _began_arrival
	if passed >= SPAN_USEC:
		_runs = absi(p_code_usec - _began_code - passed) * 20 <= passed
		_before = _quickest
		_quickest = p_arrival_usec - p_code_usec
		_began_code = p_code_usec
		_began_arrival = p_arrival_usec
	_quickest = mini(_quickest, p_arrival_usec - p_code_usec)
	var time: int = p_code_usec + mini(_quickest, _before)
	if not _runs or p_arrival_usec - time > GAP_USEC:
		time = p_arrival_usec
	if time <= _last_time and _last_time - time < GAP_USEC:
		time = _last_time + STEP_USEC
	_last_time = time
	return time


## The same from the sender's count alone.
func at_count(p_counter: int, p_arrival_usec: int) -> int:
	var steps: int = p_counter - _counter
	if _counter < 0 or steps < 0 or p_arrival_usec - _last_arrival > GAP_USEC:
		_counted = 0.0
		_period_usec = 0.0
		_window.clear()
		_first.clear()
		_is_known = false
	else:
		_counted += steps * _period_usec
	_counter = p_counter
	if _window.is_empty() and _first.is_empty():
		_look_usec = p_arrival_usec + SPAN_USEC
	if _window.size() < MAX_WINDOW:
		_window.append_array([p_counter, p_arrival_usec])
	if p_arrival_usec >= _look_usec:
		_look_usec = p_arrival_usec + SPAN_USEC
		_measure_period()
	if _period_usec <= 0.0:
		return at_arrival(p_arrival_usec)
	# The count was compared with time while the period was measured.
	_runs = _runs or not _is_known
	return at(roundi(_counted), p_arrival_usec)


## The same where the arrival is all that is known.
func at_arrival(p_arrival_usec: int) -> int:
	_last_arrival = p_arrival_usec
	_last_time = maxi(p_arrival_usec, _last_time + STEP_USEC)
	return _last_time


## The time between two counts: between the quickest samples of the first and of the last span, for
## those that waited on their way say nothing of it.
func _measure_period() -> void:
	var last: int = _window.size() - 2
	if _period_usec <= 0.0:
		_period_usec = float(_window[last + 1] - _window[1]) / maxi(_window[last] - _window[0], 1)
	var best: int = 0
	var least: float = INF
	for at: int in range(0, _window.size(), 2):
		var late: float = _window[at + 1] - _window[1] - (_window[at] - _window[0]) * _period_usec
		if late < least:
			least = late
			best = at
	var quickest: PackedInt64Array = _window.slice(best, best + 2)
	_window.clear()
	if _first.is_empty():
		_first = quickest
	elif quickest[0] > _first[0]:
		_period_usec = float(quickest[1] - _first[1]) / (quickest[0] - _first[0])


func _begin(p_code_usec: int, p_arrival_usec: int) -> void:
	# What ran before a gap runs after it, as far as is known.
	_is_known = true
	_began_code = p_code_usec
	_began_arrival = p_arrival_usec
	_quickest = p_arrival_usec - p_code_usec
	_before = _quickest
