class_name SampleClock
extends RefCounted
## Finds for the server which moment of a wearer's motion is "now".
##
## Samples carry the wearer's clock and arrive with a varying delay, which is never below a minimum:
## the quickest arrival of the last one or two seconds gives the offset of the clocks. That
## offset falls at once and rises slowly, so that clocks may drift and the network may become slower
## without the motion going back in time. The moment advances by whole steps of the simulation and
## is pulled gently to what the offset gives, so that jitter does not shake the ragdoll.

## Span whose quickest arrival counts, s.
const WINDOW_S: float = 1.0
## How fast the offset rises, seconds per second.
const RISE: float = 0.1
## A rise beyond this, s, is applied at once: the other machine has paused.
const PAUSE_S: float = 0.25
## How much of the error is corrected per step.
const CORRECTION: float = 0.1
## An error beyond this is a jump (a loop of a clip, another suit): the clock is set anew. Seconds.
const JUMP_S: float = 0.5

# The server's time minus the wearer's at the quickest arrival, s; infinite before the first.
var _offset_s: float = INF
var _quickest_s: float = INF
var _quickest_before_s: float = INF
var _window_begin_s: float = -INF
var _last_s: float = 0.0
var _moment_s: float = -INF


## Takes note of a sample: its time in the wearer's clock and the server's time of arrival, s.
func arrived(p_sample_s: float, p_now_s: float) -> void:
	var offset: float = p_now_s - p_sample_s
	if absf(offset - _offset_s) > JUMP_S:
		_clear()
	if p_now_s - _window_begin_s > WINDOW_S:
		_window_begin_s = p_now_s
		_quickest_before_s = _quickest_s
		_quickest_s = INF
	_quickest_s = minf(_quickest_s, offset)
	var rise: float = minf(_quickest_s, _quickest_before_s) - _offset_s
	if rise > 0.0 and rise <= PAUSE_S:
		rise = minf(rise, maxf(p_now_s - _last_s, 0.0) * RISE)
	# The first value replaces infinity.
	_offset_s = offset if is_inf(_offset_s) else minf(_offset_s + maxf(rise, 0.0), offset)
	_last_s = p_now_s


## Goes on by a step and returns the moment of the motion, s in the wearer's clock.
func advance(p_now_s: float, p_delta_s: float) -> float:
	var wanted: float = p_now_s - _offset_s
	var stepped: float = _moment_s + p_delta_s
	# Written so that NaN, before the first sample, counts as a jump.
	if not absf(wanted - stepped) <= JUMP_S:
		_moment_s = wanted
	else:
		_moment_s = stepped + (wanted - stepped) * CORRECTION
	return _moment_s


func _clear() -> void:
	_offset_s = INF
	_quickest_s = INF
	_quickest_before_s = INF
	_window_begin_s = -INF
