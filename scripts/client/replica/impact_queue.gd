class_name ImpactQueue
extends RefCounted
## Impacts that wait until their tick is displayed, so that what is heard is what is seen.

## Most that wait; beyond it the oldest are dropped.
const MAX_WAITING: int = 512
## Delay after which an impact is dropped, ticks.
const LATE_TICKS: float = 30.0
## Distance ahead beyond which an impact is invalid, ticks.
const AHEAD_TICKS: float = 600.0

var _waiting: Array[Impact] = []


## Takes the impacts of a message.
func push(p_impacts: Array[Impact]) -> void:
	for impact: Impact in p_impacts:
		var index: int = _waiting.size()
		while index > 0 and _waiting[index - 1].tick > impact.tick:
			index -= 1
		_waiting.insert(index, impact)
	while _waiting.size() > MAX_WAITING:
		_waiting.pop_front()


## The impacts to be heard when a tick, with its fraction, is displayed.
func take(p_shown_tick: float) -> Array[Impact]:
	var due: Array[Impact] = []
	while not _waiting.is_empty() and _waiting[0].tick <= p_shown_tick:
		var impact: Impact = _waiting.pop_front()
		if impact.tick > p_shown_tick - LATE_TICKS:
			due.append(impact)
	while not _waiting.is_empty() and _waiting.back().tick > p_shown_tick + AHEAD_TICKS:
		_waiting.pop_back()
	return due


## Forgets everything.
func clear() -> void:
	_waiting.clear()
