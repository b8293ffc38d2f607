class_name ClockOffset
extends RefCounted
## Estimates by how much another machine's clock differs from ours, from what it sends.
##
## The delay on the way varies, but is never below some least one: the quickest arrival of the last
## one or two seconds gives the offset. It falls at once and rises slowly, so that clocks may drift
## and the way may become slower without what is shown going back in time.

## Span whose quickest arrival counts, s.
const WINDOW_S: float = 1.0
## How fast the offset rises, seconds per second.
const RISE: float = 0.1
## A rise beyond this, s, is taken over at once: the other machine has paused.
const PAUSE_S: float = 0.25

## Our time minus the other's at the quickest arrival, s; infinite before the first.
var value_s: float = INF

var _quickest_s: float = INF
var _quickest_before_s: float = INF
var _window_begin_s: float = -INF
var _last_s: float = 0.0


## Takes note of something that was sent at a time of the other clock and arrived at one of ours, s.
func arrived(p_sent_s: float, p_now_s: float) -> void:
	var offset: float = p_now_s - p_sent_s
	if p_now_s - _window_begin_s > WINDOW_S:
		_window_begin_s = p_now_s
		_quickest_before_s = _quickest_s
		_quickest_s = INF
	_quickest_s = minf(_quickest_s, offset)
	var rise: float = minf(_quickest_s, _quickest_before_s) - value_s
	if rise > 0.0 and rise <= PAUSE_S:
		rise = minf(rise, maxf(p_now_s - _last_s, 0.0) * RISE)
	# The first value replaces infinity.
	value_s = offset if is_inf(value_s) else minf(value_s + maxf(rise, 0.0), offset)
	_last_s = p_now_s


## Begins anew.
func clear() -> void:
	value_s = INF
	_quickest_s = INF
	_quickest_before_s = INF
	_window_begin_s = -INF
