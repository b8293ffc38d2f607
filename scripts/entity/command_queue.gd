class_name CommandQueue
extends RefCounted
## The commands of one session at the server: in order, and each only once.
##
## Datagrams repeat the last commands, and may come twice, late and out of order. A command waits
## until its tick, but not longer than [constant MAX_WAIT_TICKS]; a command for a past tick is
## applied at once.

## Longest wait for a command's tick: a client that claims a distant tick gains nothing.
const MAX_WAIT_TICKS: int = 8
## Maximum of waiting commands; further ones are refused.
const MAX_WAITING: int = 64
## Maximum of a session's commands per second, and at once.
const MAX_PER_SECOND: int = 120
const MAX_BURST: int = 60

## Number of the newest command that was applied, or -1.
var applied: int = -1
## Number of the newest command that was taken, or -1.
var newest: int = -1
## Commands that were refused because there were too many.
var refused: int = 0

var _waiting: Array[EntityCommand] = []
var _arrival_ticks: PackedInt32Array = PackedInt32Array()
var _allowance: float = MAX_BURST


## Takes a command that arrived during a tick. Returns false if it is a repetition or refused.
func push(p_command: EntityCommand, p_now_tick: int) -> bool:
	if newest >= 0 and not is_newer(p_command.number, newest):
		return false
	if _waiting.size() >= MAX_WAITING or _allowance < 1.0:
		refused += 1
		return false
	_allowance -= 1.0
	newest = p_command.number
	_waiting.append(p_command)
	_arrival_ticks.append(p_now_tick)
	return true


## The commands that are due, oldest first. Call it once a tick.
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
