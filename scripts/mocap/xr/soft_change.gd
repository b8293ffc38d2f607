class_name SoftChange
extends RefCounted
## Turns a jump of a pose into a short motion: what jumped is kept as a difference, which fades.

## Time constant, s, and the greatest speeds, m/s and rad/s.
const FADE_S: float = 0.3
const MAX_SPEED: float = 1.0
const MAX_TURN: float = 2.0

## What is to be added to the position, m.
var offset: Vector3 = Vector3.ZERO
## What the rotation is to be turned by, in the frame of the position.
var turn: Quaternion = Quaternion.IDENTITY


## What is shown jumps here.
func add_jump(p_from: Vector3, p_to: Vector3) -> void:
	offset = p_from - p_to


## What is shown turns suddenly here.
func add_turn(p_from: Quaternion, p_to: Quaternion) -> void:
	turn = (p_from * p_to.inverse()).normalized()
	if turn.w < 0.0:
		turn = -turn


## Goes on by a time, s.
func advance(p_step_s: float) -> void:
	var far: float = offset.length()
	if far > 0.0:
		var step: float = minf(far * (1.0 - exp(-p_step_s / FADE_S)), MAX_SPEED * p_step_s)
		offset = offset.move_toward(Vector3.ZERO, maxf(step, 1e-5))
	var angle: float = Rotations.angle(turn)
	if angle > 1e-6:
		var less: float = minf(angle * (1.0 - exp(-p_step_s / FADE_S)), MAX_TURN * p_step_s)
		turn = turn.slerp(Quaternion.IDENTITY, clampf(less / angle, 0.0, 1.0)).normalized()
	else:
		turn = Quaternion.IDENTITY


## Ends it: jumps are wanted.
func clear() -> void:
	offset = Vector3.ZERO
	turn = Quaternion.IDENTITY
