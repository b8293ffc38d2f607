class_name SteadyEye
extends RefCounted
## Follows somebody's eyes as a calm camera: spectators do not get sick of every shake of a head.
##
## Turns and moves are followed with a delay that is the shorter the further behind it is, so that
## quick looks are followed quickly, and small shakes hardly at all. The horizon stays level.

## Time constant with which small movements are followed, s.
const CALM_S: float = 0.25
## Greatest lag: rad, m.
const MAX_ANGLE: float = 0.25
const MAX_DISTANCE_M: float = 0.12
## Distance that counts as a jump, m.
const JUMP_M: float = 1.0

var _is_known: bool = false
var _place: Vector3 = Vector3.ZERO
var _turn: Quaternion = Quaternion.IDENTITY


## Forgets whose eyes it followed.
func restart() -> void:
	_is_known = false


## Where the calm camera is when the eyes (which look along -Z) are somewhere, a time after the call
## before, s.
func advance(p_eyes: Transform3D, p_step_s: float) -> Transform3D:
	var wanted: Quaternion = _without_roll(p_eyes.basis.orthonormalized())
	if not _is_known or _place.distance_to(p_eyes.origin) > JUMP_M:
		_is_known = true
		_place = p_eyes.origin
		_turn = wanted
		return Transform3D(Basis(_turn), _place)
	_place = _place.lerp(
		p_eyes.origin, _share(_place.distance_to(p_eyes.origin) / MAX_DISTANCE_M, p_step_s)
	)
	_turn = _turn.slerp(wanted, _share(_turn.angle_to(wanted) / MAX_ANGLE, p_step_s)).normalized()
	return Transform3D(Basis(_turn), _place)


## Share of the distance to cover in a step, given the lag as a part of the greatest.
static func _share(p_behind: float, p_step_s: float) -> float:
	var calm: float = 1.0 - exp(-maxf(p_step_s, 0.0) / CALM_S * (1.0 + 4.0 * p_behind * p_behind))
	# Lag beyond the greatest is removed at once.
	return maxf(calm, 1.0 - 1.0 / p_behind) if p_behind > 1.0 else calm


static func _without_roll(p_turn: Basis) -> Quaternion:
	var ahead: Vector3 = -p_turn.z
	# Straight up or down there is no roll to take away.
	if absf(ahead.y) > 0.97:
		return p_turn.get_rotation_quaternion()
	return Basis.looking_at(ahead).get_rotation_quaternion()
