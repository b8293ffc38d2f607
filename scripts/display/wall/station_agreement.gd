class_name StationAgreement
extends RefCounted
## Which tick all displays of a station show: pure, of what each would show by itself.
##
## The first client leads, but no further than the slowest of the others has got, or they could not
## follow; the others show what it shows at the same moment.

## It waits for others by no more than this, s.
const MAX_WAIT_S: float = 0.25
## How quickly it waits longer, and how slowly less, as shares per message.
const _LONGER: float = 0.05
const _SHORTER: float = 0.01

## Whether this display leads.
var leads: bool = false
## By how many ticks the leader waits for the others.
var wait: float = 0.0

## Where the leader has the station, by the ticks that it shows.
var track: StationTrack = StationTrack.new()

var _others: Dictionary[int, StationClock] = {}
var _shown: float = -INF


func _init(p_leads: bool) -> void:
	leads = p_leads


## Takes what another display says, at a time of the own clock, µs.
func take(p_message: StationMessage, p_arrival_usec: int) -> void:
	# A leader hears the others, and they hear only the leader.
	if leads != (p_message.kind == StationMessage.Kind.WANT):
		return
	var key: int = p_message.sender if leads else 0
	if not _others.has(key):
		if _others.size() >= WallLayout.MAX_SCREENS:
			return
		_others[key] = StationClock.new()
	_others[key].take(p_message, p_arrival_usec)
	if not leads and _others[key].newest == p_message:
		track.take(p_message)


## The tick that is shown at a moment, where this display by itself would show another; µs, µs.
func agree(p_tick: float, p_at_usec: int, p_rate: float, p_now_usec: int) -> float:
	for key: int in _others.keys():
		if not _others[key].is_known(p_now_usec):
			_others.erase(key)
			track.clear()
	if not leads:
		var tick: float = _others[0].tick_at(p_at_usec, p_now_usec) if _others.has(0) else NAN
		# Alone, each goes on by itself.
		return _forward(p_tick if is_nan(tick) else tick, p_rate)
	var slack: float = 0.0
	for clock: StationClock in _others.values():
		# Nobody waits for a display that has stopped.
		if clock.is_fresh(p_now_usec):
			slack = maxf(slack, p_tick - clock.tick_at(p_at_usec, p_now_usec))
	slack = minf(slack, MAX_WAIT_S * p_rate)
	wait = lerpf(wait, slack, _LONGER if slack > wait else _SHORTER)
	return _forward(p_tick - wait, p_rate)


## What the leader said last; null: nothing.
func leader_message() -> StationMessage:
	return _others[0].newest if not leads and _others.has(0) else null


## How many others are heard.
func count() -> int:
	return _others.size()


## Time does not go back, but for another session.
func _forward(p_tick: float, p_rate: float) -> float:
	if p_tick < _shown and p_tick > _shown - p_rate:
		return _shown
	_shown = p_tick
	return p_tick
