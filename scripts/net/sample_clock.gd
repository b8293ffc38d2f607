class_name SampleClock
extends RefCounted
## Tells the server which moment of a wearer's motion is "now".
##
## Samples carry the wearer's clock and arrive with a varying delay. The quickest arrival of the last
## seconds gives the offset between the clocks; the moment then advances by whole steps of the
## simulation and is drawn gently towards the offset, so that jitter does not shake the ragdoll.

## How much of the error is corrected per step.
const CORRECTION: float = 0.1
## An error beyond this is a jump (a loop of a clip, another suit): the clock is set anew. Seconds.
const JUMP_S: float = 0.5
## How fast the offset forgets a quick arrival: it allows for drifting clocks. Seconds per second.
const DRIFT: float = 0.002

var _offset_s: float = INF
var _last_s: float = 0.0
var _moment_s: float = -INF


## Takes note of a sample: its time in the wearer's clock and the server's time of arrival, s.
func arrived(p_sample_s: float, p_now_s: float) -> void:
	var offset: float = p_now_s - p_sample_s
	if absf(offset - _offset_s) > JUMP_S:
		_offset_s = offset
	_offset_s = minf(_offset_s + maxf(p_now_s - _last_s, 0.0) * DRIFT, offset)
	_last_s = p_now_s


## Goes on by a step and returns the moment of the motion, s in the wearer's clock.
func advance(p_now_s: float, p_delta_s: float) -> float:
	var wanted: float = p_now_s - _offset_s
	var stepped: float = _moment_s + p_delta_s
	if absf(wanted - stepped) > JUMP_S:
		_moment_s = wanted
	else:
		_moment_s = stepped + (wanted - stepped) * CORRECTION
	return _moment_s
