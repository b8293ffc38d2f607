class_name TickWatch
extends RefCounted
## Notices when a server's ticks come too slowly: the world then runs slower than the clock, as its
## step never grows.

## Span over which the rate is judged, s.
const WINDOW_S: float = 1.0
## Below the first share of the rate the world counts as slow, above the second as normal again.
const SLOW: float = 0.95
const WELL: float = 0.98
## Time after the start that does not count, s: a loaded machine catches up with it.
const GRACE_S: float = 1.0

## Whether the world runs slower than it should.
var is_slow: bool = false
## Speed of the world in the last window: 1 is right.
var speed: float = 1.0
## Slow windows so far.
var slow_windows: int = 0

var _rate: float = 60.0
var _began_s: float = -1.0
var _since_s: float = 0.0
var _ticks: int = 0


func _init(p_rate: float) -> void:
	_rate = p_rate


## Records a tick at a time, s. Returns whether [member is_slow] has just changed.
func ticked(p_now_s: float) -> bool:
	if _began_s < 0.0:
		_began_s = p_now_s
		_since_s = p_now_s + GRACE_S
	if p_now_s < _since_s:
		return false
	_ticks += 1
	var span: float = p_now_s - _since_s
	if span < WINDOW_S:
		return false
	# The first tick of a window closes the last one.
	speed = _ticks / (span * _rate)
	_since_s = p_now_s
	_ticks = 0
	var was_slow: bool = is_slow
	is_slow = speed < (WELL if was_slow else SLOW)
	slow_windows += 1 if is_slow else 0
	return is_slow != was_slow
