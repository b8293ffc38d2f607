class_name SampleClock
extends RefCounted
## Finds for the server which moment of a wearer's motion is "now".
##
## Samples carry the wearer's clock and arrive with a varying delay: [QuickestArrivals] gives the
## offset of the clocks. The moment advances by whole steps of the simulation and is pulled gently
## to what the offset gives, so that jitter does not shake the ragdoll.
##
## Where samples often come too late for the tick that needs them (jitter, a loaded machine), the
## moment waits for them by up to a tick: what is not known has to be foreseen, and the error of
## that grows with the square of the time.

## How much of the error is corrected per step.
const CORRECTION: float = 0.1
## An error that has not lasted is corrected by no more than this per step, s: a tick that begins
## late is no other moment of the motion.
const CALM_S: float = 0.0003
## How long an error lasts until all of it counts, s.
const LASTING_S: float = 0.5
## An error beyond this is a jump (a loop of a clip, another suit): the clock is set anew. Seconds.
const JUMP_S: float = 0.5
## The share of ticks that are to begin with a sample no older than [constant FREE_S].
const IN_TIME: float = 0.9
## Age of the newest sample at a tick that is no reason to wait, s: it is sampled that long before.
const FREE_S: float = 0.002
## The longest wait, s.
const MAX_WAIT_S: float = 1.0 / 60.0
## Who has paused for so long is not waited for, s.
const PAUSE_S: float = 0.25
## How fast the wait changes at most, seconds per second.
const WAIT_RATE: float = 0.05

# The server's time minus the wearer's, at the server's time, s.
var _offset: QuickestArrivals = QuickestArrivals.new()
var _moment_s: float = -INF
var _newest_s: float = -INF
var _wait_s: float = 0.0
var _lasting_s: float = 0.0


## Takes note of a sample: its time in the wearer's clock and the server's time of arrival, s.
func arrived(p_sample_s: float, p_now_s: float) -> void:
	var offset: float = p_now_s - p_sample_s
	if absf(offset - _offset.delay_at(p_now_s)) > JUMP_S:
		_offset.clear()
		_newest_s = -INF
		_wait_s = 0.0
	_offset.note(p_now_s, offset)
	_newest_s = maxf(_newest_s, p_sample_s)


## Goes on by a step and returns the moment of the motion, s in the wearer's clock.
func advance(p_now_s: float, p_delta_s: float) -> float:
	var quickest_s: float = p_now_s - _offset.delay_at(p_now_s)
	_adapt_wait(quickest_s - _newest_s - FREE_S, p_delta_s)
	var wanted: float = quickest_s - _wait_s
	var stepped: float = _moment_s + p_delta_s
	# Written so that NaN, before the first sample, counts as a jump.
	if not absf(wanted - stepped) <= JUMP_S:
		_moment_s = wanted
		_lasting_s = 0.0
	else:
		var off: float = wanted - stepped
		_lasting_s += (off - _lasting_s) * minf(p_delta_s / LASTING_S, 1.0)
		var most: float = CALM_S + absf(_lasting_s) * CORRECTION
		_moment_s = stepped + clampf(off * CORRECTION, -most, most)
	return _moment_s


## Moves the wait towards the quantile [constant IN_TIME] of what would have been necessary, by the
## sign of the difference (stochastic approximation, Robbins and Monro 1951).
func _adapt_wait(p_needed_s: float, p_delta_s: float) -> void:
	# Who has paused is not waited for. Written so that NaN, before the first sample, changes nothing.
	if not absf(p_needed_s) <= PAUSE_S:
		return
	var part: float = IN_TIME if p_needed_s > _wait_s else IN_TIME - 1.0
	_wait_s = clampf(_wait_s + part * WAIT_RATE * p_delta_s, 0.0, MAX_WAIT_S)
