class_name RoomFrame
extends RefCounted
## Transform of the wearer's room in the world: what moves a headset's view, besides the headset.
##
## The view is always the headset's own pose in this frame, so it may only move calmly. It follows
## where the server has the wearer's body: a wall that stops the body, a step that lifts it, a
## vehicle that carries it. What carries the room moves it at once and rigidly; the rest is followed
## slowly, and a jump (a change of level, a teleport) is a cut. Who walks by a stick says how fast:
## the room moves so evenly, without lagging behind, and only what differs is followed slowly, such
## as the steps of stairs.

## Time constants with which the room follows the body, s: level and upright.
const CALM_S: float = 0.8
const CALM_UP_S: float = 0.25
## Deviation that is ignored, m: bodies that stand still tremble.
const REST_M: float = 0.01
## Deviation that counts as a jump, m and rad.
const JUMP_M: float = 1.5
const JUMP_ANGLE: float = 0.8
## How quickly a new heading is followed, 1/s.
const TURN: float = 1.5
const REST_ANGLE: float = 0.002

var _is_known: bool = false
var _carrier: int = -1
# In the frame of what carries it, or the world's.
var _room: Transform3D = Transform3D.IDENTITY


## Forgets the room.
func restart() -> void:
	_is_known = false


## Where the room is in the world, when the body says that it should be somewhere, a time after the
## call before, s. [param p_carrier] is the number of what carries the wearer, or -1, and
## [param p_frame] where that is; [param p_velocity] is what the room moves by in the world besides
## its carrier, m/s.
func advance(
	p_wanted: Transform3D,
	p_step_s: float,
	p_carrier: int = -1,
	p_frame := Transform3D.IDENTITY,
	p_velocity := Vector3.ZERO
) -> Transform3D:
	if not p_wanted.is_finite() or not p_frame.is_finite():
		return p_frame * _room if p_frame.is_finite() else _room
	var wanted: Transform3D = (p_frame.affine_inverse() * p_wanted).orthonormalized()
	if not _is_known or p_carrier != _carrier or _is_jump(wanted):
		_is_known = true
		_carrier = p_carrier
		_room = wanted
		return p_frame * _room
	var step_s: float = maxf(p_step_s, 0.0)
	if p_velocity.is_finite():
		_room.origin += p_frame.basis.inverse() * p_velocity * step_s
	_follow(wanted, step_s)
	return p_frame * _room


func _is_jump(p_wanted: Transform3D) -> bool:
	var angle: float = _angle_to(p_wanted)
	return _room.origin.distance_to(p_wanted.origin) > JUMP_M or angle > JUMP_ANGLE


func _follow(p_wanted: Transform3D, p_step_s: float) -> void:
	var off: Vector3 = p_wanted.origin - _room.origin
	var level: Vector3 = Vector3(off.x, 0.0, off.z)
	if level.length() > REST_M:
		level = level.limit_length(level.length() - REST_M)
		_room.origin += level * (1.0 - exp(-p_step_s / CALM_S))
	if absf(off.y) > REST_M:
		var up: float = off.y - signf(off.y) * REST_M
		_room.origin.y += up * (1.0 - exp(-p_step_s / CALM_UP_S))
	if _angle_to(p_wanted) > REST_ANGLE:
		var turn: Quaternion = _room.basis.get_rotation_quaternion()
		var share: float = 1.0 - exp(-p_step_s * TURN)
		_room.basis = Basis(turn.slerp(p_wanted.basis.get_rotation_quaternion(), share))


func _angle_to(p_wanted: Transform3D) -> float:
	var turn: Quaternion = p_wanted.basis.get_rotation_quaternion()
	return _room.basis.get_rotation_quaternion().angle_to(turn)
