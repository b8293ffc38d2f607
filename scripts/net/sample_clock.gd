class_name SampleClock
extends RefCounted
## Tells the server which moment of a wearer's motion is "now".
##
## Samples carry the wearer's clock and arrive with a varying delay. [ClockOffset] tells how much
## the clocks differ; the moment advances by whole steps of the simulation and is drawn gently to
## it, so that jitter does not shake the ragdoll.

## How much of the error is corrected per step.
const CORRECTION: float = 0.1
## An error beyond this is a jump (a loop of a clip, another suit): the clock is set anew. Seconds.
const JUMP_S: float = 0.5

var _offset: ClockOffset = ClockOffset.new()
var _moment_s: float = -INF


## Takes note of a sample: its time in the wearer's clock and the server's time of arrival, s.
func arrived(p_sample_s: float, p_now_s: float) -> void:
	if absf(p_now_s - p_sample_s - _offset.value_s) > JUMP_S:
		_offset.clear()
	_offset.arrived(p_sample_s, p_now_s)


## Goes on by a step and returns the moment of the motion, s in the wearer's clock.
func advance(p_now_s: float, p_delta_s: float) -> float:
	var wanted: float = p_now_s - _offset.value_s
	var stepped: float = _moment_s + p_delta_s
	# Written so that NaN, before the first sample, counts as a jump.
	if not absf(wanted - stepped) <= JUMP_S:
		_moment_s = wanted
	else:
		_moment_s = stepped + (wanted - stepped) * CORRECTION
	return _moment_s
