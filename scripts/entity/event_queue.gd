class_name EventQueue
extends RefCounted
## Events of a client that wait until their tick is displayed.

## Maximum of waiting events; beyond it the oldest are played at once.
const MAX_WAITING: int = 1024
## Events further ahead than this are invalid, ticks.
const MAX_AHEAD_TICKS: int = 600
## Numbers that are remembered, to recognise repetitions.
const _MEMORY: int = 4096

var _waiting: Array[EntityEvent] = []
var _known: Dictionary[int, int] = {}


## Takes an event. Returns false for a repetition.
func push(p_event: EntityEvent) -> bool:
	if _waiting.size() >= 2 * MAX_WAITING:
		return false
	if _known.has(p_event.number) and _known[p_event.number] == p_event.tick:
		return false
	_known[p_event.number] = p_event.tick
	if _known.size() > _MEMORY:
		for oldest: int in _known:
			_known.erase(oldest)
			break
	var index: int = _waiting.size()
	while index > 0 and _waiting[index - 1].tick > p_event.tick:
		index -= 1
	_waiting.insert(index, p_event)
	return true


## The events to play when a tick, with its fraction, is displayed.
func take(p_shown_tick: float) -> Array[EntityEvent]:
	var due: Array[EntityEvent] = []
	while not _waiting.is_empty():
		var is_due: bool = _waiting[0].tick <= p_shown_tick
		var is_stray: bool = _waiting[0].tick > p_shown_tick + MAX_AHEAD_TICKS
		if not is_due and not is_stray and _waiting.size() <= MAX_WAITING:
			break
		var event: EntityEvent = _waiting.pop_front()
		if not is_stray:
			due.append(event)
	return due


## Forgets everything.
func clear() -> void:
	_waiting.clear()
	_known.clear()
