class_name WalkerPrediction
extends RefCounted
## A walker at the own client, as many ticks ahead of the server as a command takes to arrive, so
## that it obeys at once.
##
## Both ends make the same ticks of the same input. The server compares each tick's state with what
## the client says of its own, and tells its state only where they differ: then the ticks since are
## made again, and the difference fades out of the picture.

## Ticks that are remembered: two seconds.
const MEMORY: int = 128
## Time constant with which a correction fades out of the picture, s.
const FADE_S: float = 0.1
## A correction beyond this is shown at once, m.
const JUMP_M: float = 2.0

## What is moved.
var mover: WalkerMover = WalkerMover.new()
## The tick that it has reached, or -1 before the server has said where it is.
var tick: int = -1
## Number of the newest correction that was taken.
var correction: int = 0
## From the state to what is shown, m.
var offset: Vector3 = Vector3.ZERO
## Corrections that were taken, and how far each pulled, m.
var corrections: int = 0
var pulls: Statistics = Statistics.recent()

var _inputs: Dictionary[int, WalkerInput] = {}


## Goes on to a tick, by an input that is rounded already. Ticks between are made with the same.
func advance(p_tick: int, p_input: WalkerInput, p_delta_s: float) -> void:
	var first: int = maxi(tick + 1, p_tick - MEMORY)
	for each: int in range(first, p_tick + 1):
		_make(each, p_input, p_delta_s)
	tick = maxi(p_tick, tick)
	offset *= exp(-p_delta_s / FADE_S)


## Takes what the server says of the state after a tick. Returns false where that is no state.
func correct(p_tick: int, p_number: int, p_state: PackedByteArray, p_delta_s: float) -> bool:
	var before: Vector3 = shown()
	if not mover.set_state(p_state):
		return false
	correction = p_number
	corrections += 1
	var newest: int = tick
	if newest < 0 or newest < p_tick or newest - p_tick >= MEMORY:
		restart_at(p_tick)
		return true
	for each: int in range(p_tick + 1, newest + 1):
		_make(each, _inputs.get(each, WalkerInput.new()), p_delta_s)
	offset = before - mover.get_position()
	pulls.add(offset.length())
	if offset.length() > JUMP_M:
		offset = Vector3.ZERO
	return true


## Goes on from the mover's present state as that of a tick.
func restart_at(p_tick: int) -> void:
	tick = p_tick
	offset = Vector3.ZERO
	_inputs.clear()


## Begins anew: nothing is known.
func clear() -> void:
	tick = -1
	offset = Vector3.ZERO
	correction = 0
	_inputs.clear()


## Where the feet are shown, m.
func shown() -> Vector3:
	return mover.get_position() + offset


func _make(p_tick: int, p_input: WalkerInput, p_delta_s: float) -> void:
	p_input.apply(mover, p_delta_s)
	_inputs[p_tick] = p_input
	_inputs.erase(p_tick - MEMORY)
