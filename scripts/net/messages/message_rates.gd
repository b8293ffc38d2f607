class_name MessageRates
extends RefCounted
## How often a server takes what a client may send: the table of docs/protocol.md, in one place.
##
## An order that comes too soon is answered, and its sender stays; other messages are dropped and
## counted. What touches everybody has a limit for all sessions together besides.

## Of each kind: burst of a session and its rate per second; then the same of all sessions together,
## zeros where there is no limit.
const ROWS: Dictionary[StringName, Array] = {
	&"who": [4, 2.0, 0, 0.0],
	&"admit": [64, 20.0, 0, 0.0],
	&"refuse": [64, 20.0, 0, 0.0],
	&"kick": [32, 4.0, 64, 8.0],
	&"ban": [32, 2.0, 64, 4.0],
	&"calibrate": [64, 4.0, 64, 8.0],
	# Orders that are carried out: all sessions together have one in twenty seconds, and the last
	# order counts.
	&"level": [8, 2.0, 3, 0.05],
	&"fields": [8, 4.0, 16, 8.0],
	&"effect": [4, 1.0, 8, 2.0],
	&"motion-set": [2, 0.05, 0, 0.0],
	# Answers that something came too soon, and refusals of calls and of pieces of levels.
	&"refusals": [20, 20.0, 0, 0.0],
	&"wearer": [16, 4.0, 0, 0.0],
	&"stats": [4, 2.0, 0, 0.0],
	&"commands": [CommandQueue.MAX_BURST, CommandQueue.MAX_PER_SECOND, 0, 0.0],
	# Of several lists the last one counts.
	&"people": [1, 1.0 / PEOPLE_PERIOD_S, 0, 0.0],
	# Counted by the second.
	&"motion": [MOTIONS, MOTIONS, 0, 0.0],
}
## The rows that hold for each message of a kind, wherever it goes; it is dropped beyond.
const OF_MESSAGES: Dictionary[int, StringName] = {
	Protocol.Message.WEARER: &"wearer",
	Protocol.Message.STATS: &"stats",
}
## The rows of orders.
const OF_ORDERS: Dictionary[int, StringName] = {
	OrderMessage.Kind.WHO: &"who",
	OrderMessage.Kind.ADMIT: &"admit",
	OrderMessage.Kind.REFUSE: &"refuse",
	OrderMessage.Kind.KICK: &"kick",
	OrderMessage.Kind.BAN: &"ban",
	OrderMessage.Kind.CALIBRATE: &"calibrate",
	OrderMessage.Kind.LEVEL: &"level",
	OrderMessage.Kind.FIELDS: &"fields",
}
## Time from a list of people that counts to the next one, s.
const PEOPLE_PERIOD_S: float = 2.0
## Datagrams of motion of a client in a second.
const MOTIONS: int = 600

var _of_session: Dictionary[StringName, Allowance] = {}
var _of_all: Dictionary[StringName, Allowance] = {}


func _init() -> void:
	for what: StringName in ROWS:
		var row: Array = ROWS[what]
		_of_session[what] = Allowance.new(row[0], row[1])
		if row[2] > 0:
			_of_all[what] = Allowance.new(row[2], row[3])


## Takes one of a session, and of all where that has a limit, at a time, s. Returns false, and takes
## none, if one of them has none left.
func take(p_what: StringName, p_session: int, p_now_s: float) -> bool:
	if _of_all.has(p_what):
		if not _of_session[p_what].has(p_session, p_now_s):
			return false
		if not _of_all[p_what].take(0, p_now_s):
			return false
	return _of_session[p_what].take(p_session, p_now_s)


## Takes one of a session, whatever all together have taken.
func take_of_session(p_what: StringName, p_session: int, p_now_s: float) -> bool:
	return _of_session[p_what].take(p_session, p_now_s)


## Takes one of all together.
func take_of_all(p_what: StringName, p_now_s: float) -> bool:
	return _of_all[p_what].take(0, p_now_s)


## Seconds until all together have one left.
func wait_of_all_s(p_what: StringName, p_now_s: float) -> float:
	return _of_all[p_what].wait_s(0, p_now_s)


## A session has ended.
func forget(p_session: int) -> void:
	for what: StringName in _of_session:
		_of_session[what].forget(p_session)


## Says how often something may be, for somebody for whom it was too soon.
static func describe(p_what: StringName) -> String:
	var row: Array = ROWS[p_what]
	var text: String = (
		"too soon: '%s' at most %d times at once and %s a second"
		% [p_what, row[0], String.num(row[1], 2)]
	)
	if row[2] > 0:
		text += ", of all instructors %d and %s" % [row[2], String.num(row[3], 2)]
	return text
