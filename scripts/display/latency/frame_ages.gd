class_name FrameAges
extends RefCounted
## Measures how old the motion is that each frame shows: from when the shown moment of somebody's
## motion was sampled to when the frame was drawn.
##
## A frame shows the world at a tick with a fraction. When that moment was sampled follows from the
## marks on both sides of it. Beyond the newest mark time goes on at the tick rate, but the tick is
## that of [method WorldReplica.motion_tick]: no further than motion was carried on. While nothing
## comes, ages grow. One person is followed at a time: whose marks come.

## Marks that are kept at most; beyond it the oldest are given up.
const MAX_KEPT: int = 256
## Distance from a mark beyond which the time of sampling is not derived from it, s.
const MAX_GAP_S: float = 2.5

## How quickly [member recent_ms] follows.
const RECENT_GAIN: float = 0.02

## The ages, one for each frame.
var ages: LatencyHistogram = LatencyHistogram.new()
## The mean of the last ones, ms; 0 before the first.
var recent_ms: float = 0.0

var _person: int = -1
# In the order of their ticks.
var _ticks: PackedInt32Array = PackedInt32Array()
var _sampled_usec: PackedInt64Array = PackedInt64Array()


## Takes a mark: it says when what a tick moved by was sampled.
func arrived(p_mark: LatencyMark) -> void:
	if p_mark.sampled_usec == LatencyMark.UNKNOWN or not _is_followed(p_mark):
		return
	if not _ticks.is_empty() and p_mark.tick <= _ticks[-1]:
		return
	_person = p_mark.person
	_ticks.append(p_mark.tick)
	_sampled_usec.append(p_mark.sampled_usec)
	if _ticks.size() > MAX_KEPT:
		_drop_first()


## Notes that a frame was drawn at a time of the server's clock (µs) which shows motion at a tick
## (with its fraction) of a server that makes so many ticks a second.
func drawn(p_motion_tick: float, p_tick_rate: float, p_now_usec: int) -> void:
	# Frames never go back: marks before the one before this frame are of no more use.
	while _ticks.size() > 1 and _ticks[1] <= p_motion_tick:
		_drop_first()
	if _ticks.is_empty() or p_motion_tick < _ticks[0] or p_tick_rate <= 0.0:
		return
	var since: float = p_motion_tick - _ticks[0]
	var rate_usec: float = 1e6 / p_tick_rate
	if _ticks.size() > 1:
		rate_usec = float(_sampled_usec[1] - _sampled_usec[0]) / (_ticks[1] - _ticks[0])
	if since * rate_usec <= MAX_GAP_S * 1e6:
		var age_ms: float = (p_now_usec - _sampled_usec[0] - since * rate_usec) / 1000.0
		ages.add(age_ms)
		recent_ms = lerpf(recent_ms, age_ms, RECENT_GAIN) if ages.count() > 1 else age_ms


## Forgets the marks: another server begins its ticks anew.
func restart() -> void:
	_ticks.clear()
	_sampled_usec.clear()


## Whether a mark is about the person whose marks count. Somebody else's turn comes when that one's
## marks no longer come.
func _is_followed(p_mark: LatencyMark) -> bool:
	if _person == p_mark.person or _ticks.is_empty():
		return true
	if p_mark.sampled_usec - _sampled_usec[-1] < MAX_GAP_S * 1e6:
		return false
	restart()
	return true


func _drop_first() -> void:
	_ticks.remove_at(0)
	_sampled_usec.remove_at(0)
