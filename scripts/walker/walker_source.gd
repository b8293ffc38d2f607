class_name WalkerSource
extends MotionSource
## The motion of a client's user who has no suit and walks by keys or a stick
## ([code]--source=walker[/code]): shown at once, as the client predicts it. The server is sent what
## is wished, not the motion, and makes its own of it.

## Distance between the tick that is due and the next one beyond which it begins anew, ticks: a
## frame that takes long makes several ticks at once.
const MAX_DRIFT: float = 10.0
## Share of a smaller distance that each tick corrects, and at most, ticks.
const CORRECTION: float = 0.05
const MAX_CORRECTION: float = 0.1
## Ticks whose moments are remembered.
const _MEMORY: int = 128

## Where the server will have it: ahead of its news.
var prediction: WalkerPrediction = WalkerPrediction.new()
## What hands wish: [code]func(delta_s: float) -> WalkerInput[/code]; not valid: nothing.
var read_input: Callable = Callable()
## The tick of the server that a command reaches which leaves now, with its fraction; below 0 while
## that is not known: [code]func() -> float[/code].
var due_tick: Callable = Callable()
## Sends an input for a tick: [code]func(input: WalkerInput, tick: int) -> void[/code].
var send: Callable = Callable()
## Says where the room of a headset is, whose wearer walks: [code]func(place) -> void[/code], which
## changes the transform of the client's wearer; not valid: the body's own frame.
var find_room: Callable = Callable()
## The form of the command, by which inputs are rounded.
var schema: EntitySchema = null
## Length of a tick, s.
var tick_s: float = 1.0 / 60.0
## How the person's own frame is turned in the world, rad.
var frame_heading: float = 0.0

# The tick that is due, as it goes on evenly.
var _due: float = -1.0
var _pose: WalkerPose = WalkerPose.new()
var _scale: float = 1.0
var _moments: Dictionary[int, int] = {}


func needs_world() -> bool:
	return true


func is_sent() -> bool:
	return false


func describe() -> String:
	return "a walker, by keys or a stick"


## The body that the server has made: height of its hips, m, and its joints.
func embody(p_hip_height: float, p_joints: PersonSkeleton) -> void:
	_scale = p_hip_height / get_hip_height() if p_hip_height > 0.0 else 1.0
	_pose.set_body(p_hip_height, p_joints)


## Goes on by a set of the person's own; null: by that of everybody.
func use_set(p_set: WalkerSet) -> void:
	_pose.use_set(p_set)


## Begins anew: another server, or another body.
func restart() -> void:
	prediction.clear()
	_moments.clear()
	_due = -1.0


## Takes the server's state after a tick. Returns false where that is none.
func correct(p_tick: int, p_number: int, p_state: PackedByteArray) -> bool:
	var begins: bool = prediction.tick < 0
	if not prediction.correct(p_tick, p_number, p_state, tick_s):
		return false
	if begins:
		_pose.restart(prediction.mover)
	return true


## When a tick was shown here first: µs of Unix time; -1: it was not.
func moment_of(p_tick: int) -> int:
	return _moments.get(p_tick, -1)


func _read(p_time_usec: int) -> PoseSample:
	if not read_input.is_valid() or schema == null:
		return null
	var next: int = _find_next()
	if next < 0 or next <= prediction.tick:
		return null
	var ticks: int = next - prediction.tick if prediction.tick >= 0 else 1
	var input: WalkerInput = (read_input.call(ticks * tick_s) as WalkerInput).rounded(schema)
	input.check = prediction.mover.get_check()
	input.correction = prediction.correction
	send.call(input, next)
	if prediction.tick < 0:
		return null
	prediction.advance(next, input, tick_s)
	_moments[next] = p_time_usec
	_moments.erase(next - _MEMORY)
	return _sample(input)


## The tick that is to be made now; -1 while none is known.
func _find_next() -> int:
	var measured: float = due_tick.call()
	if measured < 0.0:
		return -1
	_due += 1.0
	var off: float = measured - _due
	if absf(off) > MAX_DRIFT:
		_due = measured
	else:
		_due += clampf(off * CORRECTION, -MAX_CORRECTION, MAX_CORRECTION)
	return roundi(_due)


## The pose in the person's own frame, at the wearer's size.
func _sample(p_input: WalkerInput) -> PoseSample:
	var sample: PoseSample = _pose.advance(prediction.mover, p_input, tick_s)
	var back: Quaternion = Rotations.yaw(-frame_heading)
	sample.root = back * (sample.root + prediction.offset) / _scale
	if absf(frame_heading) > 1e-4:
		sample.turn_limbs(back)
	return sample
