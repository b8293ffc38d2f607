class_name PeopleLists
extends RefCounted
## Limits how often clients may change their list of people: of each session one list per period
## counts, the last one. The first counts at once.

## Time from a list that counts to the next one, s.
const PERIOD_S: float = MessageRates.PEOPLE_PERIOD_S

var _applied_s: Dictionary[int, float] = {}
var _waiting: Dictionary[int, Array] = {}


## Takes a session's list at a time, s.
func take(p_session: int, p_cards: Array[PersonCard]) -> void:
	_waiting[p_session] = p_cards


## The lists that count at a time, s, by session.
func take_due(p_now_s: float) -> Dictionary[int, Array]:
	var due: Dictionary[int, Array] = {}
	for session: int in _waiting.keys():
		if p_now_s - _applied_s.get(session, -INF) >= PERIOD_S:
			due[session] = _waiting[session]
			_waiting.erase(session)
			_applied_s[session] = p_now_s
	return due


## Forgets a session.
func forget(p_session: int) -> void:
	_waiting.erase(p_session)
	_applied_s.erase(p_session)
