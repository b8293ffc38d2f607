class_name WorkBudget
extends RefCounted
## Limits the processor time of a tick that deferred work takes: parts are done until the next one
## would probably exceed it.
##
## The time is the thread's own: what other programs take of the processor does not count.

## Time of a tick that may be spent, µs.
const USEC: int = 630
## Weight of the last part in the mean time of its kind, and in the mean deviation.
const _SHARE: float = 0.125
## Expected time of a part: the mean plus so many mean deviations, which is seldom exceeded.
const _DEVIATIONS: float = 2.0
## Expected time of a part of an unknown kind, µs.
const _UNKNOWN_USEC: float = 500.0

## What was spent in each tick that had something to do, s.
var time: Statistics = Statistics.recent()

## Mean and mean deviation of each kind's time, µs.
var _seen: Dictionary[StringName, Vector2] = {}
var _spent_usec: int = 0


## Begins a tick.
func begin() -> void:
	_spent_usec = 0


## Ends it.
func end() -> void:
	if _spent_usec > 0:
		time.add(_spent_usec / 1e6)


## Whether a part of a kind fits into the tick: the first one always does.
func allows(p_kind: StringName) -> bool:
	return _spent_usec == 0 or _spent_usec + _expected(p_kind) <= USEC


## Does a part of a kind, and notes what it took.
func do(p_kind: StringName, p_part: Callable) -> void:
	var begin_usec: int = ThreadClock.get_usec()
	p_part.call()
	note(p_kind, maxi(ThreadClock.get_usec() - begin_usec, 1))


## Notes what a part of a kind took, µs.
func note(p_kind: StringName, p_usec: int) -> void:
	_spent_usec += p_usec
	var seen: Vector2 = _seen.get(p_kind, Vector2(p_usec, 0.0))
	seen.y = lerpf(seen.y, absf(p_usec - seen.x), _SHARE)
	seen.x = lerpf(seen.x, p_usec, _SHARE)
	_seen[p_kind] = seen


func _expected(p_kind: StringName) -> float:
	if not _seen.has(p_kind):
		return _UNKNOWN_USEC
	return _seen[p_kind].x + _DEVIATIONS * _seen[p_kind].y
