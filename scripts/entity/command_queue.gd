class_name CommandQueue
extends RefCounted
## The commands of one session, in order and each once, at the server.
##
## Datagrams repeat the last commands, come twice, late and in another order. A command waits until
## the tick that it is meant for, but not longer than [constant MAX_WAIT_TICKS]; what is meant for
## a tick that is over is applied at once.

## Longest wait for a command's tick: a client that claims a distant tick gains nothing.
const MAX_WAIT_TICKS: int = 8
## Commands that wait at most; beyond it the session is too eager, and new ones are refused.
const MAX_WAITING: int = 64
## Commands of a session per second at most, and at once.
const MAX_PER_SECOND: int = 120
const MAX_BURST: int = 60

## Number of the newest command that was taken out, or -1.
var applied: int = -1
## Commands that were refused because there were too many.
var refused: int = 0

var _newest: int = -1
var _waiting: Array[EntityCommand] = []
var _arrival_ticks: PackedInt32Array = PackedInt32Array()
var _allowance: float = MAX_BURST


## Takes a command that arrived during a tick. Returns false for one that is known, or refused.
func push(p_command: EntityCommand, p_now_tick: int) -> bool:
	if _newest >= 0 and not is_newer(p_command.number, _newest):
		return false
	if _waiting.size() >= MAX_WAITING or _allowance < 1.0:
		refused += 1
		return false
	_allowance -= 1.0
	_newest = p_command.number
	_waiting.append(p_command)
	_arrival_ticks.append(p_now_tick)
	return true


## The commands whose time has come, oldest first. Call it once a tick.
func take(p_now_tick: int, p_tick_rate: int) -> Array[EntityCommand]:
	_allowance = minf(_allowance + float(MAX_PER_SECOND) / p_tick_rate, MAX_BURST)
	var due: Array[EntityCommand] = []
	while not _waiting.is_empty():
		var is_due: bool = _waiting[0].tick <= p_now_tick
		if not is_due and p_now_tick - _arrival_ticks[0] < MAX_WAIT_TICKS:
			break
		var command: EntityCommand = _waiting.pop_front()
		_arrival_ticks.remove_at(0)
		applied = command.number
		due.append(command)
	return due


## Drops the commands that wait.
func forget_waiting() -> void:
	_waiting.clear()
	_arrival_ticks.clear()


## Whether a number of 16 bits is newer than another one.
static func is_newer(p_number: int, p_than: int) -> bool:
	var ahead: int = (p_number - p_than) & 0xFFFF
	return ahead != 0 and ahead < 0x8000
